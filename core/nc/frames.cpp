// SPDX-FileCopyrightText: 2026 The Burin authors
// SPDX-License-Identifier: Apache-2.0
#include "core/nc/frames.h"

namespace burin {
namespace {

/// Work offsets in the order of LinuxCNC's parameters, from 5221 in steps of twenty.
constexpr std::array<int, 9> workOffsetOrder{54, 55, 56, 57, 58, 59, 591, 592, 593};

} // namespace

Frames::Frames(const MachineState& start, AxisSet axes)
    : axes_(axes)
    , length_(start.lengthOffset)
    , offsets_(start.workOffsets)
    , lengths_(start.lengthOffsets)
    , homes_(start.homes)
    , unit_(start.unit) {
    for (const Axis axis : axes_) {
        if (!start.place[axis]) continue;
        const std::optional<double> place = fromMachine(axis, *start.place[axis]);
        known_.set(axis, place.has_value());
        place_.set(axis, place.value_or(0.0));
    }
}

void Frames::moveTo(const AxisValues& place, AxisSet known) {
    place_ = place;
    known_ = known;
}

std::optional<double> Frames::offsetOf(int number, Axis axis) const {
    const auto found = offsets_.find(number);
    return found == offsets_.end() ? std::nullopt : found->second[axis];
}

std::optional<double> Frames::fromMachine(Axis axis, double value) const {
    const std::optional<double> offset = offsetOf(workOffset_, axis);
    if (!offset || (axis == Axis::z && !length_)) return std::nullopt;
    return value - *offset - (axis == Axis::z ? *length_ : 0.0);
}

std::optional<double> Frames::inMachine(Axis axis) const {
    const std::optional<double> offset = offsetOf(workOffset_, axis);
    if (!offset || !known_.has(axis) || (axis == Axis::z && !length_)) return std::nullopt;
    return place_[axis] + *offset + (axis == Axis::z ? *length_ : 0.0);
}

void Frames::setWorkOffset(int number) {
    if (number == workOffset_) return;
    for (const Axis axis : axes_) {
        const std::optional<double> before = offsetOf(workOffset_, axis), after = offsetOf(number, axis);
        if (before && after)
            place_.set(axis, place_[axis] + (*before - *after));
        else
            known_.set(axis, false);
    }
    workOffset_ = number;
}

void Frames::writeWorkOffset(int number, const PartialPlace& zero) {
    for (const Axis axis : axes_) {
        if (!zero[axis]) continue;
        if (number == workOffset_) {
            const std::optional<double> before = offsetOf(number, axis);
            if (before)
                place_.set(axis, place_[axis] + (*before - *zero[axis]));
            else
                known_.set(axis, false);
        }
        offsets_[number][axis] = zero[axis];
        ownZero_ = true;
    }
}

void Frames::writeWorkOffsetHere(int number, const PartialPlace& here) {
    for (const Axis axis : axes_) {
        if (!here[axis]) continue;
        const double place = *here[axis] + shift_[axis];
        std::optional<double> zero = inMachine(axis);
        if (zero) zero = *zero - place - (axis == Axis::z ? *length_ : 0.0);
        offsets_[number][axis] = zero;
        ownZero_ = true;
        if (number != workOffset_) continue;
        place_.set(axis, place);
        known_.set(axis);
    }
}

void Frames::setLengthOffset(int number, std::optional<double> length) noexcept {
    if (length_ && length)
        place_.set(Axis::z, place_[Axis::z] + (*length_ - *length));
    else
        known_.set(Axis::z, false);
    lengthNumber_ = number;
    length_ = length;
}

std::optional<double> Frames::lengthOf(int number) const {
    const auto found = lengths_.find(number);
    return found == lengths_.end() ? std::nullopt : std::optional<double>(found->second);
}

void Frames::shiftSoThatHereIs(const PartialPlace& here) {
    for (const Axis axis : axes_) {
        if (!here[axis]) continue;
        if (known_.has(axis)) {
            shift_.set(axis, place_[axis] - *here[axis]);
        } else { // the text never states where this zero is in the frame of the work offset
            place_.set(axis, *here[axis] + shift_[axis]);
            known_.set(axis);
            ownZero_ = true;
        }
    }
    keptShift_ = shift_;
}

void Frames::setShift(const PartialPlace& shift) {
    for (const Axis axis : axes_)
        if (shift[axis]) shift_.set(axis, *shift[axis]);
    keptShift_ = shift_;
}

void Frames::dropShift(bool keep) {
    shift_ = {};
    if (!keep) keptShift_ = shift_;
}

void Frames::storeHome(std::size_t which) {
    for (const Axis axis : axes_) homes_[which][axis] = inMachine(axis);
}

std::optional<Axis> Frames::axisOf(int number, int first) const noexcept {
    const int place = number - first;
    if (place < 0 || place >= static_cast<int>(axisCount) || !axes_.has(static_cast<Axis>(place))) return std::nullopt;
    return static_cast<Axis>(place);
}

std::optional<double> Frames::parameter(int number, double length, int tool) const {
    const auto inUnit = [this](Axis axis, std::optional<double> value) {
        return value && !isRotary(axis) ? std::optional<double>(*value / unit_) : value;
    };
    if (number == 5400) return tool;
    if (const auto axis = axisOf(number, 5420)) {
        if (!known_.has(*axis)) return std::nullopt;
        return (place_[*axis] - shift_[*axis]) / (isRotary(*axis) ? 1.0 : length);
    }
    if (const auto axis = axisOf(number, 5161)) return inUnit(*axis, homes_[0][*axis]);
    if (const auto axis = axisOf(number, 5181)) return inUnit(*axis, homes_[1][*axis]);
    if (const auto axis = axisOf(number, 5211)) return inUnit(*axis, keptShift_[*axis]);
    for (std::size_t i = 0; i < workOffsetOrder.size(); ++i) {
        if (number == 5220 && workOffsetOrder[i] == workOffset_) return static_cast<double>(i + 1);
        if (const auto axis = axisOf(number, 5221 + 20 * static_cast<int>(i)))
            return inUnit(*axis, offsetOf(workOffsetOrder[i], *axis));
    }
    return std::nullopt;
}

} // namespace burin

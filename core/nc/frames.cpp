// SPDX-FileCopyrightText: 2026 The Burin authors
// SPDX-License-Identifier: Apache-2.0
#include "core/nc/frames.h"

#include "core/nc/axis_index.h"

namespace burin {
namespace {

/// Work offsets in the order in which LinuxCNC's parameters hold them, 5221 on, twenty apart.
constexpr std::array<int, 9> workOffsetOrder{54, 55, 56, 57, 58, 59, 591, 592, 593};

/// Axis of a parameter that holds X, Y or Z; -1 for the rotary and further ones.
constexpr int axisOf(int number, int first) noexcept {
    const int axis = number - first;
    return axis >= 0 && axis < 3 ? axis : -1;
}

} // namespace

Frames::Frames(const MachineState& start)
    : length_(start.lengthOffset)
    , offsets_(start.workOffsets)
    , lengths_(start.lengthOffsets)
    , homes_(start.homes)
    , unit_(start.unit) {
    for (int axis = 0; axis < 3; ++axis) {
        if (!start.place[axisIndex(axis)]) continue;
        const std::optional<double> place = fromMachine(axis, *start.place[axisIndex(axis)]);
        known_[axisIndex(axis)] = place.has_value();
        place_[axis] = place.value_or(0.0);
    }
}

void Frames::moveTo(const glm::dvec3& place, const std::array<bool, 3>& known) noexcept {
    place_ = place;
    known_ = known;
}

std::optional<double> Frames::offsetOf(int number, int axis) const {
    const auto found = offsets_.find(number);
    return found == offsets_.end() ? std::nullopt : found->second[axisIndex(axis)];
}

std::optional<double> Frames::fromMachine(int axis, double value) const {
    const std::optional<double> offset = offsetOf(workOffset_, axis);
    if (!offset || (axis == 2 && !length_)) return std::nullopt;
    return value - *offset - (axis == 2 ? *length_ : 0.0);
}

std::optional<double> Frames::inMachine(int axis) const {
    const std::optional<double> offset = offsetOf(workOffset_, axis);
    if (!offset || !known_[axisIndex(axis)] || (axis == 2 && !length_)) return std::nullopt;
    return place_[axis] + *offset + (axis == 2 ? *length_ : 0.0);
}

void Frames::setWorkOffset(int number) {
    if (number == workOffset_) return;
    for (int axis = 0; axis < 3; ++axis) {
        const std::optional<double> before = offsetOf(workOffset_, axis), after = offsetOf(number, axis);
        if (before && after)
            place_[axis] += *before - *after;
        else
            known_[axisIndex(axis)] = false;
    }
    workOffset_ = number;
}

void Frames::writeWorkOffset(int number, const PartialPlace& zero) {
    for (int axis = 0; axis < 3; ++axis) {
        if (!zero[axisIndex(axis)]) continue;
        if (number == workOffset_) {
            const std::optional<double> before = offsetOf(number, axis);
            if (before)
                place_[axis] += *before - *zero[axisIndex(axis)];
            else
                known_[axisIndex(axis)] = false;
        }
        offsets_[number][axisIndex(axis)] = zero[axisIndex(axis)];
        ownZero_ = true;
    }
}

void Frames::writeWorkOffsetHere(int number, const PartialPlace& here) {
    for (int axis = 0; axis < 3; ++axis) {
        if (!here[axisIndex(axis)]) continue;
        const double place = *here[axisIndex(axis)] + shift_[axis];
        std::optional<double> zero = inMachine(axis);
        if (zero) zero = *zero - place - (axis == 2 ? *length_ : 0.0);
        offsets_[number][axisIndex(axis)] = zero;
        ownZero_ = true;
        if (number != workOffset_) continue;
        place_[axis] = place;
        known_[axisIndex(axis)] = true;
    }
}

void Frames::setLengthOffset(int number, std::optional<double> length) noexcept {
    if (length_ && length)
        place_.z += *length_ - *length;
    else
        known_[2] = false;
    lengthNumber_ = number;
    length_ = length;
}

std::optional<double> Frames::lengthOf(int number) const {
    const auto found = lengths_.find(number);
    return found == lengths_.end() ? std::nullopt : std::optional<double>(found->second);
}

void Frames::shiftSoThatHereIs(const PartialPlace& here) noexcept {
    for (int axis = 0; axis < 3; ++axis) {
        if (!here[axisIndex(axis)]) continue;
        if (known_[axisIndex(axis)]) {
            shift_[axis] = place_[axis] - *here[axisIndex(axis)];
        } else { // the text never says where this zero lies in the work offset's frame
            place_[axis] = *here[axisIndex(axis)] + shift_[axis];
            known_[axisIndex(axis)] = true;
            ownZero_ = true;
        }
    }
    keptShift_ = shift_;
}

void Frames::setShift(const PartialPlace& shift) noexcept {
    for (int axis = 0; axis < 3; ++axis)
        if (shift[axisIndex(axis)]) shift_[axis] = *shift[axisIndex(axis)];
    keptShift_ = shift_;
}

void Frames::dropShift(bool keep) noexcept {
    shift_ = glm::dvec3(0.0);
    if (!keep) keptShift_ = shift_;
}

void Frames::storeHome(std::size_t which) {
    for (int axis = 0; axis < 3; ++axis) homes_[which][axisIndex(axis)] = inMachine(axis);
}

std::optional<double> Frames::parameter(int number, double length, int tool) const {
    const auto inUnit = [this](std::optional<double> value) {
        return value ? std::optional<double>(*value / unit_) : value;
    };
    if (number == 5400) return tool;
    if (const int axis = axisOf(number, 5420); axis >= 0)
        return known_[axisIndex(axis)] ? std::optional<double>((place_[axis] - shift_[axis]) / length) : std::nullopt;
    if (const int axis = axisOf(number, 5161); axis >= 0) return inUnit(homes_[0][axisIndex(axis)]);
    if (const int axis = axisOf(number, 5181); axis >= 0) return inUnit(homes_[1][axisIndex(axis)]);
    if (const int axis = axisOf(number, 5211); axis >= 0) return inUnit(keptShift_[axis]);
    for (std::size_t i = 0; i < workOffsetOrder.size(); ++i) {
        if (number == 5220 && workOffsetOrder[i] == workOffset_) return static_cast<double>(i + 1);
        if (const int axis = axisOf(number, 5221 + 20 * static_cast<int>(i)); axis >= 0)
            return inUnit(offsetOf(workOffsetOrder[i], axis));
    }
    return std::nullopt;
}

} // namespace burin

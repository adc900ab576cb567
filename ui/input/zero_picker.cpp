// SPDX-FileCopyrightText: 2026 The Burin authors
// SPDX-License-Identifier: Apache-2.0
#include "ui/input/zero_picker.h"

#include <algorithm>
#include <cmath>
#include <limits>
#include <utility>

namespace burin {

namespace {

/// Along one axis: the nearest of both sides and the middle.
BoxSide nearestSide(double place, double low, double high) {
    const double share = high > low ? (place - low) / (high - low) : 0.5;
    return share < 0.25 ? BoxSide::low : share > 0.75 ? BoxSide::high : BoxSide::middle;
}

} // namespace

bool ZeroPicker::press(const ViewportEvent& event) {
    if (FacePicker::press(event)) return true;
    taken_ = false;
    if (event.button != Qt::LeftButton || stock_.empty()) return false;
    const std::optional<glm::dvec3> place = boxOn(sightOf(event), stock_);
    if (!place) return false;
    taken_ = true;
    std::array<BoxSide, 3> sides{};
    for (int axis = 0; axis < 3; ++axis)
        sides[static_cast<std::size_t>(axis)] = nearestSide((*place)[axis], stock_.low[axis], stock_.high[axis]);
    emit stockChosen(sides);
    return true;
}

bool ZeroPicker::release(const ViewportEvent& event) {
    return FacePicker::release(event) || (event.button == Qt::LeftButton && std::exchange(taken_, false));
}

QString ZeroPicker::escapeMeaning() {
    return tr("Esc: cancel picking program zero");
}

std::optional<glm::dvec3> boxOn(const Sight& sight, const Box& box) noexcept {
    const glm::dvec3 origin = sight.seenOrigin();
    double enter = 0.0, leave = std::numeric_limits<double>::infinity();
    for (int axis = 0; axis < 3; ++axis) {
        const double along = sight.direction[axis];
        if (along == 0.0) {
            if (origin[axis] < box.low[axis] || origin[axis] > box.high[axis]) return std::nullopt;
            continue;
        }
        double first = (box.low[axis] - origin[axis]) / along, last = (box.high[axis] - origin[axis]) / along;
        if (first > last) std::swap(first, last);
        enter = std::max(enter, first);
        leave = std::min(leave, last);
    }
    if (enter > leave) return std::nullopt;
    return origin + enter * sight.direction;
}

} // namespace burin

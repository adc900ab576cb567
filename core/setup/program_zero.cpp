// SPDX-FileCopyrightText: 2026 The Burin authors
// SPDX-License-Identifier: Apache-2.0
#include "core/setup/program_zero.h"

namespace burin {

std::string_view idOf(ZeroReference reference) noexcept {
    switch (reference) {
    case ZeroReference::stock:
        return "stock";
    case ZeroReference::part:
        return "part";
    case ZeroReference::point:
        return "point";
    }
    return "";
}

std::optional<ZeroReference> zeroReferenceFromId(std::string_view id) noexcept {
    for (const ZeroReference reference : zeroReferences)
        if (idOf(reference) == id) return reference;
    return std::nullopt;
}

std::string_view idOf(BoxSide side) noexcept {
    switch (side) {
    case BoxSide::low:
        return "low";
    case BoxSide::middle:
        return "middle";
    case BoxSide::high:
        return "high";
    }
    return "";
}

std::optional<BoxSide> boxSideFromId(std::string_view id) noexcept {
    for (const BoxSide side : boxSides)
        if (idOf(side) == id) return side;
    return std::nullopt;
}

glm::dvec3 placeOn(const Box& box, const std::array<BoxSide, 3>& sides) noexcept {
    glm::dvec3 place = box.centre();
    for (int axis = 0; axis < 3; ++axis) {
        const BoxSide side = sides[static_cast<std::size_t>(axis)];
        if (side != BoxSide::middle) place[axis] = side == BoxSide::low ? box.low[axis] : box.high[axis];
    }
    return place;
}

ProgramZero moved(ProgramZero zero, const Placement& by) {
    if (zero.on == ZeroReference::point) zero.point = by.point(zero.point);
    return zero;
}

} // namespace burin

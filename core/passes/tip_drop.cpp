// SPDX-FileCopyrightText: 2026 The Burin authors
// SPDX-License-Identifier: Apache-2.0
#include "core/passes/tip_drop.h"

#include "core/geometry/lowest_clear.h"

#include <algorithm>

namespace burin {
namespace {

constexpr double above = 0.02;       // mm of a tip above the part
constexpr double farthestLook = 1e3; // mm

} // namespace

TipDrop::TipDrop(const MeshDistance& part, std::span<const RevolvedPiece> pieces, double distance, double floor)
    : asker_(part, pieces)
    , distance_(distance)
    , floor_(floor)
    , top_(std::max(part.bounds().high.z + distance + above, floor)) {}

double TipDrop::spareAt(const glm::dvec2& place, double z) {
    return asker_.ask({place.x, place.y, z}, distance_ + farthestLook, {}).clearance - distance_;
}

std::optional<double> TipDrop::at(const glm::dvec2& place, double from) {
    return lowestClear([&](double z) { return spareAt(place, z); }, std::max(from, floor_), floor_);
}

ToolClearance TipDrop::touch(const glm::dvec3& tip) {
    return asker_.ask(tip, distance_ + farthestLook, {});
}

glm::dvec2 touchedPlace(const ToolClearance& touch, const glm::dvec3& tip) noexcept {
    constexpr double level = 0.99985; // z of the unit vector out of the part: one degree
    return glm::dvec2(touch.away.z > level ? tip : touch.meshPoint);
}

} // namespace burin

// SPDX-FileCopyrightText: 2026 The Burin authors
// SPDX-License-Identifier: Apache-2.0
#pragma once

#include "core/geometry/mesh_distance.h"

#include <optional>
#include <span>
#include <vector>

namespace burin {

/// Lets an upright tool down onto a part, exact for the part's triangles: the lowest tip above which all is clear.
class TipDrop {
public:
    /// Keeps references to part and pieces, which outlive it. @param pieces of the tool, flutes first
    /// @param distance mm, that the tool keeps from the part, >= 0 @param floor mm, the lowest tip
    TipDrop(const MeshDistance& part, std::span<const RevolvedPiece> pieces, double distance, double floor);

    /// mm, as lowestClear finds it; nothing where the tool touches nowhere above the floor. One thread.
    /// @param from mm, a tip from which everything upwards is clear
    std::optional<double> at(const glm::dvec2& place, double from);
    std::optional<double> at(const glm::dvec2& place) { return at(place, top_); }

    /// What the tool touches at a tip.
    ToolClearance touch(const glm::dvec3& tip);

    double top() const noexcept { return top_; } ///< mm: a tip this high has the whole part below it

private:
    double spareAt(const glm::dvec2& place, double z);

    ClearanceAsker asker_;
    double distance_, floor_, top_;
};

/// The place in plan that a tool means at a tip: what it touches, where that is a slope; under its tip where it stands
/// level, as a flat end touches there in many places. mm
glm::dvec2 touchedPlace(const ToolClearance& touch, const glm::dvec3& tip) noexcept;

} // namespace burin

// SPDX-FileCopyrightText: 2026 The Burin authors
// SPDX-License-Identifier: Apache-2.0
#pragma once

#include "core/geometry/mesh_distance.h"

#include <optional>
#include <span>
#include <vector>

namespace burin {

/// Lowers an upright tool onto a part, exact for the triangles of the part: finds the lowest tip above which everything
/// is clear.
class TipDrop {
public:
    /// Keeps references to part and pieces, which must outlive it. @param pieces of the tool, flutes first
    /// @param distance that the tool keeps from the part, mm, >= 0 @param floor height of the lowest tip, mm
    TipDrop(const MeshDistance& part, std::span<const RevolvedPiece> pieces, double distance, double floor);

    /// The height of the tip, mm, as found by lowestClear; empty if the tool touches nothing above the floor. Not
    /// thread-safe.
    /// @param from height of a tip above which everything is clear, mm
    std::optional<double> at(const glm::dvec2& place, double from);
    std::optional<double> at(const glm::dvec2& place) { return at(place, top_); }

    /// What the tool touches at a tip.
    ToolClearance touch(const glm::dvec3& tip);

    double top() const noexcept { return top_; } ///< height of a tip that is above the whole part, mm

private:
    double spareAt(const glm::dvec2& place, double z);

    ClearanceAsker asker_;
    double distance_, floor_, top_;
};

/// The point in plan that belongs to a tip, mm: the contact point on a slope; the point below the tip on a level face,
/// where a flat end touches at many points.
glm::dvec2 touchedPlace(const ToolClearance& touch, const glm::dvec3& tip) noexcept;

} // namespace burin

// SPDX-FileCopyrightText: 2026 The Burin authors
// SPDX-License-Identifier: Apache-2.0
#pragma once

#include "core/field/tool_field.h"
#include "core/geometry/box.h"
#include "core/tool/tool.h"

#include <glm/glm.hpp>

#include <vector>

namespace burin {

/// Where a tip that comes straight down at (x, y) is stopped by the part, mm: the lowest height from which everything
/// up to `top` has clearance >= allowance. `bottom` where nothing stops it, +infinity where it can't even be at `top`.
/// Marches by the clearance itself, so that it passes no wall, and ends within 1 µm.
double lowestFeasibleHeight(const ClearanceField& field, double x, double y, double allowance, double top,
                            double bottom) noexcept;

/// How deep below standing stock the operator takes a cutter, mm: the flutes less a margin.
double usableFlutes(const Cutter& cutter) noexcept;

/// How far beside standing stock the operator keeps shank and holder, mm: a hand has tremor and rounds its corners.
double lateralMargin(const Cutter& cutter) noexcept;

/// How much narrower than the cutter the operator takes a cut to be, mm: the hand's tremor misses some of its edge.
double trembleMargin(const Cutter& cutter) noexcept;

/// How high stock stands on squares of one size, where something has been milled already.
struct StandingStock {
    glm::dvec2 low{0.0}; ///< mm, corner of the first square
    double edge = 0.0;   ///< mm
    int columns = 0, rows = 0;
    std::vector<double> heights;     ///< mm, row by row along x; WorkpieceHeights::nothing: none. Empty: not known
    std::vector<double> thickness{}; ///< mm of what stands highest, down to the part or the air below it

    /// The highest on the squares that a rectangle touches, mm; `nothing` beside them.
    double highestIn(const glm::dvec2& from, const glm::dvec2& to) const noexcept;
};

/// What the operator sees of the workpiece while planning: how high the stock stands, on a raster. It knows no overhang
/// and no part. Stock outside the raster does not exist.
class WorkpieceHeights {
public:
    static constexpr double nothing = -1e300; ///< height where there is no stock

    /// A box of stock, not empty. The raster is a sixth of the cutter's radius wide, at most 0.5 mm; wider where the
    /// stock is so large that it would take more than four million cells. @param coarseness times that width, >= 1
    WorkpieceHeights(const Box& stock, const Cutter& cutter, double coarseness = 1.0);

    /// Nothing stands higher than this any more.
    void lowerTo(const StandingStock& standing) noexcept;
    /// The flutes at this tip surely take away what stands in them, but for the margin for tremor at their edge.
    void cut(const glm::dvec3& tip) noexcept;
    /// A straight move, by tips no further apart than the raster.
    void cut(const glm::dvec3& from, const glm::dvec3& to) noexcept;

    /// Highest stock within `radius` of (x, y), mm; `nothing` where there is none.
    double highestWithin(double x, double y, double radius) const noexcept;
    /// Lowest tip at (x, y) at which the flutes touch no stock; `nothing` beside the stock.
    /// @param inset mm: as if the cutter were so much narrower to each side
    double freeTip(double x, double y, double inset = 0.0) const noexcept;
    /// Whether the flutes at this tip would take away more than `leastRest`.
    bool hasRest(const glm::dvec3& tip) const noexcept { return freeTip(tip.x, tip.y, cell_) > tip.z + leastRest; }
    static constexpr double leastRest = 0.1; ///< mm; less is what step-overs and voxels leave
    /// Lowest height, not below the tip's, at which shank and holder, each with the lateral margin, keep above the
    /// stock.
    /// @param further mm that the tip may be beside where it is meant to be, beyond the margin.
    double safeHeight(const glm::dvec3& tip, double further = 0.0) const noexcept;
    /// How far the cutter's surface rises above its tip at a distance from the axis within its radius, mm.
    double riseAt(double distance) const noexcept;

    const Box& stock() const noexcept { return stock_; }
    double raster() const noexcept { return cell_; } ///< mm

private:
    /// A part of the tool that must not touch stock: its lower face.
    struct Relief {
        double height = 0.0; ///< mm above the tip
        double radius = 0.0; ///< mm
    };
    template <class Visit>
    void visitDisc(double x, double y, double radius, Visit&& visit) const noexcept;

    Box stock_;
    Cutter cutter_;
    std::vector<RevolvedPiece> flutes_;
    std::vector<Relief> reliefs_;
    double cell_ = 0.5;
    int columns_ = 0, rows_ = 0;
    std::vector<double> heights_;
};

} // namespace burin

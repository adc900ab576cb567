// SPDX-FileCopyrightText: 2026 The Burin authors
// SPDX-License-Identifier: Apache-2.0
#pragma once

#include "core/field/tool_field.h"
#include "core/geometry/box.h"
#include "core/tool/tool.h"

#include <glm/glm.hpp>

#include <vector>

namespace burin {

/// The height at which the part stops a tip that comes straight down at (x, y), mm: the lowest height from which
/// everything up to `top` has clearance >= allowance. `bottom` if nothing stops it, +infinity if the tip can't even be
/// at `top`. Marches in steps of the clearance itself, so that it skips no wall, and ends within 1 µm.
double lowestFeasibleHeight(const ClearanceField& field, double x, double y, double allowance, double top,
                            double bottom) noexcept;

/// How deep below standing stock the operator uses a cutter, mm: the flute length less a margin.
double usableFlutes(const Cutter& cutter) noexcept;

/// The horizontal distance that the operator keeps between standing stock and shank or holder, mm: a hand has tremor
/// and rounds its corners.
double lateralMargin(const Cutter& cutter) noexcept;

/// How much narrower than the cutter the operator assumes a cut to be, mm: because of the hand's tremor the edge does
/// not cut everywhere.
double trembleMargin(const Cutter& cutter) noexcept;

/// The height of the standing stock on squares of one size, if something has been milled already.
struct StandingStock {
    glm::dvec2 low{0.0}; ///< mm, corner of the first square
    double edge = 0.0;   ///< mm
    int columns = 0, rows = 0;
    std::vector<double> heights;     ///< mm, row by row along x; WorkpieceHeights::nothing: no stock. Empty: not known
    std::vector<double> thickness{}; ///< mm of the topmost stock, down to the part or the air below it

    /// The greatest height on the squares that a rectangle touches, mm; `nothing` outside the squares.
    double highestIn(const glm::dvec2& from, const glm::dvec2& to) const noexcept;
};

/// What the operator sees of the workpiece while planning: a height map of the stock. It knows neither overhangs nor
/// the part. There is no stock outside the raster.
class WorkpieceHeights {
public:
    static constexpr double nothing = -1e300; ///< height where there is no stock

    /// A box of stock, not empty. The raster spacing is a sixth of the cutter's radius, at most 0.5 mm; larger for
    /// stock so large that it would need more than four million cells. @param coarseness factor for the spacing, >= 1
    WorkpieceHeights(const Box& stock, const Cutter& cutter, double coarseness = 1.0);

    /// Lowers all heights to those of `standing` where they are higher.
    void lowerTo(const StandingStock& standing) noexcept;
    /// Removes what the flutes at this tip are certain to cut: all stock within them except for the tremor margin at
    /// their edge.
    void cut(const glm::dvec3& tip) noexcept;
    /// The same along a straight move, at tips no farther apart than the raster spacing.
    void cut(const glm::dvec3& from, const glm::dvec3& to) noexcept;

    /// Greatest height of stock within `radius` of (x, y), mm; `nothing` if there is none.
    double highestWithin(double x, double y, double radius) const noexcept;
    /// Lowest tip at (x, y) at which the flutes touch no stock; `nothing` beside the stock.
    /// @param inset mm by which the radius of the cutter is reduced
    double freeTip(double x, double y, double inset = 0.0) const noexcept;
    /// Whether the flutes at this tip would remove more than `leastRest`.
    bool hasRest(const glm::dvec3& tip) const noexcept { return freeTip(tip.x, tip.y, cell_) > tip.z + leastRest; }
    static constexpr double leastRest = 0.1; ///< mm; step-overs and voxels leave less than this
    /// Lowest height, not below the tip's, at which shank and holder, each with the lateral margin, stay above the
    /// stock.
    /// @param further horizontal deviation of the tip from its intended position, beyond the margin, mm
    double safeHeight(const glm::dvec3& tip, double further = 0.0) const noexcept;
    /// Height of the cutter's surface above its tip at a distance from the axis within its radius, mm.
    double riseAt(double distance) const noexcept;

    const Box& stock() const noexcept { return stock_; }
    double raster() const noexcept { return cell_; } ///< mm

private:
    /// A part of the tool that must not touch stock, by its lower face.
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

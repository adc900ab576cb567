// SPDX-FileCopyrightText: 2026 The Burin authors
// SPDX-License-Identifier: Apache-2.0
#pragma once

#include "core/passes/pass_ground.h"
#include "core/passes/pass_request.h"
#include "core/passes/tip_drop.h"
#include "core/passes/workpiece_heights.h"

#include <functional>
#include <vector>

namespace burin {

/// A row in plan, mm.
using PlanRow = std::vector<glm::dvec2>;

/// The share of a straight segment that lies within bounds.
struct SegmentShare {
    double from = 0.0, to = 1.0;
    bool empty() const noexcept { return !(from < to); }
};
SegmentShare shareWithin(const PlanBounds& bounds, const glm::dvec2& from, const glm::dvec2& to) noexcept;

/// A point of the surface of tips.
struct SurfacePlace {
    glm::dvec3 tip{0.0}; ///< mm
    bool onPart = false; ///< the part stops the tip; otherwise it is at the lowest height
};

/// Projects rows onto the part of a pass: the tool comes straight down at every point, exact on the triangles of the
/// part. Points are at most 0.2 mm apart, closer where the segment between two of them would deviate from the part by
/// more than 0.002 mm. Beside the part the row continues at the lowest height, where stock is left. Usable from any
/// number of threads, each with its own probe.
class SurfaceTrace {
public:
    /// Keeps references to both, which must outlive it.
    SurfaceTrace(const PassRequest& request, const PassGround& ground);

    /// The probe that lowers the tool, for one thread.
    TipDrop probe() const { return {ground_.part, pieces_, request_.allowance, bottom_}; }
    SurfacePlace at(const glm::dvec2& place, TipDrop& probe) const;
    /// Whether the request asks for this point: its area, its slopes, the remaining stock.
    bool isRequested(const SurfacePlace& place, TipDrop& probe) const;
    /// The same where it is known what the tool touches.
    bool isRequested(const SurfacePlace& place, const ToolClearance& touch) const;
    /// Whether only the flutes meet stock there, and no more of it than they can bear.
    bool isPossible(const SurfacePlace& place) const;

    /// The parts of a row within the bounds that are requested and possible. @param leftOut increased by the length,
    /// mm, that is requested but not possible
    std::vector<TipLine> along(const PlanRow& row, double& leftOut) const;

    /// The same for a line of tips that lie on the part.
    std::vector<TipLine> intervalsOf(const TipLine& line, double& leftOut) const;

    /// The area of the request, or the part, extended by the distance at which the tool still touches it.
    const PlanBounds& bounds() const noexcept { return bounds_; }
    double cutterRadius() const noexcept { return ground_.tool.cutter.radius(); } ///< mm

private:
    class Intervals;
    PlanBounds boundsOfRequest() const;
    template <class Touch>
    bool isRequestedWith(const SurfacePlace& place, const Touch& touch) const;
    void between(const SurfacePlace& first, const SurfacePlace& last, TipDrop& probe,
                 const std::function<void(const SurfacePlace&)>& add) const;

    const PassRequest& request_;
    const PassGround& ground_;
    std::vector<RevolvedPiece> pieces_;
    WorkpieceHeights heights_;
    double bottom_;
    PlanBounds bounds_;
};

/// Whether the flutes at a tip would remove stock more than 0.1 mm high, according to the scanlines of the workpiece;
/// stock between two scanlines is not detected.
bool isRest(const WorkpieceHeights& heights, const PassGround& ground, const glm::dvec3& tip) noexcept;

/// The line without the points that lie within 0.0005 mm of the segment between their neighbours.
TipLine straightened(const TipLine& line);

} // namespace burin

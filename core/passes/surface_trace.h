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

/// A place of the surface of tips.
struct SurfacePlace {
    glm::dvec3 tip{0.0}; ///< mm
    bool onPart = false; ///< the part holds it up; else it is at the lowest height
};

/// Lays rows onto the part of a pass: the tool comes straight down at every place, exact on the part's triangles, with
/// a place at every 0.2 mm at most, closer where the way between two would leave the part by more than 0.002 mm.
/// Beside the part it goes on at the lowest height, where stock is left. Any number of threads, with a probe each.
class SurfaceTrace {
public:
    /// Keeps references to both, which outlive it.
    SurfaceTrace(const PassRequest& request, const PassGround& ground);

    /// What lets the tool down in one thread.
    TipDrop probe() const { return {ground_.part, pieces_, request_.allowance, bottom_}; }
    SurfacePlace at(const glm::dvec2& place, TipDrop& probe) const;
    /// The request asks for it: its area, its slopes, what is left of the stock.
    bool isWanted(const SurfacePlace& place, TipDrop& probe) const;
    /// Nothing but the flutes meets stock, and these no more than they bear.
    bool isPossible(const SurfacePlace& place) const;

    /// The stretches of a row that are wanted and possible. @param leftOut mm that were wanted alone are added to it
    std::vector<TipLine> along(const PlanRow& row, double& leftOut) const;

    /// The same of a line of tips that lie on the part.
    std::vector<TipLine> stretchesOf(const TipLine& line, double& leftOut) const;

    /// The area of the request, or the part, and as far beside it as the tool touches it.
    PlanBounds bounds() const;

private:
    class Stretches;
    bool isInArea(const SurfacePlace& place, TipDrop& probe) const;
    void between(const SurfacePlace& first, const SurfacePlace& last, TipDrop& probe,
                 const std::function<void(const SurfacePlace&)>& add) const;

    const PassRequest& request_;
    const PassGround& ground_;
    std::vector<RevolvedPiece> pieces_;
    WorkpieceHeights heights_;
    double bottom_;
};

/// Whether the flutes at a tip would take away stock that is more than 0.1 mm high, as the workpiece's scanlines have
/// it: what lies between two of them is not seen.
bool isRest(const WorkpieceHeights& heights, const PassGround& ground, const glm::dvec3& tip) noexcept;

/// Without the places that lie on the straight way between their neighbours, within 0.0005 mm.
TipLine straightened(const TipLine& line);

} // namespace burin

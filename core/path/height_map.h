// SPDX-FileCopyrightText: 2026 The Burin authors
// SPDX-License-Identifier: Apache-2.0
#pragma once

#include "core/geometry/arc.h"
#include "core/geometry/box.h"
#include "core/geometry/revolved_piece.h"
#include "core/tool/tool.h"

#include <limits>
#include <span>
#include <vector>

namespace burin {

/// Height map (z-map) of the stock: for each grid square the height above which it is known to be empty, because flutes
/// have passed there. Conservative on both sides: a square is lowered only by what the flutes certainly swept over all
/// of it, and a tool is supported by the highest square that it may touch. Outside the stock nothing supports a tool.
class HeightMap {
public:
    /// @param pieces of the tool, upright, in order from below, flutes first
    /// @param fluteCount number of pieces that are flutes, > 0
    /// @param hollow Cutter::hollow: what lies in it is not taken to be cleared
    HeightMap(const Box& stock, std::span<const RevolvedPiece> pieces, std::size_t fluteCount,
              const HollowSpace& hollow = {});

    /// Takes over what another map of the same stock knows to be empty; its squares may be larger or smaller.
    void include(const HeightMap& before);

    /// Records that the flutes moved straight from one tip position to another.
    void cut(const glm::dvec3& from, const glm::dvec3& to);
    /// The same along an arc.
    void cut(const Arc& arc);

    /// The lowest tip above (x, y) at which the whole tool is in empty space, mm; very low outside the stock.
    double freeHeight(double x, double y) const { return restingHeight(x, y, pieces_, stock_.low.z - 1e3); }
    /// The same for the parts of flutes, shank and holder within `radius` of the axis, mm.
    double freeHeightWithin(double radius, double x, double y) const {
        return restingHeight(x, y, pieces_, stock_.low.z - 1e3, 0.0, radius);
    }
    /// The same all along a straight move in plan. Between two samples the squares are taken to be nearer by half of
    /// the distance between the samples.
    double freeHeight(const glm::dvec3& from, const glm::dvec3& to) const;
    /// The height above which the stock is empty at a point, mm; very low outside the stock.
    double heightAt(const glm::dvec3& place) const;
    /// The height to which the tip has to rise, mm, until everything above the flutes is empty, so that they cut
    /// nothing higher up. In stock deeper than the flutes are long, only a neck has been above them.
    double risenHeight(const glm::dvec3& tip) const;
    /// Whether shank and holder are in empty space.
    bool shankIsFree(const glm::dvec3& tip) const {
        return restingHeight(tip.x, tip.y, std::span(pieces_).subspan(fluteCount_), tip.z) <= tip.z;
    }

private:
    void cutAt(const glm::dvec3& tip);
    /// The lowest tip, not below `floor`, at which the pieces are in empty space, even if displaced sideways by
    /// `slack`; what is farther than `radius` from the axis is ignored.
    double restingHeight(double x, double y, std::span<const RevolvedPiece> pieces, double floor, double slack = 0.0,
                         double radius = std::numeric_limits<double>::infinity()) const;
    /// Indices of the squares that a circle may touch, along one axis.
    struct Range {
        long first, last;
    };
    Range range(double centre, double radius, int axis) const;
    double& height(long i, long j) { return heights_[static_cast<std::size_t>(j * countX_ + i)]; }
    double height(long i, long j) const { return heights_[static_cast<std::size_t>(j * countX_ + i)]; }

    Box stock_;
    std::vector<RevolvedPiece> pieces_;
    std::size_t fluteCount_ = 1;
    HollowSpace hollow_;
    double edge_; // of a square, mm
    long countX_, countY_;
    std::vector<double> heights_;
};

} // namespace burin

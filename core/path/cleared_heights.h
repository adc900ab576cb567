// SPDX-FileCopyrightText: 2026 The Burin authors
// SPDX-License-Identifier: Apache-2.0
#pragma once

#include "core/geometry/arc.h"
#include "core/geometry/box.h"
#include "core/geometry/revolved_piece.h"

#include <limits>
#include <span>
#include <vector>

namespace burin {

/// Above which height each little square of the stock is known to be empty, because flutes went there. Conservative on
/// both sides: a square is lowered only by what the flutes surely swept over all of it, and a tool is held up by the
/// highest square that it may touch. Beside the stock nothing holds a tool up.
class ClearedHeights {
public:
    /// @param pieces     of the tool, upright, flutes first, from below
    /// @param fluteCount how many of them are flutes, > 0
    ClearedHeights(const Box& stock, std::span<const RevolvedPiece> pieces, std::size_t fluteCount);

    /// What another map of the same stock knows to be empty is empty here too; its squares may be larger or smaller.
    void include(const ClearedHeights& before);

    /// The flutes went straight from one tip to another.
    void cut(const glm::dvec3& from, const glm::dvec3& to);
    /// The same along an arc.
    void cut(const Arc& arc);

    /// The lowest tip above (x, y) at which the whole tool is in empty space, mm; very low beside the stock.
    double freeHeight(double x, double y) const { return restingHeight(x, y, pieces_, stock_.low.z - 1e3); }
    /// The same for flutes, shank and holder no farther than `radius` from the axis, mm.
    double freeHeightWithin(double radius, double x, double y) const {
        return restingHeight(x, y, pieces_, stock_.low.z - 1e3, 0.0, radius);
    }
    /// The same all along a straight way in plan; the squares that the tool passes between two looks are held to be as
    /// near as half of the way between them.
    double freeHeight(const glm::dvec3& from, const glm::dvec3& to) const;
    /// Above which height it is empty there, mm; very low beside the stock.
    double heightAt(const glm::dvec3& place) const;
    /// How far the flutes have to rise from a tip until what is above them is empty, so that they cut nothing farther
    /// up: the height of the tip then, mm. Above more than their own length of stock only a neck has been.
    double risenHeight(const glm::dvec3& tip) const;
    /// Whether shank and holder are in empty space.
    bool shankIsFree(const glm::dvec3& tip) const {
        return restingHeight(tip.x, tip.y, std::span(pieces_).subspan(fluteCount_), tip.z) <= tip.z;
    }

private:
    void cutAt(const glm::dvec3& tip);
    /// The lowest tip, not below `floor`, at which the pieces are in empty space, also where it is aside by `slack`;
    /// what is farther than `radius` from the axis does not count.
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
    double edge_; // of a square, mm
    long countX_, countY_;
    std::vector<double> heights_;
};

} // namespace burin

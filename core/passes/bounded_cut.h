// SPDX-FileCopyrightText: 2026 The Burin authors
// SPDX-License-Identifier: Apache-2.0
#pragma once

#include "core/geometry/plan_region.h"
#include "core/passes/pass_ground.h"
#include "core/passes/workpiece_heights.h"

#include <cstddef>
#include <cstdint>
#include <deque>
#include <functional>
#include <optional>
#include <vector>

namespace burin {

/// What stands on a level, seen in plan on fine squares: how much of it a round tool takes.
class StandingPlan {
public:
    /// @param radius of the tool, mm
    StandingPlan(const WorkpieceHeights& heights, double level, double radius);

    using Taken = std::vector<std::size_t>; ///< squares
    /// Takes what the tool covers at a point; returns its area, mm².
    double take(const glm::dvec2& place, Taken& taken);
    void giveBack(const Taken& taken);
    /// What the tool would take, as a share of the area that it covers there.
    double shareAt(const glm::dvec2& place);

private:
    glm::dvec2 low_{0.0};
    double edge_ = 0.0, radius_ = 0.0; // mm
    int columns_ = 0, rows_ = 0;
    std::vector<std::uint8_t> stands_;
};

/// Answers quickly whether a region holds a point, by rows of its edges.
class RowedRegion {
public:
    /// @param low, high mm: y between which points are asked for; elsewhere nothing is held
    RowedRegion(const PlanRegion& region, double low, double high);
    bool holds(const glm::dvec2& place) const noexcept;

private:
    struct Edge {
        glm::dvec2 from{0.0}, to{0.0};
    };
    double low_;
    std::vector<std::vector<Edge>> rows_;
};

/// Follows the runs of one level so that the tool takes no more than a width: where a run would cut wider (the first
/// loop of a closed pocket, an inner corner, the way to the next loop), the tool goes in circles beside it, to its left
/// and tangent to it, each so little farther on that it keeps to the width; into material it comes down on a helix of
/// such circles. Circles are anticlockwise, climb cuts like the runs.
class BoundedCut {
public:
    struct Values {
        double level = 0.0;   ///< mm, height of the tip
        double depth = 0.0;   ///< mm of stock above the level, at most
        double radius = 0.0;  ///< mm, of the tool
        double width = 0.0;   ///< mm, that a run cuts beside its neighbour; the largest radius of circles
        double most = 0.0;    ///< mm, the bound of the width: `width`, more on levels that are not as deep as others
        double spacing = 0.0; ///< mm between points
    };
    /// Where circles may be on the level, by their centre, mm, and radius, mm.
    using HasRoom = std::function<bool(const glm::dvec2& centre, double radius)>;
    /// @param heights has to outlive it
    BoundedCut(const Values& values, const WorkpieceHeights& heights, HasRoom hasRoom);

    /// Whether a run would still take anything worth it.
    bool cuts(const std::vector<glm::dvec2>& run);
    /// The point at which a closed run is best begun from above: the first one, unless that is in material and another
    /// one has more room for a helix.
    std::size_t entryOf(const std::vector<glm::dvec2>& closed);
    /// The tips along a run, which is then cut. @param joined the tool is at its first point, which is left out of the
    /// result; otherwise it comes from above
    TipLine along(const std::vector<glm::dvec2>& run, bool joined);

private:
    struct Circle {
        glm::dvec2 centre{0.0}, forward{0.0};
        double radius = 0.0;
    };
    struct Spot {
        glm::dvec2 place{0.0}, forward{0.0};
    };
    /// A run by its lengths.
    class Course {
    public:
        explicit Course(const std::vector<glm::dvec2>& places);
        double length() const noexcept { return ends_.back(); } ///< mm
        Spot at(double way) const;
        /// Its points behind a length, and the one at another.
        std::vector<glm::dvec2> between(double from, double to) const;

    private:
        std::vector<glm::dvec2> places_;
        std::vector<double> ends_; ///< mm, length up to each point
    };
    /// A piece of the way that the tool goes.
    struct Cut {
        double length = 0.0; ///< mm
        double area = 0.0;   ///< mm², that it takes there
    };
    void remember(const Cut& cut);
    std::vector<Circle> circlesAt(const Spot& spot) const;
    std::vector<glm::dvec2> waysRound(const glm::dvec2& from, const Circle& circle) const;
    double widest(const std::vector<glm::dvec2>& way, const glm::dvec2& from, StandingPlan::Taken& taken);
    bool descend(const Spot& spot, TipLine& tips);
    std::optional<double> circleOn(const Course& course, double done, double straight, TipLine& tips);
    bool followed(const Course& course, double from, double to, TipLine& tips);
    void go(const std::vector<glm::dvec2>& way, TipLine& tips);

    Values values_;
    const WorkpieceHeights& heights_;
    HasRoom hasRoom_;
    StandingPlan plan_;
    std::deque<Cut> recent_; ///< of the way that was gone last
    std::vector<Cut> cuts_;  ///< in use while a way is measured
};

} // namespace burin

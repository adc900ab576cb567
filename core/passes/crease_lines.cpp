// SPDX-FileCopyrightText: 2026 The Burin authors
// SPDX-License-Identifier: Apache-2.0
#include "core/passes/crease_lines.h"

#include "core/base/parallel.h"
#include "core/base/parallel_progress.h"
#include "core/base/units.h"
#include "core/geometry/segment.h"

#include <algorithm>
#include <array>
#include <cmath>
#include <map>
#include <optional>

namespace burin {
namespace {

constexpr double leastTurn = 20.0 * pi / 180.0; // rad: a smaller bend is a fillet that the cutter rolls through
constexpr double precision = 1e-3;              // mm, across a crease
constexpr double chordError = 0.002;            // mm
constexpr double closest = 0.04;                // mm between points

/// A sample of the surface of tips.
struct Look {
    SurfacePlace place;
    glm::dvec3 away{0.0, 0.0, 1.0}; ///< unit vector out of the part
};

/// Finds where a straight line over the surface of tips crosses a crease. Not thread-safe.
class CreaseSearch {
public:
    explicit CreaseSearch(const SurfaceTrace& trace) : trace_(trace), probe_(trace.probe()) {}

    Look look(const glm::dvec2& at) {
        const SurfacePlace place = trace_.at(at, probe_);
        return {place, place.onPart ? probe_.touch(place.tip).away : glm::dvec3(0.0, 0.0, 1.0)};
    }

    /// The point on the lower side of the sharpest crease that the samples at both ends of a line indicate.
    std::optional<glm::dvec3> between(Look from, Look to) {
        const auto plan = [](const Look& look) { return glm::dvec2(look.place.tip); };
        while (true) {
            if (turn(from, to) < leastTurn) return {};
            if (glm::distance(plan(from), plan(to)) <= precision) break;
            const Look middle = look(0.5 * (plan(from) + plan(to)));
            (turn(from, middle) >= turn(middle, to) ? to : from) = middle;
        }
        const Look& lower = from.place.tip.z <= to.place.tip.z ? from : to;
        // At the bottom, beside the part, only the part itself counts as touched.
        if (!lower.place.onPart) return {};
        return lower.place.tip;
    }

private:
    /// The angle by which the surface of tips turns upwards between two samples, rad, including a jump between them, as
    /// at a wall.
    static double turn(const Look& from, const Look& to) {
        const glm::dvec2 way = glm::dvec2(to.place.tip - from.place.tip);
        const double length = glm::length(way);
        const auto slope = [&](const Look& look) {
            return std::atan2(-glm::dot(glm::dvec2(look.away), way) / length, std::max(look.away.z, 0.0));
        };
        const double first = slope(from), last = slope(to);
        const double chord = std::atan2(to.place.tip.z - from.place.tip.z, length);
        return std::max({last - first, chord - first, last - chord});
    }

    const SurfaceTrace& trace_;
    TipDrop probe_;
};

/// Samples a raster, and links the crossings on the sides of its squares.
class CreaseRaster {
public:
    CreaseRaster(const SurfaceTrace& trace, double raster, Progress& progress)
        : trace_(trace), raster_(raster), progress_(progress), bounds_(trace.bounds()) {
        columns_ = static_cast<int>(std::ceil((bounds_.high.x - bounds_.low.x) / raster)) + 1;
        rows_ = static_cast<int>(std::ceil((bounds_.high.y - bounds_.low.y) / raster)) + 1;
    }

    std::vector<TipLine> lines() {
        findCrossings();
        if (progress_.cancelled()) return {};
        link();
        std::vector<TipLine> lines = chains();
        parallelFor(std::size_t{0}, lines.size(), [&](std::size_t i) {
            if (!progress_.cancelled()) lines[i] = refined(lines[i]);
        });
        return lines;
    }

private:
    struct Node {
        glm::dvec3 place{0.0};
        std::vector<std::size_t> next;
    };
    glm::dvec2 placeOf(int column, int row) const { return bounds_.low + raster_ * glm::dvec2(column, row); }
    std::size_t indexOf(int column, int row) const {
        return static_cast<std::size_t>(row) * static_cast<std::size_t>(columns_) + static_cast<std::size_t>(column);
    }
    /// Index of the edge from a point to its neighbour along x, or along y.
    std::size_t edgeOf(int column, int row, bool upwards) const { return indexOf(column, row) * 2 + (upwards ? 1 : 0); }

    std::vector<Look> lookAround() const {
        std::vector<Look> looks(indexOf(0, rows_));
        ParallelProgress done(progress_, static_cast<std::size_t>(rows_));
        parallelFor(0, rows_, [&](int row) {
            if (progress_.cancelled()) return;
            CreaseSearch search(trace_);
            for (int column = 0; column < columns_; ++column)
                looks[indexOf(column, row)] = search.look(placeOf(column, row));
            done.add();
        });
        return looks;
    }

    void findCrossings() {
        std::vector<std::optional<glm::dvec3>> found(static_cast<std::size_t>(columns_) *
                                                     static_cast<std::size_t>(rows_) * 2);
        const std::vector<Look> looks = lookAround();
        parallelFor(0, rows_, [&](int row) {
            if (progress_.cancelled()) return;
            CreaseSearch search(trace_);
            for (int column = 0; column < columns_; ++column) {
                const Look& here = looks[indexOf(column, row)];
                if (column + 1 < columns_)
                    found[edgeOf(column, row, false)] = search.between(here, looks[indexOf(column + 1, row)]);
                if (row + 1 < rows_)
                    found[edgeOf(column, row, true)] = search.between(here, looks[indexOf(column, row + 1)]);
            }
        });
        for (std::size_t edge = 0; edge < found.size(); ++edge) {
            if (!found[edge]) continue;
            nodeOn_[edge] = nodes_.size();
            nodes_.push_back({*found[edge], {}});
        }
    }

    /// Links the crossings on the sides of each square, the nearest first, without closing a ring.
    void link() {
        for (int row = 0; row + 1 < rows_; ++row)
            for (int column = 0; column + 1 < columns_; ++column) {
                std::vector<std::size_t> of;
                for (const std::size_t edge : {edgeOf(column, row, false), edgeOf(column + 1, row, true),
                                               edgeOf(column, row + 1, false), edgeOf(column, row, true)})
                    if (const auto node = nodeOn_.find(edge); node != nodeOn_.end()) of.push_back(node->second);
                join(of);
            }
    }
    void join(std::vector<std::size_t> apart) {
        if (apart.size() < 2) return;
        std::vector<std::size_t> joined{apart.back()};
        apart.pop_back();
        while (!apart.empty()) {
            std::size_t from = 0, to = 0;
            double least = 1e300;
            for (std::size_t i = 0; i < joined.size(); ++i)
                for (std::size_t k = 0; k < apart.size(); ++k) {
                    const double way = glm::distance(nodes_[joined[i]].place, nodes_[apart[k]].place);
                    if (!(way < least)) continue;
                    least = way;
                    from = i;
                    to = k;
                }
            nodes_[joined[from]].next.push_back(apart[to]);
            nodes_[apart[to]].next.push_back(joined[from]);
            joined.push_back(apart[to]);
            apart.erase(apart.begin() + static_cast<std::ptrdiff_t>(to));
        }
    }

    /// Follows lines from one end or fork to the next, then the closed ones.
    std::vector<TipLine> chains() {
        std::vector<TipLine> lines;
        const auto follow = [&](std::size_t node) {
            while (!nodes_[node].next.empty()) {
                TipLine& line = lines.emplace_back(TipLine{nodes_[node].place});
                std::size_t at = node;
                do {
                    const std::size_t to = nodes_[at].next.back();
                    nodes_[at].next.pop_back();
                    std::erase(nodes_[to].next, at);
                    line.push_back(nodes_[to].place);
                    at = to;
                } while (nodes_[at].next.size() == 1);
            }
        };
        for (std::size_t i = 0; i < nodes_.size(); ++i)
            if (nodes_[i].next.size() != 2) follow(i);
        for (std::size_t i = 0; i < nodes_.size(); ++i) follow(i);
        return lines;
    }

    /// Inserts points where the crease bends.
    TipLine refined(const TipLine& line) const {
        CreaseSearch search(trace_);
        TipLine fine{line.front()};
        for (std::size_t i = 1; i < line.size(); ++i) {
            refine(search, line[i - 1], line[i], fine);
            fine.push_back(line[i]);
        }
        return fine;
    }
    void refine(CreaseSearch& search, const glm::dvec3& from, const glm::dvec3& to, TipLine& fine) const {
        const glm::dvec2 way = glm::dvec2(to - from);
        const double length = glm::length(way);
        if (length < closest) return;
        const glm::dvec3 middle = 0.5 * (from + to);
        const glm::dvec2 across = 0.25 * glm::dvec2(-way.y, way.x);
        const auto place =
            search.between(search.look(glm::dvec2(middle) - across), search.look(glm::dvec2(middle) + across));
        if (!place || distanceToSegment(*place, from, to) <= chordError) return;
        refine(search, from, *place, fine);
        fine.push_back(*place);
        refine(search, *place, to, fine);
    }

    const SurfaceTrace& trace_;
    double raster_;
    Progress& progress_;
    PlanBounds bounds_;
    int columns_ = 0, rows_ = 0;
    std::map<std::size_t, std::size_t> nodeOn_;
    std::vector<Node> nodes_;
};

} // namespace

std::vector<TipLine> creaseLines(const SurfaceTrace& trace, double raster, Progress& progress) {
    return CreaseRaster(trace, raster, progress).lines();
}

} // namespace burin

// SPDX-FileCopyrightText: 2026 The Burin authors
// SPDX-License-Identifier: Apache-2.0
#include "core/base/parallel.h"
#include "core/base/parallel_progress.h"
#include "core/passes/hand_finish.h"
#include "core/passes/near_segments.h"
#include "core/passes/raster_borders.h"
#include "core/passes/surface_distance.h"
#include "core/passes/surface_pass.h"

#include <algorithm>
#include <cmath>
#include <iterator>
#include <limits>
#include <optional>

namespace burin {
namespace {

constexpr double leastUpwards = 0.2588; // z of the unit vector out of the part: 75 degrees
constexpr double mostSquares = 1500.0;  // along a side of the raster
constexpr double gap = 0.58;            // of the step-over: distance from the middle between two rows to the next one
// of the distance of the tips: where the tool rolls around an edge it cuts next to nothing
constexpr double leastShare = 0.3;
constexpr double closeBy = 6.0;          // squares around a stroke whose distance from it is measured directly
constexpr double smoothSpan = 0.25;      // of the tool's radius: from one exact sample of a smooth surface to the next
constexpr double leastAgreement = 0.995; // cosine of the largest turn of a smooth surface between two samples
constexpr double smoothWithin = 0.002;   // mm

/// Rows at even distances on a surface of tips: from the border of the area inwards, or from strokes of the hand
/// outwards.
class ScallopRows {
public:
    /// @param hand null: from the border
    ScallopRows(const SurfaceTrace& trace, double stepOver, double coarseness, bool ball, const HandFinish* hand,
                Progress& progress)
        : trace_(trace), step_(stepOver), ball_(ball), hand_(hand), progress_(progress), bounds_(trace.bounds()) {
        if (hand_ != nullptr) bounds_ = {bounds_.low - 2.0 * stepOver, bounds_.high + 2.0 * stepOver};
        const glm::dvec2 size = bounds_.high - bounds_.low;
        edge_ = std::max(std::clamp(0.5 * stepOver, 0.1, 0.3 * coarseness), std::max(size.x, size.y) / mostSquares);
        surface_.columns = static_cast<int>(std::ceil(size.x / edge_)) + 1;
        surface_.rows = static_cast<int>(std::ceil(size.y / edge_)) + 1;
    }

    std::vector<PlanRow> rows() {
        look();
        if (progress_.cancelled()) return {};
        const auto length = [this](std::size_t one, std::size_t other) { return lengthBetween(one, other); };
        distance_ = hand_ != nullptr ? distancesFrom(surface_, length, besideStrokes())
                                     : distancesFromBorder(surface_, length, 0.5 * edge_);
        const double farthest = distance_.empty() ? 0.0 : *std::ranges::max_element(distance_);
        const auto count = static_cast<std::size_t>(std::max(0.0, std::ceil((farthest - levelOf(0)) / step_)));
        std::vector<std::vector<PlanRing>> rings(count + 1); // the last is empty
        parallelFor(std::size_t{0}, count, [&](std::size_t i) { rings[i] = ringsAt(levelOf(i)); });
        std::vector<std::vector<PlanRow>> rowsAt(count);
        parallelFor(std::size_t{0}, count, [&](std::size_t i) {
            if (progress_.cancelled()) return;
            NearSegments next(step_);
            for (const PlanRing& ring : rings[i + 1]) next.addRing(ring);
            for (const PlanRing& ring : ringsAt(levelOf(i) + 0.5 * step_)) addGaps(ring, next, rowsAt[i]);
            for (const PlanRing& ring : rings[i]) rowsAt[i].push_back(closed(ring));
            if (hand_ != nullptr) rowsAt[i] = withoutMargin(rowsAt[i]);
        });
        std::vector<PlanRow> rows;
        for (std::vector<PlanRow>& level : rowsAt) std::ranges::move(level, std::back_inserter(rows));
        return inOrder(std::move(rows));
    }

private:
    /// Distance of a row, mm: the first is half a step from the border, or a step from a stroke.
    double levelOf(std::size_t row) const {
        return (static_cast<double>(row) + (hand_ != nullptr ? 1.0 : 0.5)) * step_;
    }
    /// The distances of the points close to strokes; infinite for all others.
    std::vector<double> besideStrokes() const {
        std::vector<double> distances(samples_.size(), std::numeric_limits<double>::infinity());
        parallelFor(std::size_t{0}, samples_.size(), [&](std::size_t i) {
            if (const auto near = hand_->nearest(samples_[i].tip, closeBy * edge_)) distances[i] = near->distance;
        });
        return distances;
    }
    /// Rows from strokes lead out of the raster: borders of the raster itself, which close them, are no rows.
    std::vector<PlanRow> withoutMargin(const std::vector<PlanRow>& rows) const {
        const glm::dvec2 low = bounds_.low + 0.6 * edge_;
        const glm::dvec2 high = bounds_.low + edge_ * (glm::dvec2(surface_.columns, surface_.rows) - 1.6);
        std::vector<PlanRow> kept;
        for (const PlanRow& row : rows) {
            bool open = false;
            for (const glm::dvec2& place : row) {
                const bool inside = place.x > low.x && place.y > low.y && place.x < high.x && place.y < high.y;
                if (inside && !open) kept.emplace_back();
                open = inside;
                if (inside) kept.back().push_back(place);
            }
        }
        std::erase_if(kept, [](const PlanRow& row) { return row.size() < 2; });
        return kept;
    }
    /// Samples the surface: exactly on a coarse raster, then between its points, where it is smooth, by them. The rows
    /// themselves are exact everywhere.
    void look() {
        const std::size_t count = static_cast<std::size_t>(surface_.columns) * static_cast<std::size_t>(surface_.rows);
        surface_.on.assign(count, 0);
        samples_.assign(count, {});
        int coarse = 1;
        while (2 * coarse * edge_ <= smoothSpan * trace_.cutterRadius()) coarse *= 2;
        double done = 0.0;
        for (int step = coarse; step >= 1 && !progress_.cancelled(); step /= 2) {
            const ProgressPart part(progress_, done, done + (step > 1 ? 0.4 * (1.0 - done) : 1.0 - done));
            done += 0.4 * (1.0 - done);
            lookEvery(step, step == coarse);
        }
    }
    /// @param first no coarser raster has been sampled
    void lookEvery(int step, bool first) {
        const int lines = (surface_.rows - 1) / step + 1;
        ParallelProgress done(progress_, static_cast<std::size_t>(lines));
        parallelFor(0, lines, [&](int line) {
            if (progress_.cancelled()) return;
            TipDrop probe = trace_.probe();
            const int row = line * step, twice = 2 * step;
            for (int column = 0; column < surface_.columns; column += step) {
                const glm::ivec2 odd(column % twice, row % twice);
                if (!first && odd == glm::ivec2(0)) continue;
                std::optional<Sampled> found;
                if (!first && odd != glm::ivec2(step)) found = between({column, row}, odd);
                if (!first && odd == glm::ivec2(step)) {
                    found = between({column, row}, {step, step});
                    if (found && !between({column, row}, {step, -step})) found.reset();
                }
                take(surface_.indexOf(column, row), found ? *found : lookAt(column, row, probe));
            }
            done.add();
        });
    }

    /// A sample of the surface of tips.
    struct Sampled {
        glm::dvec3 tip{0.0}, touched{0.0}; ///< mm; beside the part both are the tip
        glm::vec3 away{0.0f, 0.0f, 1.0f};  ///< unit vector out of the part
        bool onPart = false;
    };
    Sampled lookAt(int column, int row, TipDrop& probe) const {
        const SurfacePlace place = trace_.at(bounds_.low + edge_ * glm::dvec2(column, row), probe);
        if (!place.onPart) return {place.tip, place.tip};
        const ToolClearance touch = probe.touch(place.tip);
        return {place.tip, touch.meshPoint, touch.away, true};
    }
    /// The sample in the middle between two, if the surface is smooth there: a cubic with their heights and slopes, on
    /// which the difference of heights has to agree with the slopes.
    std::optional<Sampled> between(const glm::ivec2& at, const glm::ivec2& way) const {
        const glm::ivec2 from = at - way, to = at + way;
        if (glm::any(glm::lessThan(glm::min(from, to), glm::ivec2(0))) ||
            glm::any(glm::greaterThanEqual(glm::max(from, to), glm::ivec2(surface_.columns, surface_.rows))))
            return {};
        const Sampled &one = samples_[surface_.indexOf(from.x, from.y)],
                      &other = samples_[surface_.indexOf(to.x, to.y)];
        if (one.onPart != other.onPart) return {};
        Sampled middle{0.5 * (one.tip + other.tip), 0.5 * (one.touched + other.touched), one.away, one.onPart};
        if (!one.onPart) return middle; // nothing is narrower than the tool
        const glm::dvec3 away(one.away), next(other.away);
        if (glm::dot(away, next) < leastAgreement || std::min(away.z, next.z) < 0.5 * leastUpwards) return {};
        const glm::dvec2 span(other.tip - one.tip);
        const double first = -glm::dot(glm::dvec2(away), span) / away.z;
        const double last = -glm::dot(glm::dvec2(next), span) / next.z;
        if (std::abs(other.tip.z - one.tip.z - 0.5 * (first + last)) > smoothWithin) return {};
        middle.tip.z += (first - last) / 8.0;
        middle.away = glm::normalize(away + next);
        return middle;
    }
    void take(std::size_t i, const Sampled& sample) {
        samples_[i] = sample;
        // Rows from strokes are cut to the area later, so that they meet its border in any direction.
        if (hand_ != nullptr) {
            surface_.on[i] = 1;
        } else if (sample.onPart && sample.away.z >= leastUpwards) {
            ToolClearance touch;
            touch.meshPoint = sample.touched;
            touch.away = sample.away;
            surface_.on[i] = trace_.isRequested({sample.tip, true}, touch) ? 1 : 0;
        }
    }

    /// A ball leaves a ridge of s·t / 8R between two rows whose tips are s apart and whose contact points are t apart,
    /// on plane, convex and concave faces alike: the geometric mean of both has to be even.
    double lengthBetween(std::size_t one, std::size_t other) const {
        const double tips = glm::distance(samples_[one].tip, samples_[other].tip);
        if (!ball_) return tips;
        const double touched = glm::distance(samples_[one].touched, samples_[other].touched);
        return std::max(leastShare * tips, std::sqrt(tips * touched));
    }

    std::vector<PlanRing> ringsAt(double level) const {
        std::vector<double> room(distance_.size());
        for (std::size_t i = 0; i < room.size(); ++i) room[i] = level - distance_[i];
        std::vector<PlanRing> rings = bordersOf(room, surface_.columns, surface_.rows, level);
        for (PlanRing& ring : rings)
            for (glm::dvec2& place : ring) place = bounds_.low + edge_ * place;
        return rings;
    }
    static PlanRow closed(PlanRing ring) {
        ring.push_back(ring.front());
        return ring;
    }

    /// Fills gaps where rows bend sharply or rows from two sides meet, and the next row is therefore farther away than
    /// a step: with part of a row half a step on. @param ring half a step on
    void addGaps(const PlanRing& ring, const NearSegments& next, std::vector<PlanRow>& rows) const {
        std::vector<char> lacks(ring.size(), 0);
        for (std::size_t i = 0; i < ring.size(); ++i) {
            if (!leavesGap(ring[i], next)) continue;
            for (const std::size_t k : {i + ring.size() - 1, i, i + 1}) lacks[k % ring.size()] = 1;
        }
        const auto first = std::ranges::find(lacks, 0);
        if (first == lacks.end()) return rows.push_back(closed(ring));
        const auto start = static_cast<std::size_t>(first - lacks.begin());
        for (std::size_t i = 0, open = 0; i < ring.size(); ++i) {
            const std::size_t at = (start + i) % ring.size();
            if (lacks[at] && !open) rows.emplace_back();
            if (lacks[at]) rows.back().push_back(ring[at]);
            open = lacks[at] ? 1 : 0;
        }
    }
    bool leavesGap(const glm::dvec2& place, const NearSegments& next) const {
        return !next.anyWithin(place, gap * step_ / std::max(steepnessAt(place), 1e-6)); // mm in plan
    }
    /// The largest increase of the distance per mm in plan; on a ridge that of the steeper side.
    double steepnessAt(const glm::dvec2& place) const {
        const glm::dvec2 at = (place - bounds_.low) / edge_;
        const int column = std::clamp(static_cast<int>(std::lround(at.x)), 1, surface_.columns - 2);
        const int row = std::clamp(static_cast<int>(std::lround(at.y)), 1, surface_.rows - 2);
        const auto near = [&](int right, int up) { return distance_[surface_.indexOf(column + right, row + up)]; };
        const double here = near(0, 0);
        const double x = std::max(std::abs(near(1, 0) - here), std::abs(near(-1, 0) - here));
        const double y = std::max(std::abs(near(0, 1) - here), std::abs(near(0, -1) - here));
        return std::hypot(x, y) / edge_;
    }

    /// Orders the rows by nearest neighbour; closed ones begin at their nearest point.
    static std::vector<PlanRow> inOrder(std::vector<PlanRow> rows) {
        std::vector<PlanRow> ordered;
        while (!rows.empty()) {
            std::size_t next = 0, start = 0;
            double least = 1e300;
            for (std::size_t i = 0; i < rows.size() && !ordered.empty(); ++i) {
                const bool ring = rows[i].front() == rows[i].back();
                for (std::size_t k = 0; k < rows[i].size(); k += ring ? 1 : rows[i].size() - 1) {
                    const double way = glm::distance(rows[i][k], ordered.back().back());
                    if (!(way < least)) continue;
                    least = way;
                    next = i;
                    start = k;
                }
            }
            PlanRow row = std::move(rows[next]);
            rows.erase(rows.begin() + static_cast<std::ptrdiff_t>(next));
            if (row.front() == row.back()) {
                row.pop_back();
                std::ranges::rotate(row, row.begin() + static_cast<std::ptrdiff_t>(start % row.size()));
                row.push_back(row.front());
            } else if (start > 0) {
                std::ranges::reverse(row);
            }
            ordered.push_back(std::move(row));
        }
        return ordered;
    }

    const SurfaceTrace& trace_;
    double step_;
    bool ball_;
    const HandFinish* hand_;
    Progress& progress_;
    PlanBounds bounds_;
    double edge_ = 0.0; // mm
    SurfaceRaster surface_;
    std::vector<Sampled> samples_; // by point
    std::vector<double> distance_; // mm, by point
};

} // namespace

std::vector<PlanRow> scallopRows(const SurfaceTrace& trace, double stepOver, double coarseness, bool ball,
                                 Progress& progress) {
    return ScallopRows(trace, stepOver, coarseness, ball, nullptr, progress).rows();
}

std::vector<PlanRow> extendedRows(const SurfaceTrace& trace, const HandFinish& hand, double stepOver, double coarseness,
                                  bool ball, Progress& progress) {
    return ScallopRows(trace, stepOver, coarseness, ball, &hand, progress).rows();
}

} // namespace burin

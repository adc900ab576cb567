// SPDX-FileCopyrightText: 2026 The Burin authors
// SPDX-License-Identifier: Apache-2.0
#include "core/base/numbers.h"
#include "core/base/parallel.h"
#include "core/base/units.h"
#include "core/geometry/segment.h"
#include "core/passes/near_segments.h"
#include "core/passes/surface_pass.h"

#include <algorithm>
#include <cmath>
#include <optional>
#include <utility>

namespace burin {
namespace {

constexpr double spiralChord = 0.002; // mm between a spiral and its chords

std::vector<PlanRow> parallelRows(const PassRequest& request, const PlanBounds& bounds, double stepOver) {
    const glm::dvec2 along(std::cos(request.direction), std::sin(request.direction)), across(-along.y, along.x);
    glm::dvec2 low(1e300), high(-1e300); // in coordinates along and across the rows
    for (const double x : {bounds.low.x, bounds.high.x})
        for (const double y : {bounds.low.y, bounds.high.y}) {
            const glm::dvec2 seen(glm::dot(glm::dvec2(x, y), along), glm::dot(glm::dvec2(x, y), across));
            low = glm::min(low, seen);
            high = glm::max(high, seen);
        }
    const int intervals = std::max(1, static_cast<int>(std::ceil((high.y - low.y) / stepOver - 1e-9)));
    std::vector<PlanRow> rows;
    for (int i = 0; i <= intervals; ++i) {
        const double side = low.y + (high.y - low.y) * i / intervals;
        rows.push_back({low.x * along + side * across, high.x * along + side * across});
    }
    return rows;
}

/// The point that radial rows and spirals go around: the first point of the first line, or the middle.
glm::dvec2 centreOf(const PassRequest& request, const PlanBounds& bounds) {
    return request.lines.empty() ? 0.5 * (bounds.low + bounds.high) : glm::dvec2(request.lines.front().front());
}

double farthestFrom(const glm::dvec2& centre, const PlanBounds& bounds) {
    return glm::length(glm::max(glm::abs(bounds.low - centre), glm::abs(bounds.high - centre)));
}

/// Towards the centre, every second row ends where the rows next to it are close enough.
std::vector<PlanRow> radialRows(const PassRequest& request, const PlanBounds& bounds, double stepOver) {
    const glm::dvec2 centre = centreOf(request, bounds);
    const double reach = farthestFrom(centre, bounds);
    int count = 8; // a power of two, so that every second row can end, repeatedly
    while (2.0 * pi * reach / count > stepOver) count *= 2;
    std::vector<PlanRow> rows;
    for (int i = 0; i < count; ++i) {
        int among =
            i == 0 ? count : i & -i; // it is one of every `among` rows: the power of two that divides its number
        among = std::min(among, count);
        const double begin = among == count ? 0.0 : stepOver * count / (2.0 * pi * 2.0 * among);
        if (begin >= reach) continue;
        const double angle = 2.0 * pi * i / count;
        const glm::dvec2 out(std::cos(angle), std::sin(angle));
        rows.push_back({centre + begin * out, centre + reach * out});
    }
    return rows;
}

/// An Archimedean spiral, anticlockwise from the centre.
std::vector<PlanRow> spiralRow(const PassRequest& request, const PlanBounds& bounds, double stepOver) {
    const glm::dvec2 centre = centreOf(request, bounds);
    const double reach = farthestFrom(centre, bounds) + stepOver;
    PlanRow row{centre};
    for (double angle = 0.0, distance = 0.0; distance < reach; distance = stepOver * angle / (2.0 * pi)) {
        row.push_back(centre + distance * glm::dvec2(std::cos(angle), std::sin(angle)));
        angle += std::min(0.5, std::sqrt(8.0 * spiralChord / std::max(distance, stepOver)));
    }
    return {row};
}

/// The line in plan, extended at its ends, without points that hardly bend it.
PlanRow carriedOn(const PassLine& line, double by) {
    TipLine flat;
    for (const glm::dvec3& place : line)
        if (flat.empty() || glm::distance(glm::dvec2(flat.back()), glm::dvec2(place)) > 1e-6)
            flat.emplace_back(glm::dvec2(place), 0.0);
    PlanRow row;
    for (const glm::dvec3& place : straightened(flat)) row.emplace_back(place);
    if (row.size() < 2) return row;
    row.insert(row.begin(), row.front() + by * glm::normalize(row.front() - row[1]));
    row.push_back(row.back() + by * glm::normalize(row.back() - row[row.size() - 2]));
    return row;
}

/// Whether a point lies to the left of the nearest part of a line.
bool isLeftOf(const PlanRow& line, const glm::dvec2& place) {
    double nearest = 1e300, side = 0.0;
    for (std::size_t i = 1; i < line.size(); ++i) {
        const glm::dvec2 along = line[i] - line[i - 1], from = place - line[i - 1];
        const double distance = distanceToSegment(place, line[i - 1], line[i]);
        if (distance >= nearest) continue;
        nearest = distance;
        side = along.x * from.y - along.y * from.x;
    }
    return side > 0.0;
}

/// The parts of a ring within bounds; a ring that never leaves them is closed.
std::vector<PlanRow> partsWithin(const PlanRing& ring, const PlanBounds& bounds) {
    const std::size_t count = ring.size();
    const auto within = [&](std::size_t side) {
        return shareWithin(bounds, ring[side % count], ring[(side + 1) % count]);
    };
    std::size_t start = 0; // a side outside, at which the ring may be split
    while (start < count && !within(start).empty()) ++start;
    std::vector<PlanRow> parts;
    bool open = false;
    for (std::size_t side = start; side < start + count; ++side) {
        const SegmentShare share = within(side);
        const glm::dvec2 &from = ring[side % count], &to = ring[(side + 1) % count];
        if (share.empty() || share.from > 0.0) open = false;
        if (share.empty()) continue;
        if (!open) parts.push_back({glm::mix(from, to, share.from)});
        parts.back().push_back(glm::mix(from, to, share.to));
        open = share.to == 1.0;
    }
    return parts;
}

/// The parts of a row, half a step-over before the next one, that lie farther than that from it: where a line comes
/// near itself, or bends, rows from two sides meet there.
std::vector<PlanRow> gapsIn(const PlanRow& row, const NearSegments& next, double stepOver) {
    constexpr double gap = 0.58, spacing = 0.4; // of the step-over
    PlanRow places{row.front()};
    for (std::size_t i = 1; i < row.size(); ++i) {
        const double length = glm::distance(row[i - 1], row[i]);
        const int steps = std::max(1, static_cast<int>(std::ceil(length / (spacing * stepOver))));
        for (int k = 1; k <= steps; ++k) places.push_back(glm::mix(row[i - 1], row[i], static_cast<double>(k) / steps));
    }
    std::vector<char> lacks(places.size(), 0);
    for (std::size_t i = 0; i < places.size(); ++i) {
        if (next.anyWithin(places[i], gap * stepOver)) continue;
        for (std::size_t k = i > 0 ? i - 1 : 0; k <= std::min(i + 1, places.size() - 1); ++k) lacks[k] = 1;
    }
    std::vector<PlanRow> gaps;
    for (std::size_t i = 0; i < places.size(); ++i) {
        if (lacks[i] && (i == 0 || !lacks[i - 1])) gaps.emplace_back();
        if (lacks[i]) gaps.back().push_back(places[i]);
    }
    std::erase_if(gaps, [](const PlanRow& part) { return part.size() < 2; });
    return gaps;
}

/// Moves points between two rows to the middle between them, and leaves out what was there before: both sides of a gap
/// lead to the same line.
class GapMiddles {
public:
    /// @param behind the rows on either side, half a step-over from the points that are moved
    GapMiddles(const NearSegments& behind, double stepOver) : behind_(behind), step_(stepOver), made_(stepOver) {}

    void add(const PlanRow& gap) {
        constexpr std::size_t delay = 3; // points: a line is not compared with what it has just left
        PlanRow middle;
        for (const glm::dvec2& place : gap) middle.push_back(middleOf(place));
        bool open = false;
        for (std::size_t i = 0; i < middle.size(); ++i) {
            if (i > delay) made_.add(middle[i - delay - 1], middle[i - delay]);
            const bool known = made_.anyWithin(middle[i], sameShare * step_);
            if (!known && !open) rows_.emplace_back();
            if (!known) rows_.back().push_back(middle[i]);
            open = !known;
        }
        for (std::size_t i = middle.size() - std::min(delay + 1, middle.size()); i + 1 < middle.size(); ++i)
            made_.add(middle[i], middle[i + 1]);
    }
    std::vector<PlanRow> taken() {
        std::erase_if(rows_, [](const PlanRow& row) { return row.size() < 2; });
        return std::move(rows_);
    }

private:
    static constexpr double sameShare = 0.3, precision = 0.01; // of the step-over

    /// As far from the nearest row as that row stays the nearest, at most where the next row would be.
    glm::dvec2 middleOf(const glm::dvec2& place) const {
        const std::optional<glm::dvec2> foot = behind_.nearestWithin(place, 0.6 * step_);
        if (!foot || *foot == place) return place;
        const double from = glm::distance(place, *foot);
        const glm::dvec2 away = (place - *foot) / from;
        double reached = 0.0, beyond = 0.5 * step_;
        while (beyond - reached > precision * step_) {
            const double half = 0.5 * (reached + beyond);
            const bool staysNearest = !behind_.anyWithin(place + half * away, from + half - precision * step_);
            (staysNearest ? reached : beyond) = half;
        }
        return place + reached * away;
    }

    const NearSegments& behind_;
    double step_; // mm
    NearSegments made_;
    std::vector<PlanRow> rows_;
};

/// Lines parallel to a given one, at even distances to either side, from left to right. Beyond the bounds they are left
/// out: there alone one side becomes the other, at the far ends of the line.
class RowsBeside {
public:
    RowsBeside(const PassLine& lead, const PlanBounds& bounds, double stepOver)
        : bounds_(bounds)
        , step_(stepOver)
        , reach_(2.0 * glm::length(bounds.high - bounds.low) + farthestFrom(glm::dvec2(lead.front()), bounds) +
                 farthestFrom(glm::dvec2(lead.back()), bounds))
        , line_(carriedOn(lead, reach_)) {}

    std::vector<PlanRow> rows() {
        if (line_.size() < 4) return {};
        constexpr int mostTogether = 32; // distances
        const int most = static_cast<int>(std::ceil(reach_ / step_));
        bool reached = false;
        for (int first = 1, together = 1; first <= most; first += together) {
            together = std::min(first, mostTogether);
            prepare(first + together - 1);
            std::vector<std::vector<PlanRow>> rows(static_cast<std::size_t>(together));
            std::vector<std::vector<PlanRow>> gaps(rows.size());
            parallelFor(0, together, [&](int i) {
                const auto k = static_cast<std::size_t>(i);
                rows[k] = rowsAt((first + i) * step_);
                gaps[k] = gapsBefore((first + i) * step_, rows[k]);
            });
            for (std::size_t k = 0; k < rows.size(); ++k) {
                for (const PlanRow& row : gaps[k]) add(row);
                for (const PlanRow& row : rows[k]) add(row);
                if (reached && rows[k].empty()) return ordered(); // distances within the bounds have no gaps
                reached = reached || !rows[k].empty();
            }
        }
        return ordered();
    }

private:
    /// Makes the regions that those at distances of up to a number of step-overs are grown from.
    void prepare(int last) {
        while (std::ldexp(1.0, static_cast<int>(grown_.size())) < last) {
            const double distance = step_ * std::ldexp(1.0, static_cast<int>(grown_.size()));
            grown_.push_back(cleaned(regionAt(distance), cleanedBy));
        }
    }
    /// The region around the line: where its parts are nearer to each other than the distance, it is much sooner grown
    /// from another region around it than from the line.
    PlanRegion regionAt(double distance) const {
        for (std::size_t i = grown_.size(); i > 0; --i)
            if (const double by = distance - step_ * std::ldexp(1.0, static_cast<int>(i - 1)); by > 0.25 * step_)
                return grown(grown_[i - 1], by);
        return around(line_, distance);
    }
    /// Within the bounds and two step-overs around them.
    std::vector<PlanRow> rowsAt(double distance) const {
        const PlanBounds wide{bounds_.low - 2.0 * step_, bounds_.high + 2.0 * step_};
        std::vector<PlanRow> rows;
        for (const PlanRing& ring : regionAt(distance).rings)
            for (PlanRow& part : partsWithin(ring, wide)) rows.push_back(std::move(part));
        return rows;
    }
    NearSegments segmentsOf(const std::vector<PlanRow>& rows) const {
        NearSegments segments(step_);
        for (const PlanRow& row : rows)
            for (std::size_t i = 1; i < row.size(); ++i) segments.add(row[i - 1], row[i]);
        return segments;
    }
    /// Parts of a row, in the middle between the rows before these, where they meet more than a step-over apart.
    std::vector<PlanRow> gapsBefore(double distance, const std::vector<PlanRow>& rows) const {
        const NearSegments next = segmentsOf(rows);
        std::vector<PlanRow> gaps;
        for (const PlanRow& row : rowsAt(distance - 0.5 * step_))
            for (PlanRow& gap : gapsIn(row, next, step_)) gaps.push_back(std::move(gap));
        if (gaps.empty()) return gaps;
        const bool besideLine = distance < 1.5 * step_;
        const NearSegments behind = segmentsOf(besideLine ? std::vector<PlanRow>{line_} : rowsAt(distance - step_));
        GapMiddles middles(behind, step_);
        for (const PlanRow& gap : gaps) middles.add(gap);
        return middles.taken();
    }
    void add(const PlanRow& row) {
        const bool left = isLeftOf(line_, 0.5 * (row[row.size() / 2 - 1] + row[row.size() / 2]));
        (left ? left_ : right_).push_back(row);
    }
    std::vector<PlanRow> ordered() {
        std::ranges::reverse(left_);
        left_.push_back(line_);
        left_.insert(left_.end(), right_.begin(), right_.end());
        return std::move(left_);
    }

    static constexpr double cleanedBy = 0.001; // mm

    PlanBounds bounds_;
    double step_, reach_; // mm
    PlanRow line_;
    std::vector<PlanRegion> grown_; ///< around the line, by 1, 2, 4, … step-overs
    std::vector<PlanRow> left_, right_;
};

/// Points at even fractions of a line's length.
PlanRow resampled(const PassLine& line, std::size_t count) {
    std::vector<double> way{0.0};
    for (std::size_t i = 1; i < line.size(); ++i)
        way.push_back(way.back() + glm::distance(glm::dvec2(line[i]), glm::dvec2(line[i - 1])));
    PlanRow row;
    for (std::size_t i = 0, at = 1; i < count; ++i) {
        const double wanted = way.back() * static_cast<double>(i) / static_cast<double>(count - 1);
        while (at + 1 < line.size() && way[at] < wanted) ++at;
        const double span = way[at] - way[at - 1];
        const double share = span > 0.0 ? std::clamp((wanted - way[at - 1]) / span, 0.0, 1.0) : 0.0;
        row.push_back(glm::mix(glm::dvec2(line[at - 1]), glm::dvec2(line[at]), share));
    }
    return row;
}

/// Rows from each line to the next, blended between the two, nowhere farther apart than the step-over.
std::vector<PlanRow> blendedRows(const std::vector<PassLine>& lines, double stepOver) {
    constexpr std::size_t places = 400;
    std::vector<PlanRow> leads;
    for (const PassLine& line : lines) {
        PlanRow lead = resampled(line, places);
        if (!leads.empty() &&
            glm::distance(leads.back().front(), lead.back()) + glm::distance(leads.back().back(), lead.front()) <
                glm::distance(leads.back().front(), lead.front()) + glm::distance(leads.back().back(), lead.back()))
            std::ranges::reverse(lead);
        leads.push_back(std::move(lead));
    }
    std::vector<PlanRow> rows{leads.front()};
    for (std::size_t k = 1; k < leads.size(); ++k) {
        double widest = 0.0;
        for (std::size_t i = 0; i < places; ++i) widest = std::max(widest, glm::distance(leads[k - 1][i], leads[k][i]));
        const int steps = std::max(1, static_cast<int>(std::ceil(widest / stepOver - 1e-9)));
        for (int step = 1; step <= steps; ++step) {
            PlanRow& row = rows.emplace_back();
            for (std::size_t i = 0; i < places; ++i)
                row.push_back(glm::mix(leads[k - 1][i], leads[k][i], static_cast<double>(step) / steps));
        }
    }
    return rows;
}

} // namespace

std::vector<PlanRow> rowsOf(const PassRequest& request, const PlanBounds& bounds, double stepOver) {
    switch (request.kind) {
    case PassKind::radial:
        return radialRows(request, bounds, stepOver);
    case PassKind::spiral:
        return spiralRow(request, bounds, stepOver);
    case PassKind::flow:
        return request.lines.size() == 1 ? RowsBeside(request.lines.front(), bounds, stepOver).rows()
                                         : blendedRows(request.lines, stepOver);
    default:
        return parallelRows(request, bounds, stepOver);
    }
}

Result<double> stepOverOf(const PassRequest& request, const Cutter& cutter) {
    if (request.stepOver > 0.0) return request.stepOver;
    if (request.scallop == 0.0) return usualFineStep * cutter.diameter;
    if (!(request.scallop < cutter.cornerRadius))
        return Error{ErrorCode::argumentInvalid, "scallop_mm", formatShortest(request.scallop),
                     cutter.cornerRadius > 0.0
                         ? "less than the rounding of the tool's end, " + formatShortest(cutter.cornerRadius) + " mm"
                         : "a tool with a rounded end; give a step-over for this one"};
    // Two circles of the corner radius at this distance leave a ridge of that height between them.
    return 2.0 * std::sqrt(request.scallop * (2.0 * cutter.cornerRadius - request.scallop));
}

} // namespace burin

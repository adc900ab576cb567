// SPDX-FileCopyrightText: 2026 The Burin authors
// SPDX-License-Identifier: Apache-2.0
#include "core/base/numbers.h"
#include "core/base/units.h"
#include "core/geometry/segment.h"
#include "core/passes/surface_pass.h"

#include <algorithm>
#include <cmath>

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

/// The line in plan, extended at its ends.
PlanRow carriedOn(const PassLine& line, double by) {
    PlanRow row;
    for (const glm::dvec3& place : line)
        if (row.empty() || glm::distance(row.back(), glm::dvec2(place)) > 1e-6) row.emplace_back(place);
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

/// Lines parallel to a given one, at even distances to either side, from left to right.
std::vector<PlanRow> rowsBeside(const PassLine& lead, const PlanBounds& bounds, double stepOver) {
    const double reach = 2.0 * glm::length(bounds.high - bounds.low) + farthestFrom(glm::dvec2(lead.front()), bounds) +
                         farthestFrom(glm::dvec2(lead.back()), bounds);
    const PlanRow line = carriedOn(lead, reach);
    if (line.size() < 4) return {};
    std::vector<PlanRow> left, right;
    const int most = static_cast<int>(std::ceil(reach / stepOver));
    for (int i = 1; i <= most; ++i) {
        bool near = false;
        for (PlanRing ring : around(line, i * stepOver).rings) {
            // A ring surrounds both sides; it is split where one side becomes the other, at the far ends.
            const std::size_t count = ring.size();
            std::size_t start = 0;
            while (start < count && isLeftOf(line, ring[start]) == isLeftOf(line, ring[(start + count - 1) % count]))
                ++start;
            std::ranges::rotate(ring, ring.begin() + static_cast<std::ptrdiff_t>(start % count));
            for (std::size_t k = 0; k < count; ++k) {
                std::vector<PlanRow>& side = isLeftOf(line, ring[k]) ? left : right;
                const bool goesOn = k > 0 && isLeftOf(line, ring[k]) == isLeftOf(line, ring[k - 1]);
                if (!goesOn) side.emplace_back();
                side.back().push_back(ring[k]);
                near = near || (ring[k].x > bounds.low.x && ring[k].y > bounds.low.y && ring[k].x < bounds.high.x &&
                                ring[k].y < bounds.high.y);
            }
        }
        if (!near && i * stepOver > glm::length(bounds.high - bounds.low)) break;
    }
    std::ranges::reverse(left);
    left.push_back(line);
    left.insert(left.end(), right.begin(), right.end());
    std::erase_if(left, [](const PlanRow& row) { return row.size() < 2; });
    return left;
}

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
        return request.lines.size() == 1 ? rowsBeside(request.lines.front(), bounds, stepOver)
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

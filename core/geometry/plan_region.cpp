// SPDX-FileCopyrightText: 2026 The Burin authors
// SPDX-License-Identifier: Apache-2.0
#include "core/geometry/plan_region.h"

#include <algorithm>
#include <cmath>
#include <iterator>
#include <polyclipping/clipper.hpp>

namespace burin {

namespace {

/// Clipper works on integers; these stay in the range in which it needs no 128-bit products.
constexpr double unitsPerMillimetre = 1e4;
constexpr double lineTolerance = 1e-3;  // mm, of the ends of lines
constexpr double brushTolerance = 0.01; // mm, of a brush's round ends
constexpr double mitreLimit = 2.0;      // no corner is mitred, but Clipper requires a value

ClipperLib::IntPoint toUnits(const glm::dvec2& place) {
    const auto whole = [](double value) {
        return static_cast<ClipperLib::cInt>(
            std::llround(std::clamp(value, -farthestInPlan, farthestInPlan) * unitsPerMillimetre));
    };
    return {whole(place.x), whole(place.y)};
}

ClipperLib::Path toUnits(const std::vector<glm::dvec2>& places) {
    ClipperLib::Path path;
    path.reserve(places.size());
    for (const glm::dvec2& place : places) path.push_back(toUnits(place));
    return path;
}

ClipperLib::Paths toUnits(const PlanRegion& region) {
    ClipperLib::Paths paths;
    paths.reserve(region.rings.size());
    for (const PlanRing& ring : region.rings) paths.push_back(toUnits(ring));
    return paths;
}

PlanRing toMillimetres(const ClipperLib::Path& path) {
    PlanRing ring;
    ring.reserve(path.size());
    for (const ClipperLib::IntPoint& point : path)
        ring.emplace_back(static_cast<double>(point.X) / unitsPerMillimetre,
                          static_cast<double>(point.Y) / unitsPerMillimetre);
    return ring;
}

PlanRegion toMillimetres(const ClipperLib::Paths& paths) {
    PlanRegion region;
    for (const ClipperLib::Path& path : paths)
        if (path.size() >= 3) region.rings.push_back(toMillimetres(path));
    return region;
}

ClipperLib::Paths combined(const ClipperLib::Paths& one, const ClipperLib::Paths& other, ClipperLib::ClipType how) {
    ClipperLib::Clipper clipper;
    clipper.AddPaths(one, ClipperLib::ptSubject, true);
    clipper.AddPaths(other, ClipperLib::ptClip, true);
    ClipperLib::Paths solution;
    clipper.Execute(how, solution, ClipperLib::pftEvenOdd, ClipperLib::pftEvenOdd);
    return solution;
}

PlanRegion offset(const ClipperLib::Paths& paths, double distance, double tolerance, ClipperLib::EndType ends) {
    ClipperLib::ClipperOffset clipper(mitreLimit, tolerance * unitsPerMillimetre);
    clipper.AddPaths(paths, ClipperLib::jtRound, ends);
    ClipperLib::Paths solution;
    clipper.Execute(solution, distance * unitsPerMillimetre);
    return toMillimetres(solution);
}

} // namespace

PlanRegion rectangle(const glm::dvec2& low, const glm::dvec2& high) {
    return {{{low, {high.x, low.y}, high, {low.x, high.y}}}};
}

PlanBounds boundsOf(const PlanRegion& region) noexcept {
    PlanBounds bounds;
    bool first = true;
    for (const PlanRing& ring : region.rings)
        for (const glm::dvec2& place : ring) {
            bounds.low = first ? place : glm::min(bounds.low, place);
            bounds.high = first ? place : glm::max(bounds.high, place);
            first = false;
        }
    return bounds;
}

bool holds(const PlanRegion& region, const glm::dvec2& place) noexcept {
    bool inside = false;
    for (const PlanRing& ring : region.rings)
        for (std::size_t i = 0; i < ring.size(); ++i) {
            const glm::dvec2 &a = ring[i], &b = ring[(i + 1) % ring.size()];
            if ((a.y > place.y) == (b.y > place.y)) continue;
            if (place.x < a.x + (b.x - a.x) * (place.y - a.y) / (b.y - a.y)) inside = !inside;
        }
    return inside;
}

PlanRegion grown(const PlanRegion& region, double distance, double tolerance) {
    // Rings that are nested irregularly or self-intersect are normalised first: an offset depends on their orientation.
    return offset(combined(toUnits(region), {}, ClipperLib::ctUnion), distance, tolerance, ClipperLib::etClosedPolygon);
}

PlanRegion cleaned(const PlanRegion& region, double tolerance) {
    ClipperLib::Paths paths = toUnits(region);
    ClipperLib::CleanPolygons(paths, tolerance * unitsPerMillimetre);
    return toMillimetres(paths);
}

PlanRegion around(const std::vector<glm::dvec2>& line, double distance) {
    return offset({toUnits(line)}, distance, lineTolerance, ClipperLib::etOpenButt);
}

PlanRegion brushed(const std::vector<glm::dvec2>& line, double radius) {
    return offset({toUnits(line)}, radius, brushTolerance, ClipperLib::etOpenRound);
}

PlanRegion joined(const PlanRegion& one, const PlanRegion& other) {
    return toMillimetres(combined(toUnits(one), toUnits(other), ClipperLib::ctUnion));
}

PlanRegion filledBy(const std::vector<PlanRing>& rings) {
    ClipperLib::Paths paths;
    ClipperLib::SimplifyPolygons(toUnits(PlanRegion{rings}), paths, ClipperLib::pftNonZero);
    return toMillimetres(paths);
}

double areaInPlan(const PlanRegion& region) {
    double area = 0.0;
    for (const ClipperLib::Path& path : combined(toUnits(region), {}, ClipperLib::ctUnion))
        area += ClipperLib::Area(path); // holes have the opposite orientation
    return area / (unitsPerMillimetre * unitsPerMillimetre);
}

PlanRegion without(const PlanRegion& one, const PlanRegion& other) {
    return toMillimetres(combined(toUnits(one), toUnits(other), ClipperLib::ctDifference));
}

std::vector<PlanPiece> piecesOf(const PlanRegion& region) {
    ClipperLib::Clipper clipper;
    clipper.AddPaths(toUnits(region), ClipperLib::ptSubject, true);
    ClipperLib::PolyTree tree;
    clipper.Execute(ClipperLib::ctUnion, tree, ClipperLib::pftEvenOdd, ClipperLib::pftEvenOdd);
    std::vector<PlanPiece> pieces;
    for (const ClipperLib::PolyNode* node = tree.GetFirst(); node != nullptr; node = node->GetNext()) {
        if (node->IsHole()) continue;
        PlanPiece piece{toMillimetres(node->Contour), {}}; // Clipper gives both the documented orientation
        for (const ClipperLib::PolyNode* hole : node->Childs) piece.holes.push_back(toMillimetres(hole->Contour));
        pieces.push_back(std::move(piece));
    }
    return pieces;
}

PlanRegion oriented(const PlanRegion& region) {
    PlanRegion turned;
    for (PlanPiece& piece : piecesOf(region)) {
        turned.rings.push_back(std::move(piece.border));
        std::ranges::move(piece.holes, std::back_inserter(turned.rings));
    }
    return turned;
}

} // namespace burin

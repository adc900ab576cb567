// SPDX-FileCopyrightText: 2026 The Burin authors
// SPDX-License-Identifier: Apache-2.0
#include "core/cutting/surface_flux.h"

#include "core/base/units.h"
#include "core/cutting/footprint.h"

#include <algorithm>
#include <bit>
#include <cmath>

namespace burin {

namespace {

// Largest numbers of patches for a hemisphere or a turn of the wall; large tools get larger patches.
struct PatchBounds {
    double hemisphere, strips, sectors;
};
constexpr PatchBounds fine{1000.0, 240.0, 48.0}, coarse{130.0, 80.0, 32.0};
// Reading a scanline that the tick has not accessed yet is a cache miss: above this radius few patches have to suffice.
constexpr double largestFineRadius = 30.0; // voxels
// Height of the wall's lowest ring divided by the radius, and of each further ring divided by the height below it.
constexpr double lowestRing = 0.15, ringGrowth = 0.3;
constexpr int mostWallRings = 24; // of a wall of a section
constexpr double lookAhead = 1.0; // voxels
constexpr int directionCount = 128;
constexpr double goldenRatio = 0.6180339887498949;

int countOf(double length, double spacing) noexcept {
    return std::max(1, static_cast<int>(std::ceil(length / spacing)));
}

double fractionOf(double x) noexcept {
    return x - std::floor(x);
}

/// Returns the smallest rotation that takes +Z to `axis`; it is continuous while the axis rotates.
glm::dmat3 turnTo(const glm::dvec3& axis) noexcept {
    if (axis.z < -1.0 + 1e-12) return {{1.0, 0.0, 0.0}, {0.0, -1.0, 0.0}, {0.0, 0.0, -1.0}};
    const double k = 1.0 / (1.0 + axis.z), mixed = -axis.x * axis.y * k;
    return {{1.0 - axis.x * axis.x * k, mixed, -axis.x}, {mixed, 1.0 - axis.y * axis.y * k, -axis.y}, axis};
}

} // namespace

/// The sums over the patches.
struct SurfaceFlux::Sum {
    const RunVolume& workpiece;
    const CutCache* window;
    Flux& flux;
    Directions directions{};
    double lowest = std::numeric_limits<double>::infinity(), highest = -lowest; ///< mm above the tip

    /// Adds the volume of a material ahead of a patch.
    void take(PropertyIndex property, double volume, const glm::dvec3& place) noexcept {
        flux.volume[property] += volume;
        flux.total += volume;
        flux.moment += volume * place;
    }
    /// Adds a patch, or part of its area, that pushes into material between two heights.
    void meet(const Patch& patch, double size, double low, double high) noexcept {
        flux.engagement.area += size;
        for (std::size_t i = 0; i < directions.size(); ++i) directions[i] |= patch.directions[i];
        lowest = std::min(lowest, low);
        highest = std::max(highest, high);
    }
};

SurfaceFlux::SurfaceFlux(std::span<const RevolvedPiece> flutes, double edge) : edge_(edge) {
    double radius = 0.0; // end radius of the pieces so far
    for (const RevolvedPiece& piece : flutes) {
        addPiece(piece, radius);
        radius = piece.topRadius;
    }
}

SurfaceFlux::SurfaceFlux(const PlanRegion& section, double top, double edge) : edge_(edge) {
    const Fineness fineness = finenessFor(boundsOf(section).high.x);
    const auto isUpperEnd = [&](const glm::dvec2& corner) { return corner.y >= top - 1e-3; };
    for (const PlanRing& ring : oriented(section).rings)
        for (std::size_t i = 0; i < ring.size(); ++i) {
            const glm::dvec2 &from = ring[i], &to = ring[(i + 1) % ring.size()];
            if (!(isUpperEnd(from) && isUpperEnd(to)) && from.x + to.x > 0.0) addEdge(from, to, fineness);
        }
}

SurfaceFlux::Fineness SurfaceFlux::finenessFor(double radius) const noexcept {
    const PatchBounds& most = radius <= largestFineRadius * edge_ ? fine : coarse;
    const double around = 2.0 * pi * radius;
    return {std::max(edge_, radius * std::sqrt(2.0 * pi / most.hemisphere)),
            std::max(0.5 * edge_, around / most.strips), std::max(edge_, around / most.sectors)};
}

/// Adds what an edge of a section sweeps in a turn; the section lies on its left.
void SurfaceFlux::addEdge(const glm::dvec2& from, const glm::dvec2& to, const Fineness& fineness) {
    const double middle = 0.5 * (from.x + to.x);
    const bool parallel = from.x == to.x, level = from.y == to.y;
    if (parallel) addRing({from.x, to.x, from.y, to.y}, countOf(2.0 * pi * middle, fineness.strip), strips_);
    const double length = level ? fineness.spacing : parallel ? lowestRing * middle : lookAhead * edge_;
    const int fitting = countOf(glm::distance(from, to), std::max(edge_, length));
    const int rings = parallel ? std::min(fitting, mostWallRings) : fitting;
    for (int i = 0; i < rings; ++i) {
        const glm::dvec2 low = glm::mix(from, to, static_cast<double>(i) / rings),
                         high = glm::mix(from, to, static_cast<double>(i + 1) / rings);
        addRing({low.x, high.x, low.y, high.y},
                countOf(pi * (low.x + high.x), level ? fineness.spacing : fineness.sector), parallel ? wall_ : end_);
    }
}

/// @param innerRadius mm, of the part of the bottom that is covered by the piece before
void SurfaceFlux::addPiece(const RevolvedPiece& piece, double innerRadius) {
    const double radius = piece.widestRadius(), flat = piece.bottomRadius - piece.cornerRadius;
    const Fineness fineness = finenessFor(radius);
    const int discs = flat > innerRadius ? countOf(flat - innerRadius, fineness.spacing) : 0;
    for (int i = 0; i < discs; ++i) {
        const double inner = innerRadius + (flat - innerRadius) * i / discs;
        const double outer = innerRadius + (flat - innerRadius) * (i + 1) / discs;
        addRing({inner, outer, piece.bottom, piece.bottom}, countOf(pi * (inner + outer), fineness.spacing), end_);
    }
    if (piece.bulges()) {
        const double up = 1.0 / piece.bulgeRadius;
        addArc(piece, {piece.bulgeCentreRadius, piece.bulgeCentreHeight}, piece.bulgeRadius,
               std::asin(std::clamp((piece.bottom - piece.bulgeCentreHeight) * up, -1.0, 1.0)),
               std::asin(std::clamp((piece.top - piece.bulgeCentreHeight) * up, -1.0, 1.0)), fineness.spacing);
        return;
    }
    if (piece.cornerRadius > 0.0)
        addArc(piece, {flat, piece.bottom + piece.cornerRadius}, piece.cornerRadius, -0.5 * pi, 0.0, fineness.spacing);
    addSide(piece, fineness);
}

/// @param centre of the arc: (distance from the axis, height above the tip); from, to: rad above the plane
/// perpendicular to the axis
void SurfaceFlux::addArc(const RevolvedPiece& piece, const glm::dvec2& centre, double radius, double from, double to,
                         double spacing) {
    const int arcs = countOf((to - from) * radius, spacing);
    const auto at = [&](int i) {
        const double angle = from + (to - from) * i / arcs;
        return glm::dvec2(std::max(0.0, centre.x + radius * std::cos(angle)), centre.y + radius * std::sin(angle));
    };
    for (int i = 0; i < arcs; ++i) {
        const glm::dvec2 low = at(i),
                         high = i + 1 == arcs && piece.bulges() ? glm::dvec2(piece.topRadius, piece.top) : at(i + 1);
        addRing({low.x, high.x, low.y, high.y, radius, centre}, countOf(pi * (low.x + high.x), spacing), end_);
    }
}

/// Adds the straight side above a corner, if any: rings whose height grows with the distance from the tip.
void SurfaceFlux::addSide(const RevolvedPiece& piece, const Fineness& fineness) {
    const double foot = piece.bottom + piece.cornerRadius, radius = piece.widestRadius();
    if (!(piece.top > foot)) return;
    const bool parallel = piece.bottomRadius == piece.topRadius;
    if (parallel) addRing({radius, radius, foot, piece.top}, countOf(2.0 * pi * radius, fineness.strip), strips_);
    // In shares of the side, as a cone may be almost level: then its heights do not divide it, but its radii do.
    const double height = piece.top - foot, widening = piece.topRadius - piece.bottomRadius;
    // A cone's ring is no wider than the distance that its patches look ahead, otherwise they would look over the stock
    // that its foot meets.
    const double mostStep = parallel ? 1.0 : lookAhead * edge_ / std::abs(widening);
    for (double low = 0.0; low < 1.0;) {
        const double ring = std::max(edge_, lowestRing * radius) + ringGrowth * low * height;
        const double step = std::min(ring / height, mostStep);
        const double high = low + 1.5 * step < 1.0 ? low + step : 1.0;
        const double inner = piece.topRadius - (1.0 - low) * widening;
        const double outer = piece.topRadius - (1.0 - high) * widening;
        addRing({inner, outer, piece.top - (1.0 - low) * height, piece.top - (1.0 - high) * height},
                countOf(pi * (inner + outer), fineness.sector), parallel ? wall_ : end_);
        low = high;
    }
}

/// Returns a point between the circles of a ring and the outward normal there, in the plane of the axis.
/// @param share fraction of the distance from the inner circle
SurfaceFlux::ProfilePlace SurfaceFlux::placeOn(const Ring& ring, double share) noexcept {
    const glm::dvec2 across(ring.outerRadius - ring.innerRadius, ring.high - ring.low);
    const glm::dvec2 straight = glm::dvec2(ring.innerRadius, ring.low) + share * across;
    if (ring.bulge <= 0.0) return {straight, glm::dvec2(across.y, -across.x) / glm::length(across)};
    const glm::dvec2 normal = glm::normalize(straight - ring.centre);
    return {ring.centre + ring.bulge * normal, normal};
}

/// Divides a ring into sectors. A sector's integral of the normal: in the plane, the chord's normal times the height;
/// along the axis, its area projected along it.
void SurfaceFlux::addRing(const Ring& ring, int sectors, std::vector<Patch>& patches) const {
    sectors = std::max(12, sectors);
    const double middle = 0.5 * (ring.innerRadius + ring.outerRadius), angle = 2.0 * pi / sectors;
    const double sideways = 2.0 * std::sin(0.5 * angle) * middle * (ring.high - ring.low);
    const double down = 0.5 * angle * (ring.outerRadius - ring.innerRadius) * (ring.outerRadius + ring.innerRadius);
    const double start = fractionOf(goldenRatio * static_cast<double>(patches.size()));
    for (int i = 0; i < sectors; ++i) {
        const double cosine = std::cos((start + i + 0.5) * angle), sine = std::sin((start + i + 0.5) * angle);
        const ProfilePlace at = placeOn(ring, fractionOf(goldenRatio * (i + 0.5)));
        Patch patch{{sideways * cosine, sideways * sine, -down},
                    {at.place.x * cosine, at.place.x * sine, at.place.y},
                    {at.normal.x * cosine, at.normal.x * sine, at.normal.y},
                    std::min(ring.low, ring.high),
                    std::max(ring.low, ring.high),
                    std::hypot(sideways, down),
                    {}};
        // The directions whose middle lies in the sector, so that a whole ring has each direction once.
        const double width = static_cast<double>(directionCount) / sectors;
        const int first = static_cast<int>(std::ceil((start + i) * width - 0.5)),
                  last = static_cast<int>(std::ceil((start + i + 1) * width - 0.5));
        for (int direction = first; direction < last; ++direction) {
            const auto bit = static_cast<unsigned>(direction % directionCount);
            patch.directions[bit / 64] |= std::uint64_t{1} << bit % 64;
        }
        patches.push_back(patch);
    }
}

void SurfaceFlux::measure(const RunVolume& workpiece, const CutCache* window, const ToolPose& from, const ToolPose& to,
                          Flux& flux) const noexcept {
    const Grid& grid = workpiece.grid();
    const ToolPose start = inLineFrame(grid, from), end = inLineFrame(grid, to);
    const glm::dmat3 turn = turnTo(end.axis), back = glm::transpose(turn);
    Stand stand{
        turn,   end.tip, back * (end.tip - start.tip), back * glm::cross(start.axis, end.axis), lookAhead * edge_,
        end.tip};
    if (const double length = glm::length(end.tip - start.tip); length > 0.0)
        stand.probe += (end.tip - start.tip) * (stand.lookAhead / length);
    stand.lines = inLineFrame(grid, grid.low());
    Sum sum{workpiece, window, flux};
    const bool alongRuns = start.axis == end.axis && end.axis.x == 0.0 && end.axis.y == 0.0;
    if (alongRuns) {
        for (const Patch& patch : end_) measureAlongRuns(patch, stand, sum);
        for (const Patch& patch : strips_) measureAlongRuns(patch, stand, sum);
    } else {
        for (const Patch& patch : end_) measureAtPlace(patch, stand, sum);
        for (const Patch& patch : wall_) measureAtPlace(patch, stand, sum);
    }
    flux.moment = inSetupFrame(grid, flux.moment);
    int met = 0;
    for (const std::uint64_t directions : sum.directions) met += std::popcount(directions);
    flux.engagement.arc = 2.0 * pi * met / directionCount;
    if (sum.highest > sum.lowest) flux.engagement.depth = sum.highest - sum.lowest;
}

/// Measures all heights of the patch at once, on the one scanline ahead of its point.
void SurfaceFlux::measureAlongRuns(const Patch& patch, const Stand& stand, Sum& sum) const noexcept {
    const double swept = glm::dot(patch.area, stand.motion);
    if (swept <= 0.0) return;          // facing away from the motion
    const double up = stand.turn[2].z; // 1 or -1
    const Grid& grid = sum.workpiece.grid();
    const glm::dvec3& probe = stand.probe;
    const glm::dvec3 side = stand.turn * glm::dvec3(patch.place.x, patch.place.y, 0.0);
    const double u = (probe.x + side.x - stand.lines.x) / edge_, v = (probe.y + side.y - stand.lines.y) / edge_;
    if (!(u >= 0.0 && v >= 0.0 && u < grid.lineCountU() && v < grid.lineCountV())) return;
    const double high = std::max(patch.high, patch.low + 0.25 * edge_); // so that a level patch also samples something
    const RunPosition first = grid.toRunPosition(probe.z + (up > 0.0 ? patch.low : -high)),
                      last = grid.toRunPosition(probe.z + (up > 0.0 ? high : -patch.low));
    const double unit = (edge_ / unitsPerVoxel) / (high - patch.low);
    const LineIndex line{static_cast<std::int32_t>(u), static_cast<std::int32_t>(v)};
    // All heights of a wall push into the material ahead of them; for a slope it is the part between its surface on
    // this line now and later. Old floors below that do not count.
    const bool slopes = patch.normal.z < 0.0;
    const RunPosition pushed =
        slopes ? grid.toRunPosition(stand.tip.z + up * heightPushedInto(patch, stand, line)) : first;
    const auto add = [&](PropertyIndex property, RunPosition from, RunPosition to) {
        if (sum.workpiece.properties().isProtected(property)) return;
        const bool meets = !slopes || (from <= pushed && pushed < to);
        const RunPosition start = std::max(from, first), end = std::min(to, last);
        const double share = start < end ? unit * (end - start) : 0.0;
        const double low = grid.toMillimetres(start), top = grid.toMillimetres(end);
        const double ends[] = {std::clamp(up * (low - probe.z), patch.low, patch.high),
                               std::clamp(up * (top - probe.z), patch.low, patch.high)};
        if (share > 0.0)
            sum.take(property, share * swept, {stand.tip.x + side.x, stand.tip.y + side.y, 0.5 * (low + top)});
        if (meets)
            sum.meet(patch, (slopes ? 1.0 : share) * patch.size, std::min(ends[0], ends[1]),
                     std::max(ends[0], ends[1]));
    };
    if (first < last)
        forEachPieceLeft(sum.workpiece, sum.window, line, std::min(first, pushed), std::max(last, pushed + 1), add);
}

/// Returns the height in mm above the tip, half way between the height of a sloping patch's surface on a line now and
/// that after the tool has moved by the look-ahead distance, with the slope continued.
double SurfaceFlux::heightPushedInto(const Patch& patch, const Stand& stand, LineIndex line) const noexcept {
    const glm::dvec3 normal = stand.turn * patch.normal, place = stand.turn * patch.place;
    const double x = stand.lines.x + (line.u + 0.5) * edge_ - (stand.tip.x + place.x);
    const double y = stand.lines.y + (line.v + 0.5) * edge_ - (stand.tip.y + place.y);
    const double steepness = 1.0 / -patch.normal.z, half = 0.5 * stand.lookAhead;
    const double rise = half * glm::dot(patch.normal, stand.motion) / glm::length(stand.motion) * steepness;
    const double height = patch.place.z + (normal.x * x + normal.y * y) * steepness - rise;
    return std::clamp(height, patch.low - half, patch.high);
}

void SurfaceFlux::measureAtPlace(const Patch& patch, const Stand& stand, Sum& sum) const noexcept {
    const glm::dvec3 motion = stand.motion + glm::cross(stand.turning, patch.place);
    const double swept = glm::dot(patch.area, motion);
    if (swept <= 0.0) return; // facing away from the motion
    const Grid& grid = sum.workpiece.grid();
    const glm::dvec3 place = stand.tip + stand.turn * patch.place;
    const glm::dvec3 ahead = stand.turn * (motion * (stand.lookAhead / glm::length(motion)));
    const glm::dvec3 probe = (place + ahead - stand.lines) / edge_; // voxels
    if (!(probe.x >= 0.0 && probe.y >= 0.0 && probe.z >= 0.0)) return;
    if (!(probe.x < grid.lineCountU() && probe.y < grid.lineCountV() && probe.z < grid.voxelsPerLine())) return;
    const LineIndex line{static_cast<std::int32_t>(probe.x), static_cast<std::int32_t>(probe.y)};
    const auto at = static_cast<RunPosition>(probe.z * unitsPerVoxel);
    const auto add = [&](PropertyIndex property, RunPosition, RunPosition) {
        if (sum.workpiece.properties().isProtected(property)) return;
        sum.take(property, swept, place);
        sum.meet(patch, patch.size, patch.place.z, patch.place.z);
    };
    forEachPieceLeft(sum.workpiece, sum.window, line, at, at + 1, add);
}

} // namespace burin

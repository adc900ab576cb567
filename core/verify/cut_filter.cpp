// SPDX-FileCopyrightText: 2026 The Burin authors
// SPDX-License-Identifier: Apache-2.0
#include "core/verify/cut_filter.h"

#include "core/base/vectorised.h"
#include "core/cutting/line_frame.h"

#include <algorithm>
#include <cmath>
#include <cstring>

namespace burin {

namespace {

constexpr double wider = 0.02;   // voxels
constexpr float lower = 4.0F;    // run units
constexpr double steepest = 4.0; // a steeper move counts as being at its lowest point everywhere
constexpr float unitsOfVoxel = unitsPerVoxel;

/// Parameters common to all lanes.
struct Form {
    float radius, flat, corner;
    bool ball;
};

BURIN_INLINE Floats heightOf(const Form& form, const CutFilter::Way& way, Floats ahead, Floats aside, Floats from,
                             Floats to, Floats halfChord) noexcept {
    if (form.ball) {
        const Floats at = least(most(ahead - halfChord * way.sine, from), to), off = ahead - at;
        return way.height + at * way.slope +
               (form.corner - rootsOf(form.corner * form.corner - aside * aside - off * off)) * unitsOfVoxel;
    }
    const Floats tip = way.height + least(from * way.slope, to * way.slope);
    const Floats off = ahead - least(most(ahead, Floats{}), floats(way.length));
    const Floats beyond = most(rootsOf(aside * aside + off * off) - form.flat, Floats{});
    return tip + (form.corner - rootsOf(form.corner * form.corner - beyond * beyond)) * unitsOfVoxel;
}

BURIN_VECTORISED
std::uint64_t linesBelow(const Form& form, const CutFilter::Way& way, float toU, float toV, const std::int32_t* tops,
                         std::size_t stride) noexcept {
    const Floats lane{0.0F, 1.0F, 2.0F, 3.0F, 4.0F, 5.0F, 6.0F, 7.0F};
    const Floats x = lane + toU;
    const float square = form.radius * form.radius;
    std::uint64_t lines = 0;
    for (int v = 0; v < lanes; ++v) {
        const float y = toV + static_cast<float>(v);
        const Floats ahead = x * way.alongX + y * way.alongY, aside = x * way.alongY - y * way.alongX;
        const Floats halfChord = rootsOf(square - aside * aside);
        const Floats from = most(ahead - halfChord, Floats{}), to = least(ahead + halfChord, floats(way.length));
        const Floats height = heightOf(form, way, ahead, aside, from, to, halfChord);
        Integers top;
        std::memcpy(&top, tops + static_cast<std::size_t>(v) * stride, sizeof top);
        const Integers below = (height - lower < floatsOf(top)) & (aside * aside < floats(square)) & (from <= to);
        lines |= std::uint64_t{bitsOf(below)} << (8 * v);
    }
    return lines;
}

} // namespace

CutFilter::CutFilter(std::span<const RevolvedPiece> flutes, const Grid& grid) noexcept : grid_(grid) {
    double widest = 0.0;
    for (const RevolvedPiece& piece : flutes) widest = std::max(widest, piece.widestRadius());
    radius_ = flat_ = static_cast<float>(widest / grid.edge() + wider);
    const RevolvedPiece& piece = flutes.front();
    const bool rounded = flutes.size() == 1 && !piece.bulges() && piece.cornerRadius > 0.0 && piece.bottom == 0.0;
    if (!rounded) return;
    corner_ = static_cast<float>(piece.cornerRadius / grid.edge() + wider);
    flat_ = static_cast<float>((piece.bottomRadius - piece.cornerRadius) / grid.edge());
    ball_ = piece.bottomRadius == piece.cornerRadius;
}

CutFilter::Way CutFilter::way(const glm::dvec3& from, const glm::dvec3& to) const noexcept {
    const glm::dvec3 low = inLineFrame(grid_, grid_.low());
    const glm::dvec3 start = (from - low) / grid_.edge(), end = (to - low) / grid_.edge();
    Way way;
    way.fromX = start.x - 0.5;
    way.fromY = start.y - 0.5;
    const double length = std::hypot(end.x - start.x, end.y - start.y), rise = end.z - start.z;
    way.height = static_cast<float>(std::min(start.z, end.z) * unitsPerVoxel);
    if (!(length > 1e-9)) return way;
    way.alongX = static_cast<float>((end.x - start.x) / length);
    way.alongY = static_cast<float>((end.y - start.y) / length);
    way.length = static_cast<float>(length);
    if (std::abs(rise) > steepest * length) return way;
    way.height = static_cast<float>(start.z * unitsPerVoxel);
    way.slope = static_cast<float>(rise / length * unitsPerVoxel);
    way.sine = static_cast<float>(rise / std::hypot(rise, length));
    return way;
}

std::uint64_t CutFilter::mayCut(const Way& way, LineIndex corner, const std::int32_t* tops,
                                std::size_t stride) const noexcept {
    return linesBelow({radius_, flat_, corner_, ball_}, way, static_cast<float>(corner.u - way.fromX),
                      static_cast<float>(corner.v - way.fromY), tops, stride);
}

} // namespace burin

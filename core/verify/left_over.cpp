// SPDX-FileCopyrightText: 2026 The Burin authors
// SPDX-License-Identifier: Apache-2.0
#include "core/verify/left_over.h"

#include "core/base/parallel.h"
#include "core/cutting/line_frame.h"
#include "core/volume/runs/brick_lines.h"

#include <algorithm>
#include <cmath>
#include <limits>

namespace burin {

namespace {

constexpr double start = 0.125; // voxels
constexpr double nudge = 1e-6;  // voxels: across a border

/// The parameter at which a ray leaves a slab.
double leaves(double from, double slope, double low, double high) noexcept {
    if (slope > 0.0) return (high - from) / slope;
    if (slope < 0.0) return (low - from) / slope;
    return std::numeric_limits<double>::infinity();
}

} // namespace

LeftOver::LeftOver(const RunVolume& workpiece)
    : workpiece_(workpiece)
    , grid_(workpiece.grid())
    , bricksU_((grid_.lineCountU() + brickSide - 1) / brickSide)
    , common_(static_cast<std::size_t>(bricksU_) *
              static_cast<std::size_t>((grid_.lineCountV() + brickSide - 1) / brickSide)) {
    parallelIntervals(std::size_t{0}, common_.size(), 64, [&](std::size_t from, std::size_t to) {
        for (std::size_t i = from; i != to; ++i) {
            const auto row = static_cast<std::int32_t>(i) / bricksU_, column = static_cast<std::int32_t>(i) % bricksU_;
            common_[i] = commonOf({column * brickSide, row * brickSide});
        }
    });
}

/// Uses the topmost stock of each line.
LeftOver::Common LeftOver::commonOf(LineIndex corner) const {
    const PropertyList& properties = workpiece_.properties();
    Common common{0, static_cast<std::int32_t>(grid_.lineEnd())};
    const std::int32_t endV = std::min(corner.v + brickSide, grid_.lineCountV());
    const std::int32_t endU = std::min(corner.u + brickSide, grid_.lineCountU());
    for (LineIndex line = corner; line.v < endV; ++line.v)
        for (line.u = corner.u; line.u < endU; ++line.u) {
            Common top;
            std::int32_t from = 0;
            for (const Segment segment : workpiece_.line(line)) {
                const auto to = static_cast<std::int32_t>(segment.end());
                if (segment.property() != airProperty && !properties.isProtected(segment.property())) top = {from, to};
                from = to;
            }
            common = {std::max(common.from, top.from), std::min(common.to, top.to)};
            if (common.from >= common.to) return {};
        }
    return common;
}

double LeftOver::along(const glm::dvec3& place, const glm::dvec3& direction, double longest) const noexcept {
    // Lengths in voxels of the line frame; heights in run units.
    const glm::dvec3 from = inLineFrame(grid_, (place - grid_.low()) / grid_.edge());
    const glm::dvec3 slope = inLineFrame(grid_, direction);
    const glm::dvec3 end(grid_.lineCountU(), grid_.lineCountV(), grid_.voxelsPerLine());
    const double last = longest / grid_.edge();
    double thickness = 0.0;
    for (double way = start; way <= last;) {
        const glm::dvec3 at = from + way * slope;
        if (!(at.x >= 0.0 && at.y >= 0.0 && at.z >= 0.0 && at.x < end.x && at.y < end.y && at.z < end.z)) break;
        const LineIndex line{static_cast<std::int32_t>(at.x), static_cast<std::int32_t>(at.y)};
        const auto position = static_cast<std::int32_t>(at.z * unitsPerVoxel);
        LineIndex corner{line.u / brickSide * brickSide, line.v / brickSide * brickSide};
        double side = brickSide;
        Common interval = common_[static_cast<std::size_t>(corner.v / brickSide * bricksU_ + corner.u / brickSide)];
        bool stock = true;
        if (position < interval.from || position >= interval.to) {
            corner = line;
            side = 1.0;
            interval = {};
            PropertyIndex property = airProperty;
            for (const Segment segment : workpiece_.line(line)) {
                interval = {interval.to, static_cast<std::int32_t>(segment.end())};
                property = segment.property();
                if (position < interval.to) break;
            }
            if (property == airProperty) break;
            stock = !workpiece_.properties().isProtected(property);
        }
        const double out = std::min({leaves(from.x, slope.x, corner.u, corner.u + side),
                                     leaves(from.y, slope.y, corner.v, corner.v + side),
                                     leaves(from.z, slope.z, static_cast<double>(interval.from) / unitsPerVoxel,
                                            static_cast<double>(interval.to) / unitsPerVoxel)});
        if (stock) thickness = std::max(out, way);
        way = std::max(out, way) + nudge;
    }
    return std::min(thickness, last) * grid_.edge();
}

} // namespace burin

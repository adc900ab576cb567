// SPDX-FileCopyrightText: 2026 The Burin authors
// SPDX-License-Identifier: Apache-2.0
#pragma once

#include "core/tool/tool.h"
#include "core/volume/runs/run_volume.h"

#include <algorithm>
#include <cmath>

namespace burin::benchmarks {

/// Voxels first … end - 1 of a line along z; empty if end <= first.
struct VoxelSpan {
    std::int32_t first = 0, end = 0;
    bool empty() const noexcept { return end <= first; }
};

/// Flutes of a tool, voxels of 1 mm.
struct EndMill {
    double radius = 0.0;
    double length = 0.0;
    double corner = 0.0; ///< radius of the end's rounding: `radius` for a ball, 0 for a flat end
};
inline EndMill endMillOf(const Cutter& cutter) {
    return {cutter.radius(), cutter.fluteLength, cutter.cornerRadius};
}

/// A cutter with a ball, flat or bull-nosed end as whole voxels of 1 mm at any pose with axis +Z. A voxel belongs to it
/// if its centre is inside.
class VoxelTool {
public:
    VoxelTool(const EndMill& tool, const Grid& grid)
        : radius_(tool.radius)
        , corner_(tool.corner)
        , fluteLength_(tool.length)
        , countU_(grid.lineCountU())
        , countV_(grid.lineCountV())
        , length_(grid.voxelsPerLine()) {}

    double radius() const noexcept { return radius_; }

    /// Calls visit(line, span) for every line that meets the tool with its tip at a position.
    template <class Visit>
    void forEachLine(const glm::dvec3& tip, Visit&& visit) const {
        const VoxelSpan rows = within(tip.y, radius_, countV_);
        for (std::int32_t v = rows.first; v < rows.end; ++v) {
            const double dy = v + 0.5 - tip.y, rest = radius_ * radius_ - dy * dy;
            if (rest <= 0.0) continue;
            const VoxelSpan row = within(tip.x, std::sqrt(rest), countU_);
            for (std::int32_t u = row.first; u < row.end; ++u) {
                const double dx = u + 0.5 - tip.x;
                visit(LineIndex{u, v}, along(tip, rest - dx * dx));
            }
        }
    }
    /// Voxels of a line that the tool covers.
    VoxelSpan at(const glm::dvec3& tip, LineIndex line) const noexcept {
        const double dx = line.u + 0.5 - tip.x, dy = line.v + 0.5 - tip.y;
        return along(tip, radius_ * radius_ - dx * dx - dy * dy);
    }

private:
    /// @param square half chord of the outline at the line, squared
    VoxelSpan along(const glm::dvec3& tip, double square) const noexcept {
        if (square <= 0.0) return {};
        const double low = tip.z + endHeight(square), high = tip.z + fluteLength_;
        return {std::max(0, up(low)), std::min(length_, up(high))};
    }
    double endHeight(double square) const noexcept {
        if (corner_ == radius_) return radius_ - std::sqrt(square);
        const double beyond = std::sqrt(radius_ * radius_ - square) - (radius_ - corner_);
        return beyond <= 0.0 ? 0.0 : corner_ - std::sqrt(std::max(0.0, corner_ * corner_ - beyond * beyond));
    }
    static VoxelSpan within(double middle, double half, std::int32_t count) noexcept {
        return {std::max(0, up(middle - half)), std::min(count, up(middle + half))};
    }
    /// The first voxel whose centre is not below a position. Half-open, so that a tie is decided once.
    static std::int32_t up(double place) noexcept { return static_cast<std::int32_t>(std::ceil(place - 0.5)); }

    double radius_, corner_, fluteLength_;
    std::int32_t countU_, countV_, length_;
};

/// Calls visit(tip, tipBefore) for the poses of a move, less than a voxel apart (paper, eqs. 6-8), without its start.
template <class Visit>
void forEachPose(const glm::dvec3& from, const glm::dvec3& to, Visit&& visit) {
    const int poses = static_cast<int>(std::floor(glm::length(to - from))) + 1;
    glm::dvec3 before = from;
    for (int i = 1; i <= poses; ++i) {
        const glm::dvec3 tip = i == poses ? to : from + (to - from) * (static_cast<double>(i) / poses);
        visit(tip, before);
        before = tip;
    }
}

/// Calls visit(part) for the parts of `now` that are not in `before`: at most two spans.
template <class Visit>
void forEachNew(VoxelSpan now, VoxelSpan before, Visit&& visit) {
    if (now.empty()) return;
    if (before.empty() || before.end <= now.first || now.end <= before.first) return visit(now);
    if (now.first < before.first) visit(VoxelSpan{now.first, before.first});
    if (now.end > before.end) visit(VoxelSpan{before.end, now.end});
}

} // namespace burin::benchmarks

// SPDX-FileCopyrightText: 2026 The Burin authors
// SPDX-License-Identifier: Apache-2.0
#include "core/field/field_builder.h"

#include "core/field/brick_sampler.h"
#include "core/field/spread.h"

#include <algorithm>
#include <cmath>
#include <limits>
#include <numbers>

namespace burin {

namespace {

constexpr double halfDiagonal = 0.5 * std::numbers::sqrt3; // of a cube of edge 1

class Builder {
public:
    Builder(const MeshDistance& part, const ToolFieldRequest& request, Progress& progress)
        : part_(part), request_(request), progress_(progress), resolution_(fieldResolution(request)) {}

    Result<BrickField> build() {
        if (!lay()) return tooLarge();
        sampleCorners();
        boundCoarseBricks();
        if (!choose()) return tooLarge();
        BrickSampler sampler(part_, request_, resolution_, field_, fine_);
        spread(fine_.size(), 0.2, 0.5, progress_, [&](std::size_t order) { sampler.sampleEven(order); });
        spread(fine_.size(), 0.5, 1.0, progress_, [&](std::size_t order) { sampler.fill(order); });
        if (progress_.cancelled()) return Error{ErrorCode::cancelled, "boundary field of a tool", "", ""};
        progress_.report(1.0);
        return std::move(field_);
    }

private:
    static Error tooLarge() {
        return {ErrorCode::outOfMemory, "boundary field of a tool", "", "more bricks than a field can count"};
    }

    double clearance(const glm::dvec3& tip, double within) const {
        return clearanceAt(part_, request_, tip, within).value;
    }

    bool lay() {
        field_.tips = request_.tips;
        field_.spacing = resolution_.spacing;
        field_.interpolationBound = resolution_.interpolationBound;
        const double reach = std::max(resolution_.high, -resolution_.low) + 2.0 * halfDiagonal * field_.brickEdge();
        field_.quantum = (reach + resolution_.interpolationBound) / 32000.0;
        double count = 1.0;
        for (int axis = 0; axis < 3; ++axis) {
            const double along = std::max(
                1.0, std::ceil((request_.tips.high[axis] - request_.tips.low[axis]) / field_.brickEdge() - 1e-9));
            count *= along + 1.0;
            if (count > 1e9) return false;
            field_.bricks[axis] = static_cast<int>(along);
        }
        field_.corners.assign(field_.cornerCount(), 0.0F);
        field_.coarseBound.assign(field_.brickCount(), 0.0F);
        field_.place.assign(field_.brickCount(), BrickField::coarse);
        return true;
    }

    static float roundedDown(double value) noexcept {
        const auto nearest = static_cast<float>(value);
        return static_cast<double>(nearest) > value ? std::nextafter(nearest, -std::numeric_limits<float>::infinity())
                                                    : nearest;
    }

    void sampleCorners() {
        const int rows = field_.bricks.y + 1;
        spread(static_cast<std::size_t>(rows) * static_cast<std::size_t>(field_.bricks.z + 1), 0.0, 0.1, progress_,
               [&](std::size_t row) {
                   const int j = static_cast<int>(row) % rows, k = static_cast<int>(row) / rows;
                   double bound = farthestClearance;
                   for (int i = 0; i <= field_.bricks.x; ++i) {
                       const glm::ivec3 corner{i, j, k};
                       const double value = clearance(field_.brickLow(corner), bound);
                       field_.corners[field_.cornerAt(corner)] = roundedDown(value);
                       bound = value + field_.brickEdge() + 1e-6; // no tip this much farther on has more
                   }
               });
    }

    std::pair<double, double> cornerRange(const glm::ivec3& brick) const noexcept {
        double low = farthestClearance, high = -farthestClearance;
        for (int i = 0; i < 8; ++i) {
            const double value = field_.corners[field_.cornerAt(brick + glm::ivec3(i & 1, (i >> 1) & 1, i >> 2))];
            low = std::min(low, value);
            high = std::max(high, value);
        }
        return {low, high};
    }

    void boundCoarseBricks() {
        const double edge = field_.brickEdge();
        for (std::size_t number = 0; number < field_.brickCount(); ++number) {
            const double least = cornerRange(field_.brickOf(number)).first - halfDiagonal * edge;
            double bound = halfDiagonal * edge; // the clearance changes no faster than the tip moves
            if (least > 0.0) bound = std::min(bound, 0.375 * edge * edge / least); // nor bends more than a ball's
            field_.coarseBound[number] = static_cast<float>(bound * (1.0 + 1e-6) + 1e-6);
        }
    }

    /// Whether the band may pass through a cube; asks its centre, then those of its eighths.
    bool inBand(const glm::dvec3& centre, double edge, int depth) const {
        const double radius = halfDiagonal * edge;
        const double value = clearance(centre, resolution_.high + radius + 1e-6);
        if (value - radius > resolution_.high || value + radius < resolution_.low) return false;
        if (depth == 0) return true;
        for (int i = 0; i < 8; ++i) {
            const glm::dvec3 side{i & 1 ? 0.25 : -0.25, i & 2 ? 0.25 : -0.25, i & 4 ? 0.25 : -0.25};
            if (inBand(centre + edge * side, 0.5 * edge, depth - 1)) return true;
        }
        return false;
    }

    bool choose() {
        const double edge = field_.brickEdge(), radius = halfDiagonal * edge;
        std::vector<std::uint8_t> wanted(field_.brickCount(), 0);
        spread(field_.brickCount(), 0.1, 0.2, progress_, [&](std::size_t number) {
            const glm::ivec3 brick = field_.brickOf(number);
            const auto [low, high] = cornerRange(brick);
            if (low - radius > resolution_.high || high + radius < resolution_.low) return;
            wanted[number] = inBand(field_.brickLow(brick) + 0.5 * edge, edge, 2) ? 1 : 0;
        });
        for (std::size_t number = 0; number < wanted.size(); ++number)
            if (wanted[number] != 0) {
                field_.place[number] = static_cast<std::int32_t>(fine_.size());
                fine_.push_back(static_cast<std::uint32_t>(number));
            }
        if (fine_.size() > static_cast<std::size_t>(std::numeric_limits<std::int32_t>::max())) return false;
        field_.samples.assign(fine_.size() * BrickField::samplesPerBrick, 0);
        return true;
    }

    const MeshDistance& part_;
    const ToolFieldRequest& request_;
    Progress& progress_;
    FieldResolution resolution_;
    BrickField field_;
    std::vector<std::uint32_t> fine_; ///< bricks that are fine, in the order of their samples
};

} // namespace

FieldResolution fieldResolution(const ToolFieldRequest& request) noexcept {
    const double voxel = request.voxel;
    FieldResolution resolution;
    resolution.interpolationBound = 0.02 * voxel;
    const double radius = request.tool.front().cornerRadius + 4.0 * voxel;
    resolution.spacing = std::min(voxel, std::sqrt(4.0 * resolution.interpolationBound * radius));
    resolution.low = -3.0 * voxel;
    resolution.high = std::max(request.maximumAllowance, 0.0) + 4.0 * voxel;
    return resolution;
}

Result<BrickField> buildBrickField(const MeshDistance& part, const ToolFieldRequest& request, Progress& progress) {
    return Builder(part, request, progress).build();
}

} // namespace burin

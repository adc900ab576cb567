// SPDX-FileCopyrightText: 2026 The Burin authors
// SPDX-License-Identifier: Apache-2.0
#include "core/field/field_builder.h"

#include "core/field/brick_sampler.h"
#include "core/field/spread.h"

#include <algorithm>
#include <cmath>
#include <limits>
#include <numbers>
#include <optional>

namespace burin {

namespace {

const glm::vec3 notAsked(std::numeric_limits<float>::infinity()); // for a gradient
constexpr double halfDiagonal = 0.5 * std::numbers::sqrt3;        // of a cube of edge 1

class Builder {
public:
    Builder(const MeshDistance& part, const ToolFieldRequest& request, Progress& progress)
        : part_(part), request_(request), progress_(progress), resolution_(fieldResolution(request)) {}

    Result<BrickField> build() {
        if (!lay()) return tooLarge();
        sampleCorners();
        boundCoarseBricks();
        if (!choose()) return tooLarge();
        BrickSampler sampler(part_, request_, resolution_, field_, fine_, corners_);
        spread(fine_.size(), 0.2, 0.25, progress_, [&](std::size_t order) { sampler.look(order); });
        spread(fine_.size(), 0.25, 0.5, progress_, [&](std::size_t order) { sampler.sampleEven(order); });
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
        // A fine brick has a corner as near as mayHoldBand says, or one as deep.
        const double edge = field_.brickEdge(), reach = nearEnough(edge) - resolution_.low + 3.0 * halfDiagonal * edge;
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

    /// Every second corner is asked for; those between where the band may be near, and a value that is safe elsewhere.
    void sampleCorners() {
        corners_.resize(field_.cornerCount());
        const int rows = field_.bricks.y + 1;
        const auto inRows = [&](double from, double to, const auto& corner) {
            spread(static_cast<std::size_t>(rows) * static_cast<std::size_t>(field_.bricks.z + 1), from, to, progress_,
                   [&](std::size_t row) {
                       const int j = static_cast<int>(row) % rows, k = static_cast<int>(row) / rows;
                       Bound bound;
                       for (int i = 0; i <= field_.bricks.x; ++i) corner(glm::ivec3(i, j, k), bound);
                   });
        };
        inRows(0.0, 0.05, [&](const glm::ivec3& corner, Bound& bound) {
            if (isEven(corner)) askCorner(corner, bound);
        });
        inRows(0.05, 0.1, [&](const glm::ivec3& corner, Bound& bound) {
            if (isEven(corner)) return;
            const std::optional<double> safe = farValue(corner);
            if (safe)
                corners_[field_.cornerAt(corner)] = {static_cast<float>(*safe), notAsked};
            else
                askCorner(corner, bound);
        });
        for (std::size_t i = 0; i < corners_.size(); ++i) {
            const auto distance = static_cast<double>(corners_[i].distance);
            field_.corners[i] = roundedDown(distance - 1e-6 - 1.2e-7 * std::abs(distance));
        }
    }

    /// The last place asked in a row: none has more clearance than that and the way.
    struct Bound {
        double value = farthestClearance;
        int at = 0;
    };

    bool isEven(const glm::ivec3& corner) const noexcept {
        for (int axis = 0; axis < 3; ++axis) // the last ones count, too: each lies on a cube
            if (corner[axis] % 2 != 0 && corner[axis] != field_.bricks[axis]) return false;
        return true;
    }

    void askCorner(const glm::ivec3& corner, Bound& last) {
        const double within = last.value + field_.brickEdge() * (corner.x - last.at) + 1e-6;
        const ClearanceSample found = clearanceAt(part_, request_, field_.brickLow(corner), within);
        corners_[field_.cornerAt(corner)] = {static_cast<float>(found.value), glm::vec3(found.gradient)};
        last = {found.value, corner.x};
    }

    /// What a corner between even ones has for certain, when no cube that it lies on comes near the band.
    std::optional<double> farValue(const glm::ivec3& corner) const noexcept {
        double value = farthestClearance;
        for (int side = 0; side < 8; ++side) {
            glm::ivec3 low, high;
            bool inside = true;
            for (int axis = 0; axis < 3; ++axis) {
                low[axis] = (corner[axis] - ((side >> axis) & 1)) / 2 * 2;
                inside = inside && corner[axis] - ((side >> axis) & 1) >= 0 && low[axis] < field_.bricks[axis];
                high[axis] = std::min(low[axis] + 2, field_.bricks[axis]);
            }
            if (!inside) continue;
            double least = farthestClearance, sum = 0.0;
            for (int i = 0; i < 8; ++i) {
                const glm::ivec3 at{i & 1 ? high.x : low.x, i & 2 ? high.y : low.y, i & 4 ? high.z : low.z};
                const auto distance = static_cast<double>(corners_[field_.cornerAt(at)].distance);
                const glm::dvec3 share = glm::abs(glm::dvec3(corner - at)) / glm::dvec3(high - low);
                least = std::min(least, distance);
                sum += (1.0 - share.x) * (1.0 - share.y) * (1.0 - share.z) * distance;
            }
            if (mayHoldBand(least, 2.0 * field_.brickEdge())) return std::nullopt;
            value = std::min(value, sum - interpolationExcess(least, 2.0 * field_.brickEdge()));
        }
        return value;
    }

    /// Whether a cube whose corners have so much clearance may have less than the band's upper end: a tip that has lies
    /// so near to a place where the tool touches, and that place no nearer to a corner than half a face's diagonal
    /// tells.
    bool mayHoldBand(double least, double edge) const noexcept { return least <= nearEnough(edge); }
    double nearEnough(double edge) const noexcept {
        return std::max(std::hypot(resolution_.high, std::sqrt(0.5) * edge), halfDiagonal * edge) + 1e-6;
    }

    /// By how much a value between a cube's corners may exceed the clearance: this changes no faster than the tip
    /// moves, nor bends more than a ball's.
    static double interpolationExcess(double least, double edge) noexcept {
        const double reach = halfDiagonal * edge, away = least - reach;
        return away > 0.0 ? std::min(reach, 0.375 * edge * edge / away) : reach;
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
            const double bound = interpolationExcess(cornerRange(field_.brickOf(number)).first, edge);
            field_.coarseBound[number] = static_cast<float>(bound * (1.0 + 1e-6) + 1e-6);
        }
    }

    bool allAsked(const glm::ivec3& brick) const noexcept {
        for (int i = 0; i < 8; ++i) {
            const glm::ivec3 corner = brick + glm::ivec3(i & 1, (i >> 1) & 1, i >> 2);
            if (std::isinf(corners_[field_.cornerAt(corner)].gradient.x)) return false;
        }
        return true;
    }

    bool choose() {
        const double edge = field_.brickEdge(), radius = halfDiagonal * edge;
        std::vector<std::uint8_t> wanted(field_.brickCount(), 0);
        spread(field_.brickCount(), 0.1, 0.2, progress_, [&](std::size_t number) {
            const glm::ivec3 brick = field_.brickOf(number);
            if (!allAsked(brick)) return; // far
            const auto [low, high] = cornerRange(brick);
            if (!mayHoldBand(low, edge) || high + radius < resolution_.low) return;
            if (high < resolution_.low) { // all of it may be deeper
                const double middle = clearance(field_.brickLow(brick) + 0.5 * edge, high + radius + 1e-6);
                if (middle + radius < resolution_.low) return;
            }
            wanted[number] = 1;
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
    std::vector<PartSample> corners_; ///< of bricks, as the field's, mm, with their gradients
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

// SPDX-FileCopyrightText: 2026 The Burin authors
// SPDX-License-Identifier: Apache-2.0
#include "core/field/field_builder.h"

#include "core/base/available_memory.h"
#include "core/field/brick_sampler.h"
#include "core/field/spread.h"
#include "core/field/tip_asker.h"
#include "core/field/tip_corners.h"

#include <algorithm>
#include <cmath>
#include <limits>
#include <numbers>

namespace burin {

namespace {

class Builder {
public:
    Builder(const MeshDistance& part, const ToolFieldRequest& request, Progress& progress)
        : part_(part), request_(request), progress_(progress), resolution_(fieldResolution(request)) {}

    /// @param spacing  of fine samples, an eighth of a brick, mm
    Builder(const MeshDistance& part, const ToolFieldRequest& request, double spacing, Progress& progress)
        : Builder(part, request, progress) {
        resolution_.spacing = spacing;
    }

    Result<CoarseBricks> buildCoarse() {
        if (Result<void> laid = lay(); !laid) return laid.error();
        TipCorners corners(part_, request_, resolution_, field_);
        corners.sample(progress_, 0.0, 0.9);
        std::vector<std::uint8_t> band = bricksInBand(corners, 0.9, 1.0);
        if (progress_.cancelled()) return Error{ErrorCode::cancelled, subject, "", ""};
        return CoarseBricks{std::move(field_), std::move(band)};
    }

    Result<BrickField> build() {
        if (Result<void> laid = lay(); !laid) return laid.error();
        TipCorners corners(part_, request_, resolution_, field_);
        corners.sample(progress_, 0.0, 0.15);
        if (Result<void> chosen = choose(corners); !chosen) return chosen.error();
        BrickSampler(part_, request_, resolution_, field_, fine_, corners.samples()).fill(progress_, 0.2, 1.0);
        if (progress_.cancelled()) return Error{ErrorCode::cancelled, subject, "", ""};
        progress_.report(1.0);
        return std::move(field_);
    }

private:
    static constexpr const char* subject = "boundary field of a tool";

    static Error tooLarge() { return {ErrorCode::outOfMemory, subject, "", "more bricks than a field can count"}; }

    Result<void> lay() {
        field_.tips = request_.tips;
        field_.spacing = resolution_.spacing;
        field_.interpolationBound = resolution_.interpolationBound;
        field_.quantum = resolution_.quantum;
        double count = 1.0;
        for (int axis = 0; axis < 3; ++axis) {
            const double along = std::max(
                1.0, std::ceil((request_.tips.high[axis] - request_.tips.low[axis]) / field_.brickEdge() - 1e-9));
            count *= along + 1.0;
            if (count > 1e9) return tooLarge();
            field_.bricks[axis] = static_cast<int>(along);
        }
        constexpr std::size_t each = sizeof(TipSample) + 3 * sizeof(float) + sizeof(std::uint8_t);
        if (Result<void> fits = needMemory(subject, count * static_cast<double>(each)); !fits) return fits;
        field_.corners.assign(field_.cornerCount(), 0.0F);
        field_.coarseBound.assign(field_.brickCount(), 0.0F);
        field_.place.assign(field_.brickCount(), BrickField::coarse);
        return {};
    }

    /// By brick; 1 or 0.
    std::vector<std::uint8_t> bricksInBand(const TipCorners& corners, double from, double to) {
        std::vector<std::uint8_t> band(field_.brickCount(), 0);
        spreadIntervals(field_.brickCount(), from, to, progress_, [&](std::size_t first, std::size_t end) {
            TipAsker asker(part_, request_, {1e-4 * request_.voxel, -field_.brickEdge(), 0.1 * request_.voxel});
            for (std::size_t number = first; number < end; ++number)
                band[number] = corners.mayHoldBand(field_.brickOf(number), asker) ? 1 : 0;
        });
        return band;
    }

    /// Determines the fine bricks.
    Result<void> choose(const TipCorners& corners) {
        const std::vector<std::uint8_t> wanted = bricksInBand(corners, 0.15, 0.2);
        for (std::size_t number = 0; number < wanted.size(); ++number)
            if (wanted[number] != 0) {
                field_.place[number] = static_cast<std::int32_t>(fine_.size());
                fine_.push_back(static_cast<std::uint32_t>(number));
            }
        if (fine_.size() > static_cast<std::size_t>(std::numeric_limits<std::int32_t>::max())) return tooLarge();
        const double needed = static_cast<double>(fine_.size()) * static_cast<double>(BrickSampler::bytesPerBrick());
        if (Result<void> fits = needMemory(subject, needed); !fits) return fits;
        field_.samples.assign(fine_.size() * BrickField::samplesPerBrick, 0);
        field_.fineBound.assign(fine_.size(), 0.0F);
        return {};
    }

    const MeshDistance& part_;
    const ToolFieldRequest& request_;
    Progress& progress_;
    FieldResolution resolution_;
    BrickField field_;
    std::vector<std::uint32_t> fine_; ///< fine bricks, in the order of their samples
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
    resolution.clear = std::max(request.maximumAllowance, 0.0) + 0.05 * voxel;
    // A fine brick has a corner as near as TipCorners::mayHoldBand requires, or as deep.
    const double edge = BrickField::cells * resolution.spacing, diagonal = std::numbers::sqrt3 * edge;
    const double reach = TipCorners::nearEnough(resolution, edge) - resolution.low + 1.5 * diagonal;
    resolution.quantum = (reach + resolution.interpolationBound) / 32000.0;
    return resolution;
}

Result<void> checkFieldRequest(const ToolFieldRequest& request) {
    if (request.tool.empty()) return Error{ErrorCode::argumentInvalid, "tool", "", "at least one piece"};
    if (!(request.voxel > 0.0) || !std::isfinite(request.voxel))
        return Error{ErrorCode::argumentInvalid, "voxel", "", "greater than 0 mm"};
    if (request.tips.empty() || !isFinite(request.tips.low) || !isFinite(request.tips.high))
        return Error{ErrorCode::argumentInvalid, "tips", "", "a box that is not empty"};
    return {};
}

Result<CoarseBricks> buildCoarseBricks(const MeshDistance& part, const ToolFieldRequest& request, double edge,
                                       Progress& progress) {
    return Builder(part, request, edge / BrickField::cells, progress).buildCoarse();
}

Result<BrickField> buildBrickField(const MeshDistance& part, const ToolFieldRequest& request, Progress& progress) {
    return Builder(part, request, progress).build();
}

} // namespace burin

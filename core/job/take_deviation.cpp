// SPDX-FileCopyrightText: 2026 The Burin authors
// SPDX-License-Identifier: Apache-2.0
#include "core/job/take_deviation.h"

#include "core/base/parallel.h"
#include "core/base/parallel_progress.h"
#include "core/job/milling_context.h"
#include "core/job/recorded_time.h"

#include <algorithm>
#include <limits>
#include <optional>
#include <span>
#include <utility>

namespace burin {

namespace {

constexpr std::uint64_t samplesPerValue = TakeTrack::samplesPerBin;
constexpr double noLimit = 1e300; // mm: no limit
constexpr ClearanceTolerance clearanceWithin{.ordinary = 1e-4, .deep = 1e-4};

Error deviationCancelled() {
    return {ErrorCode::cancelled, "deviation of a take", {}, {}};
}

/// Finds the least clearance of some poses, of consecutive samples.
class LeastClearance {
public:
    LeastClearance(const MeshDistance& part, std::span<const RevolvedPiece> tool) : asker_(part, tool) {}

    /// NaN if no pose is finite.
    float of(std::span<const ToolPose> poses) noexcept {
        double least = std::numeric_limits<double>::infinity();
        for (const ToolPose& pose : poses) {
            if (!isFinite(pose.tip) || !isFinite(pose.axis) || canNotBeLess(pose, least)) continue;
            clearance_ = asker_.ask(pose, noLimit, clearanceWithin).clearance;
            asked_ = pose;
            least = std::min(least, clearance_);
        }
        return least < noLimit ? static_cast<float>(least) : std::numeric_limits<float>::quiet_NaN();
    }

private:
    /// A clearance changes by no more than the tool moves.
    bool canNotBeLess(const ToolPose& pose, double least) const noexcept {
        return asked_ && asked_->axis == pose.axis &&
               clearance_ - clearanceWithin.ordinary - glm::distance(asked_->tip, pose.tip) >= least;
    }

    ClearanceAsker asker_;
    std::optional<ToolPose> asked_; ///< the pose that `clearance_` belongs to
    double clearance_ = 0.0;        ///< mm
};

} // namespace

Result<DeviationMatter> deviationMatter(const Project& project, std::int64_t take, const Progress& progress) {
    const Result<std::vector<TakeInfo>> takes = project.takes();
    if (!takes) return takes.error();
    const auto info = std::ranges::find(*takes, take, &TakeInfo::id);
    if (info == takes->end()) return Error{ErrorCode::nameUnknown, "take", std::to_string(take), {}};
    Result<Tool> tool = toolFor(project, info->toolId);
    if (!tool) return std::move(tool).error();
    DeviationMatter matter{*info, std::move(*tool), {}};
    matter.poses.reserve(info->sampleCount);
    const Result<void> read = project.visitSamples(take, [&](std::span<const Sample> samples) -> Result<void> {
        for (const Sample& sample : samples) matter.poses.push_back(sample.proxy);
        return progress.cancelled() ? Result<void>(deviationCancelled()) : Result<void>();
    });
    if (!read) return read.error();
    return matter;
}

Result<std::vector<float>> takeDeviation(const DeviationMatter& matter, const MeshDistance& part, Progress& progress) {
    const std::span<const ToolPose> poses = matter.poses;
    std::vector<float> values((poses.size() + samplesPerValue - 1) / samplesPerValue,
                              std::numeric_limits<float>::quiet_NaN());
    if (part.bounds().empty()) return values;
    constexpr std::size_t together = 200; // bins with one object for all queries, whose results bound the next ones
    const std::vector<RevolvedPiece> tool = pieces(matter.tool.cutter);
    const std::size_t parts = (values.size() + together - 1) / together;
    ParallelProgress counted(progress, parts);
    parallelFor(std::size_t{0}, parts, [&](std::size_t i) {
        if (progress.cancelled()) return;
        LeastClearance least(part, tool);
        for (std::size_t bin = i * together; bin < std::min(values.size(), (i + 1) * together); ++bin)
            values[bin] = least.of(
                poses.subspan(bin * samplesPerValue, std::min(samplesPerValue, poses.size() - bin * samplesPerValue)));
        counted.add();
    });
    if (progress.cancelled()) return deviationCancelled();
    return values;
}

} // namespace burin

// SPDX-FileCopyrightText: 2026 The Burin authors
// SPDX-License-Identifier: Apache-2.0
#include "core/path/axis_guard.h"

#include "core/base/numbers.h"
#include "core/base/parallel.h"
#include "core/machine/kinematics.h"
#include "core/path/hand_interval.h"

#include <algorithm>
#include <cmath>
#include <optional>

namespace burin {
namespace {

constexpr double guardTolerance = 0.001; // mm that a tilted tool may be nearer than upright
constexpr double guardedGouge = 0.002;   // mm by which a path may be in the part before, by rounding
constexpr double largestPart = 1.0;      // degrees of a move that is followed as one

/// Where a tilted tool is nearer than it may be.
struct Breach {
    glm::dvec3 place{0.0};  ///< mm, on the part or fixture
    double clearance = 0.0; ///< mm
    double missing = 0.0;   ///< mm
};

class AxisGuard {
public:
    AxisGuard(const std::vector<TiltedPoint>& points, std::vector<AxisValues> values, const Kinematics& kinematics,
              bool linksOnly)
        : points_(points), values_(std::move(values)), kinematics_(kinematics), linksOnly_(linksOnly) {}

    /// The worst breach of the distance that a move has to keep from a solid; empty if there is none.
    template <class Kept>
    std::optional<Breach> worst(const PartGuard& solid, const Kept& kept, const Progress& progress) const {
        std::vector<std::optional<Breach>> found(points_.size());
        parallelFor(std::size_t{1}, points_.size(), [&](std::size_t i) {
            if (progress.cancelled() || !isJudged(i)) return;
            double required = kept(points_[i]);
            for (const TiltedPoint* end : {&points_[i - 1], &points_[i]})
                required = std::min(required, solid.clearance(end->before, required + 1.0).clearance);
            found[i] = breach(solid, i, std::max(required, -guardedGouge) - guardTolerance);
        });
        std::optional<Breach> most;
        for (const std::optional<Breach>& each : found)
            if (each && (!most || each->missing > most->missing)) most = each;
        return most;
    }

private:
    bool isJudged(std::size_t i) const noexcept {
        if (linksOnly_ && points_[i].point.kind == MoveKind::cut && hasMoment(points_[i].point)) return false;
        return points_[i - 1].changed() || points_[i].changed();
    }

    std::optional<Breach> breach(const PartGuard& solid, std::size_t i, double required) const {
        const AxisValues &from = values_[i - 1], &to = values_[i];
        double turn = 0.0;
        for (const Axis axis : kinematics_.axes())
            if (isRotary(axis)) turn = std::max(turn, std::abs(to[axis] - from[axis]));
        const auto parts = static_cast<std::size_t>(std::clamp(std::ceil(turn / largestPart), 1.0, 1e4));
        std::optional<Breach> worst;
        ToolPose before = points_[i - 1].point.pose;
        for (std::size_t k = 1; k <= parts; ++k) {
            const double share = static_cast<double>(k) / static_cast<double>(parts);
            const ToolPose next = k == parts ? points_[i].point.pose : kinematics_.poseOf(between(from, to, share));
            if (const auto dip = solid.deepestDip(before, next, required, defaultSampling);
                dip && (!worst || required - dip->clearance > worst->missing)) {
                const ToolPose there{glm::mix(before.tip, next.tip, dip->part),
                                     directionBetween(before.axis, next.axis, dip->part)};
                worst = Breach{solid.clearance(there, 1e3).meshPoint, dip->clearance, required - dip->clearance};
            }
            before = next;
        }
        return worst;
    }

    const std::vector<TiltedPoint>& points_;
    std::vector<AxisValues> values_;
    const Kinematics& kinematics_;
    bool linksOnly_;
};

Error axisError(const char* what, const Breach& breach) {
    const std::string place = formatFixed(breach.place.x, 3) + " " + formatFixed(breach.place.y, 3) + " " +
                              formatFixed(breach.place.z, 3) + " mm";
    return {ErrorCode::checkFailed, "tool axis",
            "the tool comes " + formatFixed(breach.missing, 3) + " mm too near to " + what + " at " + place, ""};
}

} // namespace

Result<void> guardAxes(const std::vector<TiltedPoint>& points, const PartGuard& part, const PathContext& context,
                       const std::map<std::int64_t, double>& allowances, bool linksOnly, const Progress& progress) {
    using By = CoursePose::By;
    std::vector<CoursePose> poses;
    poses.reserve(points.size());
    for (const TiltedPoint& each : points)
        poses.push_back({each.point.pose, each.point.kind == MoveKind::rapid ? By::rapid
                                          : each.point.arc                   ? By::arc
                                                                             : By::line});
    const std::unique_ptr<const Kinematics> kinematics = kinematicsOf(context.machine, context.workOffset);
    Result<std::vector<AxisValues>> values = axesAlong(*kinematics, poses, AxisValues());
    if (!values) return std::move(values).error();
    const AxisGuard guard(points, std::move(*values), *kinematics, linksOnly);
    const auto allowance = [&](const TiltedPoint& point) {
        const auto found = allowances.find(point.point.source);
        return found != allowances.end() ? found->second : 0.0;
    };
    const std::optional<Breach> gouge = guard.worst(part, allowance, progress);
    if (gouge) return axisError("the part", *gouge);
    for (const ObstacleSolid& obstacle : context.obstacles) {
        if (!obstacle.on) continue;
        const PartGuard solid(*obstacle.surface, context.tool);
        const auto margin = [&](const TiltedPoint&) { return obstacle.margin; };
        if (const auto hit = guard.worst(solid, margin, progress)) return axisError("a fixture", *hit);
    }
    if (progress.cancelled()) return Error{ErrorCode::cancelled, "tool axis", "", ""};
    return {};
}

} // namespace burin

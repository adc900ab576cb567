// SPDX-FileCopyrightText: 2026 The Burin authors
// SPDX-License-Identifier: Apache-2.0
#include "core/job/program_moments.h"

#include "core/path/hand_interval.h"

#include <algorithm>

namespace burin {

namespace {

/// Limit of the search: a program omits only few points in a row, where rounding makes them equal to the previous one.
constexpr std::size_t farthestAhead = 1000;

/// Follows a path's points as a program's motions end in them.
class Follower {
public:
    Follower(const Path& path, const Kinematics& kinematics, double tolerance)
        : path_(path), kinematics_(kinematics), tolerance_(tolerance) {}

    /// Returns the point that a motion ends in; empty if there is none ahead.
    std::optional<std::size_t> next(const NcMotion& motion) {
        if (!motion.endKnown(kinematics_.axes())) return std::nullopt;
        const glm::dvec3 place = kinematics_.poseOf(motion.to).tip;
        const std::size_t end = std::min(path_.points.size(), at_ + farthestAhead);
        for (std::size_t i = at_; i < end; ++i) {
            if (glm::distance(path_.points[i].pose.tip, place) > tolerance_) continue;
            at_ = i + 1;
            return i;
        }
        return std::nullopt;
    }

private:
    const Path& path_;
    const Kinematics& kinematics_;
    double tolerance_;
    std::size_t at_ = 0;
};

} // namespace

std::vector<std::optional<std::size_t>> pointsBehind(const ParsedProgram& program, const Path& path,
                                                     const Kinematics& kinematics, double tolerance) {
    std::vector<std::optional<std::size_t>> points(program.motions.size());
    Follower follower(path, kinematics, tolerance);
    std::size_t waiting = 0; // motions from here on belong to the next point that is met
    for (std::size_t i = 0; i < program.motions.size(); ++i) {
        if (program.motions[i].kind == NcMotionKind::dwell) continue;
        const auto point = follower.next(program.motions[i]);
        if (!point) continue;
        std::fill(points.begin() + static_cast<std::ptrdiff_t>(waiting),
                  points.begin() + static_cast<std::ptrdiff_t>(i + 1), point);
        waiting = i + 1;
    }
    return points;
}

std::vector<Moment> momentsOf(const ParsedProgram& program, const Path& path, const Kinematics& kinematics,
                              double tolerance) {
    std::vector<Moment> moments;
    for (const std::optional<std::size_t> point : pointsBehind(program, path, kinematics, tolerance))
        moments.push_back(point ? momentOf(path.points[*point]) : Moment{});
    return moments;
}

} // namespace burin

// SPDX-FileCopyrightText: 2026 The Burin authors
// SPDX-License-Identifier: Apache-2.0
#pragma once

#include "core/haptics/boundary/pose_boundary.h"

#include <limits>

namespace burin {

/// Keeps what a boundary answered last: a tick begins at the pose where the previous one ended. One thread at a time.
class NewestSample {
public:
    void forget() noexcept { pose_.tip = glm::dvec3(std::numeric_limits<double>::quiet_NaN()); }

    /// The kept answer for the same pose if it reaches as far, else that of `ask(pose, enough)`.
    template <class Ask>
    PoseSample at(const ToolPose& pose, double enough, Ask&& ask) noexcept {
        const bool again = pose.tip == pose_.tip && pose.axis == pose_.axis;
        if (again && (sample_.fine || enough <= enough_)) return sample_;
        pose_ = pose;
        enough_ = enough;
        return sample_ = ask(pose, enough);
    }

private:
    ToolPose pose_{glm::dvec3(std::numeric_limits<double>::quiet_NaN())};
    double enough_ = 0.0; ///< mm
    PoseSample sample_;
};

} // namespace burin

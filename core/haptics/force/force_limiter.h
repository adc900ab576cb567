// SPDX-FileCopyrightText: 2026 The Burin authors
// SPDX-License-Identifier: Apache-2.0
#pragma once

#include <glm/glm.hpp>

namespace burin {

/// Keeps a force finite, below a maximum and changing slowly; its direction is kept. A fixed small slew limit would act
/// as delay on stiff devices, so it goes with the coupling's stiffness at a hand's 0.5 m/s.
class ForceLimiter {
public:
    /// @param maximum N. @param stiffness N/m of the coupling. @param period s
    ForceLimiter(double maximum, double stiffness, double period) noexcept;

    /// N in, N out. A force that is not finite becomes zero.
    glm::dvec3 limit(const glm::dvec3& wanted) noexcept;
    void reset() noexcept { applied_ = glm::dvec3(0.0); }
    /// @param maximum N; a change that is less than a fall in a tick is no kick
    void setMaximum(double maximum) noexcept { maximum_ = maximum; }
    /// The last force was cut down to the maximum.
    bool saturated() const noexcept { return saturated_; }
    double maximum() const noexcept { return maximum_; }
    double riseStep() const noexcept { return riseStep_; } ///< N per tick while the force grows
    double fallStep() const noexcept { return fallStep_; } ///< N per tick while it shrinks: letting go is never unsafe

private:
    double maximum_, riseStep_, fallStep_;
    glm::dvec3 applied_{0.0};
    bool saturated_ = false;
};

/// Weight of all forces: fades in from nothing after a start or a fault.
class ForceRamp {
public:
    explicit ForceRamp(double seconds) noexcept : seconds_(seconds) {}
    void restart() noexcept { elapsed_ = 0.0; }
    void advance(double period) noexcept { elapsed_ = elapsed_ + period < seconds_ ? elapsed_ + period : seconds_; }
    bool complete() const noexcept { return elapsed_ >= seconds_; }
    /// 0 … 1, smooth at both ends.
    double weight() const noexcept {
        if (complete()) return 1.0;
        const double t = elapsed_ / seconds_;
        return t * t * (3.0 - 2.0 * t);
    }

private:
    double seconds_, elapsed_ = 0.0;
};

} // namespace burin

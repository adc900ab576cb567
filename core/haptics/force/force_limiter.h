// SPDX-FileCopyrightText: 2026 The Burin authors
// SPDX-License-Identifier: Apache-2.0
#pragma once

#include <glm/glm.hpp>

namespace burin {

/// Keeps a force finite, below a maximum and limited in its rate of change; its direction is kept. A fixed small slew
/// limit would act as a delay on stiff devices, so the limit is that of the coupling's stiffness with a hand moving at
/// 0.5 m/s.
class ForceLimiter {
public:
    /// @param maximum N. @param stiffness N/m of the coupling. @param period s
    ForceLimiter(double maximum, double stiffness, double period) noexcept;

    /// N in, N out. A force that is not finite becomes zero.
    glm::dvec3 limit(const glm::dvec3& wanted) noexcept;
    void reset() noexcept { applied_ = glm::dvec3(0.0); }
    /// @param maximum N; a change smaller than the fall step of a tick causes no perceptible jump
    void setMaximum(double maximum) noexcept { maximum_ = maximum; }
    /// Whether the last force was cut down to the maximum.
    bool saturated() const noexcept { return saturated_; }
    double maximum() const noexcept { return maximum_; }
    double riseStep() const noexcept { return riseStep_; } ///< N per tick while the force grows
    /// N per tick while the force shrinks: releasing a force is never unsafe
    double fallStep() const noexcept { return fallStep_; }

private:
    double maximum_, riseStep_, fallStep_;
    glm::dvec3 applied_{0.0};
    bool saturated_ = false;
};

/// Weight of all forces: fades in from zero after a start or a fault.
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

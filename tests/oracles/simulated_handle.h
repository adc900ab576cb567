// SPDX-FileCopyrightText: 2026 The Burin authors
// SPDX-License-Identifier: Apache-2.0
#pragma once

#include "core/base/units.h"

#include <glm/glm.hpp>

#include <array>
#include <cmath>
#include <cstddef>

namespace burin::test {

/// A hand as a mass that a spring and a damper pull towards an intended position; all 0: nobody holds the handle.
struct SimulatedGrip {
    double mass = 0.0;      ///< kg
    double damping = 0.0;   ///< N·s/m
    double stiffness = 0.0; ///< N/m
};
inline constexpr SimulatedGrip noGrip{}, lightGrip{0.05, 2.0, 100.0}, middleGrip{0.15, 5.0, 300.0},
    firmGrip{0.3, 10.0, 600.0};

/// Mechanical properties of a desktop device's handle, and the effect of its electronics on pose and force.
struct SimulatedMechanism {
    double mass = 0.08;     ///< kg
    double damping = 0.5;   ///< N·s/m
    double encoder = 0.055; ///< mm, resolution of the position reading; 0: exact
    std::size_t delay = 0;  ///< delay of the force in ticks, at most 3
};

/// A device's handle in a hand, integrated on its own in steps of 10 µs while the force is held constant: the reference
/// by which a control loop is judged. It shares nothing with the product's virtual operator.
class SimulatedHandle {
public:
    SimulatedHandle(const SimulatedGrip& grip, const SimulatedMechanism& mechanism, const glm::dvec3& start)
        : grip_(grip), mechanism_(mechanism), position_(start) {}

    /// mm, position read by the encoders
    glm::dvec3 reading() const {
        return mechanism_.encoder > 0.0 ? glm::round(position_ / mechanism_.encoder) * mechanism_.encoder : position_;
    }
    /// One tick. @param force N, computed from the last reading. @param intent mm, position the hand intends to hold.
    /// @param push N, additional external force
    void hold(const glm::dvec3& force, const glm::dvec3& intent, const glm::dvec3& push, double seconds) {
        const glm::dvec3 acting = delayed(force);
        const glm::dvec3 before = position_;
        const int steps = static_cast<int>(std::lround(seconds / step));
        const double mass = mechanism_.mass + grip_.mass, damping = mechanism_.damping + grip_.damping;
        for (int i = 0; i < steps; ++i) {
            const glm::dvec3 held = grip_.stiffness * (intent - position_) / millimetresPerMetre; // N
            const glm::dvec3 drag = damping * velocity_ / millimetresPerMetre;                    // N
            velocity_ += (acting + push + held - drag) / mass * millimetresPerMetre * step;
            position_ += velocity_ * step;
        }
        energy_ += glm::dot(acting, position_ - before) / millimetresPerMetre;
    }

    glm::dvec3 position() const { return position_; } ///< mm, true
    glm::dvec3 velocity() const { return velocity_; } ///< mm/s
    double energy() const { return energy_; }         ///< J that the device has delivered to handle and hand so far

private:
    static constexpr double step = 10e-6; ///< s

    glm::dvec3 delayed(const glm::dvec3& force) {
        queue_[tick_ % queue_.size()] = force;
        const std::size_t late = tick_ >= mechanism_.delay ? tick_ - mechanism_.delay : 0;
        const glm::dvec3 acting = tick_ >= mechanism_.delay ? queue_[late % queue_.size()] : glm::dvec3(0.0);
        ++tick_;
        return acting;
    }

    SimulatedGrip grip_;
    SimulatedMechanism mechanism_;
    glm::dvec3 position_, velocity_{0.0};
    double energy_ = 0.0;
    std::array<glm::dvec3, 4> queue_{};
    std::size_t tick_ = 0;
};

} // namespace burin::test

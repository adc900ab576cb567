// SPDX-FileCopyrightText: 2026 The Burin authors
// SPDX-License-Identifier: Apache-2.0
#pragma once

#include <glm/glm.hpp>

#include <array>
#include <cstddef>

namespace burin {

/// Estimates velocity and rest from a position that is read in steps, tick by tick. A velocity that is delayed turns a
/// damper into a drive, and a velocity from single ticks shakes a resting hand by its encoder steps. So the velocity is
/// filtered briefly, and rest is detected separately, as the velocity is less reliable then. Called in the haptic tick.
class MotionEstimator {
public:
    static constexpr double cutoff = 120.0;   ///< Hz, of the velocity's filter (first order): 1.3 ms of lag
    static constexpr double restTime = 0.015; ///< s within one step of the current position count as rest

    /// @param step mm, resolution of the positions along each axis; 0: they are exact
    explicit MotionEstimator(double step) noexcept;

    /// @param position mm. @param period s since the previous position, > 0
    void add(const glm::dvec3& position, double period) noexcept;
    void reset() noexcept { count_ = 0; }

    /// Velocity in mm/s; zero until two positions are known.
    glm::dvec3 velocity() const noexcept { return velocity_; }
    /// Whether all recent positions lie within one step, so that the motion consists mostly of encoder steps. Never
    /// true for exact positions that differ.
    bool rests() const noexcept;
    /// The last position moved towards the one before, mm. @param share 0 … 0.5: 0.5 is their mean
    glm::dvec3 averaged(double share) const noexcept;

private:
    struct Entry {
        glm::dvec3 position{0.0};
        double time = 0.0; ///< s
    };
    static constexpr std::size_t capacity = 64; ///< at 4 kHz 60 ticks make the rest time
    const Entry& back(std::size_t ticks) const noexcept { return entries_[(newest_ + capacity - ticks) % capacity]; }

    double step_;
    std::array<Entry, capacity> entries_{};
    std::size_t newest_ = 0, count_ = 0;
    double time_ = 0.0;
    glm::dvec3 velocity_{0.0};
};

} // namespace burin

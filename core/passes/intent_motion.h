// SPDX-FileCopyrightText: 2026 The Burin authors
// SPDX-License-Identifier: Apache-2.0
#pragma once

#include "core/base/result.h"

#include <glm/glm.hpp>

#include <span>
#include <vector>

namespace burin {

/// One point that the operator means to reach.
struct IntentPoint {
    glm::dvec3 tip{0.0}; ///< mm, setup frame
    double speed = 0.0;  ///< mm/s of the move to this point, > 0; not used for the first point
};

/// How fast a hand changes its speed. Our estimates: half of gravity is brisk but controlled, and a corner is rounded
/// over some hundredths of a second.
struct MotionLimits {
    double acceleration = 4000.0; ///< mm/s², > 0
    double cornerSeconds = 0.025; ///< s over which a corner is rounded, > 0
    double maximumSpeed = 1.0e9;  ///< mm/s, > 0; faster points are slowed down
};

/// The motion that the operator intends, at one time.
struct MotionState {
    glm::dvec3 position{0.0};     ///< mm
    glm::dvec3 velocity{0.0};     ///< mm/s
    glm::dvec3 acceleration{0.0}; ///< mm/s²
};

/// A polyline traversed as a hand does it: at the stated speeds, slower into corners and tight curves, then averaged
/// over `cornerSeconds`, so that the velocity has no jumps. Starts and ends at rest, exactly on the first and last
/// point. Immutable, thread-safe.
class IntentMotion {
public:
    /// Errors: argumentInvalid (no point, a coordinate that is not finite, a speed or limit not > 0).
    static Result<IntentMotion> make(std::span<const IntentPoint> points, const MotionLimits& limits);

    /// @param time s since the start; before 0 the state rests at the first point, after duration() at the last.
    MotionState at(double time) const noexcept;
    double duration() const noexcept { return travelSeconds_ + limits_.cornerSeconds; } ///< s

private:
    /// A phase of constant acceleration along a line. Positions are relative to the first point, so that the integral
    /// keeps its precision over hours.
    struct Phase {
        double start = 0.0;        ///< s
        glm::dvec3 position{0.0};  ///< mm at its start
        glm::dvec3 integral{0.0};  ///< mm·s, of the position from time 0 to its start
        glm::dvec3 direction{0.0}; ///< unit
        double speed = 0.0;        ///< mm/s at its start
        double acceleration = 0.0; ///< mm/s² along the line
    };
    /// The unrounded motion at one time.
    struct Moment {
        glm::dvec3 integral{0.0};
        glm::dvec3 position{0.0};
        glm::dvec3 velocity{0.0};
    };

    explicit IntentMotion(const MotionLimits& limits) : limits_(limits) {}
    void append(const glm::dvec3& direction, double length, double entry, double cruise, double exit);
    void appendPhase(const glm::dvec3& direction, double speed, double acceleration, double seconds);
    Moment unrounded(double time) const noexcept;

    MotionLimits limits_;
    glm::dvec3 origin_{0.0};
    std::vector<Phase> phases_;
    double travelSeconds_ = 0.0;
    Moment end_; ///< the state to which the next phase is appended; at the end, the last point at rest
};

} // namespace burin

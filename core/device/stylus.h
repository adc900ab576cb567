// SPDX-FileCopyrightText: 2026 The Burin authors
// SPDX-License-Identifier: Apache-2.0
#pragma once

#include "core/base/result.h"
#include "core/geometry/pose.h"

#include <cstdint>
#include <string>

namespace burin {

/// What a stylus says of itself: the limits that every gain is scaled by.
struct StylusDescription {
    std::string name;
    std::string source;               ///< where the figures come from
    bool actuated = false;            ///< has motors
    double maximumForce = 0.0;        ///< N
    double maximumStiffness = 0.0;    ///< N/m, closed loop at 1 kHz
    double maximumDamping = 0.0;      ///< N·s/m
    double workspaceRadius = 0.0;     ///< mm, device frame
    double maximumSpeed = 1000.0;     ///< mm/s; faster is taken for a fault
};

/// One reading. Device frame: x right, y away from the user, z up; mm.
struct StylusState {
    double time = 0.0;          ///< s since the session began
    Pose pose;
    std::uint32_t buttons = 0;  ///< bit 0: the first button
    bool valid = false;         ///< false: the device had nothing to say this tick
};

/// A stylus that the loop calls: one read and one write a tick. Plugins implement it; one thread.
class Stylus {
public:
    static constexpr int interfaceVersion = 1; ///< +1 with any change to this declaration
    virtual ~Stylus() = default;
    virtual StylusDescription description() const = 0;
    virtual Result<void> open() = 0;
    /// @param time s since the session began. In the tick: no allocation, no exception.
    virtual StylusState read(double time) noexcept = 0;
    /// @param force N, device frame, already limited.
    virtual void write(const glm::dvec3& force) noexcept = 0;
    /// True when the stylus has nothing more to say (a trace's end, a virtual operator's last pass).
    virtual bool finished() const noexcept { return false; }
    virtual void close() noexcept = 0;
};

} // namespace burin

// SPDX-FileCopyrightText: 2026 The Burin authors
// SPDX-License-Identifier: Apache-2.0
#pragma once

#include "core/cutting/cutting_force.h"

namespace burin {

/// How the cutting force comes into the hand. A force against the velocity would be a damper far beyond what a desktop
/// device can hold; here a spring to an anchor drags behind the tool and yields at the scaled force, as dry friction
/// does: its stiffness is bounded, it rests when the hand rests.
class CuttingForceRendering {
public:
    struct Settings {
        double scale = 0.01;         ///< rendered / real force
        double stiffness = 0.0;      ///< N/m in device space, at most the coupling's
        double maximum = 0.0;        ///< N, of what is rendered
        double workspaceScale = 1.0; ///< mm of setup per mm of device
    };
    explicit CuttingForceRendering(const Settings& settings) noexcept : settings_(settings) {}

    /// @param cut    unscaled, setup frame
    /// @param motion of the tip in this tick, mm. @param tip at its end, mm, setup frame
    /// @return N, axes of the setup frame
    glm::dvec3 operator()(const CuttingForce& cut, const glm::dvec3& motion, const glm::dvec3& tip,
                          double period) noexcept;
    void reset() noexcept;
    void setWorkspaceScale(double scale) noexcept { settings_.workspaceScale = scale; }

private:
    static constexpr double smoothing = 0.015; ///< s; removal comes in steps of whole scanlines
    Settings settings_;
    double yield_ = 0.0;       ///< N
    glm::dvec3 sideways_{0.0}; ///< N
    glm::dvec3 anchor_{0.0};   ///< mm
    bool anchored_ = false;
};

} // namespace burin

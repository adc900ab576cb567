// SPDX-FileCopyrightText: 2026 The Burin authors
// SPDX-License-Identifier: Apache-2.0
#pragma once

#include "core/cutting/cutting_force.h"
#include "core/haptics/hand_input.h"
#include "core/haptics/tool_motion.h"

namespace burin {

/// Contact and cutting as shown by a device that only assists (AssistAbilities). Contact: the distance from the hand to
/// the tool that something holds, in device space, as a share of `fullDepth`. Cutting: the force of the engaged area,
/// as on other devices, with `referenceShare` for the reference cut; while the tool rests (below 1 mm/s) it is
/// zero, as the hand would not hold against it. Both are multiplied by the user's ceiling; their changes are limited. A
/// push on the stick (not a vibration) is only there while a button is held: that of the dead man's switch, or else the
/// first one. Called in the haptic tick.
class AssistOutput {
public:
    static constexpr double fullDepth = 5.0;    ///< mm, device space
    static constexpr double riseSeconds = 0.1;  ///< from nothing to the ceiling
    static constexpr double fallSeconds = 0.02; ///< from the ceiling to nothing
    static constexpr double settling = 0.03;    ///< s, time constant of the cutting force

    explicit AssistOutput(const HapticSettings& settings) noexcept;

    /// Whether the device assists and the user lets it.
    bool active() const noexcept { return ceiling_ > 0.0; }
    /// @param away mm, from the hand to the tool, setup frame. @param weight 0 … 1, of all forces (ForceRamp)
    /// @param period s
    Assist advance(const glm::dvec3& away, const ToolMotion& motion, const CuttingForce& cutting, const Hand& hand,
                   double weight, double period) noexcept;
    /// Nothing is shown in this tick; the following ones rise from zero.
    Assist none() noexcept;

private:
    /// All as shares of the ceiling, setup frame.
    struct Shares {
        glm::dvec3 contact{0.0}, cutting{0.0};
    };
    Shares sharesOf(const glm::dvec3& away, const ToolMotion& motion, const CuttingForce& cutting, const Hand& hand,
                    double period) noexcept;

    double ceiling_, gain_;
    std::uint32_t holdButtons_; ///< bit mask: a push is only there while one of them is held; 0: always
    glm::dvec3 cutting_{0.0};   ///< smoothed
    Assist shown_;
};

} // namespace burin

// SPDX-FileCopyrightText: 2026 The Burin authors
// SPDX-License-Identifier: Apache-2.0
#pragma once

#include "core/device/stylus.h"

#include <cstdint>

namespace burin::input_events {

/// The values of the effects, as the kernel takes them (linux/input.h).
struct EffectLevels {
    /// towards which a constant force pushes: 0 to the user, 0x4000 left, 0x8000 away, 0xC000 right
    std::uint16_t direction = 0;
    std::int16_t level = 0;             ///< of the constant force, 0 … 0x7FFF
    std::uint16_t strong = 0, weak = 0; ///< of the two vibrations, 0 … 0xFFFF
    std::uint16_t ceiling = 0;          ///< of spring and damper, 0 … 0xFFFF; 0: nothing is wanted from the device
    friend bool operator==(const EffectLevels&, const EffectLevels&) = default;
};

/// The part of a force that a stick can push, x to the right, y away from the user: each axis of the stick pushes along
/// the motion that is assigned to it, in the direction in which it has to be moved for that. The first two axes of the
/// map are those of the stick. An axis without a translation pushes nothing.
/// @param axes 0 … 2: number of axes that can push, the first ones
glm::dvec2 stickForce(const glm::dvec3& force, const AxisMap& map, int axes) noexcept;

/// A stick gets the force, and its vibration, if it has one, shows the part of the force that the stick can't push. A
/// device that only vibrates shows the contact with the strong motor and the load with the weak one. Values that are
/// not finite count as 0, larger ones than the ceiling as the ceiling.
EffectLevels encoded(const Assist& assist, const AxisMap& map, const AssistAbilities& abilities) noexcept;

} // namespace burin::input_events

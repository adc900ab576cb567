// SPDX-FileCopyrightText: 2026 The Burin authors
// SPDX-License-Identifier: Apache-2.0
#pragma once

#include "core/machine/machine_profile.h"

#include <optional>

namespace burin {

/// Where a machine lets a tool go, setup frame. An empty box sets no limit.
struct Envelope {
    Box tips;  ///< mm: the tip stays inside (the axes' travel)
    Box tools; ///< mm: every point of cutter, shank and holder stays inside (doors, walls, table)
};

/// How a setup stands in its machine.
struct TravelPlacement {
    bool on = true; ///< the travel bounds the tool
    /// mm from the low end of X, Y and Z, for the tip of the tool that is in the spindle, to the program's zero.
    /// Nothing: the rule of `travelEnvelope`.
    std::optional<glm::dvec3> zero;

    friend bool operator==(const TravelPlacement&, const TravelPlacement&) = default;
};

/// The travel of a three-axis machine as a box for the tip of an upright tool. Where it is not said how the setup
/// stands, the stock is taken to be in the middle of X and Y, and Z to reach up to the machine's tool change height
/// above it, which a profile promises to be free. Without limits where the placement is off.
/// @param workOffset program zero in the setup frame, mm @param stockTop centre of the stock's top face, mm: a zero on
/// a corner does not move the stock on its table
Envelope travelEnvelope(const MachineProfile& machine, const TravelPlacement& placement, const glm::dvec3& workOffset,
                        const glm::dvec3& stockTop);

} // namespace burin

// SPDX-FileCopyrightText: 2026 The Burin authors
// SPDX-License-Identifier: Apache-2.0
#pragma once

#include "core/machine/machine_profile.h"

#include <optional>

namespace burin {

/// The space in which a machine can move a tool, setup frame. An empty box sets no limit.
struct Envelope {
    Box tips;  ///< mm: the tip stays inside (the axes' travel)
    Box tools; ///< mm: every point of cutter, shank and holder stays inside (doors, walls, table)
};

/// Where a setup is placed in its machine.
struct TravelPlacement {
    bool on = true; ///< whether the travel limits the tool
    /// mm from the low end of X, Y and Z, for the tip of the tool that is in the spindle, to the program's zero. Empty:
    /// the rule of `travelEnvelope` applies.
    std::optional<glm::dvec3> zero;

    friend bool operator==(const TravelPlacement&, const TravelPlacement&) = default;
};

/// The travel of a three-axis machine as a box for the tip of an upright tool. If the placement of the setup is not
/// stated, the stock is assumed to be in the middle of X and Y, and Z to reach up to the machine's tool change height
/// above the stock, which a profile guarantees to be free. Without limits if the placement is off.
/// @param workOffset program zero in the setup frame, mm @param stockTop centre of the stock's top face, mm: with a
/// zero at a corner of the stock, the stock is still assumed to be in the middle of the table
Envelope travelEnvelope(const MachineProfile& machine, const TravelPlacement& placement, const glm::dvec3& workOffset,
                        const glm::dvec3& stockTop);

} // namespace burin

// SPDX-FileCopyrightText: 2026 The Burin authors
// SPDX-License-Identifier: Apache-2.0
#pragma once

#include "core/machine/axis.h"

#include <array>
#include <map>
#include <optional>

namespace burin {

/// Values of axes, mm or degrees, some of which may be unknown.
using PartialPlace = ByAxis<std::optional<double>>;

/// What the machine knows when a program starts and the program does not state. All of it is optional: what depends on
/// a missing value is marked as unknown, or is an error where a move cannot be determined without it.
struct MachineState {
    PartialPlace place{};                    ///< position of the machine, machine frame
    std::map<int, PartialPlace> workOffsets; ///< zeros in the machine frame, by NcMotion::workOffset
    std::map<int, double> lengthOffsets;     ///< mm by H number
    std::optional<double> lengthOffset;      ///< mm, in force at the start
    std::array<PartialPlace, 2> homes{};     ///< of G28 and G30, machine frame
    double unit = 1.0;                       ///< mm of the machine's own unit, in which parameters 5161 … are given
    bool unsetParametersAreZero = false;
};

} // namespace burin

// SPDX-FileCopyrightText: 2026 The Burin authors
// SPDX-License-Identifier: Apache-2.0
#pragma once

#include "core/machine/axis.h"

#include <array>
#include <map>
#include <optional>

namespace burin {

/// Values of axes, mm or degrees, of which some may not be known.
using PartialPlace = ByAxis<std::optional<double>>;

/// What a program does not say and its machine knows when it starts. All of it may be left out: what depends on it is
/// then marked as unknown, or an error where a move can't be told without it.
struct MachineState {
    PartialPlace place{};                    ///< where the machine stands, machine frame
    std::map<int, PartialPlace> workOffsets; ///< zeros in the machine frame, by NcMotion::workOffset
    std::map<int, double> lengthOffsets;     ///< mm by H number
    std::optional<double> lengthOffset;      ///< mm, in force at the start
    std::array<PartialPlace, 2> homes{};     ///< of G28 and G30, machine frame
    double unit = 1.0;                       ///< mm of the machine's own unit, in which parameters 5161 … count
    bool unsetParametersAreZero = false;
};

} // namespace burin

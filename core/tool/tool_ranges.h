// SPDX-FileCopyrightText: 2026 The Burin authors
// SPDX-License-Identifier: Apache-2.0
#pragma once

#include "core/base/number_range.h"

/// The allowed ranges of a tool's numbers, in files and input fields: far beyond any real tool, to detect a wrong unit
/// or a mistyped digit.
namespace burin::tool_range {

inline constexpr NumberRange length{0.0, 1000.0};             ///< mm
inline constexpr NumberRange taper{0.0, 90.0};                ///< °
inline constexpr NumberRange spindleSpeed{0.0, 1e6};          ///< 1/min
inline constexpr NumberRange stiffness{0.0, 2e6};             ///< N/mm², diamond has 1.2e6
inline constexpr NumberRange breakage{0.0, 2e4};              ///< N/mm²
inline constexpr NumberRange presetSpeed{1.0, 1e6};           ///< 1/min
inline constexpr NumberRange presetFeed{0.1, 1e6};            ///< mm/min
inline constexpr NumberRange presetChipLoad{1e-5, 10.0};      ///< mm per tooth
inline constexpr NumberRange presetStep{0.01, 1000.0};        ///< mm
inline constexpr int highestNumber = 99999, mostFlutes = 100; ///< LinuxCNC's highest tool number

} // namespace burin::tool_range

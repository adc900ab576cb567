// SPDX-FileCopyrightText: 2026 The Burin authors
// SPDX-License-Identifier: Apache-2.0
#pragma once

#include "core/base/number_range.h"

/// The ranges of values in a machine file: wide enough for any milling machine, narrow enough to catch a wrong unit.
namespace burin::machine_range {

inline constexpr NumberRange travel{1.0, 1e5};             ///< mm, of an axis
inline constexpr NumberRange home{-1e5, 1e5};              ///< mm, of an axis in the machine frame
inline constexpr NumberRange feed{1.0, 1e6};               ///< mm/min
inline constexpr NumberRange spindleSpeed{0.0, 1e6};       ///< 1/min
inline constexpr NumberRange spindlePower{1.0, 1e6};       ///< W
inline constexpr NumberRange spindleTorque{1e-4, 1e5};     ///< N m
inline constexpr NumberRange acceleration{1.0, 1e6};       ///< mm/s²
inline constexpr NumberRange jerk{1.0, 1e9};               ///< mm/s³
inline constexpr NumberRange blockRate{1.0, 1e6};          ///< 1/s
inline constexpr NumberRange height{0.0, 1e4};             ///< mm
inline constexpr NumberRange toolChange{0.0, 3600.0};      ///< s
inline constexpr NumberRange rotaryAngle{-1e5, 1e5};       ///< degrees
inline constexpr NumberRange rotaryRate{1.0, 1e7};         ///< degrees/min
inline constexpr NumberRange rotaryAcceleration{1.0, 1e7}; ///< degrees/s²
inline constexpr NumberRange tolerance{0.0, 1.0};          ///< mm
inline constexpr NumberRange sweep{0.0, 360.0};            ///< degrees; 0: the control takes no arcs
inline constexpr NumberRange radius{0.0, 1e6};             ///< mm
inline constexpr int fewestDecimals = 0, mostDecimals = 9;
inline constexpr int shortestLine = 20, longestLine = 100000; ///< characters

} // namespace burin::machine_range

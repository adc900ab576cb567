// SPDX-FileCopyrightText: 2026 The Burin authors
// SPDX-License-Identifier: Apache-2.0
#pragma once

namespace burin {

// Units inside Burin: mm, s, N, rad, mm³, J/mm³, double precision. Other units occur only in files and controls, and
// are converted here.
inline constexpr double millimetresPerInch = 25.4;
inline constexpr double millimetresPerMetre = 1000.0;
inline constexpr double secondsPerMinute = 60.0;
inline constexpr double pi = 3.14159265358979323846;
/// 1 N·m = 1000 N·mm: converts J/mm³ · mm³/s over mm/s to N (Chen & Yang 2004, eq. 12, in our units).
inline constexpr double newtonMillimetresPerJoule = 1000.0;

} // namespace burin

// SPDX-FileCopyrightText: 2026 The Burin authors
// SPDX-License-Identifier: Apache-2.0
#pragma once

namespace burin {

// Inside Burin: mm, s, N, rad, mm³, J/mm³, double precision. Other units exist only where a file or a control has
// them, and are changed here.
inline constexpr double millimetresPerInch = 25.4;
inline constexpr double millimetresPerMetre = 1000.0;
inline constexpr double secondsPerMinute = 60.0;
inline constexpr double pi = 3.14159265358979323846;
/// 1 N·m = 1000 N·mm: turns J/mm³ · mm³/s over mm/s into N (Chen & Yang 2004, eq. 12, in our units).
inline constexpr double newtonMillimetresPerJoule = 1000.0;

} // namespace burin

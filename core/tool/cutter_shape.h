// SPDX-FileCopyrightText: 2026 The Burin authors
// SPDX-License-Identifier: Apache-2.0
#pragma once

#include "core/tool/tool.h"

namespace burin {

/// A value of a cutter that only some types have.
enum class CutterValue : std::uint8_t { diameter, cornerRadius, tipDiameter, taperAngle, fluteLength };
/// The user decides it: neither left out by the type nor given by another value or by the profile.
bool isFree(CutterType type, CutterValue value) noexcept;

/// The cutter with what its type leaves out set to 0, what it gives set to that, and what it needs and lacks, or can't
/// be as it is, set to what is usual. Values that fit stay. Lengths that have to reach as far are made longer; nothing
/// else grows.
/// @param cutter diameters and lengths finite and > 0. @return valid but for a profile of another diameter
Cutter fitted(Cutter cutter);

} // namespace burin

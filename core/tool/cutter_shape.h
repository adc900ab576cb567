// SPDX-FileCopyrightText: 2026 The Burin authors
// SPDX-License-Identifier: Apache-2.0
#pragma once

#include "core/tool/tool.h"

namespace burin {

/// A value of a cutter that not all types have.
enum class CutterValue : std::uint8_t { diameter, cornerRadius, tipDiameter, taperAngle, fluteLength };
/// Whether the user can choose the value: the type has it, and it is not determined by another value or by the profile.
bool isFree(CutterType type, CutterValue value) noexcept;

/// Returns the cutter adapted to its type: values that the type does not have are set to 0, values that it determines
/// are set to these, and values that are missing or impossible are set to usual ones. Valid values are kept. Lengths
/// that are too short are extended; nothing else is enlarged.
/// @param cutter diameters and lengths finite and > 0. @return valid except for a profile of another diameter
Cutter fitted(Cutter cutter);

} // namespace burin

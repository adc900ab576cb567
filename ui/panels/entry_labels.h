// SPDX-FileCopyrightText: 2026 The Burin authors
// SPDX-License-Identifier: Apache-2.0
#pragma once

#include "core/path/evaluate.h"
#include "ui/theme/length_unit.h"

#include <QString>

namespace burin {

// Texts of the panels for strokes that begin in material. For display only; positions are relative to program zero.

/// "ramps 12 · plunges 1"; empty if no stroke begins in material.
QString entriesText(const EditReport& report);
/// The positions where the tool plunges because there is no room for another entry, one per line, the deepest first, at
/// most ten.
/// @param zero program zero, mm, setup frame
QString plungeLines(const EditReport& report, const glm::dvec3& zero, LengthUnit unit);

} // namespace burin

// SPDX-FileCopyrightText: 2026 The Burin authors
// SPDX-License-Identifier: Apache-2.0
#pragma once

#include "core/path/evaluate.h"
#include "ui/theme/length_unit.h"

#include <QString>

namespace burin {

// What panels say of strokes that begin in material. For display alone; positions are told from program zero.

/// "ramps 12 · plunges 1"; empty where no stroke begins in material.
QString entriesText(const EditReport& report);
/// Where the tool plunges as there is room for nothing else, a line each, the deepest first; of many the first ten.
/// @param zero mm, of the program, in the setup frame
QString plungeLines(const EditReport& report, const glm::dvec3& zero, LengthUnit unit);

} // namespace burin

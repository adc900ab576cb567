// SPDX-FileCopyrightText: 2026 The Burin authors
// SPDX-License-Identifier: Apache-2.0
#pragma once

#include "core/path/evaluate.h"
#include "ui/theme/length_unit.h"

#include <QString>

#include <vector>

namespace burin {

// What panels say of the parts of a path that edits left out. For display alone; positions are told from program zero.
// @param zero mm, of the program, in the setup frame

/// "12.345 mm left out"; empty where nothing was.
QString omittedText(const EditReport& report, LengthUnit unit);
/// Where, how long and why, a line each, the longest first; of many the longest ten. Empty where there is nothing.
QString omissionLines(const EditReport& report, const glm::dvec3& zero, LengthUnit unit);
/// A sentence of all edits, then where the longest part is and what helps. Empty where nothing was left out.
QString omissionNotice(const std::vector<EditReport>& reports, const glm::dvec3& zero, LengthUnit unit);

} // namespace burin

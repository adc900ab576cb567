// SPDX-FileCopyrightText: 2026 The Burin authors
// SPDX-License-Identifier: Apache-2.0
#pragma once

#include "core/passes/pass_request.h"
#include "core/path/evaluate.h"
#include "ui/theme/length_unit.h"

#include <QString>

#include <vector>

namespace burin {

// Texts for the parts of a path that edits left out, and for the holes that a pass did not finish. For display only;
// positions are relative to program zero.
// @param zero program zero, mm, setup frame

/// "12.345 mm left out"; empty if nothing was left out.
QString omittedText(const EditReport& report, LengthUnit unit);
/// Position, length and reason of each omission, one per line, the longest first, at most ten. Empty if nothing was
/// left out.
QString omissionLines(const EditReport& report, const glm::dvec3& zero, LengthUnit unit);
/// A sentence for all edits together, then the position of the longest omitted part and the remedy. Empty if nothing
/// was left out.
QString omissionNotice(const std::vector<EditReport>& reports, const glm::dvec3& zero, LengthUnit unit);
/// How many holes a pass did not drill or thread to the requested depth, or how many studs it did not thread, and why.
/// @param holes at least 1
QString unreachedHolesText(std::size_t holes, HoleWork work);

} // namespace burin

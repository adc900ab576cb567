// SPDX-FileCopyrightText: 2026 The Burin authors
// SPDX-License-Identifier: Apache-2.0
#pragma once

#include "core/geometry/box.h"
#include "core/nc/lint.h"
#include "core/tool/tool.h"
#include "core/verify/verify.h"
#include "core/volume/runs/property_list.h"
#include "ui/theme/length_unit.h"

#include <QString>

#include <string>
#include <vector>

namespace burin {

// Texts of the panels for data of core. For display only.

QString toolName(const Tool& tool); ///< in the user's language if the tool is shipped with Burin
QString toolName(const std::vector<Tool>& tools, const std::string& id); ///< the id itself if no tool has it
QString toolSummary(const Tool& tool, LengthUnit unit);                  ///< "Ø 10 mm, R 2 mm, 4 flutes"
QString materialName(const Property& material);                          ///< as `toolName`
QString takeName(const std::string& name);                               ///< as `toolName`, for takes named by Burin
/// The label of a value such as "specific_cutting_energy"; unknown names are shown with spaces instead of underscores.
QString valueNameText(const std::string& name);
QString prettyUnit(const std::string& unit); ///< "J/mm^3" with a raised 3; empty for "1"

QString countText(std::size_t count);                     ///< with group separators: "12,408"
QString shortLength(double millimetres, LengthUnit unit); ///< without trailing zeros, with its unit
QString wayText(double millimetres, LengthUnit unit); ///< with group separators, rounded to the millimetre: "38,393 mm"
QString sizeText(const glm::dvec3& size, LengthUnit unit);           ///< "120 × 70 × 45 mm"
QString areaText(double squareMillimetres, LengthUnit unit);         ///< "412 mm²", "0.64 in²"
QString volumeText(double cubicMillimetres, LengthUnit unit);        ///< "24.51 cm³", "1.496 in³"
QString rateText(double cubicMillimetresPerSecond, LengthUnit unit); ///< "412 mm³/s"
QString feedText(double millimetresPerMinute, LengthUnit unit);      ///< "640 mm/min", "25.2 in/min"; "–" of 0
QString spindleSpeedText(double perMinute);                          ///< "12,000 rpm"; "–" of 0
QString shareText(double share);                                     ///< "42 %", of 0.42
QString durationText(double seconds);                                ///< "01:42", "1:02:07"
QString clockText(double seconds, int decimals);                     ///< the same with decimals: "01:42.318"

QString nearPassText(const NearPass& pass, LengthUnit unit);  ///< "Shank passes the part at 0.4 mm"
QString findingText(const Finding& finding, LengthUnit unit); ///< "Gouge of 0.034 mm"
QString lintText(const LintMark& mark);                       ///< "decimal point is missing: …"

} // namespace burin

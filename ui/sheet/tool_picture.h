// SPDX-FileCopyrightText: 2026 The Burin authors
// SPDX-License-Identifier: Apache-2.0
#pragma once

#include "core/tool/tool.h"
#include "ui/theme/length_unit.h"

#include <QString>

namespace burin {

/// A tool from the side, tip down, as an SVG element with its diameter, flutes and stick-out.
/// @param pixels per mm: the same for all tools of a page, so that they can be compared
QString toolPicture(const Tool& tool, double pixels, LengthUnit unit);

} // namespace burin

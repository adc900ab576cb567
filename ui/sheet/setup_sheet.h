// SPDX-FileCopyrightText: 2026 The Burin authors
// SPDX-License-Identifier: Apache-2.0
#pragma once

#include "core/job/sheet_content.h"
#include "ui/scene/picture.h"
#include "ui/theme/length_unit.h"

#include <array>
#include <span>
#include <string>

namespace burin {

/// Returns one HTML page for whoever clamps and runs the setup: pictures of the clamped stock, machine, work offset and
/// zero, stock and materials, fixtures, tools with stick-out, feeds and times, the program and the findings of its
/// check. In the language of the program, lengths in `unit`, coordinates from program zero. Without links to other
/// files.
/// @param pictures PNG of `sheetPicture`, one for each of `sheetViews`
std::string setupSheet(const SheetContent& content, LengthUnit unit, std::span<const std::string> pictures);
/// The contents of its pictures.
PictureContent sheetPicture(const SheetContent& content);
inline constexpr std::array sheetViews{StandardView::isometric, StandardView::top, StandardView::front};

} // namespace burin

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

/// One HTML page for whoever clamps and runs the setup: pictures of the stock as it is clamped, machine, work offset
/// and zero, stock and materials, fixtures, tools with stick-out, feeds and times, the program and what its check
/// found. In the language of the program, lengths in `unit`, coordinates from program zero. Without a link to any
/// other file.
/// @param pictures PNG of `sheetPicture`, one for each of `sheetViews`
std::string setupSheet(const SheetContent& content, LengthUnit unit, std::span<const std::string> pictures);
/// What its pictures show.
PictureContent sheetPicture(const SheetContent& content);
inline constexpr std::array sheetViews{StandardView::isometric, StandardView::top, StandardView::front};

} // namespace burin

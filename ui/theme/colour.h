// SPDX-FileCopyrightText: 2026 The Burin authors
// SPDX-License-Identifier: Apache-2.0
#pragma once

#include <QColor>

#include <array>
#include <cstdint>
#include <optional>

namespace burin {

/// Contrast of two opaque colours, 1 … 21. Source: WCAG 2.1, relative luminance and contrast ratio.
double contrast(const QColor& one, const QColor& other);

/// Blends `over` onto `ground` in sRGB with an opacity of `share` (0 … 1). The result is opaque.
QColor mixed(const QColor& ground, const QColor& over, double share);

/// Near-black or white, whichever reads better on `ground`.
QColor readableOn(const QColor& ground);

/// The colour of a body, opaque; invalid if it has none. @param rgb sRGB
QColor colourFrom(const std::optional<std::array<std::uint8_t, 3>>& rgb);

} // namespace burin

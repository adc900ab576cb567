// SPDX-FileCopyrightText: 2026 The Burin authors
// SPDX-License-Identifier: Apache-2.0
#pragma once

#include "core/base/result.h"

#include <QColor>
#include <QString>

class QApplication;

namespace burin {

/// The roles that colours have; both themes carry the same ones. Values come from resources/themes/<id>.json.
struct Palette {
    QColor window, panel, field, border, text, quietText;          ///< surfaces and the two greys for text
    QColor accent, force, inOrder, part;                           ///< one accent, three signals: red, green, blue
    QColor sceneTop, sceneBottom, grid;                            ///< the viewport's background
    QColor flutes, shank, holder, ghost, coupling, path, livePath; ///< in the viewport
};

enum class Theme { dark, light };

/// Errors: resourceInvalid, fileNotFound.
Result<Palette> loadPalette(Theme theme);
/// Dresses the whole application: QPalette, font and style sheet.
void applyTheme(QApplication& application, const Palette& palette);

} // namespace burin

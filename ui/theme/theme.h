// SPDX-FileCopyrightText: 2026 The Burin authors
// SPDX-License-Identifier: Apache-2.0
#pragma once

#include "core/base/result.h"

#include <QColor>
#include <QString>

#include <array>
#include <string_view>
#include <utility>

class QApplication;

namespace burin {

/// The colour roles; both themes define the same ones. The values come from resources/themes/<id>.json.
struct Palette {
    QColor window, panel, field, border, text, quietText; ///< surfaces and the two greys for text
    QColor accent, force, inOrder, part;                  ///< one accent, three signals: red, green, blue
    QColor sceneTop, sceneBottom, grid;                   ///< the viewport's background
    QColor flutes, shank, holder, ghost, coupling, guide, path, livePath; ///< in the viewport
    /// Moves of a path that are not climb milling, the selected part of a path, and the path it is compared with. Every
    /// path line has an outline in `pathHalo`, of the opposite lightness, so that one of the two contrasts with any
    /// background.
    QColor conventionalPath, rapidPath, plungePath, chosenPath, comparedPath, pathHalo;
};

/// One role of a palette, such as `&Palette::accent`. Code that stores a role instead of a colour follows a change of
/// theme.
using ColourRole = QColor Palette::*;

/// Every role with its key in the theme files.
inline constexpr std::array<std::pair<std::string_view, ColourRole>, 27> colourRoles{{
    {"window", &Palette::window},
    {"panel", &Palette::panel},
    {"field", &Palette::field},
    {"border", &Palette::border},
    {"text", &Palette::text},
    {"quiet_text", &Palette::quietText},
    {"accent", &Palette::accent},
    {"force", &Palette::force},
    {"in_order", &Palette::inOrder},
    {"part", &Palette::part},
    {"scene_top", &Palette::sceneTop},
    {"scene_bottom", &Palette::sceneBottom},
    {"grid", &Palette::grid},
    {"flutes", &Palette::flutes},
    {"shank", &Palette::shank},
    {"holder", &Palette::holder},
    {"ghost", &Palette::ghost},
    {"coupling", &Palette::coupling},
    {"guide", &Palette::guide},
    {"path", &Palette::path},
    {"live_path", &Palette::livePath},
    {"conventional_path", &Palette::conventionalPath},
    {"rapid_path", &Palette::rapidPath},
    {"plunge_path", &Palette::plungePath},
    {"chosen_path", &Palette::chosenPath},
    {"compared_path", &Palette::comparedPath},
    {"path_halo", &Palette::pathHalo},
}};
static_assert(colourRoles.size() * sizeof(QColor) == sizeof(Palette), "every colour of a palette has a role");

enum class Theme { dark, light };

/// Errors: resourceInvalid, fileNotFound.
Result<Palette> loadPalette(Theme theme);
/// Reads a palette from the text of a theme file. @param origin file name for messages. Errors: resourceInvalid.
Result<Palette> paletteFromJson(std::string_view text, const std::string& origin);
/// Styles the whole application: QPalette, font and style sheet. May be called again for another theme; widgets then
/// receive QEvent::PaletteChange. GUI thread.
void applyTheme(QApplication& application, const Palette& palette);
/// The palette that was last passed to `applyTheme`, for widgets that paint themselves; before the first call, roles
/// derived from the system's QPalette. GUI thread.
const Palette& activePalette();

} // namespace burin

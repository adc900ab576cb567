// SPDX-FileCopyrightText: 2026 The Burin authors
// SPDX-License-Identifier: Apache-2.0
#pragma once

#include <QString>
#include <QWidget>

#include <vector>

namespace burin::testing {

/// One text that a user reads, and the name of what shows it.
struct VisibleText {
    QString where, text;
};

/// What can be read in a window now: labels, buttons, choices with all that they offer, lists, units of fields,
/// tooltips, the title, and everything in its menus. Not what the user wrote, nor a program's text.
std::vector<VisibleText> visibleTexts(QWidget& window);

/// Texts that are seen now and have less room than their font needs: of labels, buttons, check boxes, choices and
/// fields. What ends in "…" is none of them if its tooltip has the whole text, nor is what only has to be scrolled to,
/// downwards.
std::vector<VisibleText> clippedTexts(QWidget& window);

} // namespace burin::testing

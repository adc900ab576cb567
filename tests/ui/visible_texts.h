// SPDX-FileCopyrightText: 2026 The Burin authors
// SPDX-License-Identifier: Apache-2.0
#pragma once

#include <QString>
#include <QWidget>

#include <vector>

namespace burin::testing {

/// A text that a user reads, and the name of the widget that shows it.
struct VisibleText {
    QString where, text;
};

/// The texts that can be read in a window now: labels, buttons, choices with all their entries, lists, units of fields,
/// tooltips, the title, and everything in its menus. Texts that the user wrote and the text of a program are left out.
std::vector<VisibleText> visibleTexts(QWidget& window);

/// Visible texts of labels, buttons, check boxes, choices and fields that have less room than their font needs. Texts
/// that end in "…" are left out if their tooltip shows the whole text, and so are texts that only have to be scrolled
/// to, downwards.
std::vector<VisibleText> clippedTexts(QWidget& window);

} // namespace burin::testing

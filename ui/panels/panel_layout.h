// SPDX-FileCopyrightText: 2026 The Burin authors
// SPDX-License-Identifier: Apache-2.0
#pragma once

#include <QLabel>
#include <QVBoxLayout>

class QScrollArea;

namespace burin {

/// What panels are laid out with: a column on the 8-pixel grid.
QVBoxLayout* makePanelLayout(QWidget* panel);

/// A quiet heading in capitals over a part of a panel.
QLabel* makeSectionTitle(const QString& text, QWidget* parent);

/// Wrapped plain text; it breaks inside of long words and file names rather than widening the panel.
QLabel* makeWrappedLabel(QWidget* parent);
/// Sets the text of such a label; nothing is done when it has it.
void setWrappedText(QLabel* label, const QString& text);

/// Scrolls what a widget lies in so that it is seen, as soon as that has been laid out.
void bringIntoView(QWidget* widget);
/// A card of a list that is made anew, shown at once: a list that is short for a moment scrolls to its top.
/// @param place in the list; -1: its end
void addCard(QBoxLayout* list, QWidget* card, int place = -1);

/// Lets the rows of a list scroll inside of a height that the caller gives it: what is below the list stays where it is
/// when rows come and go.
QScrollArea* makeListArea(QWidget* rows, QWidget* parent);

/// Changes the look that the style sheet gives a widget (ui/theme/style_sheet.h); nothing is done when it has it.
void setLook(QWidget* widget, const char* look);

} // namespace burin

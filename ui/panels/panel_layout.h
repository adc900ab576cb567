// SPDX-FileCopyrightText: 2026 The Burin authors
// SPDX-License-Identifier: Apache-2.0
#pragma once

#include <QLabel>
#include <QVBoxLayout>

class QScrollArea;

namespace burin {

/// The standard layout of panels: a column on the 8-pixel grid.
QVBoxLayout* makePanelLayout(QWidget* panel);

/// A subdued heading in capitals above a section of a panel.
QLabel* makeSectionTitle(const QString& text, QWidget* parent);

/// Wrapped plain text. Long words and file names are broken rather than widening the panel.
QLabel* makeWrappedLabel(QWidget* parent);
/// Sets the text of a wrapped label; does nothing if it is unchanged.
void setWrappedText(QLabel* label, const QString& text);

/// Scrolls the enclosing scroll area so that a widget is visible, as soon as the area has been laid out.
void bringIntoView(QWidget* widget);
/// Adds a card to a list that is being rebuilt, and shows it at once: a list that becomes shorter for a moment would
/// scroll to its top.
/// @param place position in the list; -1: at the end
void addCard(QBoxLayout* list, QWidget* card, int place = -1);

/// A scroll area for the rows of a list, with a height set by the caller, so that nothing below the list moves when
/// rows are added or removed.
QScrollArea* makeListArea(QWidget* rows, QWidget* parent);
/// A scroll area for a form that scrolls downwards only: it is as wide as the form needs at least, in every language.
QScrollArea* makeFormArea(QWidget* form, QWidget* parent);

/// Changes the look that the style sheet gives a widget (ui/theme/style_sheet.h); does nothing if it is unchanged.
void setLook(QWidget* widget, const char* look);

} // namespace burin

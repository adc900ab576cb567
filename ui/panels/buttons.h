// SPDX-FileCopyrightText: 2026 The Burin authors
// SPDX-License-Identifier: Apache-2.0
#pragma once

#include "ui/theme/theme.h"

#include <QDialog>
#include <QDialogButtonBox>
#include <QPushButton>
#include <QToolButton>

namespace burin {

/// The main action of a panel, in the accent colour.
QPushButton* makePrimaryButton(const QString& text, const QString& objectName, QWidget* parent);
QPushButton* makeButton(const QString& text, const QString& icon, const QString& objectName, QWidget* parent);
/// A small button with only an icon; `toolTip` is also its accessible name.
QToolButton* makeIconButton(const QString& icon, const QString& toolTip, const QString& objectName, QWidget* parent);
/// One of several adjacent buttons, of which one is on.
QPushButton* makeChoiceButton(const QString& text, const QString& toolTip, const QString& objectName, QWidget* parent);

/// The button row with a Close button for a modeless dialog.
QDialogButtonBox* makeCloseRow(QDialog& dialog);

/// Changes a button's icon; does nothing if the button already has it. On a filled button the role is
/// `&Palette::field`: near-black on the dark theme's light colours, white on the light theme's dark ones.
void showIcon(QAbstractButton* button, const QString& name, ColourRole role = &Palette::text);

/// Enables a button if `reason` is empty; otherwise disables it and shows the reason as its tooltip. A button that had
/// the focus regains it when it is enabled again, unless the user has moved the focus elsewhere.
void enableUnless(QWidget* button, const QString& reason, const QString& toolTip);

} // namespace burin

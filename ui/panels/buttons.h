// SPDX-FileCopyrightText: 2026 The Burin authors
// SPDX-License-Identifier: Apache-2.0
#pragma once

#include "ui/theme/theme.h"

#include <QDialog>
#include <QDialogButtonBox>
#include <QPushButton>
#include <QToolButton>

namespace burin {

/// The one action that a panel is for, in the accent's colour.
QPushButton* makePrimaryButton(const QString& text, const QString& objectName, QWidget* parent);
QPushButton* makeButton(const QString& text, const QString& icon, const QString& objectName, QWidget* parent);
/// A small button of an icon alone; `toolTip` is its accessible name as well.
QToolButton* makeIconButton(const QString& icon, const QString& toolTip, const QString& objectName, QWidget* parent);
/// One of several beside each other of which one is on.
QPushButton* makeChoiceButton(const QString& text, const QString& toolTip, const QString& objectName, QWidget* parent);

/// The row below a dialog that stays beside the window: it closes it.
QDialogButtonBox* makeCloseRow(QDialog& dialog);

/// Changes a button's icon; nothing is done when it has it. On a filled button the role is `&Palette::field`:
/// near-black on the dark theme's light colours, white on the light theme's dark ones.
void showIcon(QAbstractButton* button, const QString& name, ColourRole role = &Palette::text);

/// Enabled without a reason against it; else the reason becomes its tooltip. What had the focus has it again when it is
/// enabled, unless the user took it elsewhere.
void enableUnless(QWidget* button, const QString& reason, const QString& toolTip);

} // namespace burin

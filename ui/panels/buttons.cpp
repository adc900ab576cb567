// SPDX-FileCopyrightText: 2026 The Burin authors
// SPDX-License-Identifier: Apache-2.0
#include "ui/panels/buttons.h"

#include "ui/panels/focus_keeper.h"
#include "ui/theme/icon.h"

#include <QCoreApplication>

#include <algorithm>

namespace burin {

namespace {

constexpr int buttonIconSize = 18;

} // namespace

QPushButton* makePrimaryButton(const QString& text, const QString& objectName, QWidget* parent) {
    auto* button = makeButton(text, {}, objectName, parent);
    button->setProperty("look", "primary");
    return button;
}

QPushButton* makeButton(const QString& text, const QString& icon, const QString& objectName, QWidget* parent) {
    auto* button = new QPushButton(text, parent);
    button->setObjectName(objectName);
    button->setCursor(Qt::PointingHandCursor);
    button->setAutoDefault(false);
    button->setIconSize({buttonIconSize, buttonIconSize});
    if (!icon.isEmpty()) button->setIcon(themedIcon(icon));
    return button;
}

QToolButton* makeIconButton(const QString& icon, const QString& toolTip, const QString& objectName, QWidget* parent) {
    auto* button = new QToolButton(parent);
    button->setObjectName(objectName);
    button->setProperty("look", "flat");
    button->setIcon(themedIcon(icon));
    button->setIconSize({buttonIconSize, buttonIconSize});
    button->setToolTip(toolTip);
    button->setAccessibleName(toolTip);
    button->setFocusPolicy(Qt::StrongFocus);
    return button;
}

QPushButton* makeChoiceButton(const QString& text, const QString& toolTip, const QString& objectName, QWidget* parent) {
    auto* button = makeButton(text, {}, objectName, parent);
    button->setProperty("look", "choice");
    button->setCheckable(true);
    button->setToolTip(toolTip);
    return button;
}

QDialogButtonBox* makeCloseRow(QDialog& dialog) {
    auto* row = new QDialogButtonBox(QDialogButtonBox::Close, &dialog);
    row->button(QDialogButtonBox::Close)->setText(QCoreApplication::translate("Buttons", "Close"));
    row->button(QDialogButtonBox::Close)->setToolTip(QCoreApplication::translate("Buttons", "Close this window."));
    QObject::connect(row, &QDialogButtonBox::rejected, &dialog, &QDialog::reject);
    return row;
}

void showIcon(QAbstractButton* button, const QString& name, ColourRole role) {
    const auto known = std::ranges::find(colourRoles, role, &std::pair<std::string_view, ColourRole>::second);
    const QString key = name + QLatin1Char(' ') + QString::number(known - colourRoles.begin());
    if (button->property("iconKey").toString() == key) return;
    button->setProperty("iconKey", key);
    button->setIcon(themedIcon(name, role));
}

void enableUnless(QWidget* button, const QString& reason, const QString& toolTip) {
    setEnabledKeepingFocus(button, reason.isEmpty());
    button->setToolTip(reason.isEmpty() ? toolTip : reason);
}

} // namespace burin

// SPDX-FileCopyrightText: 2026 The Burin authors
// SPDX-License-Identifier: Apache-2.0
#include "ui/window/context_menu.h"

#include <QAction>
#include <QCoreApplication>
#include <QInputDialog>
#include <QMenu>

namespace burin {

QMenu* makeContextMenu(const char* name, const QString& title, QWidget* parent) {
    auto* menu = new QMenu(parent);
    menu->setObjectName(QLatin1String(name));
    menu->setAttribute(Qt::WA_DeleteOnClose);
    menu->setToolTipsVisible(true);
    menu->addSection(title);
    return menu;
}

void addEntry(QMenu& menu, const QString& text, const QString& tip, const char* name,
              const std::function<void()>& use) {
    QAction* action = menu.addAction(text);
    action->setObjectName(QLatin1String(name));
    action->setToolTip(tip);
    QObject::connect(action, &QAction::triggered, &menu, use);
}

QString askName(const QString& title, const QString& before, QWidget* parent) {
    bool wanted = false;
    const QString name = QInputDialog::getText(parent, title, QCoreApplication::translate("TakeMenu", "Name"),
                                               QLineEdit::Normal, before, &wanted);
    return wanted ? name.trimmed() : QString();
}

} // namespace burin

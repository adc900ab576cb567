// SPDX-FileCopyrightText: 2026 The Burin authors
// SPDX-License-Identifier: Apache-2.0
#include "ui/coach/pointed.h"

#include "ui/panels/step_button.h"
#include "ui/workbench/workbench.h"

#include <QAbstractButton>
#include <QAction>
#include <QCoreApplication>
#include <QListWidget>
#include <QMenu>
#include <QMenuBar>

namespace burin {

namespace {

QWidget* shown(const QWidget& window, const char* name) {
    for (QWidget* widget : window.findChildren<QWidget*>(QLatin1String(name)))
        if (widget->isVisible()) return widget;
    return nullptr;
}

/// Returns the part of a rectangle of a widget that its parents do not clip.
QRect seenOf(const QWidget& widget, QRect rect) {
    const QWidget* at = &widget;
    QPoint offset;
    for (; !at->isWindow() && at->parentWidget() != nullptr; at = at->parentWidget()) {
        offset += at->pos();
        rect &= at->parentWidget()->rect().translated(-offset);
    }
    return rect;
}

Pointed at(QWidget* widget, const QRect& rect) {
    return {widget, seenOf(*widget, rect & widget->rect()), {}};
}

Pointed atWidget(QWidget* widget, const FirstJobStep& step, const Workbench& workbench) {
    auto* list = qobject_cast<QListWidget*>(widget);
    const int row = list != nullptr && step.row != nullptr ? step.row(workbench) : -1;
    if (list == nullptr || list->item(row) == nullptr) return at(widget, widget->rect());
    return at(list->viewport(), list->visualItemRect(list->item(row)));
}

QAction* entryOf(const QWidget& window, const char* name) {
    for (const QMenu* menu : window.findChildren<QMenu*>())
        for (QAction* action : menu->actions())
            if (action->objectName() == QLatin1String(name)) return action;
    return nullptr;
}

/// Returns the entry if its menu is open, otherwise what opens the menu that contains it.
Pointed atEntry(const QWidget& window, const char* name) {
    QAction* action = entryOf(window, name);
    QMenu* leadsOn = nullptr;
    for (; action != nullptr; action = leadsOn != nullptr ? leadsOn->menuAction() : nullptr) {
        leadsOn = nullptr;
        for (QObject* place : action->associatedObjects()) {
            if (auto* bar = qobject_cast<QMenuBar*>(place); bar != nullptr && bar->isVisible())
                return at(bar, bar->actionGeometry(action));
            if (auto* button = qobject_cast<QAbstractButton*>(place); button != nullptr && button->isVisible())
                return at(button, button->rect());
            auto* menu = qobject_cast<QMenu*>(place);
            if (menu == nullptr) continue;
            if (menu->isVisible()) return at(menu, menu->actionGeometry(action));
            leadsOn = menu;
        }
    }
    return {};
}

/// Returns the button that leads back to the step of the job, or to the project.
Pointed atTheWay(const QWidget& window, JobStep place) {
    for (StepButton* button : window.findChildren<StepButton*>()) {
        if (button->step() != place || !button->isVisible()) continue;
        Pointed way = at(button, button->rect());
        way.way = QCoreApplication::translate("FirstJob", "Click “%1” at the top of the window.").arg(button->text());
        return way;
    }
    QWidget* back = shown(window, "backButton");
    if (back == nullptr) return {};
    Pointed way = at(back, back->rect());
    way.way = QCoreApplication::translate("FirstJob", "Return to the project.");
    return way;
}

} // namespace

QRect Pointed::rectIn(const QWidget& other) const {
    return widget ? QRect(other.mapFromGlobal(widget->mapToGlobal(rect.topLeft())), rect.size()) : QRect();
}

Pointed pointAt(const QWidget& window, const FirstJobStep& step, const Workbench& workbench) {
    if (step.widget != nullptr)
        if (QWidget* widget = shown(window, step.widget)) return atWidget(widget, step, workbench);
    if (step.action != nullptr)
        if (const Pointed entry = atEntry(window, step.action); entry.widget) return entry;
    return step.place ? atTheWay(window, *step.place) : Pointed{};
}

} // namespace burin

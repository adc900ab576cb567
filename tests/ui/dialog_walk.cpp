// SPDX-FileCopyrightText: 2026 The Burin authors
// SPDX-License-Identifier: Apache-2.0
#include "tests/ui/dialog_walk.h"

#include "tests/ui/window_steps.h"

#include <QAction>
#include <QApplication>
#include <QColorDialog>
#include <QFileDialog>
#include <QMessageBox>
#include <QPushButton>
#include <QTimer>
#include <QtTest>

#include <utility>

namespace burin::testing {

namespace {

constexpr int lookEvery = 40, opensWithin = 160; // ms

/// Those without "…" in their text.
constexpr const char* otherActions[] = {"helpAction", "keyListAction", "aboutAction"};

bool opensMore(QString text) {
    return text.endsWith(QChar(0x2026));
}

bool opensDialog(const QAction& action) {
    const auto named = [&](const char* name) { return action.objectName() == QLatin1String(name); };
    return opensMore(action.text()) || std::any_of(std::begin(otherActions), std::end(otherActions), named);
}

bool isQts(const QDialog& dialog) {
    return qobject_cast<const QFileDialog*>(&dialog) != nullptr ||
           qobject_cast<const QColorDialog*>(&dialog) != nullptr;
}

} // namespace

DialogWalk::DialogWalk(WindowDriver& driver, Look look) : driver_(driver), look_(std::move(look)) {
    goOn();
}

void DialogWalk::walk() {
    for (QAction* action : menuActions(driver_)) {
        if (!action->isEnabled() || !opensDialog(*action)) continue;
        action->trigger();
        QTest::qWait(opensWithin);
        driver_.waitFor([this] { return open_.isEmpty(); });
        driver_.settle();
    }
}

/// A new timer each time: an open dialog or menu blocks the call that opened it.
void DialogWalk::goOn() {
    QTimer::singleShot(lookEvery, this, [this] {
        goOn();
        act();
    });
}

void DialogWalk::act() {
    if (QWidget* menu = QApplication::activePopupWidget()) {
        menu->close();
        return;
    }
    const auto isNew = [this](QWidget* window) {
        auto* dialog = qobject_cast<QDialog*>(window);
        return dialog != nullptr && dialog->isVisible() && !open_.contains(dialog);
    };
    QWidget* top = QApplication::activeModalWidget();
    if (top != nullptr) {
        if (isNew(top)) visit(static_cast<QDialog&>(*top));
        return;
    }
    for (QWidget* window : QApplication::topLevelWidgets())
        if (isNew(window)) return visit(static_cast<QDialog&>(*window));
}

void DialogWalk::visit(QDialog& dialog) {
    const QPointer<QDialog> alive(&dialog);
    const QString name = dialog.objectName();
    if (!isQts(dialog) && !seen_.contains(name)) {
        seen_.insert(name);
        open_.insert(&dialog);
        QTest::qWait(lookEvery); // until it is laid out
        if (alive) look_(dialog);
        const bool question = qobject_cast<QMessageBox*>(&dialog) != nullptr;
        const QList<QPushButton*> buttons = dialog.findChildren<QPushButton*>();
        for (const QPointer<QPushButton> button : buttons) {
            if (question || !alive || !button || !button->isVisible() || !button->isEnabled() ||
                !opensMore(button->text()))
                continue;
            button->click();
            QTest::qWait(opensWithin);
        }
        open_.remove(&dialog);
    }
    if (alive) alive->reject();
}

} // namespace burin::testing

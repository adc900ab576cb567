// SPDX-FileCopyrightText: 2026 The Burin authors
// SPDX-License-Identifier: Apache-2.0
#include "ui/panels/focus_keeper.h"

#include <QKeyEvent>
#include <QWidget>

namespace burin {
namespace {

constexpr qint64 typingPause = 2000; // ms: a key pressed later is handled normally

bool holds(const QWidget* widget, const QWidget* focus) {
    return focus != nullptr && (widget == focus || widget->isAncestorOf(focus));
}

FocusKeeper* keeperFor(QWidget* widget) {
    if (widget->parentWidget() == nullptr) return nullptr;
    for (FocusKeeper* keeper :
         widget->parentWidget()->findChildren<FocusKeeper*>(QString(), Qt::FindDirectChildrenOnly))
        if (holds(widget, keeper->kept())) return keeper;
    return nullptr;
}

} // namespace

bool isTyped(const QKeyEvent& key) {
    if ((key.modifiers() & (Qt::ControlModifier | Qt::AltModifier | Qt::MetaModifier)) != 0) return false;
    if (key.key() == Qt::Key_Backspace || key.key() == Qt::Key_Delete || key.key() == Qt::Key_Return ||
        key.key() == Qt::Key_Enter)
        return true;
    return !key.text().isEmpty() && key.text().front().isPrint();
}

FocusKeeper::FocusKeeper(QWidget* place, QWidget* kept) : QObject(place), place_(place), kept_(kept) {
    place->setFocus(Qt::OtherFocusReason);
    place->installEventFilter(this);
    if (kept->testAttribute(Qt::WA_InputMethodEnabled) || kept->inherits("QComboBox")) typing_.start();
}

void FocusKeeper::giveBack() {
    place_->removeEventFilter(this);
    if (kept_ && kept_->isVisible() && place_->window()->focusWidget() == place_) kept_->setFocus(Qt::OtherFocusReason);
    deleteLater();
    setParent(nullptr);
}

bool FocusKeeper::eventFilter(QObject* watched, QEvent* event) {
    switch (event->type()) {
    case QEvent::FocusOut:
        if (static_cast<QFocusEvent*>(event)->reason() != Qt::ActiveWindowFocusReason) deleteLater();
        break;
    case QEvent::ShortcutOverride:
    case QEvent::KeyPress:
        if (typing_.isValid() && typing_.elapsed() < typingPause && isTyped(*static_cast<QKeyEvent*>(event))) {
            typing_.start();
            event->accept();
            return true;
        }
        break;
    default:
        break;
    }
    return QObject::eventFilter(watched, event);
}

void setEnabledKeepingFocus(QWidget* widget, bool enabled) {
    QWidget* const place = widget->parentWidget();
    QWidget* const focus = widget->window()->focusWidget();
    if (!enabled && place != nullptr && widget->isEnabledTo(place) && holds(widget, focus))
        new FocusKeeper(place, focus);
    widget->setEnabled(enabled);
    if (!enabled) return;
    if (FocusKeeper* keeper = keeperFor(widget)) keeper->giveBack();
}

void forgetKeptFocus(QWidget* place) {
    qDeleteAll(place->findChildren<FocusKeeper*>(QString(), Qt::FindDirectChildrenOnly));
}

} // namespace burin

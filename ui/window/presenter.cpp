// SPDX-FileCopyrightText: 2026 The Burin authors
// SPDX-License-Identifier: Apache-2.0
#include "ui/window/presenter.h"

namespace burin {

Presenter::Presenter(Workbench& workbench, const std::vector<Controller*>& sources, QObject* parent)
    : QObject(parent), workbench_(workbench) {
    for (const Controller* source : sources) connect(source, &Controller::changed, this, &Presenter::presentSoon);
    presentSoon();
}

void Presenter::setUnit(LengthUnit unit) {
    unit_ = unit;
    presentSoon();
}

void Presenter::presentSoon() {
    if (std::exchange(due_, true)) return;
    if (widget_ != nullptr && !widget_->isVisible())
        turn_.start();
    else
        QMetaObject::invokeMethod(this, &Presenter::presentDue, Qt::QueuedConnection);
}

void Presenter::presentDue() {
    turn_.stop();
    if (std::exchange(due_, false)) present();
}

void Presenter::yieldWhileHidden(QWidget& widget) {
    widget_ = &widget;
    widget.installEventFilter(this);
    turn_.setSingleShot(true);
    connect(&turn_, &QTimer::timeout, this, &Presenter::presentDue);
}

/// Updates before the widget is shown, so that no outdated state is visible.
bool Presenter::eventFilter(QObject* watched, QEvent* event) {
    if (watched == widget_ && event->type() == QEvent::Show) presentDue();
    return false;
}

} // namespace burin

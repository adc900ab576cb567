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
    QMetaObject::invokeMethod(
        this,
        [this] {
            due_ = false;
            present();
        },
        Qt::QueuedConnection);
}

} // namespace burin

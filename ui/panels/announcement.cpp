// SPDX-FileCopyrightText: 2026 The Burin authors
// SPDX-License-Identifier: Apache-2.0
#include "ui/panels/announcement.h"

#include <QAccessible>
#include <QWidget>

namespace burin {

void announce(QWidget& widget) {
    if (!widget.isVisible()) return;
    QAccessibleEvent news(&widget, QAccessible::Alert);
    QAccessible::updateAccessibility(&news);
}

} // namespace burin

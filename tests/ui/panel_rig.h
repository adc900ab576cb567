// SPDX-FileCopyrightText: 2026 The Burin authors
// SPDX-License-Identifier: Apache-2.0
#pragma once

#include "ui/panels/row_list.h"
#include "ui/panels/value_row.h"

#include <QAbstractButton>
#include <QComboBox>
#include <QDoubleSpinBox>
#include <QtTest>

#include <algorithm>
#include <map>

/// Panels operated by real mouse and key events.
namespace burin {

inline constexpr int panelWidth = 320;

/// Shows a panel as the window does.
inline void show(QWidget& panel) {
    panel.resize(panelWidth, std::max(panel.sizeHint().height(), panel.heightForWidth(panelWidth)));
    panel.show();
    panel.activateWindow();
    QVERIFY(QTest::qWaitForWindowActive(&panel));
}

template <class T>
T& child(QWidget& panel, const char* name) {
    T* found = panel.findChild<T*>(QLatin1String(name));
    if (found == nullptr) qFatal("there is no %s", name);
    return *found;
}

inline void click(QWidget& panel, const char* name) {
    QTest::mouseClick(&child<QWidget>(panel, name), Qt::LeftButton);
}

inline void type(QWidget& panel, const char* field, const char* text) {
    auto& box = child<QDoubleSpinBox>(panel, field);
    box.setFocus(Qt::TabFocusReason);
    box.selectAll();
    QTest::keyClicks(&box, QLatin1String(text));
    QTest::keyClick(&box, Qt::Key_Return);
}

inline void clickRow(QWidget& panel, const char* list, int row) {
    auto& rows = child<RowList>(panel, list);
    QTest::mouseClick(rows.viewport(), Qt::LeftButton, {}, rows.visualItemRect(rows.item(row)).center());
}

/// The positions of all visible buttons, choices and number fields in a panel.
inline std::map<const QWidget*, QRect> controlsOf(QWidget& panel) {
    QCoreApplication::sendPostedEvents(nullptr, QEvent::LayoutRequest);
    std::map<const QWidget*, QRect> controls;
    for (const QWidget* widget : panel.findChildren<QWidget*>()) {
        const bool pressed = qobject_cast<const QAbstractButton*>(widget) != nullptr ||
                             qobject_cast<const QAbstractSpinBox*>(widget) != nullptr ||
                             qobject_cast<const QComboBox*>(widget) != nullptr;
        if (pressed && widget->isVisible()) controls[widget] = QRect(widget->mapTo(&panel, QPoint()), widget->size());
    }
    return controls;
}

/// What a ValueRow shows, with plain spaces instead of no-break ones.
inline QString valueOf(QWidget& panel, const char* name) {
    return child<ValueRow>(panel, name).value().replace(QChar(QChar::Nbsp), QLatin1Char(' '));
}

/// The text with plain spaces instead of no-break ones.
inline QString plain(QString text) {
    return text.replace(QChar(QChar::Nbsp), QLatin1Char(' '));
}

} // namespace burin

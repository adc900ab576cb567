// SPDX-FileCopyrightText: 2026 The Burin authors
// SPDX-License-Identifier: Apache-2.0
#pragma once

#include "ui/panels/row_list.h"
#include "ui/panels/value_row.h"

#include <QDoubleSpinBox>
#include <QtTest>

#include <algorithm>

/// Panels led by real mouse and key events.
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

/// What a ValueRow shows, with plain spaces.
inline QString valueOf(QWidget& panel, const char* name) {
    return child<ValueRow>(panel, name).value().replace(QChar(QChar::Nbsp), QLatin1Char(' '));
}

/// Text with plain spaces for no-break ones.
inline QString plain(QString text) {
    return text.replace(QChar(QChar::Nbsp), QLatin1Char(' '));
}

} // namespace burin

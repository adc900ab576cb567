// SPDX-FileCopyrightText: 2026 The Burin authors
// SPDX-License-Identifier: Apache-2.0
#pragma once

#include <QApplication>
#include <QString>

namespace burin {

/// Takes the style sheet off an application for as long as it lives. Under a style sheet, a widget that gets a parent
/// passes the style on to everything inside it, again at each level: two thirds of the time in which a window is built.
/// Widgets that are not shown yet miss nothing, as they are polished when they are shown. GUI thread.
class WithoutStyleSheet {
public:
    explicit WithoutStyleSheet(QApplication& application)
        : application_(application), sheet_(application.styleSheet()) {
        application_.setStyleSheet({});
    }
    ~WithoutStyleSheet() { application_.setStyleSheet(sheet_); }
    WithoutStyleSheet(const WithoutStyleSheet&) = delete;
    WithoutStyleSheet& operator=(const WithoutStyleSheet&) = delete;

private:
    QApplication& application_;
    QString sheet_;
};

} // namespace burin

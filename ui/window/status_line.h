// SPDX-FileCopyrightText: 2026 The Burin authors
// SPDX-License-Identifier: Apache-2.0
#pragma once

#include "ui/theme/length_unit.h"

#include <QStatusBar>

class QLabel;
class QProgressBar;
class QToolButton;

namespace burin {

/// One row of status: stylus, the rate actually reached, position, size in memory, time of saving, background work.
class StatusLine final : public QStatusBar {
    Q_OBJECT
public:
    explicit StatusLine(QWidget* parent = nullptr);

    void setRecording(const QString& text); ///< empty: no recording
    void setEscape(const QString& text);    ///< effect of Esc; empty: none
    /// Sets the text for a page on which Esc has another effect.
    void setPageEscape(const QString& text, bool counts);
    void setStylus(const QString& text, bool running);
    void setRate(const QString& text);
    void setPosition(const QString& text);
    void setSize(const QString& text);
    void setSaved(const QString& text);
    /// @param fraction 0 … 1; an empty title: no task is running
    void setTask(const QString& title, double fraction, bool cancelling);

signals:
    void cancelRequested();

private:
    QLabel* add(const char* name, const QString& toolTip);
    QLabel* add(const char* name, const QString& toolTip, QLabel* label);

    void showEscape();

    QString escapeText_, pageEscape_;
    bool pageCounts_ = false;
    QLabel* recording_ = nullptr;
    QLabel* escape_ = nullptr;
    QLabel* stylus_ = nullptr;
    QLabel* rate_ = nullptr;
    QLabel* position_ = nullptr;
    QLabel* size_ = nullptr;
    QLabel* saved_ = nullptr;
    QLabel* task_ = nullptr;
    QProgressBar* progress_ = nullptr;
    QToolButton* cancel_ = nullptr;
};

} // namespace burin

// SPDX-FileCopyrightText: 2026 The Burin authors
// SPDX-License-Identifier: Apache-2.0
#pragma once

#include <QFrame>
#include <QString>

class QLabel;
class QPushButton;

namespace burin {

/// What the coach says.
struct CoachState {
    int number = 0, steps = 0; ///< the step, from 1; 0: all are behind
    QString title, text;
    QString key;       ///< the keys that do the same; empty: none
    QString note;      ///< what comes first, or stands in the way; empty: nothing
    bool done = false; ///< the step was done before
    friend bool operator==(const CoachState&, const CoachState&) = default;
};

/// A small panel over the window that says what to do next. It lies where it covers nothing of what is meant, and is
/// read out when a step begins.
class CoachPanel final : public QFrame {
    Q_OBJECT
public:
    explicit CoachPanel(QWidget* window);
    void setState(const CoachState& state);
    /// In a corner of an area, clear of what is meant. Both in logical pixels of the window.
    void placeIn(const QRect& area, const QRect& target);

signals:
    void backWanted();
    void skipWanted(); ///< or to go on from a step that was done before
    void endWanted();

protected:
    void paintEvent(QPaintEvent* event) override;

private:
    void announce(const CoachState& state);

    QLabel *count_, *title_, *text_, *key_, *note_;
    QPushButton *back_, *skip_, *end_;
    int corner_ = 0;
    int saidNumber_ = -1; ///< of the step that was read out last
};

} // namespace burin

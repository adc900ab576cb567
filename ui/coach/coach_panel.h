// SPDX-FileCopyrightText: 2026 The Burin authors
// SPDX-License-Identifier: Apache-2.0
#pragma once

#include <QFrame>
#include <QString>

class QLabel;
class QPushButton;

namespace burin {

/// The content of the coach panel.
struct CoachState {
    int number = 0, steps = 0; ///< the step, from 1; 0 if all are completed or skipped
    QString title, text;
    QString key;       ///< the shortcut that does the same; empty if there is none
    QString note;      ///< what has to be done first or prevents the step; empty if nothing
    bool done = false; ///< whether the step was completed before
    friend bool operator==(const CoachState&, const CoachState&) = default;
};

/// A small panel over the window that says what to do next. It is placed where it covers as little as possible of its
/// target, and is announced to screen readers when a step begins.
class CoachPanel final : public QFrame {
    Q_OBJECT
public:
    explicit CoachPanel(QWidget* window);
    void setState(const CoachState& state);
    /// Moves the panel to the corner of `area` where it covers least of `target`. Both in logical pixels of the window.
    void placeIn(const QRect& area, const QRect& target);

signals:
    void backRequested();
    void skipRequested(); ///< or continue from a step that was completed before
    void endRequested();

protected:
    void paintEvent(QPaintEvent* event) override;

private:
    void announce(const CoachState& state);

    QLabel *count_, *title_, *text_, *key_, *note_;
    QPushButton *back_, *skip_, *end_;
    int corner_ = 0;
    int saidNumber_ = -1; ///< of the step that was announced last
};

} // namespace burin

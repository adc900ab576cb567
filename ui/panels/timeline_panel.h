// SPDX-FileCopyrightText: 2026 The Burin authors
// SPDX-License-Identifier: Apache-2.0
#pragma once

#include "ui/panels/timeline_view.h"

#include <QFrame>

#include <array>

class QAction;
class QComboBox;
class QLabel;
class QMenu;
class QToolButton;

namespace burin {

/// The state shown by the timeline's bar and view.
struct TimelinePanelState {
    TimelineState view;
    bool reading = false, arriving = false, playing = false;
    double speed = 1.0;
};

/// The timeline below the view: the choice of curves, the playback buttons, and the time.
class TimelinePanel final : public QFrame {
    Q_OBJECT
public:
    /// Playback speeds from slowest to fastest, as multiples of the recorded speed.
    static constexpr std::array<double, 9> speeds{0.25, 0.5, 1.0, 2.0, 4.0, 8.0, 16.0, 32.0, 64.0};
    /// Actions that are shown as buttons; they must outlive the panel.
    struct Offered {
        QAction &play, &present, &punchIn;
    };

    explicit TimelinePanel(const Offered& offered, QWidget* parent = nullptr);
    void setState(const TimelinePanelState& state); ///< never emits
    void setUnit(LengthUnit unit) { view_->setUnit(unit); }
    TimelineView& view() noexcept { return *view_; }
    /// The bar with curves, playback and time, to be placed above; the panel itself contains only the view. Owned by
    /// the widget in which it is placed.
    QWidget* bar() noexcept { return bar_; }
    /// The names of the visible curves, for settings; `setCurves` restores them.
    QStringList curves() const;
    void setCurves(const QStringList& curves);

signals:
    void sought(double seconds);
    void speedChosen(double speed);
    void curveShown(TrackCurve curve, bool shown);

private:
    QToolButton* makeActionButton(QAction& action, const char* icon, const char* name);
    void showTime(const TimelinePanelState& state);

    QMenu* makeCurvesMenu();
    std::array<QAction*, trackCurves> curves_{};
    QToolButton *start_ = nullptr, *play_ = nullptr, *end_ = nullptr;
    QWidget* bar_;
    QComboBox* speed_ = nullptr;
    QLabel* time_ = nullptr;
    TimelineView* view_;
    double all_ = 0.0; ///< s
};

} // namespace burin

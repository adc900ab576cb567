// SPDX-FileCopyrightText: 2026 The Burin authors
// SPDX-License-Identifier: Apache-2.0
#pragma once

#include "ui/panels/timeline_curves.h"

#include <QWidget>

#include <memory>
#include <optional>
#include <set>
#include <utility>
#include <vector>

namespace burin {

/// A take that is being recorded, or was recorded since the timeline's takes were read.
struct GrowingClip {
    QString name;
    double seconds = 0.0;                           ///< so far
    std::vector<std::pair<double, double>> strokes; ///< s from its start: begin and end
};

/// The moments of the chosen part of a path.
struct PointedTime {
    bool hasMoment = false;         ///< false: it was computed, by a planner or an edit
    double first = 0.0, last = 0.0; ///< s from the first take's start
};

/// The state shown by a timeline.
struct TimelineState {
    std::shared_ptr<const RecordedTime> recorded; ///< null: no recording
    std::vector<GrowingClip> growing;             ///< after those takes, in order
    std::optional<PointedTime> pointed;           ///< empty: nothing is chosen on the path
    std::vector<TimeMarker> markers;              ///< in order
    bool program = false; ///< whether it shows the time of a program; its takes are then intervals with one tool
    double seconds = 0.0; ///< position of the cursor, s
    qint64 chosen = 0;    ///< take that actions apply to; 0: none
    bool away = false;    ///< whether the cursor is in the past
    bool enabled = false; ///< whether the user can seek
    std::int64_t scored = 0, reference = 0; ///< the reference is drawn behind the scored take; 0: none
};

/// The recordings along their time axis: takes as clips with their strokes, curves above, and a cursor. A click or a
/// drag seeks to a moment, the wheel zooms at the pointer, and scrolls with Shift; keys do the same.
class TimelineView final : public QWidget {
    Q_OBJECT
public:
    explicit TimelineView(QWidget* parent = nullptr);
    void setState(const TimelineState& state);
    void setUnit(LengthUnit unit);
    void sayTime(const QString& time); ///< what assistive programs read before the keys; empty: nothing
    void showCurve(TrackCurve curve, bool shown);

    QSize sizeHint() const override;
    QSize minimumSizeHint() const override;
    /// Time (s) at a pixel of the widget, and the inverse; also used by tests.
    double secondsAt(double x) const;
    double placeOf(double seconds) const;
    double all() const; ///< total length of all takes, s

signals:
    void sought(double seconds); ///< s from the first take's start
    void playToggled();
    void takeChosen(qint64 take); ///< the user clicked its clip
    /// The user requested the menu of a take. @param sample of the take, under the pointer
    void menuRequested(qint64 take, quint64 sample, const QPoint& globalPosition);
    /// The user requested the menu of a marker. @param marker index of the marker
    void markerMenuRequested(int marker, const QPoint& globalPosition);

protected:
    void paintEvent(QPaintEvent* event) override;
    void mousePressEvent(QMouseEvent* event) override;
    void mouseMoveEvent(QMouseEvent* event) override;
    void mouseDoubleClickEvent(QMouseEvent* event) override;
    void wheelEvent(QWheelEvent* event) override;
    void keyPressEvent(QKeyEvent* event) override;
    void contextMenuEvent(QContextMenuEvent* event) override;
    bool event(QEvent* event) override;

private:
    struct Lane {
        TrackCurve curve = TrackCurve::force;
        QRect area;
    };
    std::vector<Lane> lanes() const;
    QRect clipRow() const;
    double startOf(std::size_t track) const; ///< start of a take, s
    std::optional<std::size_t> trackAt(double seconds) const;
    void paintRuler(QPainter& painter) const;
    void paintLane(QPainter& painter, const Lane& lane);
    QString valueText(TrackCurve curve, std::size_t track, std::size_t bin) const;
    void paintClips(QPainter& painter) const;
    void paintGrowing(QPainter& painter) const;
    void paintPointed(QPainter& painter) const;
    void paintMarkers(QPainter& painter) const;
    void paintCursor(QPainter& painter) const;
    std::optional<std::size_t> markerAt(const QPointF& place) const;
    void seek(double x);
    void zoom(double factor, double at);
    void moveTo(double begin);
    void seekStroke(int direction);
    QString clipText(std::size_t track) const;

    TimelineState state_;
    LengthUnit unit_ = LengthUnit::millimetre;
    std::set<TrackCurve> shown_;
    TimelineCurves curves_;
    double begin_ = 0.0, length_ = 0.0; ///< the visible interval, s; length 0: everything
};

} // namespace burin

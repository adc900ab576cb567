// SPDX-FileCopyrightText: 2026 The Burin authors
// SPDX-License-Identifier: Apache-2.0
#pragma once

#include "ui/panels/timeline_curves.h"

#include <QWidget>

#include <memory>
#include <optional>
#include <set>
#include <vector>

namespace burin {

/// What a timeline shows.
struct TimelineState {
    std::shared_ptr<const RecordedTime> recorded; ///< null: nothing
    std::vector<TimeMarker> markers;              ///< in order
    bool program = false;                         ///< it is a program's time; its takes are stretches with one tool
    double seconds = 0.0;                         ///< where the cursor stands
    bool away = false;                            ///< that is the past
    bool enabled = false;                         ///< it can be gone through
};

/// The recordings along their time: takes as clips with their strokes in them, curves above, a cursor. A click or a
/// drag asks for a moment, the wheel zooms in at the pointer, with Shift it moves along; so do keys.
class TimelineView final : public QWidget {
    Q_OBJECT
public:
    explicit TimelineView(QWidget* parent = nullptr);
    void setState(const TimelineState& state);
    void setUnit(LengthUnit unit);
    void showCurve(TrackCurve curve, bool shown);

    QSize sizeHint() const override;
    QSize minimumSizeHint() const override;
    /// s at a pixel of the widget, and the inverse; for its owner's tests as well.
    double secondsAt(double x) const;
    double placeOf(double seconds) const;

signals:
    void sought(double seconds); ///< s from the first take's start
    void playToggled();
    /// The menu of a take is wanted. @param sample of the take, under the pointer
    void menuWanted(qint64 take, quint64 sample, const QPoint& globalPosition);
    /// The same of a marker. @param marker its place among them
    void markerMenuWanted(int marker, const QPoint& globalPosition);

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
    double all() const;                      ///< s of all takes
    double startOf(std::size_t track) const; ///< s
    std::optional<std::size_t> trackAt(double seconds) const;
    void paintRuler(QPainter& painter) const;
    void paintLane(QPainter& painter, const Lane& lane);
    void paintClips(QPainter& painter) const;
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
    double begin_ = 0.0, length_ = 0.0; ///< s that are seen; length 0: all
};

} // namespace burin

// SPDX-FileCopyrightText: 2026 The Burin authors
// SPDX-License-Identifier: Apache-2.0
#pragma once

#include "ui/scene/camera_view.h"

#include <chrono>
#include <optional>

namespace burin {

/// Moves the camera: by a drag of the pointer, by the wheel, or by itself to another view. Knows no window; the owner
/// gives it the time.
class CameraMotion {
public:
    using Clock = std::chrono::steady_clock;
    enum class Drag { none, orbit, pan };

    const CameraView& view() const noexcept { return view_; }
    const QSizeF& size() const noexcept { return size_; }
    /// Of the widget, device-independent pixels. Until the user moves the camera, the picture stays fitted.
    void setSize(const QSizeF& size);
    /// What `fit` shows, mm.
    void setContent(const Box& content);

    void beginDrag(Drag drag, const QPointF& position, const glm::dvec3& pivot);
    void drag(const QPointF& position);
    void endDrag() noexcept { drag_ = Drag::none; }
    Drag dragging() const noexcept { return drag_; }
    /// @param steps notches, > 0: nearer
    void zoom(double steps, const glm::dvec3& pivot);

    /// A standard view, all in the picture. @param duration zero: at once
    void turnTo(StandardView standard, Clock::time_point now, Clock::duration duration);
    /// A view of somebody else's, at once; it stays as one that the user moved to.
    void setView(const CameraView& view);
    void fit(Clock::time_point now, Clock::duration duration);
    /// Lets a movement that is under way go on. False: there is none any more.
    bool advance(Clock::time_point now);
    bool moving() const noexcept { return flight_.has_value() || drag_ != Drag::none; }

private:
    struct Flight {
        CameraView from, to;
        Clock::time_point start;
        Clock::duration duration;
    };
    void flyTo(const CameraView& view, Clock::time_point now, Clock::duration duration);

    CameraView view_ = turnedTo({}, StandardView::isometric);
    QSizeF size_{100.0, 100.0};
    Box content_;
    bool stayFitted_ = true;
    std::optional<Flight> flight_;
    Drag drag_ = Drag::none;
    QPointF dragPosition_;
    glm::dvec3 pivot_{0.0};
};

} // namespace burin

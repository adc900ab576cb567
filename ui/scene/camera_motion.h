// SPDX-FileCopyrightText: 2026 The Burin authors
// SPDX-License-Identifier: Apache-2.0
#pragma once

#include "ui/scene/camera_push.h"
#include "ui/scene/camera_view.h"

#include <chrono>
#include <optional>

namespace burin {

/// Moves the camera: by dragging with the pointer, by the wheel, or by an animation to another view. Independent of any
/// window; the owner passes the time.
class CameraMotion {
public:
    using Clock = std::chrono::steady_clock;
    enum class Drag { none, orbit, pan };

    const CameraView& view() const noexcept { return view_; }
    const QSizeF& size() const noexcept { return size_; }
    /// Sets the size of the widget, device-independent pixels. Until the user moves the camera, the view stays fitted.
    void setSize(const QSizeF& size);
    /// Sets the box that `fit` shows, mm.
    void setContent(const Box& content);

    void beginDrag(Drag drag, const QPointF& position, const glm::dvec3& pivot);
    /// @param duration of the transition from a view along an axis to the chosen projection when it is rotated
    void drag(const QPointF& position, Clock::time_point now = {}, Clock::duration duration = {});
    void endDrag() noexcept { drag_ = Drag::none; }
    Drag dragging() const noexcept { return drag_; }
    /// Moves the camera by a 3D mouse: the content moves with the cap, and rotates about its centre.
    /// @param seconds duration of the push. @param duration as in `drag`
    void push(const CameraPush& push, double seconds, Clock::time_point now = {}, Clock::duration duration = {});
    /// @param steps notches, > 0: nearer
    void zoom(double steps, const glm::dvec3& pivot);

    /// Selects parallel or perspective projection. Views straight along an axis are always parallel until they are
    /// rotated; then this choice applies again. @param duration zero: at once
    void setParallel(bool parallel, Clock::time_point now, Clock::duration duration);
    /// Turns to a standard view that shows the whole content. @param duration zero: at once
    void turnTo(StandardView standard, Clock::time_point now, Clock::duration duration);
    /// Sets a view from outside, at once; it is then treated like a view set by the user.
    void setView(const CameraView& view);
    void fit(Clock::time_point now, Clock::duration duration);
    /// Advances a running animation. Returns false if there is none any more.
    bool advance(Clock::time_point now);
    bool moving() const noexcept { return flight_ || change_ || drag_ != Drag::none; }

private:
    struct Flight {
        CameraView from, to;
        Clock::time_point start;
        Clock::duration duration;
    };
    /// A transition from perspective to parallel or back, during which the camera may be moved.
    struct Change {
        double from = 1.0, to = 1.0; ///< convergence
        Clock::time_point start;
        Clock::duration duration;
    };
    double chosenConvergence() const noexcept { return parallel_ ? 0.0 : 1.0; }
    void flyTo(const CameraView& view, Clock::time_point now, Clock::duration duration);
    void endFlight(const glm::dvec3& pivot);
    CameraView destination() const; ///< the final view of a running animation
    void change(double convergence, Clock::time_point now, Clock::duration duration);
    void converge(Clock::time_point now);

    CameraView view_ = turnedTo({}, StandardView::isometric);
    QSizeF size_{100.0, 100.0};
    Box content_;
    bool stayFitted_ = true;
    std::optional<Flight> flight_;
    std::optional<Change> change_;
    bool parallel_ = false;  ///< the user's choice
    bool alongAxis_ = false; ///< whether the view is along an axis and hence parallel
    Drag drag_ = Drag::none;
    QPointF dragPosition_;
    glm::dvec3 pivot_{0.0};
};

} // namespace burin

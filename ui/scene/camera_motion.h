// SPDX-FileCopyrightText: 2026 The Burin authors
// SPDX-License-Identifier: Apache-2.0
#pragma once

#include "ui/scene/camera_push.h"
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
    /// @param duration that a view along an axis takes to become one of the chosen projection when it is turned
    void drag(const QPointF& position, Clock::time_point now = {}, Clock::duration duration = {});
    void endDrag() noexcept { drag_ = Drag::none; }
    Drag dragging() const noexcept { return drag_; }
    /// As a device in the other hand pushes it: the content moves with the cap, and turns about its middle.
    /// @param seconds that the push lasted. @param duration as in `drag`
    void push(const CameraPush& push, double seconds, Clock::time_point now = {}, Clock::duration duration = {});
    /// @param steps notches, > 0: nearer
    void zoom(double steps, const glm::dvec3& pivot);

    /// Whether pictures are parallel. Views straight along an axis always are, until they are turned; then the choice
    /// holds again. @param duration zero: at once
    void setParallel(bool parallel, Clock::time_point now, Clock::duration duration);
    /// A standard view, all in the picture. @param duration zero: at once
    void turnTo(StandardView standard, Clock::time_point now, Clock::duration duration);
    /// A view of somebody else's, at once; it stays as one that the user moved to.
    void setView(const CameraView& view);
    void fit(Clock::time_point now, Clock::duration duration);
    /// Lets a movement that is under way go on. False: there is none any more.
    bool advance(Clock::time_point now);
    bool moving() const noexcept { return flight_ || change_ || drag_ != Drag::none; }

private:
    struct Flight {
        CameraView from, to;
        Clock::time_point start;
        Clock::duration duration;
    };
    /// From perspective to parallel or back, while the camera may be moved.
    struct Change {
        double from = 1.0, to = 1.0; ///< convergence
        Clock::time_point start;
        Clock::duration duration;
    };
    double chosenConvergence() const noexcept { return parallel_ ? 0.0 : 1.0; }
    void flyTo(const CameraView& view, Clock::time_point now, Clock::duration duration);
    void endFlight(const glm::dvec3& pivot);
    CameraView destination() const; ///< where a movement that is under way ends
    void change(double convergence, Clock::time_point now, Clock::duration duration);
    void converge(Clock::time_point now);

    CameraView view_ = turnedTo({}, StandardView::isometric);
    QSizeF size_{100.0, 100.0};
    Box content_;
    bool stayFitted_ = true;
    std::optional<Flight> flight_;
    std::optional<Change> change_;
    bool parallel_ = false;  ///< the user's choice
    bool alongAxis_ = false; ///< a view that is parallel of itself
    Drag drag_ = Drag::none;
    QPointF dragPosition_;
    glm::dvec3 pivot_{0.0};
};

} // namespace burin

// SPDX-FileCopyrightText: 2026 The Burin authors
// SPDX-License-Identifier: Apache-2.0
#include "ui/scene/camera_motion.h"

#include "core/base/units.h"

#include <algorithm>
#include <cmath>
#include <utility>

namespace burin {
namespace {

constexpr double orbitPerPixel = 0.4 * pi / 180.0; // rad: moving the pointer by a hand's width is half a turn
constexpr double zoomPerNotch = 0.85;
// Effect of one second of full push or turn.
constexpr double picturesPerSecond = 0.6; // heights of the picture
constexpr double zoomPerSecond = 2.5;     // factor of the distance
constexpr double turnPerSecond = 1.5;     // rad

/// The completed fraction of a movement. @return 1: finished
double shareOf(CameraMotion::Clock::time_point start, CameraMotion::Clock::duration duration,
               CameraMotion::Clock::time_point now) {
    if (duration <= CameraMotion::Clock::duration::zero()) return 1.0;
    return std::min(1.0, std::chrono::duration<double>(now - start) / duration);
}

/// Accelerates and decelerates smoothly.
double eased(double share) {
    return share * share * (3.0 - 2.0 * share);
}

} // namespace

void CameraMotion::setSize(const QSizeF& size) {
    size_ = size;
    if (stayFitted_) flyTo(fitted(destination(), size_, content_), {}, {});
}

void CameraMotion::setContent(const Box& content) {
    if (content.low == content_.low && content.high == content_.high) return;
    const bool first = content_.empty();
    content_ = content;
    if (stayFitted_ || first) flyTo(fitted(destination(), size_, content_), {}, {});
}

void CameraMotion::beginDrag(Drag drag, const QPointF& position, const glm::dvec3& pivot) {
    endFlight(pivot);
    drag_ = drag;
    dragPosition_ = position;
    pivot_ = pivot;
}

void CameraMotion::drag(const QPointF& position, Clock::time_point now, Clock::duration duration) {
    const QPointF way = position - dragPosition_;
    dragPosition_ = position;
    if (drag_ == Drag::none || way.isNull()) return;
    stayFitted_ = false;
    if (drag_ == Drag::orbit && std::exchange(alongAxis_, false)) change(chosenConvergence(), now, duration);
    view_ = drag_ == Drag::orbit ? orbited(view_, -way.x() * orbitPerPixel, way.y() * orbitPerPixel, pivot_)
                                 : panned(view_, size_, way, pivot_);
}

void CameraMotion::push(const CameraPush& push, double seconds, Clock::time_point now, Clock::duration duration) {
    const glm::dvec3 pivot = content_.empty() ? view_.focus : 0.5 * (content_.low + content_.high);
    endFlight(pivot);
    stayFitted_ = false;
    const double azimuth = -turnPerSecond * seconds * push.turn.z, elevation = turnPerSecond * seconds * push.turn.x;
    if (azimuth != 0.0 || elevation != 0.0) {
        pivot_ = pivot;
        if (std::exchange(alongAxis_, false)) change(chosenConvergence(), now, duration);
        view_ = orbited(view_, azimuth, elevation, pivot);
    }
    const double pixels = picturesPerSecond * seconds * size_.height();
    view_ = panned(view_, size_, {pixels * push.push.x, -pixels * push.push.z}, view_.focus);
    view_ = zoomed(view_, std::pow(zoomPerSecond, seconds * push.push.y), view_.focus);
}

void CameraMotion::zoom(double steps, const glm::dvec3& pivot) {
    endFlight(pivot);
    stayFitted_ = false;
    view_ = zoomed(view_, std::pow(zoomPerNotch, steps), pivot);
}

void CameraMotion::turnTo(StandardView standard, Clock::time_point now, Clock::duration duration) {
    stayFitted_ = true;
    alongAxis_ = standard != StandardView::isometric;
    CameraView turned = turnedTo(view_, standard);
    turned.convergence = alongAxis_ ? 0.0 : chosenConvergence();
    flyTo(fitted(turned, size_, content_), now, duration);
}

void CameraMotion::setParallel(bool parallel, Clock::time_point now, Clock::duration duration) {
    parallel_ = parallel;
    if (alongAxis_) return;
    if (flight_) {
        flight_->to.convergence = chosenConvergence();
        return;
    }
    if (drag_ == Drag::none) pivot_ = view_.focus;
    change(chosenConvergence(), now, duration);
}

void CameraMotion::change(double convergence, Clock::time_point now, Clock::duration duration) {
    change_ = Change{view_.convergence, convergence, now, duration};
    converge(now);
}

void CameraMotion::converge(Clock::time_point now) {
    const double share = shareOf(change_->start, change_->duration, now);
    view_ = converged(view_, change_->from + (change_->to - change_->from) * eased(share), pivot_);
    if (share >= 1.0) change_.reset();
}

void CameraMotion::setView(const CameraView& view) {
    flight_.reset();
    change_.reset();
    stayFitted_ = false;
    view_ = view;
    if (parallel_) view_.convergence = 0.0;
    alongAxis_ = !parallel_ && isParallel(view);
}

void CameraMotion::fit(Clock::time_point now, Clock::duration duration) {
    stayFitted_ = true;
    flyTo(fitted(destination(), size_, content_), now, duration);
}

/// Ends the animation at the current view, but not in a projection between the two.
void CameraMotion::endFlight(const glm::dvec3& pivot) {
    if (flight_) view_ = converged(view_, flight_->to.convergence, pivot);
    flight_.reset();
}

CameraView CameraMotion::destination() const {
    CameraView view = flight_ ? flight_->to : view_;
    if (change_) view.convergence = change_->to;
    return view;
}

void CameraMotion::flyTo(const CameraView& view, Clock::time_point now, Clock::duration duration) {
    flight_.reset();
    change_.reset();
    if (duration > Clock::duration::zero())
        flight_ = Flight{view_, view, now, duration};
    else
        view_ = view;
}

bool CameraMotion::advance(Clock::time_point now) {
    if (change_) converge(now);
    if (flight_) {
        const double share = shareOf(flight_->start, flight_->duration, now);
        view_ = between(flight_->from, flight_->to, eased(share));
        if (share >= 1.0) flight_.reset();
    }
    return flight_ || change_;
}

} // namespace burin

// SPDX-FileCopyrightText: 2026 The Burin authors
// SPDX-License-Identifier: Apache-2.0
#include "ui/scene/camera_motion.h"

#include "core/base/units.h"

#include <cmath>

namespace burin {
namespace {

constexpr double orbitPerPixel = 0.4 * pi / 180.0; // rad: a hand's width of the pointer is a half turn
constexpr double zoomPerNotch = 0.85;

/// Gathers speed and brakes without a jolt.
double eased(double share) {
    return share * share * (3.0 - 2.0 * share);
}

} // namespace

void CameraMotion::setSize(const QSizeF& size) {
    size_ = size;
    if (stayFitted_) flyTo(fitted(flight_ ? flight_->to : view_, size_, content_), {}, {});
}

void CameraMotion::setContent(const Box& content) {
    if (content.low == content_.low && content.high == content_.high) return;
    const bool first = content_.empty();
    content_ = content;
    if (stayFitted_ || first) flyTo(fitted(flight_ ? flight_->to : view_, size_, content_), {}, {});
}

void CameraMotion::beginDrag(Drag drag, const QPointF& position, const glm::dvec3& pivot) {
    flight_.reset();
    drag_ = drag;
    dragPosition_ = position;
    pivot_ = pivot;
}

void CameraMotion::drag(const QPointF& position) {
    const QPointF way = position - dragPosition_;
    dragPosition_ = position;
    if (drag_ == Drag::none || way.isNull()) return;
    stayFitted_ = false;
    view_ = drag_ == Drag::orbit ? orbited(view_, -way.x() * orbitPerPixel, way.y() * orbitPerPixel, pivot_)
                                 : panned(view_, size_, way, pivot_);
}

void CameraMotion::zoom(double steps, const glm::dvec3& pivot) {
    flight_.reset();
    stayFitted_ = false;
    view_ = zoomed(view_, std::pow(zoomPerNotch, steps), pivot);
}

void CameraMotion::turnTo(StandardView standard, Clock::time_point now, Clock::duration duration) {
    stayFitted_ = true;
    flyTo(fitted(turnedTo(view_, standard), size_, content_), now, duration);
}

void CameraMotion::setView(const CameraView& view) {
    flight_.reset();
    stayFitted_ = false;
    view_ = view;
}

void CameraMotion::fit(Clock::time_point now, Clock::duration duration) {
    stayFitted_ = true;
    flyTo(fitted(flight_ ? flight_->to : view_, size_, content_), now, duration);
}

void CameraMotion::flyTo(const CameraView& view, Clock::time_point now, Clock::duration duration) {
    flight_.reset();
    if (duration > Clock::duration::zero())
        flight_ = Flight{view_, view, now, duration};
    else
        view_ = view;
}

bool CameraMotion::advance(Clock::time_point now) {
    if (!flight_) return false;
    const double share = std::chrono::duration<double>(now - flight_->start) / flight_->duration;
    view_ = between(flight_->from, flight_->to, share >= 1.0 ? 1.0 : eased(share));
    if (share >= 1.0) flight_.reset();
    return flight_.has_value();
}

} // namespace burin

// SPDX-FileCopyrightText: 2026 The Burin authors
// SPDX-License-Identifier: Apache-2.0
#include "ui/input/path_hand.h"

#include "ui/input/mill_geometry.h"

#include <QtGlobal>

#include <cmath>
#include <utility>

namespace burin {
namespace {

constexpr double clickReach = 4.0;    // pixels by which a click may move
constexpr double drawnSpacing = 0.2;  // mm between drawn points
constexpr double smallestSine = 1e-3; // of the angle between a line of sight and a plane

/// The intersection of a line of sight with the plane through a point, mm.
std::optional<glm::dvec3> onPlane(const Sight& sight, const glm::dvec3& place, const glm::dvec3& normal) {
    const double slope = glm::dot(sight.direction, normal);
    if (std::abs(slope) < smallestSine) return std::nullopt;
    const double way = glm::dot(place - sight.origin, normal) / slope;
    if (way <= 0.0) return std::nullopt;
    return sight.origin + way * sight.direction;
}

} // namespace

std::optional<glm::dvec3> dragged(const glm::dvec3& place, const Sight& from, const Sight& to, DragAlong along) {
    if (along == DragAlong::level || along == DragAlong::surface) {
        const glm::dvec3 normal = along == DragAlong::level ? glm::dvec3(0.0, 0.0, 1.0) : from.direction;
        const auto began = onPlane(from, place, normal), now = onPlane(to, place, normal);
        if (!began || !now) return std::nullopt;
        return *now - *began;
    }
    glm::dvec3 axis(0.0);
    axis[static_cast<int>(along) - static_cast<int>(DragAlong::x)] = 1.0;
    const auto began = alongAxis(from, place, axis), now = alongAxis(to, place, axis);
    if (!began || !now) return std::nullopt;
    return (*now - *began) * axis;
}

PathHand::PathHand(Appearance appearance, QObject* parent) : QObject(parent), appearance_(std::move(appearance)) {}

void PathHand::setPoints(std::vector<HandPoint> points) {
    if (doing_ != Doing::drawing) giveUp(); // it concerned the previous path
    points_ = std::move(points);
    menuAt_.reset();
}

void PathHand::setHandles(std::vector<glm::dvec3> handles) {
    if (handles == handles_) return;
    if (doing_ != Doing::drawing) giveUp(); // it may concern another handle
    handles_ = std::move(handles);
}

void PathHand::setDrawing(std::optional<double> height) {
    if (height == height_) return;
    giveUp();
    height_ = height;
    emit stateChanged();
}

void PathHand::setChosen(bool chosen) {
    if (std::exchange(chosen_, chosen) != chosen) emit stateChanged();
}

void PathHand::setEscape(const QString& meaning) {
    if (std::exchange(escape_, meaning) != meaning) emit stateChanged();
}

/// @return the previous state
PathHand::Doing PathHand::become(Doing what) {
    const Doing before = std::exchange(doing_, what);
    if (before != what) emit stateChanged();
    return before;
}

PathPiece PathHand::pieceAt(std::size_t piece) const {
    return {points_[piece].place, points_[piece + 1].place, points_[piece + 1].arc};
}

/// On the piece that appears nearest. If only one of its ends comes from the hand, that end.
std::optional<PathPlace> PathHand::placeAt(const QPointF& pointer) const {
    if (points_.size() < 2) return std::nullopt;
    const auto place = nearestPlace(
        pointer, points_.size() - 1,
        [this](std::size_t i) -> std::optional<PathPiece> {
            if (!points_[i].usable && !points_[i + 1].usable) return std::nullopt;
            return pieceAt(i);
        },
        appearance_);
    if (!place) return std::nullopt;
    if (!points_[place->piece].usable) return PathPlace{place->piece, 1.0};
    if (!points_[place->piece + 1].usable) return PathPlace{place->piece, 0.0};
    return PathPlace{place->piece, place->share};
}

/// The handle that appears nearest to the pointer, within its reach.
std::optional<std::size_t> PathHand::handleAt(const QPointF& pointer) const {
    std::optional<std::size_t> nearest;
    double reach = pointerReach;
    for (std::size_t i = 0; i < handles_.size(); ++i) {
        const QPointF way = appearance_(handles_[i]) - pointer;
        if (const double far = std::hypot(way.x(), way.y()); far <= reach) {
            reach = far;
            nearest = i;
        }
    }
    return nearest;
}

bool PathHand::press(const ViewportEvent& event) {
    if (event.button == Qt::RightButton && doing_ == Doing::nothing && !height_) {
        pressedAt_ = event.position;
        menuAt_ = placeAt(event.position);
    }
    if (event.button != Qt::LeftButton) return false;
    pressedAt_ = event.position;
    pressedSight_ = sightOf(event);
    if (height_) {
        become(Doing::drawing);
        drawn_.clear();
        draw(event);
        return true;
    }
    handle_ = handleAt(event.position);
    place_ = placeAt(event.position);
    if (!handle_ && !place_) return false;
    by_ = glm::dvec3(0.0);
    become(Doing::pressed);
    return true;
}

/// The position at which the drag began, mm.
glm::dvec3 PathHand::draggedFrom() const {
    return handle_ ? handles_[*handle_] : pieceAt(place_->piece).at(place_->share);
}

bool PathHand::move(const ViewportEvent& event) {
    if (!event.buttons.testFlag(Qt::LeftButton)) giveUp(); // the release was sent to a dialog, or to another program
    if (doing_ == Doing::nothing) return false;
    if (doing_ == Doing::drawing) {
        draw(event);
        return true;
    }
    const QPointF way = event.position - pressedAt_;
    if (doing_ == Doing::pressed && std::hypot(way.x(), way.y()) < clickReach) return true;
    become(Doing::dragging);
    if (const auto by = dragged(draggedFrom(), pressedSight_, sightOf(event), along_)) by_ = *by;
    if (handle_)
        emit handleDragging(*handle_, place_, by_);
    else
        emit dragging(*place_, by_);
    return true;
}

bool PathHand::release(const ViewportEvent& event) {
    if (event.button == Qt::RightButton) {
        const QPointF way = event.position - pressedAt_;
        const std::optional<PathPlace> place = std::exchange(menuAt_, std::nullopt);
        if (place && std::hypot(way.x(), way.y()) < clickReach) emit menuRequested(*place, event.position);
        return false; // the camera follows the right button
    }
    if (event.button != Qt::LeftButton) return false;
    const Doing done = become(Doing::nothing);
    report(done, (event.modifiers & Qt::ShiftModifier) != 0);
    return done != Doing::nothing;
}

void PathHand::report(Doing done, bool extend) {
    if (done == Doing::pressed && place_)
        emit chosen(*place_, extend);
    else if (done == Doing::dragging && handle_)
        emit handleDropped(*handle_, by_);
    else if (done == Doing::dragging)
        emit dropped(*place_, by_);
    else if (done == Doing::drawing && drawn_.size() > 1)
        emit drawn(std::exchange(drawn_, {}));
    else if (done == Doing::drawing)
        emit givenUp();
}

void PathHand::draw(const ViewportEvent& event) {
    const auto place = onLevel(sightOf(event), *height_);
    if (!place || (!drawn_.empty() && glm::distance(drawn_.back(), *place) < drawnSpacing)) return;
    drawn_.push_back(*place);
    emit drawing(drawn_);
}

bool PathHand::key(int key, Qt::KeyboardModifiers) {
    if (key != Qt::Key_Escape) return false;
    if (doing_ != Doing::nothing)
        giveUp();
    else if (!escape_.isEmpty() && !height_)
        emit escaped();
    else if (height_ || chosen_)
        emit cleared();
    else
        return false;
    return true;
}

QString PathHand::escapeMeaning() {
    if (doing_ != Doing::nothing) return tr("Esc: cancel");
    if (height_) return tr("Esc: cancel drawing");
    if (!escape_.isEmpty()) return escape_;
    return chosen_ ? tr("Esc: clear the selection") : QString();
}

void PathHand::leave() {
    if (doing_ == Doing::pressed) become(Doing::nothing);
}

void PathHand::giveUp() {
    if (become(Doing::nothing) != Doing::nothing) emit givenUp();
}

} // namespace burin

// SPDX-FileCopyrightText: 2026 The Burin authors
// SPDX-License-Identifier: Apache-2.0
#include "ui/scene/camera_view.h"

#include "core/base/units.h"

#include <algorithm>
#include <cmath>

namespace burin {
namespace {

constexpr double smallestDistance = 0.05, largestDistance = 1.0e6; // mm
constexpr double fitMargin = 1.12;
constexpr double leastConvergence =
    0.002; // smaller values are indistinguishable from 0, and the eye would be too far away for the computation
constexpr double parallelReach = 1.0e5; // mm from the focus to the eye of a parallel view

const double halfHeight = std::tan(0.5 * cameraViewAngle); // of the picture, at distance 1

/// Position in units of half the height of the picture, y up.
glm::dvec2 fromPixels(const QSizeF& size, const QPointF& position) {
    const double half = 0.5 * std::max(1.0, size.height());
    return {(position.x() - 0.5 * size.width()) / half, (0.5 * size.height() - position.y()) / half};
}

/// From the focus to the eye, mm.
double reachOf(const CameraView& view) {
    return isParallel(view) ? parallelReach : view.distance / view.convergence;
}

/// The equivalent of the distance to a point in the projection: proportional to the height that the picture covers
/// there.
double widthAt(const CameraView& view, const glm::dvec3& back, const glm::dvec3& place) {
    return isParallel(view) ? view.distance : view.distance - view.convergence * glm::dot(place - view.focus, back);
}

double shortWay(double from, double to) {
    return std::remainder(to - from, 2.0 * pi);
}

} // namespace

CameraAxes axesOf(const CameraView& view) noexcept {
    const double ca = std::cos(view.azimuth), sa = std::sin(view.azimuth);
    const double ce = std::cos(view.elevation), se = std::sin(view.elevation);
    const glm::dvec3 back(ce * ca, ce * sa, se), right(-sa, ca, 0.0);
    return {view.focus + back * reachOf(view), right, glm::cross(back, right), back};
}

bool isParallel(const CameraView& view) noexcept {
    return view.convergence < leastConvergence;
}

double halfHeightOf(const CameraView& view) noexcept {
    return halfHeight * view.distance;
}

double angleOf(const CameraView& view) noexcept {
    return 2.0 * std::atan(halfHeight * view.convergence);
}

Sight sightThrough(const CameraView& view, const QSizeF& size, const QPointF& position) {
    const CameraAxes axes = axesOf(view);
    const glm::dvec2 at = fromPixels(size, position) * halfHeight;
    const glm::dvec3 aside = axes.right * at.x + axes.up * at.y;
    if (isParallel(view)) return {axes.eye + aside * view.distance, -axes.back, true};
    return {axes.eye, glm::normalize(aside * view.convergence - axes.back)};
}

QPointF appearanceOf(const CameraView& view, const QSizeF& size, const glm::dvec3& place) {
    const CameraAxes axes = axesOf(view);
    const glm::dvec3 from = place - view.focus;
    const double scale = 0.5 * size.height() / (halfHeight * widthAt(view, axes.back, place));
    return {0.5 * size.width() + glm::dot(from, axes.right) * scale,
            0.5 * size.height() - glm::dot(from, axes.up) * scale};
}

double pixelAt(const CameraView& view, const QSizeF& size, const glm::dvec3& place) {
    return 2.0 * halfHeight * widthAt(view, axesOf(view).back, place) / std::max(1.0, size.height());
}

CameraView orbited(const CameraView& view, double azimuth, double elevation, const glm::dvec3& pivot) {
    CameraView turned = view;
    turned.azimuth = std::remainder(view.azimuth + azimuth, 2.0 * pi);
    turned.elevation = std::clamp(view.elevation + elevation, -0.5 * pi, 0.5 * pi);
    const CameraAxes before = axesOf(view), after = axesOf(turned);
    const glm::dvec3 lever = view.focus - pivot;
    turned.focus = pivot + after.right * glm::dot(lever, before.right) + after.up * glm::dot(lever, before.up) +
                   after.back * glm::dot(lever, before.back);
    return turned;
}

CameraView panned(const CameraView& view, const QSizeF& size, const QPointF& pixels, const glm::dvec3& grip) {
    const CameraAxes axes = axesOf(view);
    const double scale = pixelAt(view, size, grip);
    CameraView moved = view;
    moved.focus += (axes.up * pixels.y() - axes.right * pixels.x()) * scale;
    return moved;
}

CameraView zoomed(const CameraView& view, double factor, const glm::dvec3& pivot) {
    const double distance = std::clamp(view.distance * factor, smallestDistance, largestDistance);
    CameraView nearer = view;
    nearer.distance = distance;
    nearer.focus = pivot + (view.focus - pivot) * (distance / view.distance);
    return nearer;
}

CameraView fitted(const CameraView& view, const QSizeF& size, const Box& box) {
    if (box.empty()) return view;
    CameraView fit = view;
    fit.focus = box.centre();
    const CameraAxes axes = axesOf(fit);
    const double tallest = halfHeight / fitMargin;
    const double widest = tallest * size.width() / std::max(1.0, size.height());
    double distance = smallestDistance;
    for (unsigned corner = 0; corner < 8; ++corner) {
        const glm::dvec3 from = box.corner(corner) - fit.focus;
        const double across =
            std::max(std::abs(glm::dot(from, axes.right)) / widest, std::abs(glm::dot(from, axes.up)) / tallest);
        distance = std::max(distance, across + fit.convergence * glm::dot(from, axes.back));
    }
    fit.distance = std::min(distance, largestDistance);
    return fit;
}

CameraView converged(const CameraView& view, double convergence, const glm::dvec3& pivot) {
    const glm::dvec3 back = axesOf(view).back;
    const double nearer = glm::dot(pivot - view.focus, back);
    CameraView other = view; // the same picture, expressed with a focus that is as far away as the pivot
    other.focus += back * nearer;
    other.distance = std::clamp(widthAt(view, back, pivot), smallestDistance, largestDistance);
    other.convergence = convergence;
    return other;
}

glm::dvec3 besideFocus(const CameraView& view, const Sight& sight) {
    const glm::dvec3 back = axesOf(view).back;
    return sight.origin +
           sight.direction * (glm::dot(view.focus - sight.origin, back) / glm::dot(sight.direction, back));
}

CameraView turnedTo(const CameraView& view, StandardView standard) {
    constexpr double degree = pi / 180.0;
    CameraView turned = view;
    const auto look = [&turned](double azimuth, double elevation) {
        turned.azimuth = azimuth * degree;
        turned.elevation = elevation * degree;
        return turned;
    };
    switch (standard) {
    case StandardView::top:
        return look(-90.0, 90.0);
    case StandardView::bottom:
        return look(-90.0, -90.0);
    case StandardView::front:
        return look(-90.0, 0.0);
    case StandardView::back:
        return look(90.0, 0.0);
    case StandardView::left:
        return look(180.0, 0.0);
    case StandardView::right:
        return look(0.0, 0.0);
    case StandardView::isometric:
        break;
    }
    return look(-45.0, 35.264389682754654); // the three axes have the same length
}

CameraView between(const CameraView& from, const CameraView& to, double share) {
    if (share >= 1.0) return to;
    CameraView view;
    view.focus = glm::mix(from.focus, to.focus, share);
    view.azimuth = from.azimuth + shortWay(from.azimuth, to.azimuth) * share;
    view.elevation = from.elevation + (to.elevation - from.elevation) * share;
    view.distance = from.distance * std::pow(to.distance / from.distance, share);
    view.convergence = from.convergence + (to.convergence - from.convergence) * share;
    return view;
}

} // namespace burin

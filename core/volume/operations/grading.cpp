// SPDX-FileCopyrightText: 2026 The Burin authors
// SPDX-License-Identifier: Apache-2.0
#include "core/volume/operations/grading.h"

#include "core/base/numbers.h"

#include <algorithm>
#include <cmath>
#include <utility>

namespace burin {

namespace {

bool isFinite(const glm::dvec3& place) {
    return std::isfinite(place.x) && std::isfinite(place.y) && std::isfinite(place.z);
}

Error invalid(std::string subject, double given, std::string rule) {
    return {ErrorCode::argumentInvalid, std::move(subject), formatShortest(given), std::move(rule)};
}

} // namespace

Result<Grading> Grading::fromPlane(const glm::dvec3& point, const glm::dvec3& normal, std::vector<Control> controls) {
    return byDistance(Shape::plane, point, normal, std::move(controls));
}
Result<Grading> Grading::fromPoint(const glm::dvec3& point, std::vector<Control> controls) {
    return byDistance(Shape::point, point, {0.0, 0.0, 1.0}, std::move(controls));
}
Result<Grading> Grading::fromAxis(const glm::dvec3& point, const glm::dvec3& direction, std::vector<Control> controls) {
    return byDistance(Shape::axis, point, direction, std::move(controls));
}

Result<Grading> Grading::byDistance(Shape shape, const glm::dvec3& point, const glm::dvec3& direction,
                                    std::vector<Control> controls) {
    const double length = glm::length(direction);
    if (!isFinite(point)) return invalid("point of a grading", point.x, "finite coordinates");
    if (!std::isfinite(length) || !(length > 0.0)) return invalid("direction of a grading", length, "a length above 0");
    if (controls.size() < 2)
        return invalid("controls of a grading", static_cast<double>(controls.size()), "two at least");
    Grading grading;
    grading.low_ = grading.high_ = controls.front().value;
    for (std::size_t i = 0; i < controls.size(); ++i) {
        const auto [distance, value] = controls[i];
        if (!std::isfinite(distance) || (i > 0 && distance <= controls[i - 1].distance))
            return invalid("distance of a grading", distance, "distances that rise");
        if (!std::isfinite(value)) return invalid("value of a grading", value, "a finite value");
        grading.low_ = std::min(grading.low_, value);
        grading.high_ = std::max(grading.high_, value);
    }
    if (!(grading.low_ < grading.high_)) return invalid("values of a grading", grading.low_, "values that differ");
    grading.shape_ = shape;
    grading.point_ = point;
    grading.direction_ = direction / length;
    grading.controls_ = std::move(controls);
    return grading;
}

Result<Grading> Grading::of(std::function<double(const glm::dvec3&)> function, double low, double high) {
    if (!function) return Error{ErrorCode::argumentInvalid, "function of a grading", {}, "a function"};
    if (!std::isfinite(low) || !std::isfinite(high) || !(low < high))
        return invalid("values of a grading", low, "a finite range, the lowest value first");
    Grading grading;
    grading.function_ = std::move(function);
    grading.low_ = low;
    grading.high_ = high;
    return grading;
}

std::optional<double> Grading::distance(const glm::dvec3& place) const {
    const glm::dvec3 way = place - point_;
    switch (shape_) {
    case Shape::plane:
        return glm::dot(way, direction_);
    case Shape::point:
        return glm::length(way);
    case Shape::axis:
        return glm::length(way - glm::dot(way, direction_) * direction_);
    case Shape::function:
        break;
    }
    return std::nullopt;
}

double Grading::value(const glm::dvec3& place) const {
    const std::optional<double> away = distance(place);
    if (!away) {
        const double value = function_(place);
        return std::isfinite(value) ? std::clamp(value, low_, high_) : low_;
    }
    const auto behind = std::ranges::upper_bound(controls_, *away, {}, &Control::distance);
    if (behind == controls_.begin()) return controls_.front().value;
    if (behind == controls_.end()) return controls_.back().value;
    const Control& before = *std::prev(behind);
    return before.value +
           (*away - before.distance) / (behind->distance - before.distance) * (behind->value - before.value);
}

std::optional<double> Grading::nearest(const glm::dvec3& place, int axis) const {
    if (shape_ == Shape::point) return point_[axis];
    if (shape_ != Shape::axis) return std::nullopt;
    glm::dvec3 along(0.0);
    along[axis] = 1.0;
    const glm::dvec3 across = along - direction_[axis] * direction_;
    const double square = glm::dot(across, across);
    if (!(square > 0.0)) return std::nullopt;
    return place[axis] - glm::dot(place - point_, across) / square;
}

} // namespace burin

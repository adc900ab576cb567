// SPDX-FileCopyrightText: 2026 The Burin authors
// SPDX-License-Identifier: Apache-2.0
#pragma once

#include "core/base/result.h"

#include <glm/glm.hpp>

#include <functional>
#include <optional>
#include <vector>

namespace burin {

/// A value of a material that varies in space (specific cutting energy of a casting's skin, density of a foam).
/// Positions in mm, setup frame.
class Grading {
public:
    /// The value at a distance, mm; linear between two controls, constant beyond the first and the last.
    struct Control {
        double distance = 0.0;
        double value = 0.0;
    };

    // By the distance from a plane (negative behind it), from a point or from an axis. Errors: argumentInvalid (fewer
    // than two controls, distances that do not rise, a single value, a direction without length, or numbers that are
    // not finite).
    static Result<Grading> fromPlane(const glm::dvec3& point, const glm::dvec3& normal, std::vector<Control> controls);
    static Result<Grading> fromPoint(const glm::dvec3& point, std::vector<Control> controls);
    static Result<Grading> fromAxis(const glm::dvec3& point, const glm::dvec3& direction,
                                    std::vector<Control> controls);

    /// Any function; called on several threads at once. Along a scanline it is evaluated at least once per voxel: a
    /// value that rises and falls back within one voxel may be missed. A value that is not finite counts as `low`.
    /// @param low, high  the values are clamped to these. Errors: argumentInvalid (low not below high, no function).
    static Result<Grading> of(std::function<double(const glm::dvec3&)> function, double low, double high);

    double value(const glm::dvec3& place) const;
    double low() const noexcept { return low_; }
    double high() const noexcept { return high_; }

    /// The distance that the controls refer to, mm; empty for a function.
    std::optional<double> distance(const glm::dvec3& place) const;
    const std::vector<Control>& controls() const noexcept { return controls_; } ///< empty for a function
    /// The point of least distance on the line through `place` along an axis (0, 1, 2 for x, y, z): its coordinate on
    /// that axis, mm. Empty if the distance rises or falls monotonically along the line, or is constant.
    std::optional<double> nearest(const glm::dvec3& place, int axis) const;

private:
    enum class Shape { plane, point, axis, function };

    static Result<Grading> byDistance(Shape shape, const glm::dvec3& point, const glm::dvec3& direction,
                                      std::vector<Control> controls);

    Shape shape_ = Shape::function;
    glm::dvec3 point_{0.0}, direction_{0.0};
    std::vector<Control> controls_;
    std::function<double(const glm::dvec3&)> function_;
    double low_ = 0.0, high_ = 0.0;
};

} // namespace burin

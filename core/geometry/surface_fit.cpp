// SPDX-FileCopyrightText: 2026 The Burin authors
// SPDX-License-Identifier: Apache-2.0
#include "core/geometry/surface_fit.h"

#include "core/geometry/frame_along.h"

#include <algorithm>
#include <array>
#include <cmath>
#include <cstddef>
#include <utility>

namespace burin {

namespace {

constexpr int mostSteps = 20;    ///< of Gauss and Newton
constexpr double flattest = 1e4; ///< a radius of more times the extent of the points counts as none
constexpr double singularBelow = 1e-12;

/// Normal equations of N unknowns.
template <std::size_t N>
class LeastSquares {
public:
    void add(const std::array<double, N>& row, double value) {
        for (std::size_t i = 0; i < N; ++i) {
            for (std::size_t j = 0; j < N; ++j) matrix_[i][j] += row[i] * row[j];
            right_[i] += row[i] * value;
        }
    }
    /// Elimination with the largest pivot; empty if the equations are singular.
    std::optional<std::array<double, N>> solution() const {
        auto matrix = matrix_;
        auto right = right_;
        double largest = 0.0;
        for (std::size_t i = 0; i < N; ++i) largest = std::max(largest, matrix[i][i]);
        for (std::size_t column = 0; column < N; ++column) {
            std::size_t pivot = column;
            for (std::size_t row = column + 1; row < N; ++row)
                if (std::abs(matrix[row][column]) > std::abs(matrix[pivot][column])) pivot = row;
            if (!(std::abs(matrix[pivot][column]) > singularBelow * largest)) return std::nullopt;
            std::swap(matrix[pivot], matrix[column]);
            std::swap(right[pivot], right[column]);
            for (std::size_t row = column + 1; row < N; ++row) {
                const double share = matrix[row][column] / matrix[column][column];
                for (std::size_t k = column; k < N; ++k) matrix[row][k] -= share * matrix[column][k];
                right[row] -= share * right[column];
            }
        }
        for (std::size_t row = N; row-- > 0;) {
            for (std::size_t k = row + 1; k < N; ++k) right[row] -= matrix[row][k] * right[k];
            right[row] /= matrix[row][row];
        }
        return right;
    }

private:
    std::array<std::array<double, N>, N> matrix_{};
    std::array<double, N> right_{};
};

/// The unit eigenvector of the smallest eigenvalue of a symmetric matrix, by Jacobi's rotations.
glm::dvec3 leastDirection(glm::dmat3 matrix) {
    glm::dmat3 vectors(1.0);
    for (int sweep = 0; sweep < 30; ++sweep)
        for (const auto& [p, q] : {std::pair{0, 1}, std::pair{0, 2}, std::pair{1, 2}}) {
            if (matrix[p][q] == 0.0) continue;
            const double angle = 0.5 * std::atan2(2.0 * matrix[p][q], matrix[q][q] - matrix[p][p]);
            const double c = std::cos(angle), s = std::sin(angle);
            glm::dmat3 rotation(1.0);
            rotation[p][p] = rotation[q][q] = c;
            rotation[q][p] = s;
            rotation[p][q] = -s;
            matrix = glm::transpose(rotation) * matrix * rotation;
            vectors = vectors * rotation;
        }
    int least = 0;
    for (int i = 1; i < 3; ++i)
        if (matrix[i][i] < matrix[least][least]) least = i;
    return glm::normalize(vectors[least]);
}

struct Extent {
    glm::dvec3 centroid{0.0}, normal{0.0};
    double size = 0.0; ///< mm, root mean square of the distances from the centroid
};

Extent extentOf(std::span<const SurfacePoint> points) {
    Extent extent;
    const double count = static_cast<double>(points.size());
    for (const SurfacePoint& point : points) {
        extent.centroid += point.place / count;
        extent.normal += point.normal / count;
    }
    for (const SurfacePoint& point : points) {
        const glm::dvec3 offset = point.place - extent.centroid;
        extent.size += glm::dot(offset, offset) / count;
    }
    extent.size = std::sqrt(extent.size);
    return extent;
}

glm::dmat3 spread(std::span<const SurfacePoint> points, glm::dvec3 SurfacePoint::*of, const glm::dvec3& from) {
    glm::dmat3 sum(0.0);
    for (const SurfacePoint& point : points) {
        const glm::dvec3 offset = point.*of - from;
        sum += glm::outerProduct(offset, offset);
    }
    return sum;
}

double sideOf(const FittedSurface& surface, std::span<const SurfacePoint> points) {
    FittedSurface outward = surface;
    outward.side = 1.0;
    double agreement = 0.0;
    for (const SurfacePoint& point : points) agreement += glm::dot(outward.normal(point.place), point.normal);
    return agreement < 0.0 ? -1.0 : 1.0;
}

bool isSharp(const FittedSurface& surface, const Extent& extent) {
    return std::isfinite(surface.radius) && surface.radius > 0.0 && surface.radius < flattest * extent.size;
}

std::optional<FittedSurface> fitPlane(std::span<const SurfacePoint> points) {
    const Extent extent = extentOf(points);
    FittedSurface plane;
    plane.place = extent.centroid;
    plane.axis = leastDirection(spread(points, &SurfacePoint::place, extent.centroid));
    if (glm::dot(plane.axis, extent.normal) < 0.0) plane.axis = -plane.axis;
    return plane;
}

/// The sphere with the least sum of the squares of |p - c|² - r².
std::optional<FittedSurface> algebraicSphere(std::span<const SurfacePoint> points, const Extent& extent) {
    LeastSquares<4> equations;
    for (const SurfacePoint& point : points) {
        const glm::dvec3 at = point.place - extent.centroid;
        equations.add({2.0 * at.x, 2.0 * at.y, 2.0 * at.z, 1.0}, glm::dot(at, at));
    }
    const auto found = equations.solution();
    if (!found) return std::nullopt;
    const glm::dvec3 centre((*found)[0], (*found)[1], (*found)[2]);
    FittedSurface sphere{FittedSurface::Kind::sphere, extent.centroid + centre};
    sphere.radius = std::sqrt((*found)[3] + glm::dot(centre, centre));
    return sphere;
}

std::optional<FittedSurface> fitSphere(std::span<const SurfacePoint> points) {
    const Extent extent = extentOf(points);
    std::optional<FittedSurface> sphere = algebraicSphere(points, extent);
    for (int step = 0; sphere && step < mostSteps; ++step) {
        LeastSquares<4> equations;
        for (const SurfacePoint& point : points) {
            const glm::dvec3 out = sphere->normal(point.place);
            equations.add({-out.x, -out.y, -out.z, -1.0}, -sphere->distance(point.place));
        }
        const auto change = equations.solution();
        if (!change) return std::nullopt;
        sphere->place += glm::dvec3((*change)[0], (*change)[1], (*change)[2]);
        sphere->radius += (*change)[3];
        if (!isSharp(*sphere, extent)) return std::nullopt;
        if (std::abs((*change)[3]) < 1e-9 * sphere->radius) break;
    }
    if (sphere) sphere->side = sideOf(*sphere, points);
    return sphere;
}

/// Two unit vectors perpendicular to an axis and to each other.
std::pair<glm::dvec3, glm::dvec3> across(const glm::dvec3& axis) {
    const glm::dvec3 u = anyAcross(axis);
    return {u, glm::cross(axis, u)};
}

std::optional<FittedSurface> algebraicCylinder(std::span<const SurfacePoint> points, const Extent& extent) {
    FittedSurface cylinder{FittedSurface::Kind::cylinder};
    cylinder.axis = leastDirection(spread(points, &SurfacePoint::normal, glm::dvec3(0.0)));
    const auto [u, v] = across(cylinder.axis);
    LeastSquares<3> equations;
    for (const SurfacePoint& point : points) {
        const double x = glm::dot(point.place - extent.centroid, u), y = glm::dot(point.place - extent.centroid, v);
        equations.add({2.0 * x, 2.0 * y, 1.0}, x * x + y * y);
    }
    const auto found = equations.solution();
    if (!found) return std::nullopt;
    cylinder.place = extent.centroid + (*found)[0] * u + (*found)[1] * v;
    cylinder.radius = std::sqrt((*found)[2] + (*found)[0] * (*found)[0] + (*found)[1] * (*found)[1]);
    return cylinder;
}

std::optional<FittedSurface> fitCylinder(std::span<const SurfacePoint> points) {
    const Extent extent = extentOf(points);
    std::optional<FittedSurface> cylinder = algebraicCylinder(points, extent);
    for (int step = 0; cylinder && step < mostSteps; ++step) {
        const auto [u, v] = across(cylinder->axis);
        LeastSquares<5> equations;
        for (const SurfacePoint& point : points) {
            const glm::dvec3 out = cylinder->normal(point.place);
            const double x = glm::dot(out, u), y = glm::dot(out, v);
            const double along = glm::dot(point.place - cylinder->place, cylinder->axis) / extent.size;
            equations.add({-x, -y, -along * x, -along * y, -1.0}, -cylinder->distance(point.place));
        }
        const auto change = equations.solution();
        if (!change) return std::nullopt;
        cylinder->place += (*change)[0] * u + (*change)[1] * v;
        cylinder->axis = glm::normalize(cylinder->axis + ((*change)[2] * u + (*change)[3] * v) / extent.size);
        cylinder->radius += (*change)[4];
        cylinder->place += glm::dot(extent.centroid - cylinder->place, cylinder->axis) * cylinder->axis;
        if (!isSharp(*cylinder, extent)) return std::nullopt;
        if (std::abs((*change)[4]) < 1e-9 * cylinder->radius) break;
    }
    if (cylinder) cylinder->side = sideOf(*cylinder, points);
    return cylinder;
}

} // namespace

double FittedSurface::distance(const glm::dvec3& point) const noexcept {
    const glm::dvec3 offset = point - place;
    const double along = glm::dot(offset, axis);
    if (kind == Kind::plane) return along;
    return side * (glm::length(offset - along * axis) - radius);
}

glm::dvec3 FittedSurface::normal(const glm::dvec3& point) const noexcept {
    if (kind == Kind::plane) return axis;
    const glm::dvec3 offset = point - place, out = offset - glm::dot(offset, axis) * axis;
    const double length = glm::length(out);
    return length > 0.0 ? side / length * out : glm::dvec3(0.0);
}

std::optional<FittedSurface> fitSurface(FittedSurface::Kind kind, std::span<const SurfacePoint> points) {
    constexpr std::size_t fewest = 6;
    if (points.size() < fewest) return std::nullopt;
    switch (kind) {
    case FittedSurface::Kind::plane:
        return fitPlane(points);
    case FittedSurface::Kind::cylinder:
        return fitCylinder(points);
    case FittedSurface::Kind::sphere:
        break;
    }
    return fitSphere(points);
}

} // namespace burin

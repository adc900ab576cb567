// SPDX-FileCopyrightText: 2026 The Burin authors
// SPDX-License-Identifier: Apache-2.0
#pragma once

#include "core/base/units.h"

#include <glm/glm.hpp>

#include <algorithm>
#include <cmath>
#include <random>
#include <vector>

namespace burin::oracles {

/// Root mean square error, mm³, of a body's volume that is summed from the exact lengths of the body on a square
/// lattice of lines, over all positions and orientations of the body.
///
/// Poisson's sum gives the error as the sum of the Fourier transform of the body's indicator function, F(n / edge),
/// over all lattice points n except the origin, with phases that depend on the body's position, so that squares add up.
/// Over all orientations the mean of |F(k)|² is surface / (8 pi³ k⁴): for a sphere, F(k) is radius / (pi k²) times a
/// cosine, and for any other surface the contributions of its parts add up, each in the direction that it faces. So
/// error² = surface · edge⁴ / (8 pi³) · sum of n^-4:
/// second order in the edge for every body, sharp or smooth, and of known magnitude. Bodies with flat faces or straight
/// edges have a much smaller error at most orientations and a far larger one at a few.
inline double lineSamplingError(double surface, double edge) {
    constexpr double latticeSum = 6.0268; // 4 zeta(2) beta(2)
    return edge * edge * std::sqrt(latticeSum * surface / (8.0 * pi * pi * pi));
}

/// Errors divided by their expected values.
class Scatter {
public:
    void add(double error, double expected) { parts_.push_back(error / expected); }
    double mean() const {
        return sumOf([](double part) { return part; }) / count();
    }
    double deviation() const {
        return std::sqrt(sumOf([](double part) { return part * part; }) / count() - mean() * mean());
    }
    /// Median of the magnitudes: the typical error, not affected by the few largest.
    double median() const {
        std::vector<double> magnitudes(parts_.size());
        std::ranges::transform(parts_, magnitudes.begin(), [](double part) { return std::abs(part); });
        const auto middle = magnitudes.begin() + static_cast<std::ptrdiff_t>(magnitudes.size() / 2);
        std::ranges::nth_element(magnitudes, middle);
        return *middle;
    }
    /// Of the mean.
    double standardError() const { return 1.0 / std::sqrt(count()); }

private:
    template <class Value>
    double sumOf(Value&& value) const {
        double sum = 0.0;
        for (const double part : parts_) sum += value(part);
        return sum;
    }
    double count() const { return static_cast<double>(parts_.size()); }

    std::vector<double> parts_;
};

/// Order of convergence from errors relative to what `lineSamplingError` expects, between an edge and a quarter of it.
inline double orderOf(double coarse, double fine) {
    return 2.0 + 0.5 * std::log2(coarse / fine);
}

/// A random rotation, uniformly distributed.
inline glm::dmat3 anyTurn(std::mt19937& random) {
    std::normal_distribution<double> any;
    const auto vector = [&] {
        const double x = any(random), y = any(random), z = any(random);
        return glm::dvec3(x, y, z);
    };
    const glm::dvec3 x = glm::normalize(vector()), z = glm::normalize(glm::cross(x, vector()));
    return {x, glm::cross(z, x), z};
}

/// A random point in a cube of the given edge about the origin.
inline glm::dvec3 anyPlace(std::mt19937& random, double edge) {
    std::uniform_real_distribution<double> any(-0.5 * edge, 0.5 * edge);
    const double x = any(random), y = any(random), z = any(random);
    return {x, y, z};
}

} // namespace burin::oracles

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

/// Root of the mean square error, mm³, that the volume of a body has which is summed up from its exact lengths on a
/// square lattice of lines, over all places and turns of the body.
///
/// Poisson's sum gives the error as the sum of the Fourier transform of the body's indicator, F(n / edge), over the
/// lattice's places n but the origin, with phases that go with the body's place, so that squares add up. Over all turns
/// the mean of |F(k)|² is surface / (8 pi³ k⁴): of a sphere, F(k) is radius / (pi k²) times a cosine, and any other
/// surface adds up from what its parts say in the directions that they face. So
///     error² = surface · edge⁴ / (8 pi³) · sum of n^-4:
/// second order in the edge for every body, sharp or smooth, and of a known size. Bodies with flat faces or straight
/// edges err much less at most turns and far more at a few.
inline double lineSamplingError(double surface, double edge) {
    constexpr double latticeSum = 6.0268; // 4 zeta(2) beta(2)
    return edge * edge * std::sqrt(latticeSum * surface / (8.0 * pi * pi * pi));
}

/// Errors over what is expected of them.
class Scatter {
public:
    void add(double error, double expected) { parts_.push_back(error / expected); }
    double mean() const {
        return sumOf([](double part) { return part; }) / count();
    }
    double deviation() const {
        return std::sqrt(sumOf([](double part) { return part * part; }) / count() - mean() * mean());
    }
    /// Of the magnitudes: what most are like, whatever the few largest.
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

/// Order of convergence of errors over what `lineSamplingError` expects, from an edge to a quarter of it.
inline double orderOf(double coarse, double fine) {
    return 2.0 + 0.5 * std::log2(coarse / fine);
}

/// Any turn of space, all alike.
inline glm::dmat3 anyTurn(std::mt19937& random) {
    std::normal_distribution<double> any;
    const auto vector = [&] {
        const double x = any(random), y = any(random), z = any(random);
        return glm::dvec3(x, y, z);
    };
    const glm::dvec3 x = glm::normalize(vector()), z = glm::normalize(glm::cross(x, vector()));
    return {x, glm::cross(z, x), z};
}

/// Any place in a cube of such an edge about the origin.
inline glm::dvec3 anyPlace(std::mt19937& random, double edge) {
    std::uniform_real_distribution<double> any(-0.5 * edge, 0.5 * edge);
    const double x = any(random), y = any(random), z = any(random);
    return {x, y, z};
}

} // namespace burin::oracles

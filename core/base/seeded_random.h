// SPDX-FileCopyrightText: 2026 The Burin authors
// SPDX-License-Identifier: Apache-2.0
#pragma once

#include <glm/glm.hpp>

#include <cstdint>
#include <random>

namespace burin {

/// Random numbers that are the same on every platform: the distributions of the standard library may differ between
/// implementations; its generator may not.
class SeededRandom {
public:
    explicit SeededRandom(std::uint64_t seed) : generator_(seed) {}
    /// 0 … 1, the upper end excluded.
    double share() noexcept { return static_cast<double>(generator_() >> 11) * 0x1.0p-53; }
    double between(double low, double high) noexcept { return low + (high - low) * share(); }
    /// 0 … count - 1. @param count > 0
    std::uint64_t below(std::uint64_t count) noexcept { return generator_() % count; }
    /// Each coordinate between those of two corners.
    glm::dvec3 within(const glm::dvec3& low, const glm::dvec3& high) noexcept {
        const double x = between(low.x, high.x), y = between(low.y, high.y);
        return {x, y, between(low.z, high.z)};
    }
    glm::dvec3 direction() noexcept {
        for (;;) {
            const glm::dvec3 way = within(glm::dvec3(-1.0), glm::dvec3(1.0));
            const double square = glm::dot(way, way);
            if (square > 1e-4 && square <= 1.0) return way / glm::length(way);
        }
    }

private:
    std::mt19937_64 generator_;
};

} // namespace burin

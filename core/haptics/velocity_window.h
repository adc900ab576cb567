// SPDX-FileCopyrightText: 2026 The Burin authors
// SPDX-License-Identifier: Apache-2.0
#pragma once

#include <glm/glm.hpp>

#include <array>
#include <cstddef>

namespace burin {

/// Velocity as the mean over a short window: differences of single ticks are mostly encoder steps.
class VelocityWindow {
public:
    static constexpr double length = 0.015; ///< s

    /// @param position mm. @param period s since the position before.
    void add(const glm::dvec3& position, double period) noexcept;
    void reset() noexcept { count_ = 0; }
    /// mm/s; zero until two positions are known.
    glm::dvec3 velocity() const noexcept { return velocity_; }

private:
    static constexpr std::size_t capacity = 256; ///< ticks of 60 µs fill the window
    struct Entry {
        glm::dvec3 position{0.0};
        double time = 0.0;
    };
    std::array<Entry, capacity> entries_{};
    std::size_t oldest_ = 0, count_ = 0;
    double time_ = 0.0;
    glm::dvec3 velocity_{0.0};
};

} // namespace burin

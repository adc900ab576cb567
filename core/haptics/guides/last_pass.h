// SPDX-FileCopyrightText: 2026 The Burin authors
// SPDX-License-Identifier: Apache-2.0
#pragma once

#include <glm/glm.hpp>

#include <array>
#include <cstdint>
#include <span>
#include <vector>

namespace burin {

/// Remembers where the tool went in a pass, so that the next one can keep a constant distance from it: a polyline of
/// fixed capacity, simplified as it is made (opening-window, Imai & Iri 1988 greedily). Every tip of the pass lies
/// within `errorBound` of it. A pass that fills it is thinned to every second point and gets a rougher bound. Tick
/// code, but for making the object, which allocates.
class LastPass {
public:
    static constexpr std::size_t capacity = 4096;
    static constexpr double tolerance = 0.005;  ///< mm
    static constexpr double shortestPass = 1.0; ///< mm; a shorter one is none

    LastPass() = default;

    /// The tool, in a pass that is under way or begins. @param tip mm
    void add(const glm::dvec3& tip) noexcept;
    /// The pass that was under way is over, and the last one from now on.
    void finish() noexcept;
    /// Neither a last pass nor one under way.
    void forget() noexcept;

    /// Of the last pass; empty: there is none.
    std::span<const glm::dvec3> points() const noexcept { return {passes_[last_].points.data(), passes_[last_].count}; }
    double errorBound() const noexcept { return passes_[last_].errorBound; } ///< mm, of the last pass
    /// Counts the passes that became the last one.
    std::uint32_t number() const noexcept { return number_; }

private:
    struct Pass {
        std::vector<glm::dvec3> points = std::vector<glm::dvec3>(capacity);
        std::size_t count = 0;
        double errorBound = 0.0;
    };
    Pass& underWay() noexcept { return passes_[1 - last_]; }
    bool straightTo(const glm::dvec3& tip) const noexcept;
    void keep(const glm::dvec3& tip) noexcept;
    static void thin(Pass& pass) noexcept;

    static constexpr std::size_t windowCapacity = 64;
    static constexpr double smallestMove = 0.1 * tolerance; ///< mm

    std::array<Pass, 2> passes_;
    std::size_t last_ = 0; ///< the other one is under way
    std::uint32_t number_ = 0;
    std::array<glm::dvec3, windowCapacity> window_{}; ///< tips since the point kept last
    std::size_t waiting_ = 0;                         ///< of them
};

} // namespace burin

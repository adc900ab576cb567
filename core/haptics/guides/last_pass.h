// SPDX-FileCopyrightText: 2026 The Burin authors
// SPDX-License-Identifier: Apache-2.0
#pragma once

#include <glm/glm.hpp>

#include <array>
#include <cstdint>
#include <span>
#include <vector>

namespace burin {

/// Records the tool's motion in a pass, so that the next pass can keep a constant distance from it: a polyline of fixed
/// capacity, simplified while it is recorded (opening window, a greedy form of Imai & Iri 1988). Every tip of the pass
/// lies within `errorBound` of it. A pass that fills it is thinned to every second point and gets a larger bound.
/// Called in the haptic tick, except for the constructor, which allocates.
class LastPass {
public:
    static constexpr std::size_t capacity = 4096;
    static constexpr double tolerance = 0.005;  ///< mm
    static constexpr double shortestPass = 1.0; ///< mm; shorter motions do not count as a pass

    LastPass() = default;

    /// Adds a position of the tool in a pass that is in progress or begins. @param tip mm
    void add(const glm::dvec3& tip) noexcept;
    /// Ends the pass in progress; it becomes the last pass.
    void finish() noexcept;
    /// Discards the last pass and the one in progress.
    void forget() noexcept;

    /// Points of the last pass; empty if there is none.
    std::span<const glm::dvec3> points() const noexcept { return {passes_[last_].points.data(), passes_[last_].count}; }
    double errorBound() const noexcept { return passes_[last_].errorBound; } ///< mm, of the last pass
    /// Number of passes that have become the last one so far.
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
    std::size_t last_ = 0; ///< index of the last pass; the other one is in progress
    std::uint32_t number_ = 0;
    std::array<glm::dvec3, windowCapacity> window_{}; ///< tips since the last point that was kept
    std::size_t waiting_ = 0;                         ///< number of tips in the window
};

} // namespace burin

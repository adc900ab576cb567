// SPDX-FileCopyrightText: 2026 The Burin authors
// SPDX-License-Identifier: Apache-2.0
#pragma once

#include <glm/glm.hpp>

#include <cstdint>
#include <span>

namespace burin {

/// How a polyline continues after its last point.
enum class PolylineEnds : std::uint8_t {
    stop,
    goOn, ///< straight on
    join, ///< to the first point: the polyline is closed
};

struct Polyline {
    std::span<const glm::dvec3> points; ///< mm, two or more; a closed polyline repeats its first point at the end
    PolylineEnds ends = PolylineEnds::stop;

    std::size_t segments() const noexcept { return points.size() - 1; }
};

/// The nearest point of a polyline, or the nearest one along the branch on which tracking began.
struct PolylineFoot {
    std::size_t segment = 0;
    double share = 0.0; ///< 0 … 1 within the segment; outside of that where the polyline continues straight on
    glm::dvec3 point{0.0};
    double distance = 0.0; ///< mm, to the query point
};

/// Finds the nearest point of a polyline from tick to tick, at a bounded cost. Called in the haptic tick.
class PolylineTracker {
public:
    static constexpr std::size_t searchedSegments = 64; ///< per call
    static constexpr std::size_t walkedSegments = 64;   ///< per call

    void reset() noexcept { known_ = false; }
    /// Searches for the globally nearest point: along the polyline from the last result, and in turn at some segments
    /// elsewhere. Certain after segments / searchedSegments calls at one query point.
    const PolylineFoot& search(const Polyline& line, const glm::dvec3& place) noexcept;
    /// The nearest point along the polyline from the last result, no farther along it than `travel` mm: it never jumps
    /// to another branch that comes near.
    const PolylineFoot& follow(const Polyline& line, const glm::dvec3& place, double travel) noexcept;
    const PolylineFoot& foot() const noexcept { return foot_; }

private:
    PolylineFoot foot_;
    std::size_t next_ = 0; ///< segment to be searched next
    bool known_ = false;
};

} // namespace burin

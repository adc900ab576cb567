// SPDX-FileCopyrightText: 2026 The Burin authors
// SPDX-License-Identifier: Apache-2.0
#pragma once

#include <glm/glm.hpp>

#include <cstdint>
#include <span>

namespace burin {

/// What follows the last point of a polyline.
enum class PolylineEnds : std::uint8_t {
    stop,
    goOn, ///< straight on
    join, ///< the first point again: it closes
};

struct Polyline {
    std::span<const glm::dvec3> points; ///< mm, two or more; a closed one repeats its first at the end
    PolylineEnds ends = PolylineEnds::stop;

    std::size_t segments() const noexcept { return points.size() - 1; }
};

/// The point of a polyline that is nearest, or was when tracking began.
struct PolylineFoot {
    std::size_t segment = 0;
    double share = 0.0; ///< 0 … 1 of the segment; outside where the polyline goes straight on
    glm::dvec3 point{0.0};
    double distance = 0.0; ///< mm, to the place asked for
};

/// Finds the nearest point of a polyline from tick to tick, at a bounded cost. Tick code.
class PolylineTracker {
public:
    static constexpr std::size_t searchedSegments = 64; ///< a call
    static constexpr std::size_t walkedSegments = 64;   ///< a call

    void reset() noexcept { known_ = false; }
    /// Towards the nearest point of all: looks along the polyline from the last one, and at some segments elsewhere in
    /// turn. Sure after segments / searchedSegments calls at one place.
    const PolylineFoot& search(const Polyline& line, const glm::dvec3& place) noexcept;
    /// The nearest point along the polyline from the last one, no farther along it than `travel` mm: it never jumps
    /// to another branch that comes near.
    const PolylineFoot& follow(const Polyline& line, const glm::dvec3& place, double travel) noexcept;
    const PolylineFoot& foot() const noexcept { return foot_; }

private:
    PolylineFoot foot_;
    std::size_t next_ = 0; ///< to be searched
    bool known_ = false;
};

} // namespace burin

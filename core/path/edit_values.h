// SPDX-FileCopyrightText: 2026 The Burin authors
// SPDX-License-Identifier: Apache-2.0
#pragma once

#include <glm/glm.hpp>

#include <cstdint>
#include <limits>
#include <vector>

namespace burin {

/// A moment of the hand, or of a planner's moves. Edits name places of a path by it, as an index would mean something
/// else as soon as an edit before them changed. Copies that an edit made keep the moments of what they were copied
/// from, and are meant as well.
struct Moment {
    std::int64_t source = 0; ///< PathSource::id; 0: none
    std::int64_t tick = 0;   ///< within the take; of generated moves GeneratedPoint::moment

    friend bool operator==(const Moment&, const Moment&) = default;
};

/// What the hand, or a planner, did from one moment of a source to another, both included.
struct SourceStretch {
    std::int64_t source = 0;                                                 ///< PathSource::id; 0: everything
    std::int64_t first = 0, last = std::numeric_limits<std::int64_t>::max(); ///< ticks

    bool contains(const Moment& moment) const noexcept {
        return source == 0 || (source == moment.source && moment.tick >= first && moment.tick <= last);
    }
    friend bool operator==(const SourceStretch&, const SourceStretch&) = default;
};

/// A region: a polygon in plan, between two heights.
struct Area {
    std::vector<glm::dvec3> outline; ///< mm, setup frame, closed by itself; heights have no meaning. Fewer than three
                                     ///< corners: nowhere
    double low = -1e4, high = 1e4;   ///< mm, setup frame

    friend bool operator==(const Area&, const Area&) = default;
};

} // namespace burin

// SPDX-FileCopyrightText: 2026 The Burin authors
// SPDX-License-Identifier: Apache-2.0
#pragma once

#include "core/base/result.h"

#include <glm/glm.hpp>

#include <cstdint>
#include <limits>
#include <variant>
#include <vector>

namespace burin {

/// A moment of the recording, or of a planner's moves. Edits identify points of a path by moments, as an index would
/// refer to another point as soon as an edit before them changed. Copies made by an edit keep the moments of their
/// originals, and are included.
struct Moment {
    std::int64_t source = 0; ///< PathSource::id; 0: none
    std::int64_t tick = 0;   ///< within the take; for generated moves, GeneratedPoint::moment

    friend bool operator==(const Moment&, const Moment&) = default;
};

/// The interval of a source, a hand's or a planner's, from one moment to another, both included.
struct SourceInterval {
    std::int64_t source = 0;                                                 ///< PathSource::id; 0: everything
    std::int64_t first = 0, last = std::numeric_limits<std::int64_t>::max(); ///< ticks

    bool contains(const Moment& moment) const noexcept {
        return source == 0 || (source == moment.source && moment.tick >= first && moment.tick <= last);
    }
    friend bool operator==(const SourceInterval&, const SourceInterval&) = default;
};

/// A region: a polygon in plan, between two heights.
struct Area {
    std::vector<glm::dvec3> outline; ///< mm, setup frame, implicitly closed; heights are ignored. Fewer than three
                                     ///< corners: an empty area
    double low = -1e4, high = 1e4;   ///< mm, setup frame

    friend bool operator==(const Area&, const Area&) = default;
};

class Progress;
struct Deviation;
struct PathContext;
struct PathUnderEdit;

/// Result of `apply`: how far the edit moved the path. Each kind has such a function, in the file of its name. It
/// changes the path's state in place. Strokes stay in their order; each edit treats a stroke by itself, so strokes are
/// processed in parallel with the same result for any number of threads. Errors: argumentInvalid, cancelled, and those
/// stated for each function.
using EditResult = Result<Deviation>;

/// A group of kinds of edits.
template <class... Kinds>
struct EditKinds {};

/// Type: a std::variant of the kinds of all groups, in their order.
template <class... Groups>
struct VariantOf;
template <class... Kinds>
struct VariantOf<EditKinds<Kinds...>> {
    using Type = std::variant<Kinds...>;
};
template <class... Kinds, class... Others, class... Groups>
struct VariantOf<EditKinds<Kinds...>, EditKinds<Others...>, Groups...>
    : VariantOf<EditKinds<Kinds..., Others...>, Groups...> {};

} // namespace burin

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

class Progress;
struct Deviation;
struct PathContext;
struct PathUnderEdit;

/// What `apply` says of an edit: how far the path went from what it was. Each kind has such a function, in the file of
/// its name. It changes the path's state in place. Strokes stay in their order; each edit treats a stroke by itself, so
/// they run in parallel and give the same result with any number of threads. Errors: argumentInvalid, cancelled, and
/// what each one states.
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

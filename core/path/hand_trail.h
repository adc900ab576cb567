// SPDX-FileCopyrightText: 2026 The Burin authors
// SPDX-License-Identifier: Apache-2.0
#pragma once

#include <glm/glm.hpp>

#include <cstddef>
#include <cstdint>
#include <map>
#include <span>
#include <vector>

namespace burin {

struct SourceStrokes;

/// A position that the hand passed.
struct HandMark {
    std::int64_t tick = 0;
    glm::dvec3 tip{0.0}; ///< mm, setup frame
};

/// The motion of the hand in each take, and of a planner's moves, unaffected by edits: a reference that edits can use
/// long after the strokes were changed. Between two marks the motion was never farther than `spacing` from the first of
/// them; an hour of milling takes some tens of MB.
class HandTrail {
public:
    static constexpr double spacing = 0.05; ///< mm

    explicit HandTrail(std::span<const SourceStrokes> sources);

    /// Marks of a source, ordered by tick; empty if there are none.
    std::span<const HandMark> of(std::int64_t source) const;
    std::size_t bytes() const noexcept; ///< of memory

private:
    std::map<std::int64_t, std::vector<HandMark>> marks_;
};

} // namespace burin

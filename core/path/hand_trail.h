// SPDX-FileCopyrightText: 2026 The Burin authors
// SPDX-License-Identifier: Apache-2.0
#pragma once

#include <glm/glm.hpp>

#include <cstdint>
#include <map>
#include <span>
#include <vector>

namespace burin {

struct SourceStrokes;

/// A place that the hand came by.
struct HandMark {
    std::int64_t tick = 0;
    glm::dvec3 tip{0.0}; ///< mm, setup frame
};

/// Where the hand went in each take, and a planner in its moves, which no edit changes: what an edit may go by long
/// after the strokes were changed. Between two marks it never was farther than `spacing` from the first of them; an
/// hour of milling takes some tens of MB.
class HandTrail {
public:
    static constexpr double spacing = 0.05; ///< mm

    explicit HandTrail(std::span<const SourceStrokes> sources);

    /// Marks of a source by their ticks; empty where there is none.
    std::span<const HandMark> of(std::int64_t source) const;

private:
    std::map<std::int64_t, std::vector<HandMark>> marks_;
};

} // namespace burin

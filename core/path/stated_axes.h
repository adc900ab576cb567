// SPDX-FileCopyrightText: 2026 The Burin authors
// SPDX-License-Identifier: Apache-2.0
#pragma once

#include "core/base/result.h"
#include "core/path/edit_values.h"
#include "core/tool/tool.h"

#include <cstddef>
#include <cstdint>
#include <map>
#include <memory>
#include <span>
#include <vector>

namespace burin {

struct SourceStrokes;

/// The axes of the tool that programs among a path's sources state, independent of edits.
class StatedAxes {
public:
    bool empty() const noexcept { return stated_.empty(); }
    std::size_t bytes() const noexcept; ///< of memory
    /// Whether a source states an axis for its moments; the others are upright.
    bool holds(std::int64_t source) const { return stated_.contains(source); }
    /// The axis at a moment; that of the last moment stated before it if it is not stated itself.
    glm::dvec3 at(const Moment& moment) const;
    /// The moments that a source states between two, without these, in the order from the first to the second.
    std::vector<std::int64_t> between(std::int64_t source, std::int64_t from, std::int64_t to) const;

    /// Takes the axes of a source and sets its tool upright: a ball about its centre, so that it touches the part as
    /// before. Errors: notSupported (a tilted tool of another shape).
    Result<void> take(SourceStrokes& source, const Tool& tool);

private:
    std::map<std::int64_t, std::map<std::int64_t, glm::dvec3>> stated_; ///< by source and tick
};

} // namespace burin

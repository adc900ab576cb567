// SPDX-FileCopyrightText: 2026 The Burin authors
// SPDX-License-Identifier: Apache-2.0
#pragma once

#include "core/base/json_object.h"
#include "core/tool/tool.h"
#include "core/tool/tool_ranges.h"

namespace burin {

/// Adds the segments of a list in a tool's or a holder's file; an error makes `from` fail.
inline void readSegments(JsonObject& from, std::string_view key, std::vector<HolderSegment>& segments) {
    using tool_range::length;
    from.objects(key, [&](JsonObject& segment) {
        segments.push_back({segment.number("lower_diameter_mm", length), segment.number("upper_diameter_mm", length),
                            segment.number("length_mm", length)});
    });
}

} // namespace burin

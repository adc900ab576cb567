// SPDX-FileCopyrightText: 2026 The Burin authors
// SPDX-License-Identifier: Apache-2.0
#include "core/path/hand_trail.h"

#include "core/path/stroke.h"

namespace burin {

namespace {

/// Both ends, and each point that is far enough from the mark before it.
void addMarks(std::vector<HandMark>& marks, const PathStroke& stroke) {
    for (std::size_t i = 0; i < stroke.points.size(); ++i) {
        const StrokePoint& point = stroke.points[i];
        const bool isEnd = i == 0 || i + 1 == stroke.points.size();
        if (isEnd || glm::distance(point.tip, marks.back().tip) >= HandTrail::spacing)
            marks.push_back({point.sample, point.tip});
    }
}

} // namespace

HandTrail::HandTrail(std::span<const RecordedStrokes> recorded) {
    for (const RecordedStrokes& take : recorded) {
        std::vector<HandMark>& marks = marks_[take.take.id];
        if (!marks.empty()) continue; // a take that the path has twice
        for (const PathStroke& stroke : take.strokes) addMarks(marks, stroke);
        marks.shrink_to_fit();
    }
}

std::span<const HandMark> HandTrail::of(std::int64_t take) const {
    const auto found = marks_.find(take);
    if (found == marks_.end()) return {};
    return found->second;
}

} // namespace burin

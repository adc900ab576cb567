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
        if (isEnd || glm::distance(point.pose.tip, marks.back().tip) >= HandTrail::spacing)
            marks.push_back({point.sample, point.pose.tip});
    }
}

} // namespace

HandTrail::HandTrail(std::span<const SourceStrokes> sources) {
    for (const SourceStrokes& each : sources) {
        std::vector<HandMark>& marks = marks_[each.info.source.id];
        if (!marks.empty()) continue; // the path contains this source twice
        for (const PathStroke& stroke : each.strokes) addMarks(marks, stroke);
        marks.shrink_to_fit();
    }
}

std::span<const HandMark> HandTrail::of(std::int64_t source) const {
    const auto found = marks_.find(source);
    if (found == marks_.end()) return {};
    return found->second;
}

std::size_t HandTrail::bytes() const noexcept {
    std::size_t bytes = sizeof(HandTrail);
    for (const auto& [source, marks] : marks_) bytes += sizeof(marks) + marks.capacity() * sizeof(HandMark);
    return bytes;
}

} // namespace burin

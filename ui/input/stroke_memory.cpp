// SPDX-FileCopyrightText: 2026 The Burin authors
// SPDX-License-Identifier: Apache-2.0
#include "ui/input/stroke_memory.h"

#include <algorithm>
#include <utility>

namespace burin {
namespace {

constexpr std::size_t mostRemembered = 64; // strokes; more than anyone takes back to draw on from there

} // namespace

void StrokeMemory::begin() {
    undone_.clear();
    if (strokes_.size() == mostRemembered) strokes_.erase(strokes_.begin());
    strokes_.emplace_back();
}

void StrokeMemory::add(const glm::dvec3& place, double grain) {
    if (strokes_.empty()) begin();
    DrawnStroke& stroke = strokes_.back();
    stroke.grain = std::max(stroke.grain, grain);
    if (stroke.places.empty() || stroke.places.back() != place) stroke.places.push_back(place);
}

void StrokeMemory::takeBack(bool undo) {
    std::vector<DrawnStroke>&from = undo ? strokes_ : undone_, &to = undo ? undone_ : strokes_;
    if (from.empty()) return;
    to.push_back(std::move(from.back()));
    from.pop_back();
}

const DrawnStroke& StrokeMemory::last() const noexcept {
    static const DrawnStroke none;
    return strokes_.empty() ? none : strokes_.back();
}

} // namespace burin

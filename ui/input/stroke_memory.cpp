// SPDX-FileCopyrightText: 2026 The Burin authors
// SPDX-License-Identifier: Apache-2.0
#include "ui/input/stroke_memory.h"

#include <algorithm>
#include <iterator>
#include <utility>

namespace burin {
namespace {

constexpr std::size_t mostRemembered = 64; // strokes; more than anyone undoes in order to continue from there

} // namespace

void StrokeMemory::begin(std::uint64_t begun) {
    recall(begun);
    givenUp_.clear();
    ++drawn_;
    if (!undone_.empty()) {
        undoneBefore_ = std::exchange(undone_, {});
        replacedBy_ = drawn_;
    }
    if (strokes_.size() == mostRemembered) strokes_.erase(strokes_.begin());
    strokes_.push_back({{}, drawn_});
}

void StrokeMemory::add(const glm::dvec3& place, double grain, const glm::dvec3& axis) {
    if (strokes_.empty()) return; // it was undone while it was drawn
    DrawnStroke& stroke = strokes_.back().stroke;
    stroke.grain = std::max(stroke.grain, grain);
    if (!stroke.places.empty() && stroke.places.back() == place) {
        stroke.axes.back() = axis;
        return;
    }
    stroke.places.push_back(place);
    stroke.axes.push_back(axis);
}

void StrokeMemory::giveUp(std::uint64_t begun) {
    recall(begun);
    const auto first = std::ranges::find_if(strokes_, [&](const Numbered& each) { return each.number > begun; });
    if (first == strokes_.end()) return;
    givenUp_.assign(std::make_move_iterator(first), std::make_move_iterator(strokes_.end()));
    strokes_.erase(first, strokes_.end());
    drawn_ = givenUp_.front().number - 1;
    if (replacedBy_ > drawn_) undone_ = std::exchange(undoneBefore_, {});
}

/// A stroke that was cancelled at the moment when it turned on the spindle still counts.
void StrokeMemory::recall(std::uint64_t begun) {
    if (givenUp_.empty() || givenUp_.front().number > begun) return;
    drawn_ = givenUp_.front().number;
    strokes_.push_back(std::move(givenUp_.front()));
    givenUp_.clear();
    undone_.clear();
}

void StrokeMemory::takeBack(bool undo, std::uint64_t begun) {
    recall(begun);
    // A stroke that has not turned on the spindle yet stays behind all that have.
    const auto next = std::ranges::find_if(strokes_, [&](const Numbered& each) { return each.number > begun; });
    if (undo) {
        if (next == strokes_.begin()) return;
        undone_.push_back(std::move(*(next - 1)));
        strokes_.erase(next - 1);
    } else if (!undone_.empty()) {
        strokes_.insert(next, std::move(undone_.back()));
        undone_.pop_back();
    }
}

const DrawnStroke& StrokeMemory::last() const noexcept {
    static const DrawnStroke none;
    return strokes_.empty() ? none : strokes_.back().stroke;
}

} // namespace burin

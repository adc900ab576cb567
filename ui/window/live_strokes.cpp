// SPDX-FileCopyrightText: 2026 The Burin authors
// SPDX-License-Identifier: Apache-2.0
#include "ui/window/live_strokes.h"

namespace burin {

void LiveStrokes::append(std::span<const glm::vec3> tips, bool begins) {
    if (tips.empty()) return;
    if (begins || strokes_.empty()) {
        strokes_.emplace_back();
        undone_.clear(); // new milling makes redo of undone strokes impossible
    }
    strokes_.back().insert(strokes_.back().end(), tips.begin(), tips.end());
    viewport_.appendLivePath(tips, begins);
}

void LiveStrokes::takeBack(bool undo) {
    std::vector<std::vector<glm::vec3>>&from = undo ? strokes_ : undone_, &to = undo ? undone_ : strokes_;
    if (from.empty()) return;
    to.push_back(std::move(from.back()));
    from.pop_back();
    drawAgain();
}

void LiveStrokes::clear() {
    strokes_.clear();
    undone_.clear();
    viewport_.clearLivePath();
}

void LiveStrokes::drawAgain() {
    viewport_.clearLivePath();
    for (const std::vector<glm::vec3>& stroke : strokes_) viewport_.appendLivePath(stroke, true);
}

} // namespace burin

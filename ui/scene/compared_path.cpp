// SPDX-FileCopyrightText: 2026 The Burin authors
// SPDX-License-Identifier: Apache-2.0
#include "ui/scene/compared_path.h"

#include "ui/scene/path_lines.h"

#include <utility>

namespace burin {

void ComparedPath::setPalette(const Palette& palette) {
    other_.setColours(palette.comparedPath, palette.pathHalo);
    farther_.setColours(palette.force, palette.pathHalo);
}

void ComparedPath::setLineWidth(double ratio) {
    other_.setWidth(thinLine * ratio);
    farther_.setLineWidth(boldLine * ratio);
}

void ComparedPath::set(const ComparisonMark& mark) {
    if (std::exchange(shown_, mark.other) != mark.other) showOther();
    farther_.set(mark.farther);
}

void ComparedPath::showOther() {
    const std::vector<LineEnds> lines = shown_ ? millingLines(shown_->path) : std::vector<LineEnds>{};
    other_.setLines(lineData(lines));
    other_.setVisible(!lines.empty());
}

} // namespace burin

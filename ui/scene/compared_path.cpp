// SPDX-FileCopyrightText: 2026 The Burin authors
// SPDX-License-Identifier: Apache-2.0
#include "ui/scene/compared_path.h"

#include "ui/scene/path_lines.h"

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
    const std::vector<LineEnds> lines = mark.other ? millingLines(mark.other->path) : std::vector<LineEnds>{};
    other_.setLines(lineData(lines));
    other_.setVisible(!lines.empty());
    farther_.set(mark.farther);
}

} // namespace burin

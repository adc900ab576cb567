// SPDX-FileCopyrightText: 2026 The Burin authors
// SPDX-License-Identifier: Apache-2.0
#include "ui/scene/other_paths.h"

#include "ui/scene/path_lines.h"

namespace burin {

OtherPaths::OtherPaths(vtkRenderer& renderer) : lines_(renderer) {}

void OtherPaths::setPaths(const std::vector<std::shared_ptr<const EvaluatedPath>>& paths) {
    std::vector<LineEnds> lines;
    for (const auto& evaluated : paths) {
        const std::vector<LineEnds> milled = millingLines(evaluated->path);
        lines.insert(lines.end(), milled.begin(), milled.end());
    }
    lines_.setLines(lineData(lines));
    empty_ = lines.empty();
    setVisible(visible_);
}

void OtherPaths::setVisible(bool visible) {
    visible_ = visible;
    lines_.setVisible(visible_ && !empty_);
}

} // namespace burin

// SPDX-FileCopyrightText: 2026 The Burin authors
// SPDX-License-Identifier: Apache-2.0
#pragma once

#include "core/path/evaluate.h"
#include "ui/scene/haloed_lines.h"
#include "ui/theme/theme.h"

#include <vtkRenderer.h>

#include <memory>
#include <vector>

namespace burin {

/// The paths of the job's tools other than the current one: cuts and plunges, in grey, without rapids.
class OtherPaths {
public:
    explicit OtherPaths(vtkRenderer& renderer);
    void setPalette(const Palette& palette) { lines_.setColours(palette.rapidPath, palette.pathHalo); }
    void setLineWidth(double screenPixels) { lines_.setWidth(screenPixels); }
    void setPaths(const std::vector<std::shared_ptr<const EvaluatedPath>>& paths);
    void setVisible(bool visible);

private:
    HaloedLines lines_;
    bool visible_ = true, empty_ = true;
};

} // namespace burin

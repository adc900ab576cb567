// SPDX-FileCopyrightText: 2026 The Burin authors
// SPDX-License-Identifier: Apache-2.0
#pragma once

#include "core/geometry/box.h"
#include "core/path/evaluate.h"
#include "ui/scene/haloed_lines.h"
#include "ui/scene/marked_lines.h"
#include "ui/theme/theme.h"

#include <vtkRenderer.h>

#include <array>

namespace burin {

/// What the machine shall do, told apart by colour and by stroke: cuts in orange, conventional ones in pink, rapids
/// grey and dashed, plunges in short white dashes, retracts in an unbroken grey; what edits left out, as it was before
/// them, in red with a dot where it begins.
class EditedPath {
public:
    explicit EditedPath(vtkRenderer& renderer);
    void setPalette(const Palette& palette);
    void setLineWidth(double screenPixels);
    void setPath(const EvaluatedPath& path);
    void setVisible(bool visible);
    /// Moves at feed are drawn by something else; what is left are rapids and what edits left out.
    void setFeedsHidden(bool hidden);
    Box box() const noexcept { return box_; }

private:
    static constexpr std::size_t kinds = 5, conventional = 4;
    std::array<HaloedLines, kinds> lines_; ///< by MoveKind; then conventional cuts
    MarkedLines omitted_;
    PlaceChains omissions_;
    Box box_;
    bool visible_ = true, empty_ = true, feedsHidden_ = false;
};

} // namespace burin

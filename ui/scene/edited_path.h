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

/// The commanded moves of the machine, distinguished by colour and line style: cuts in orange, conventional cuts in
/// pink, rapids grey and dashed, plunges in short white dashes, retracts in solid grey; parts left out by edits, as
/// they were before the edit, in red with a dot at their start.
class EditedPath {
public:
    explicit EditedPath(vtkRenderer& renderer);
    void setPalette(const Palette& palette);
    void setLineWidth(double screenPixels);
    void setPath(const EvaluatedPath& path);
    void setVisible(bool visible);
    /// Hides the moves at feed, which are then drawn by another object; rapids and parts left out by edits remain.
    void setFeedsHidden(bool hidden);
    Box box() const noexcept { return box_; }

private:
    static constexpr std::size_t kinds = 5, conventional = 4;
    std::array<HaloedLines, kinds> lines_; ///< indexed by MoveKind, then conventional cuts
    MarkedLines omitted_;
    PlaceChains omissions_;
    Box box_;
    bool visible_ = true, empty_ = true, feedsHidden_ = false;
};

} // namespace burin

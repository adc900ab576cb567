// SPDX-FileCopyrightText: 2026 The Burin authors
// SPDX-License-Identifier: Apache-2.0
#pragma once

#include "ui/scene/comparison_mark.h"
#include "ui/scene/haloed_lines.h"
#include "ui/scene/marked_lines.h"
#include "ui/theme/theme.h"

#include <vtkRenderer.h>

#include <memory>

namespace burin {

/// Draws the path that the edited path is compared with, in thin lines of its own colour, and on top of everything else
/// the parts of the edited path that deviate too far from it.
class ComparedPath {
public:
    /// @param lines draws the path @param marks draws the parts that deviate too far
    ComparedPath(vtkRenderer& lines, vtkRenderer& marks) : other_(lines), farther_(marks) {}
    void setPalette(const Palette& palette);
    void setLineWidth(double ratio); ///< screen pixels per device-independent pixel
    void set(const ComparisonMark& mark);
    bool marksVisible() const { return farther_.visible(); }

private:
    void showOther();

    std::shared_ptr<const EvaluatedPath> shown_; ///< the path whose lines `other_` draws; null: none
    HaloedLines other_;
    MarkedLines farther_;
};

} // namespace burin

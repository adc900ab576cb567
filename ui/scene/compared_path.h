// SPDX-FileCopyrightText: 2026 The Burin authors
// SPDX-License-Identifier: Apache-2.0
#pragma once

#include "ui/scene/comparison_mark.h"
#include "ui/scene/haloed_lines.h"
#include "ui/scene/marked_lines.h"
#include "ui/theme/theme.h"

#include <vtkRenderer.h>

namespace burin {

/// The path that the edited one is compared with, in thin lines of its own colour, and over everything else the parts
/// of the edited path that are too far from it.
class ComparedPath {
public:
    /// @param lines of the path @param marks of what is too far
    ComparedPath(vtkRenderer& lines, vtkRenderer& marks) : other_(lines), farther_(marks) {}
    void setPalette(const Palette& palette);
    void setLineWidth(double ratio); ///< screen pixels a device-independent one
    void set(const ComparisonMark& mark);
    bool marksVisible() const { return farther_.visible(); }

private:
    HaloedLines other_;
    MarkedLines farther_;
};

} // namespace burin

// SPDX-FileCopyrightText: 2026 The Burin authors
// SPDX-License-Identifier: Apache-2.0
#pragma once

#include "ui/scene/haloed_lines.h"
#include "ui/scene/place_chains.h"

#include <vtkRenderer.h>

namespace burin {

/// Lines over everything else: for selected or inspected parts of a path, and for what the user draws. A chain of one
/// point is drawn as a dot.
class MarkedLines {
public:
    explicit MarkedLines(vtkRenderer& renderer);
    void setColours(const QColor& lines, const QColor& halo) { lines_.setColours(lines, halo); }
    void setLineWidth(double screenPixels) { lines_.setWidth(screenPixels); }
    void set(const PlaceChains& chains);
    bool visible() const { return lines_.visible(); }

private:
    HaloedLines lines_;
};

} // namespace burin

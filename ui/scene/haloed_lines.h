// SPDX-FileCopyrightText: 2026 The Burin authors
// SPDX-License-Identifier: Apache-2.0
#pragma once

#include "ui/scene/actors.h"

#include <vtkRenderer.h>

namespace burin {

/// Lines with a seam of another lightness on both sides, so that they are seen on whatever they lie. Points are drawn
/// as dots with a seam. Invisible at first. The renderer outlives them.
class HaloedLines {
public:
    explicit HaloedLines(vtkRenderer& renderer);
    ~HaloedLines();
    HaloedLines(const HaloedLines&) = delete;
    HaloedLines& operator=(const HaloedLines&) = delete;

    void setLines(vtkPolyData* lines); ///< it may grow later
    /// With points (vertices) as well; it stays as it is from now on.
    void setLinesAndDots(vtkPolyData* lines);
    void setColours(const QColor& line, const QColor& halo);
    /// @param screenPixels of the line; the seams add half of it on either side
    void setWidth(double screenPixels);
    void setVisible(bool visible);
    bool visible() const { return line_->GetVisibility() != 0; }

private:
    vtkRenderer& renderer_;
    vtkSmartPointer<vtkActor> halo_, line_;
};

} // namespace burin

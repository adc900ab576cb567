// SPDX-FileCopyrightText: 2026 The Burin authors
// SPDX-License-Identifier: Apache-2.0
#pragma once

#include "ui/scene/actors.h"

#include <vtkRenderer.h>

namespace burin {

/// Lines with an outline (halo) of another lightness on both sides, so that they are visible on any background. Points
/// are drawn as dots with an outline. Invisible at first. The renderer must outlive the object.
class HaloedLines {
public:
    explicit HaloedLines(vtkRenderer& renderer);
    ~HaloedLines();
    HaloedLines(const HaloedLines&) = delete;
    HaloedLines& operator=(const HaloedLines&) = delete;

    void setLines(vtkPolyData* lines); ///< the data may grow later
    /// As `setLines`, with points (vertices) as well; the data must not change afterwards.
    void setLinesAndDots(vtkPolyData* lines);
    void setColours(const QColor& line, const QColor& halo);
    /// @param screenPixels width of the line; the outline adds half of it on either side
    void setWidth(double screenPixels);
    void setVisible(bool visible);
    bool visible() const { return line_->GetVisibility() != 0; }

private:
    vtkRenderer& renderer_;
    vtkSmartPointer<vtkActor> halo_, line_;
};

} // namespace burin

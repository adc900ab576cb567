// SPDX-FileCopyrightText: 2026 The Burin authors
// SPDX-License-Identifier: Apache-2.0
#pragma once

#include "core/geometry/box.h"
#include "ui/scene/actors.h"

#include <vtkActor.h>
#include <vtkRenderer.h>
#include <vtkSmartPointer.h>

#include <QColor>

namespace burin {

/// A subdued grid on the table below the content; it fades out with distance.
class GroundGrid {
public:
    explicit GroundGrid(vtkRenderer& renderer);
    void setColour(const QColor& colour);
    void setLineWidth(double screenPixels) { burin::setLineWidth(*actor_, screenPixels); }
    /// @param content bounding box of what is on the table, mm; empty: no grid
    void setContent(const Box& content);

private:
    void refresh();

    vtkSmartPointer<vtkActor> actor_;
    QColor colour_;
    Box content_;
};

} // namespace burin

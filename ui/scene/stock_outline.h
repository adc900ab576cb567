// SPDX-FileCopyrightText: 2026 The Burin authors
// SPDX-License-Identifier: Apache-2.0
#pragma once

#include "core/geometry/box.h"
#include "ui/scene/actors.h"

#include <vtkActor.h>
#include <vtkRenderer.h>
#include <vtkSmartPointer.h>

#include <QColor>

#include <optional>

namespace burin {

/// The outline of the future stock: a thin box and, while nothing is embedded, its translucent faces.
class StockOutline {
public:
    explicit StockOutline(vtkRenderer& renderer);
    void setColour(const QColor& colour);
    void setBox(const std::optional<Box>& stock);
    const std::optional<Box>& box() const noexcept { return stock_; }
    void setFaces(bool visible);
    void setLineWidth(double screenPixels) { burin::setLineWidth(*edges_, screenPixels); }
    /// Moves the faces to the end of the renderer's list, since what is visible through them must be drawn first.
    void drawLast();

private:
    void refresh();

    vtkRenderer& renderer_;
    vtkSmartPointer<vtkActor> edges_, faces_;
    std::optional<Box> stock_;
    bool facesRequested_ = true;
};

} // namespace burin

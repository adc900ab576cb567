// SPDX-FileCopyrightText: 2026 The Burin authors
// SPDX-License-Identifier: Apache-2.0
#pragma once

#include "ui/scene/camera_view.h"
#include "ui/scene/ground_grid.h"
#include "ui/scene/part_actors.h"
#include "ui/scene/stock_outline.h"
#include "ui/scene/tool_actors.h"

#include <vtkNew.h>
#include <vtkRenderWindow.h>
#include <vtkRenderer.h>

namespace burin {

/// Everything that stands on the bench, in one VTK window. Knows no Qt widget. Thread: user interface.
class Scene {
public:
    explicit Scene(vtkRenderWindow& window);

    void setPalette(const Palette& palette);
    void setPart(const std::vector<ShadedBody>& bodies, const Box& box);
    void setPartVisible(bool visible);
    void setStock(const std::optional<Box>& stock);
    ToolActors& tool() noexcept { return tool_; }

    /// Part, stock and workpiece: what `fit` shows. Not the tool, which may be far away.
    Box contentBox() const;
    void aimCamera(const CameraView& view);
    std::size_t triangles() const;

private:
    void refresh();

    vtkNew<vtkRenderer> bench_;
    PartActors part_;
    ToolActors tool_;
    GroundGrid grid_;
    StockOutline stock_;
    Box partBox_;
};

} // namespace burin

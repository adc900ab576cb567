// SPDX-FileCopyrightText: 2026 The Burin authors
// SPDX-License-Identifier: Apache-2.0
#pragma once

#include "ui/scene/camera_view.h"
#include "ui/scene/label.h"
#include "ui/scene/view_cube_room.h"
#include "ui/theme/theme.h"

#include <vtkActor.h>
#include <vtkRenderWindow.h>
#include <vtkRenderer.h>
#include <vtkTexture.h>

#include <QCoreApplication>

#include <array>
#include <optional>

namespace burin {

/// A cube in the upper right corner with the names of the views on its faces and the axes at its low corner. Rotates
/// with the camera; a click on a face requests that view.
class ViewCube {
    Q_DECLARE_TR_FUNCTIONS(ViewCube)

public:
    static constexpr double side = ViewCubeRoom::side, margin = ViewCubeRoom::margin;

    /// @param layer its own layer, over the others
    ViewCube(vtkRenderWindow& window, int layer);
    void setPalette(const Palette& palette);
    /// Call before each paint. @param ratio screen pixels per device-independent pixel
    void place(const CameraView& view, const QSizeF& size, double ratio);

    /// The face at a position of the widget. @param size of the widget; both in device-independent pixels
    static std::optional<StandardView> faceAt(const CameraView& view, const QSizeF& size, const QPointF& position);
    /// @return whether the picture changes
    bool setHovered(std::optional<StandardView> face);

private:
    void drawFaces();

    vtkNew<vtkRenderer> renderer_;
    vtkNew<vtkTexture> texture_;
    std::array<vtkSmartPointer<vtkActor>, 3> axes_;
    std::array<std::unique_ptr<Label>, 3> letters_;
    Palette palette_;
    std::optional<StandardView> hovered_;
    double ratio_ = 0.0;
    bool stale_ = true;
};

} // namespace burin

// SPDX-FileCopyrightText: 2026 The Burin authors
// SPDX-License-Identifier: Apache-2.0
#pragma once

#include "core/geometry/box.h"
#include "core/volume/runs/run_volume.h"
#include "ui/scene/camera_view.h"
#include "ui/scene/section_plane.h"
#include "ui/theme/theme.h"

#include <vtkActor.h>
#include <vtkNew.h>
#include <vtkPlane.h>
#include <vtkRenderer.h>
#include <vtkSmartPointer.h>

#include <array>
#include <cstdint>
#include <optional>

namespace burin {

/// A section plane: the cut face in the materials' colours, the outline of the plane, and a handle that moves it.
class SectionActors {
public:
    /// @param solids draws the workpiece, @param marks draws what is never hidden
    SectionActors(vtkRenderer& solids, vtkRenderer& marks);

    void setPalette(const Palette& palette);
    void set(const std::optional<SectionPlane>& plane);
    /// Shows or hides the handle. Without it the plane can't be moved with the pointer: for a picture that is not
    /// interactive.
    void setHandle(bool visible);
    const std::optional<SectionPlane>& plane() const noexcept { return plane_; }
    /// The clipping plane: cuts off what `plane` doesn't keep from all that is drawn with it.
    vtkPlane& clip() const noexcept { return *clip_; }
    void workpieceChanged() noexcept { stale_ = true; }
    void setLineWidth(double screenPixels);
    /// Call before each paint. @param workpiece whose cut face is drawn; empty: none @param content box that the
    /// outline surrounds
    void place(const VolumeSnapshot& workpiece, const Box& content, const CameraView& view, const QSizeF& size);
    /// Whether the pointer is on the handle as it was last drawn.
    bool gripAt(const CameraView& view, const QSizeF& size, const QPointF& position) const;
    /// The new position of the plane when the handle is dragged. @return mm along its axis
    double dragged(const CameraView& view, const QSizeF& size, const QPointF& from, const QPointF& to) const;

private:
    void drawFace(const VolumeSnapshot& workpiece);

    vtkNew<vtkPlane> clip_;
    vtkSmartPointer<vtkActor> face_, outline_, arrow_, grip_;
    std::optional<SectionPlane> plane_;
    std::array<std::uint8_t, 3> partColour_{};
    bool handle_ = true;
    bool stale_ = true; ///< whether the face must be redrawn
    glm::dvec3 gripPlace_{0.0};
};

} // namespace burin

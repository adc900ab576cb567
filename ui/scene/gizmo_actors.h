// SPDX-FileCopyrightText: 2026 The Burin authors
// SPDX-License-Identifier: Apache-2.0
#pragma once

#include "ui/scene/camera_view.h"
#include "ui/scene/gizmo.h"
#include "ui/scene/haloed_lines.h"
#include "ui/scene/label.h"
#include "ui/theme/theme.h"

#include <vtkActor.h>
#include <vtkRenderer.h>
#include <vtkSmartPointer.h>

#include <array>
#include <memory>
#include <optional>

namespace burin {

/// Draws a gizmo with a constant size on the screen, over everything else: arrows, squares and rings in the colours of
/// the axes, the handle under the pointer in the accent colour, and the value of a drag beside the pointer.
class GizmoActors {
public:
    /// @param renderer for marks that are never hidden
    explicit GizmoActors(vtkRenderer& renderer);
    void setPalette(const Palette& palette);
    void setLineWidth(double screenPixels);
    void set(const std::optional<GizmoMark>& mark);
    bool visible() const noexcept { return mark_.has_value(); }
    /// Call before each paint. @param size of the widget, device-independent pixels
    void place(const CameraView& view, const QSizeF& size, double ratio);

private:
    /// What one handle is drawn with.
    struct Drawn {
        GizmoHandle handle;
        std::unique_ptr<HaloedLines> line; ///< never null
        vtkSmartPointer<vtkActor> face,
            rim; ///< the head of an arrow and its outline, the inside of a square; else null
    };
    static void hide(Drawn& drawn);
    void draw(Drawn& drawn, const CameraView& view, double pixel) const;
    bool lit(const GizmoHandle& handle) const { return mark_ && mark_->lit == handle; }

    std::array<Drawn, 9> handles_;
    Label value_;
    std::optional<GizmoMark> mark_;
    std::array<QColor, 3> axes_;
    QColor accent_, halo_, text_, plate_;
};

} // namespace burin

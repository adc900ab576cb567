// SPDX-FileCopyrightText: 2026 The Burin authors
// SPDX-License-Identifier: Apache-2.0
#pragma once

#include "core/cad/model_preview.h"
#include "ui/scene/ground_grid.h"
#include "ui/scene/ground_shadow.h"
#include "ui/scene/part_actors.h"
#include "ui/scene/scale_bar.h"

#include <vtkNew.h>
#include <vtkRenderWindow.h>
#include <vtkRenderer.h>

namespace burin {

/// Takes some milliseconds for ten thousand triangles: call on a worker thread.
std::vector<ShadedBody> shadedBodies(const ModelPreview& preview);

/// The bounding box of the part and its future stock, which the picture of a preview contains, mm. @param margin of
/// that stock, mm
Box boundsOf(const ModelPreview& preview, double margin);

/// The preview of a part that is still being read, in its own renderer: nothing of the open project is mixed with it.
/// GUI thread.
class PreviewStage {
public:
    explicit PreviewStage(vtkRenderWindow& window);

    void setPalette(const Palette& palette);
    void setLengthUnit(LengthUnit unit) { scaleBar_.setUnit(unit); }
    void setLineWidths(double ratio);
    /// @param content box that a fitted view shows, mm
    void set(std::vector<ShadedBody> bodies, const Box& content);
    void clear();
    bool shown() const noexcept { return renderer_->GetDraw() != 0; }
    const Box& content() const noexcept { return content_; }
    std::optional<glm::dvec3> pick(const Sight& sight) const { return part_.pick(sight); }
    std::size_t triangles() const { return part_.triangles(); }
    void setDepthCue(const DepthCue& cue) { part_.setDepthCue(cue); }
    vtkRenderer& renderer() noexcept { return *renderer_; }
    /// Call before each paint. @param ratio screen pixels per device-independent pixel
    void place(const CameraView& view, const QSizeF& size, double ratio) { scaleBar_.place(view, size, ratio); }

private:
    vtkNew<vtkRenderer> renderer_;
    PartActors part_;
    GroundGrid grid_;
    GroundShadow shadow_;
    ScaleBar scaleBar_;
    Box content_;
};

} // namespace burin

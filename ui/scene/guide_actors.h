// SPDX-FileCopyrightText: 2026 The Burin authors
// SPDX-License-Identifier: Apache-2.0
#pragma once

#include "ui/scene/camera_view.h"
#include "ui/scene/guide_marks.h"
#include "ui/scene/guide_shapes.h"
#include "ui/scene/guide_surface.h"
#include "ui/scene/label.h"
#include "ui/theme/theme.h"

#include <vtkActor.h>
#include <vtkRenderer.h>
#include <vtkTubeFilter.h>

#include <functional>
#include <memory>
#include <vector>

namespace burin {

/// The guides (virtual fixtures): patches, outlines and curves, each drawn normally where it is visible and faintly
/// through whatever hides it, with a line of text for each in the corner of the picture. A guide that constrains the
/// hand is highlighted in the accent colour. GUI thread.
class GuideActors {
public:
    using Shaped = std::function<void(std::shared_ptr<const GuideSurface>)>;
    /// Creates a surface asynchronously and passes it to `then` on the GUI thread; may drop earlier requests.
    using SurfaceMaker = std::function<void(const GuideMarks& marks, double distance, Shaped then)>;

    /// @param seen draws after the workpiece, with its depths; @param through draws over everything
    GuideActors(vtkRenderer& seen, vtkRenderer& through, SurfaceMaker maker);
    ~GuideActors();

    void setPalette(const Palette& palette);
    void set(const GuideMarks& marks);
    void setTip(const glm::dvec3& tip) { tip_ = tip; } ///< mm, of the tool: position of lead and tilt guides
    void setLineWidth(double screenPixels);            ///< width of a thin line
    bool visible() const noexcept { return !drawn_.empty(); }
    /// Call before each paint: adapts elements with a constant size on the screen. @param ratio screen pixels per
    /// device-independent pixel
    void place(const CameraView& view, const QSizeF& size, double ratio);

private:
    struct Drawn;
    void shape(Drawn& drawn, const GuideMark& mark);
    void orderSurface(Drawn& drawn);
    void colour(Drawn& drawn) const;
    void placeLabels(const QSizeF& size, double ratio);

    vtkRenderer &seen_, &through_;
    SurfaceMaker maker_;
    Palette palette_;
    GuideMarks marks_;
    std::vector<std::unique_ptr<Drawn>> drawn_; ///< in the order of marks_.guides
    glm::dvec3 tip_{0.0};
    double lineWidth_ = 1.0;
    std::uint64_t orders_ = 0; ///< number of surfaces that were requested
};

} // namespace burin

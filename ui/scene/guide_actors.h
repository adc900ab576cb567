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

/// The guides of the hand: patches, outlines, curves, each once where it is to be seen and faintly through whatever
/// hides it; a line of words for each in the picture's corner. One that holds the hand stands out in the accent's
/// colour. Thread: user interface.
class GuideActors {
public:
    using Shaped = std::function<void(std::shared_ptr<const GuideSurface>)>;
    /// Makes a surface somewhere else, and hands it over here; may forget what it was asked before.
    using SurfaceMaker = std::function<void(const GuideMarks& marks, double distance, Shaped then)>;

    /// @param seen draws after the workpiece, with its depths; @param through draws over everything
    GuideActors(vtkRenderer& seen, vtkRenderer& through, SurfaceMaker maker);
    ~GuideActors();

    void setPalette(const Palette& palette);
    void set(const GuideMarks& marks);
    void setTip(const glm::dvec3& tip) { tip_ = tip; } ///< mm, of the tool: lead and tilt stand there
    void setLineWidth(double screenPixels);            ///< of a thin line
    bool visible() const noexcept { return !drawn_.empty(); }
    /// Before each paint: what has a size on the screen keeps it. @param ratio screen pixels a device-independent one
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
    std::vector<std::unique_ptr<Drawn>> drawn_; ///< as marks_.guides
    glm::dvec3 tip_{0.0};
    double lineWidth_ = 1.0;
    std::uint64_t orders_ = 0; ///< counts surfaces that were asked for
};

} // namespace burin

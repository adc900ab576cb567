// SPDX-FileCopyrightText: 2026 The Burin authors
// SPDX-License-Identifier: Apache-2.0
#pragma once

#include "ui/scene/camera_view.h"
#include "ui/scene/label.h"
#include "ui/theme/theme.h"

#include <vtkActor.h>
#include <vtkMatrix4x4.h>
#include <vtkNew.h>
#include <vtkRenderer.h>

namespace burin {

/// The force rendered to the hand: an arrow from the tip with its value. Its length on the screen is proportional to
/// the force up to a maximum, regardless of the zoom; beyond that, the number shows the true value.
class ForceArrow {
public:
    static constexpr double pixelsPerNewton = 40.0, longest = 130.0; ///< device-independent pixels
    static constexpr double smallest = 0.05;                         ///< N; less is not drawn

    explicit ForceArrow(vtkRenderer& renderer);
    void setPalette(const Palette& palette);
    /// @param force N; @param tip mm, setup frame
    void set(const glm::dvec3& force, const glm::dvec3& tip);
    bool visible() const noexcept;
    /// Call before each paint: length and label follow the view. @param ratio screen pixels per device-independent
    /// pixel
    void place(const CameraView& view, const QSizeF& size, double ratio);

private:
    vtkSmartPointer<vtkActor> arrow_;
    vtkNew<vtkMatrix4x4> matrix_;
    Label value_;
    QColor colour_, plate_;
    glm::dvec3 force_{0.0}, tip_{0.0};
};

} // namespace burin

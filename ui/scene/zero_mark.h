// SPDX-FileCopyrightText: 2026 The Burin authors
// SPDX-License-Identifier: Apache-2.0
#pragma once

#include "ui/scene/camera_view.h"
#include "ui/scene/label.h"
#include "ui/scene/zero_place.h"
#include "ui/theme/theme.h"

#include <vtkActor.h>
#include <vtkRenderer.h>
#include <vtkSmartPointer.h>

#include <array>
#include <optional>

namespace burin {

/// Draws program zero: the three axes, with a constant length on the screen in any view, and the name of the work
/// offset.
class ZeroMark {
public:
    /// @param renderer for marks that are never hidden
    explicit ZeroMark(vtkRenderer& renderer);
    void setPalette(const Palette& palette);
    void set(const std::optional<ZeroPlace>& zero);
    bool visible() const noexcept { return zero_.has_value(); }
    void setLineWidth(double screenPixels);
    /// Call before each paint. @param size of the widget, device-independent pixels
    void place(const CameraView& view, const QSizeF& size, double ratio);

private:
    std::array<vtkSmartPointer<vtkActor>, 3> axes_;
    Label name_;
    std::optional<ZeroPlace> zero_;
    double pixel_ = 0.0; ///< mm: size of a pixel for which it is drawn
    QColor colour_, plate_;
};

} // namespace burin

// SPDX-FileCopyrightText: 2026 The Burin authors
// SPDX-License-Identifier: Apache-2.0
#pragma once

#include "ui/scene/camera_view.h"
#include "ui/scene/label.h"
#include "ui/scene/press_mark.h"
#include "ui/theme/length_unit.h"
#include "ui/theme/theme.h"

#include <vtkActor.h>
#include <vtkRenderer.h>
#include <vtkSmartPointer.h>

#include <optional>

namespace burin {

/// Shows where a press would move the tool, visible through the stock: a line down to the position, the outline of the
/// cutter, its depth, and the point at which it touches the part.
class TouchMark {
public:
    /// @param renderer for marks that are never hidden
    explicit TouchMark(vtkRenderer& renderer);
    void setPalette(const Palette& palette);
    void setUnit(LengthUnit unit) { unit_ = unit; }
    void set(const std::optional<PressMark>& mark);
    const std::optional<PressMark>& mark() const noexcept { return mark_; }
    bool visible() const noexcept { return mark_.has_value(); }
    void setLineWidth(double screenPixels);
    /// Call before each paint. @param size of the widget, device-independent pixels
    void place(const CameraView& view, const QSizeF& size, double ratio);

private:
    vtkSmartPointer<vtkActor> lines_, contact_;
    Label depth_;
    std::optional<PressMark> mark_;
    QColor colour_, plate_;
    LengthUnit unit_ = LengthUnit::millimetre;
};

} // namespace burin

// SPDX-FileCopyrightText: 2026 The Burin authors
// SPDX-License-Identifier: Apache-2.0
#pragma once

#include "ui/scene/camera_view.h"
#include "ui/scene/label.h"
#include "ui/scene/marked_lines.h"
#include "ui/scene/measure_mark.h"
#include "ui/theme/theme.h"

#include <optional>

namespace burin {

/// Draws a measurement over everything else: lines, dots, and the main value next to them.
class MeasureMarks {
public:
    /// @param renderer for marks that are never hidden
    explicit MeasureMarks(vtkRenderer& renderer) : lines_(renderer), label_(renderer) {}
    void setPalette(const Palette& palette);
    void setLineWidth(double screenPixels) { lines_.setLineWidth(screenPixels); }
    void set(const std::optional<MeasureMark>& mark);
    bool visible() const noexcept { return mark_.has_value(); }
    /// Call before each paint. @param size of the widget, device-independent pixels
    void place(const CameraView& view, const QSizeF& size, double ratio);

private:
    MarkedLines lines_;
    Label label_;
    std::optional<MeasureMark> mark_;
    QColor colour_, plate_;
};

} // namespace burin

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

/// Draws what was measured over everything else: lines, dots, and the main figure beside them.
class MeasureMarks {
public:
    /// @param renderer of marks that nothing hides
    explicit MeasureMarks(vtkRenderer& renderer) : lines_(renderer), label_(renderer) {}
    void setPalette(const Palette& palette);
    void setLineWidth(double screenPixels) { lines_.setLineWidth(screenPixels); }
    void set(const std::optional<MeasureMark>& mark);
    bool visible() const noexcept { return mark_.has_value(); }
    /// Before each paint. @param size of the widget, device-independent pixels
    void place(const CameraView& view, const QSizeF& size, double ratio);

private:
    MarkedLines lines_;
    Label label_;
    std::optional<MeasureMark> mark_;
    QColor colour_, plate_;
};

} // namespace burin

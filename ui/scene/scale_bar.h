// SPDX-FileCopyrightText: 2026 The Burin authors
// SPDX-License-Identifier: Apache-2.0
#pragma once

#include "ui/scene/camera_view.h"
#include "ui/scene/label.h"
#include "ui/theme/theme.h"

namespace burin {

/// A scale bar of a round length on a background plate in the lower left corner; correct at the distance of the
/// camera's focus.
class ScaleBar {
public:
    explicit ScaleBar(vtkRenderer& renderer) : image_(renderer) {}
    void setPalette(const Palette& palette);
    void setUnit(LengthUnit unit);
    /// Call before each paint. @param ratio screen pixels per device-independent pixel
    void place(const CameraView& view, const QSizeF& size, double ratio);

private:
    void draw();

    ScreenImage image_;
    QColor colour_, plate_;
    LengthUnit unit_{};   ///< millimetre
    double length_ = 0.0; ///< in `unit_`
    int pixels_ = 0;      ///< device-independent
    double ratio_ = 0.0;
};

} // namespace burin

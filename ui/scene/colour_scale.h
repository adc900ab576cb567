// SPDX-FileCopyrightText: 2026 The Burin authors
// SPDX-License-Identifier: Apache-2.0
#pragma once

#include "ui/scene/label.h"
#include "ui/theme/theme.h"

#include <QStringList>

#include <functional>

namespace burin {

/// The meaning of the colours in a picture.
struct ColourScaleContent {
    QString heading;                       ///< quantity and unit
    std::function<QColor(double)> colours; ///< at a fraction (0 … 1) of the range from the lowest to the highest mark
    QStringList marks; ///< numbers from the lowest to the highest, evenly spaced; a single one is in the middle
};

/// A colour bar with its values on a background plate at the right of the picture, below the view cube.
class ColourScale {
public:
    explicit ColourScale(vtkRenderer& renderer) : image_(renderer) { image_.setVisible(false); }

    void setPalette(const Palette& palette);
    void set(ColourScaleContent content);
    void setVisible(bool visible);
    /// Call before each paint.
    /// @param right width that is already occupied at the right, device-independent pixels @param ratio screen pixels
    /// per device-independent pixel
    /// @return `right` plus its own width, if it is visible
    double place(const QSizeF& size, double ratio, double right);

private:
    void draw();

    ScreenImage image_;
    ColourScaleContent content_;
    QColor text_, plate_;
    double ratio_ = 0.0; ///< for which the image is drawn; 0: the image must be redrawn
    bool visible_ = false;
};

} // namespace burin

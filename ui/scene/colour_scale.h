// SPDX-FileCopyrightText: 2026 The Burin authors
// SPDX-License-Identifier: Apache-2.0
#pragma once

#include "ui/scene/label.h"
#include "ui/theme/theme.h"

#include <QStringList>

#include <functional>

namespace burin {

/// What the colours in a picture stand for.
struct ColourScaleContent {
    QString heading;                       ///< quantity and unit
    std::function<QColor(double)> colours; ///< of a share of the way from the lowest mark to the highest, 0 … 1
    QStringList marks;                     ///< numbers from the lowest to the highest, as far apart; one: in the middle
};

/// A bar of colours with their values on a plate at the picture's right, below the view cube.
class ColourScale {
public:
    explicit ColourScale(vtkRenderer& renderer) : image_(renderer) { image_.setVisible(false); }

    void setPalette(const Palette& palette);
    void set(ColourScaleContent content);
    void setVisible(bool visible);
    /// Before each paint. @param right room that is taken at the right already, device-independent pixels @param ratio
    /// screen pixels a device-independent one
    /// @return `right` with its own room, if it is visible
    double place(const QSizeF& size, double ratio, double right);

private:
    void draw();

    ScreenImage image_;
    ColourScaleContent content_;
    QColor text_, plate_;
    double ratio_ = 0.0; ///< that the image is drawn for; 0: it is to be drawn anew
    bool visible_ = false;
};

} // namespace burin

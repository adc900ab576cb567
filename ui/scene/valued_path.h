// SPDX-FileCopyrightText: 2026 The Burin authors
// SPDX-License-Identifier: Apache-2.0
#pragma once

#include "core/job/path_values.h"
#include "ui/scene/actors.h"
#include "ui/scene/colour_scale.h"
#include "ui/theme/length_unit.h"
#include "ui/theme/theme.h"

#include <vtkRenderer.h>

#include <memory>

namespace burin {

/// Moves at feed in the colours of a quantity, with an outline like other lines, and a colour scale in the picture's
/// upper right corner: dark for low values, bright for high ones, which can be distinguished by colour-blind users and
/// in greyscale as well. Moves without a value are grey.
class ValuedPath {
public:
    explicit ValuedPath(vtkRenderer& renderer);
    ~ValuedPath();
    ValuedPath(const ValuedPath&) = delete;
    ValuedPath& operator=(const ValuedPath&) = delete;

    void setPalette(const Palette& palette);
    void setUnit(LengthUnit unit);
    void setLineWidth(double screenPixels);
    /// Null: no values and no scale.
    void setValues(std::shared_ptr<const PathValues> values);
    void setVisible(bool visible);
    bool shown() const noexcept { return visible_ && values_ != nullptr; }
    ColourScale& scale() noexcept { return scale_; }

private:
    void fillScale();

    vtkRenderer& renderer_;
    vtkSmartPointer<vtkActor> halo_, line_;
    ColourScale scale_;
    std::shared_ptr<const PathValues> values_;
    LengthUnit unit_{}; ///< millimetre
    bool visible_ = true;
};

/// The sRGB colour at a fraction (0 … 1) of the range from the lowest value to the highest.
QColor valueColour(double share);

} // namespace burin

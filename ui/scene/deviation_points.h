// SPDX-FileCopyrightText: 2026 The Burin authors
// SPDX-License-Identifier: Apache-2.0
#pragma once

#include "core/verify/deviation_map.h"
#include "ui/theme/theme.h"

#include <vtkActor.h>
#include <vtkRenderer.h>
#include <vtkSmartPointer.h>

#include <span>
#include <vector>

namespace burin {

/// What a program leaves on the part, as points on it in the colours of their bands.
class DeviationPoints {
public:
    explicit DeviationPoints(vtkRenderer& renderer);
    void setPalette(const Palette& palette);
    void setSize(double screenPixels);
    /// None: nothing is drawn.
    void set(std::span<const DeviationSample> samples, const DeviationTolerance& tolerance);

private:
    void colour();

    vtkSmartPointer<vtkActor> points_;
    std::vector<DeviationBand> bands_; ///< of each point
    Palette palette_;
};

} // namespace burin

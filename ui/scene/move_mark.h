// SPDX-FileCopyrightText: 2026 The Burin authors
// SPDX-License-Identifier: Apache-2.0
#pragma once

#include "ui/theme/theme.h"

#include <vtkActor.h>
#include <vtkRenderer.h>
#include <vtkSmartPointer.h>

#include <glm/glm.hpp>

#include <span>

namespace burin {

/// A move that is looked at, as a bold line over everything else.
class MoveMark {
public:
    explicit MoveMark(vtkRenderer& renderer);
    void setPalette(const Palette& palette);
    void setLineWidth(double screenPixels);
    /// @param places along the move, mm, setup frame; fewer than two: none is looked at
    void set(std::span<const glm::dvec3> places);
    bool visible() const { return line_->GetVisibility() != 0; }

private:
    vtkSmartPointer<vtkActor> line_;
};

} // namespace burin

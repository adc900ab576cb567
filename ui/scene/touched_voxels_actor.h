// SPDX-FileCopyrightText: 2026 The Burin authors
// SPDX-License-Identifier: Apache-2.0
#pragma once

#include "core/verify/verify.h"

#include <vtkActor.h>
#include <vtkRenderer.h>
#include <vtkSmartPointer.h>

#include <QColor>

#include <vector>

namespace burin {

/// The voxels of the workpiece that shank or holder touch (the paper's collision area), as cubes that are never hidden.
class TouchedVoxelsActor {
public:
    /// @param renderer for marks that are never hidden
    explicit TouchedVoxelsActor(vtkRenderer& renderer);
    void setColours(const QColor& faces, const QColor& edges);
    void set(const std::vector<TouchedVoxels>& areas);
    bool visible() const { return cubes_->GetVisibility() != 0; }

private:
    vtkSmartPointer<vtkActor> cubes_;
};

} // namespace burin

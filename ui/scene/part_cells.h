// SPDX-FileCopyrightText: 2026 The Burin authors
// SPDX-License-Identifier: Apache-2.0
#pragma once

#include "ui/scene/bare_bricks.h"

#include <vtkCellArray.h>
#include <vtkPolyData.h>
#include <vtkSmartPointer.h>

#include <memory>

namespace burin {

/// Triangles of a part's surface, or its edges: all, or those that may be seen where a workpiece is bare.
class PartCells {
public:
    /// @param all triangles alone or lines of two points alone; stays as it is
    explicit PartCells(vtkPolyData& all);
    /// What is chosen, to be drawn; at first all.
    vtkPolyData* data() const noexcept { return chosen_; }
    std::size_t count() const noexcept { return static_cast<std::size_t>(chosen_->GetNumberOfCells()); }
    /// Cost: linear, when it's another choice than before. @param near null: all
    void choose(const std::shared_ptr<const BareBricks>& near);

private:
    vtkSmartPointer<vtkCellArray> cellsNear(const BareBricks& bare) const;

    bool lines_;
    vtkSmartPointer<vtkCellArray> cells_;
    vtkSmartPointer<vtkPolyData> chosen_;
    std::shared_ptr<const BareBricks> choice_;
};

} // namespace burin

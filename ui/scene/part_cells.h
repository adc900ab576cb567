// SPDX-FileCopyrightText: 2026 The Burin authors
// SPDX-License-Identifier: Apache-2.0
#pragma once

#include "ui/scene/bare_bricks.h"

#include <vtkCellArray.h>
#include <vtkPolyData.h>
#include <vtkSmartPointer.h>

#include <memory>

namespace burin {

/// Triangles of a part's surface, or its edges: all, or only those that may be visible where a workpiece is bare.
class PartCells {
public:
    /// @param all either only triangles or only lines of two points; must not change
    explicit PartCells(vtkPolyData& all);
    /// The chosen cells, to be drawn; initially all.
    vtkPolyData* data() const noexcept { return chosen_; }
    std::size_t count() const noexcept { return static_cast<std::size_t>(chosen_->GetNumberOfCells()); }
    /// Cost: linear if the choice differs from the previous one. @param near null: all
    void choose(const std::shared_ptr<const BareBricks>& near);

private:
    vtkSmartPointer<vtkCellArray> cellsNear(const BareBricks& bare) const;

    bool lines_;
    vtkSmartPointer<vtkCellArray> cells_;
    vtkSmartPointer<vtkPolyData> chosen_;
    std::shared_ptr<const BareBricks> choice_;
};

} // namespace burin

// SPDX-FileCopyrightText: 2026 The Burin authors
// SPDX-License-Identifier: Apache-2.0
#include "ui/scene/part_cells.h"

#include <vtkNew.h>
#include <vtkPoints.h>
#include <vtkTypeInt32Array.h>

#include <limits>

namespace burin {

PartCells::PartCells(vtkPolyData& all)
    : lines_(all.GetNumberOfLines() > 0)
    , cells_(lines_ ? all.GetLines() : all.GetPolys())
    , chosen_(vtkSmartPointer<vtkPolyData>::New()) {
    chosen_->ShallowCopy(&all);
}

void PartCells::choose(const std::shared_ptr<const BareBricks>& near) {
    if (near == choice_) return;
    choice_ = near;
    const vtkSmartPointer<vtkCellArray> cells = near ? cellsNear(*near) : cells_;
    lines_ ? chosen_->SetLines(cells) : chosen_->SetPolys(cells);
}

vtkSmartPointer<vtkCellArray> PartCells::cellsNear(const BareBricks& bare) const {
    constexpr float infinity = std::numeric_limits<float>::infinity();
    vtkPoints& points = *chosen_->GetPoints();
    vtkNew<vtkTypeInt32Array> corners;
    for (vtkIdType cell = 0, count = cells_->GetNumberOfCells(); cell < count; ++cell) {
        vtkIdType size = 0;
        const vtkIdType* ids = nullptr;
        cells_->GetCellAtId(cell, size, ids);
        glm::vec3 low(infinity), high(-infinity);
        for (vtkIdType i = 0; i < size; ++i) {
            glm::dvec3 place;
            points.GetPoint(ids[i], &place.x);
            low = glm::min(low, glm::vec3(place));
            high = glm::max(high, glm::vec3(place));
        }
        if (!bare.touches(low, high)) continue;
        for (vtkIdType i = 0; i < size; ++i) corners->InsertNextValue(static_cast<vtkTypeInt32>(ids[i]));
    }
    auto chosen = vtkSmartPointer<vtkCellArray>::New();
    chosen->SetData(vtkIdType{lines_ ? 2 : 3}, corners);
    return chosen;
}

} // namespace burin

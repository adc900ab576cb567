// SPDX-FileCopyrightText: 2026 The Burin authors
// SPDX-License-Identifier: Apache-2.0
#include "ui/scene/marked_lines.h"

#include <vtkCellArray.h>
#include <vtkNew.h>
#include <vtkPoints.h>

namespace burin {

namespace {

void addDots(vtkPolyData& data, const std::vector<glm::dvec3>& dots) {
    vtkNew<vtkCellArray> cells;
    for (const glm::dvec3& dot : dots) {
        const vtkIdType point = data.GetPoints()->InsertNextPoint(dot.x, dot.y, dot.z);
        cells->InsertNextCell(1, &point);
    }
    data.SetVerts(cells);
}

} // namespace

MarkedLines::MarkedLines(vtkRenderer& renderer) : lines_(renderer) {}

void MarkedLines::set(const PlaceChains& chains) {
    std::vector<LineEnds> lines;
    std::vector<glm::dvec3> dots;
    for (const std::vector<glm::dvec3>& chain : chains) {
        if (chain.size() == 1) dots.push_back(chain.front());
        for (std::size_t i = 1; i < chain.size(); ++i) lines.emplace_back(chain[i - 1], chain[i]);
    }
    const vtkSmartPointer<vtkPolyData> data = lineData(lines);
    addDots(*data, dots);
    lines_.setLinesAndDots(data);
    lines_.setVisible(!lines.empty() || !dots.empty());
}

} // namespace burin

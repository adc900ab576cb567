// SPDX-FileCopyrightText: 2026 The Burin authors
// SPDX-License-Identifier: Apache-2.0
#include "ui/scene/ground_grid.h"

#include "ui/scene/round_spacing.h"

#include <vtkMapper.h>
#include <vtkNew.h>
#include <vtkPointData.h>
#include <vtkPoints.h>
#include <vtkPolyDataMapper.h>
#include <vtkUnsignedCharArray.h>

#include <algorithm>
#include <array>
#include <cmath>

namespace burin {
namespace {

constexpr int linesEachWay = 14; // from the middle

/// Each line is divided into pieces of one spacing, so that its ends can fade out.
std::vector<LineEnds> gridLines(const glm::dvec3& middle, double spacing) {
    std::vector<LineEnds> lines;
    const double reach = linesEachWay * spacing;
    for (int across = -linesEachWay; across <= linesEachWay; ++across)
        for (int along = -linesEachWay; along < linesEachWay; ++along) {
            const double a = across * spacing, from = along * spacing, to = from + spacing;
            if (std::hypot(a, std::min(std::abs(from), std::abs(to))) > reach) continue;
            lines.emplace_back(middle + glm::dvec3(a, from, 0.0), middle + glm::dvec3(a, to, 0.0));
            lines.emplace_back(middle + glm::dvec3(from, a, 0.0), middle + glm::dvec3(to, a, 0.0));
        }
    return lines;
}

vtkSmartPointer<vtkUnsignedCharArray> fading(vtkPoints& points, const glm::dvec3& middle, double reach,
                                             const QColor& colour) {
    auto colours = vtkSmartPointer<vtkUnsignedCharArray>::New();
    colours->SetNumberOfComponents(4);
    colours->SetNumberOfTuples(points.GetNumberOfPoints());
    for (vtkIdType i = 0; i < points.GetNumberOfPoints(); ++i) {
        std::array<double, 3> place{};
        points.GetPoint(i, place.data());
        const double far = std::hypot(place[0] - middle.x, place[1] - middle.y) / reach;
        const double opacity = std::clamp(1.0 - far * far, 0.0, 1.0);
        const auto byte = [](double value) { return static_cast<unsigned char>(std::lround(255.0 * value)); };
        const std::array<unsigned char, 4> rgba{byte(colour.redF()), byte(colour.greenF()), byte(colour.blueF()),
                                                byte(opacity)};
        colours->SetTypedTuple(i, rgba.data());
    }
    return colours;
}

} // namespace

GroundGrid::GroundGrid(vtkRenderer& renderer) : actor_(lineActor(vtkNew<vtkPolyData>())) {
    actor_->ForceOpaqueOn();
    renderer.AddActor(actor_);
}

void GroundGrid::setColour(const QColor& colour) {
    colour_ = colour;
    refresh();
}

void GroundGrid::setContent(const Box& content) {
    if (content.low == content_.low && content.high == content_.high) return;
    content_ = content;
    refresh();
}

void GroundGrid::refresh() {
    actor_->SetVisibility(!content_.empty());
    if (content_.empty()) return;
    const double spacing = roundSpacing(std::max({content_.size().x, content_.size().y, 1e-3}));
    // The lines are at round coordinates of the setup frame, slightly below the table.
    const glm::dvec3 centre = content_.centre();
    const glm::dvec3 middle(std::round(centre.x / spacing) * spacing, std::round(centre.y / spacing) * spacing,
                            content_.low.z - 0.03 * spacing);
    vtkSmartPointer<vtkPolyData> data = lineData(gridLines(middle, spacing));
    data->GetPointData()->SetScalars(fading(*data->GetPoints(), middle, linesEachWay * spacing, colour_));
    auto* mapper = vtkPolyDataMapper::SafeDownCast(actor_->GetMapper());
    mapper->SetInputData(data);
    mapper->ScalarVisibilityOn();
    mapper->SetColorModeToDirectScalars();
}

} // namespace burin

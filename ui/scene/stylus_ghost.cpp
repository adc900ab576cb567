// SPDX-FileCopyrightText: 2026 The Burin authors
// SPDX-License-Identifier: Apache-2.0
#include "ui/scene/stylus_ghost.h"

#include "ui/scene/actors.h"
#include "ui/scene/tool_actors.h"
#include "ui/scene/tool_surface.h"

#include <vtkPolyDataMapper.h>
#include <vtkProperty.h>

namespace burin {
namespace {

constexpr double apart = 0.02; // mm: from this distance on, hand and tool are shown separately

/// Dashes from the origin to (0, 0, 1).
std::vector<LineEnds> unitDashes() {
    constexpr int dashes = 9;
    std::vector<LineEnds> lines;
    for (int i = 0; i < dashes; ++i) {
        const double from = 2.0 * i / (2.0 * dashes - 1.0), to = (2.0 * i + 1.0) / (2.0 * dashes - 1.0);
        lines.emplace_back(glm::dvec3(0.0, 0.0, from), glm::dvec3(0.0, 0.0, to));
    }
    return lines;
}

} // namespace

StylusGhost::StylusGhost(vtkRenderer& renderer)
    : flutes_(surfaceActor(vtkNew<vtkPolyData>())), coupling_(lineActor(lineData(unitDashes()))) {
    flutes_->GetProperty()->BackfaceCullingOn();
    flutes_->GetProperty()->SetSpecular(0.0);
    setBlended(*flutes_, 0.35);
    flutes_->SetUserMatrix(stylus_);
    coupling_->SetUserMatrix(interval_);
    renderer.AddActor(flutes_);
    renderer.AddActor(coupling_);
    refresh();
}

void StylusGhost::setPalette(const Palette& palette) {
    setColour(*flutes_, palette.ghost);
    setColour(*coupling_, palette.coupling);
}

void StylusGhost::setTool(const std::optional<Tool>& tool) {
    hasTool_ = tool.has_value();
    if (tool) vtkPolyDataMapper::SafeDownCast(flutes_->GetMapper())->SetInputData(flutesSurface(tool->cutter));
    refresh();
}

void StylusGhost::set(bool wanted, const glm::dvec3& stylusTip, const ToolPose& proxy) {
    const glm::dvec3 way = proxy.tip - stylusTip;
    const double length = glm::length(way);
    wanted_ = wanted && length > apart;
    if (wanted_) {
        setPose(*stylus_, {stylusTip, proxy.axis});
        setPose(*interval_, {stylusTip, way / length});
        for (int row = 0; row < 3; ++row) interval_->SetElement(row, 2, way[row]);
    }
    refresh();
}

void StylusGhost::setVisible(bool visible) {
    visible_ = visible;
    refresh();
}

void StylusGhost::setLineWidth(double screenPixels) {
    burin::setLineWidth(*coupling_, screenPixels);
}

void StylusGhost::refresh() {
    flutes_->SetVisibility(visible() && hasTool_);
    coupling_->SetVisibility(visible());
}

} // namespace burin

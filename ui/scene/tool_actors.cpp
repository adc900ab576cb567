// SPDX-FileCopyrightText: 2026 The Burin authors
// SPDX-License-Identifier: Apache-2.0
#include "ui/scene/tool_actors.h"

#include "core/base/units.h"
#include "ui/scene/actors.h"
#include "ui/scene/tool_surface.h"

#include <vtkPolyDataMapper.h>
#include <vtkProperty.h>

#include <algorithm>
#include <cmath>
#include <span>

namespace burin {
namespace {

constexpr double helixAngle = 30.0 * pi / 180.0; // usual for end mills; drawn, not reckoned with

/// Radius of the flutes at a height over the tip, mm.
double fluteRadius(std::span<const RevolvedPiece> flutes, double height) {
    for (const RevolvedPiece& piece : flutes)
        if (height <= piece.top) return radiusAt(piece, std::max(height, piece.bottom));
    return flutes.back().topRadius;
}

/// The cutting edges as helices on the flutes, a hair outside of them.
std::vector<LineEnds> cuttingEdges(const Tool& tool) {
    std::vector<LineEnds> lines;
    const Cutter& cutter = tool.cutter;
    const double turnPerHeight = std::tan(helixAngle) / std::max(cutter.radius(), 1e-6);
    constexpr int steps = 40;
    const std::vector<RevolvedPiece> pieces = flutePieces(cutter);
    const int flutes = std::clamp(tool.fluteCount, 1, 8);
    for (int flute = 0; flute < flutes; ++flute) {
        const auto at = [&](int step) {
            const double height = cutter.fluteLength * step / steps;
            const double angle = 2.0 * pi * flute / flutes + height * turnPerHeight;
            const double radius = fluteRadius(pieces, height) * 1.002;
            return glm::dvec3(radius * std::cos(angle), radius * std::sin(angle), height);
        };
        for (int step = 0; step < steps; ++step) lines.emplace_back(at(step), at(step + 1));
    }
    return lines;
}

/// A piece grown by a margin on every side: seen from within it is an outline.
RevolvedPiece grown(RevolvedPiece piece, double margin) {
    piece.bottom -= margin;
    piece.top += margin;
    piece.bottomRadius += margin;
    piece.topRadius += margin;
    if (piece.cornerRadius > 0.0) piece.cornerRadius += margin;
    return piece;
}

} // namespace

void setPose(vtkMatrix4x4& matrix, const ToolPose& pose) {
    const glm::dvec3 axis = pose.axis;
    const glm::dvec3 aside = std::abs(axis.x) < 0.9 ? glm::dvec3(1.0, 0.0, 0.0) : glm::dvec3(0.0, 1.0, 0.0);
    const glm::dvec3 x = glm::normalize(aside - axis * glm::dot(aside, axis)), y = glm::cross(axis, x);
    for (int row = 0; row < 3; ++row) {
        matrix.SetElement(row, 0, x[row]);
        matrix.SetElement(row, 1, y[row]);
        matrix.SetElement(row, 2, axis[row]);
        matrix.SetElement(row, 3, pose.tip[row]);
    }
}

void ToolActors::setPalette(const Palette& palette) {
    palette_ = palette;
    refresh();
}

void ToolActors::add(Section section, vtkSmartPointer<vtkActor> actor) {
    actor->SetUserMatrix(matrix_);
    renderer_.AddActor(actor);
    sections_.push_back({section, std::move(actor)});
}

void ToolActors::setTool(const std::optional<Tool>& tool) {
    for (const Drawn& section : sections_) renderer_.RemoveActor(section.actor);
    sections_.clear();
    if (!tool) return;
    const std::vector<RevolvedPiece> stack = pieces(tool->cutter);
    double widest = 0.0;
    for (const RevolvedPiece& piece : stack) widest = std::max(widest, piece.widestRadius());
    for (std::size_t i = 0; i < stack.size(); ++i) {
        const ToolSection part = sectionOf(tool->cutter, i);
        const Section section = part == ToolSection::flutes  ? Section::flutes
                                : part == ToolSection::shank ? Section::shank
                                                             : Section::holder;
        add(section, surfaceActor(pieceSurface(stack[i])));
        if (section == Section::flutes) continue;
        vtkSmartPointer<vtkActor> outline = surfaceActor(pieceSurface(grown(stack[i], 0.06 * widest)));
        outline->GetProperty()->LightingOff();
        outline->GetProperty()->FrontfaceCullingOn();
        outline->PickableOff();
        add(Section::outline, outline);
    }
    add(Section::edges, lineActor(lineData(cuttingEdges(*tool))));
    refresh();
}

void ToolActors::setVisible(bool visible) {
    visible_ = visible;
    refresh();
}

void ToolActors::setAlarm(bool alarm, bool lit) {
    if (alarm == alarm_ && lit == lit_) return;
    alarm_ = alarm;
    lit_ = lit;
    refresh();
}

void ToolActors::setLineWidth(double screenPixels) {
    lineWidth_ = screenPixels;
    refresh();
}

void ToolActors::refresh() {
    const bool red = alarm_ && lit_;
    for (const auto& [section, actor] : sections_) {
        switch (section) {
        case Section::flutes:
            setColour(*actor, palette_.flutes);
            break;
        case Section::edges:
            setColour(*actor, palette_.holder);
            break;
        case Section::shank:
            setColour(*actor, red ? palette_.force : palette_.shank);
            break;
        case Section::holder:
            setColour(*actor, red ? palette_.force : palette_.holder);
            break;
        case Section::outline:
            setColour(*actor, palette_.force);
            break;
        }
        burin::setLineWidth(*actor, lineWidth_);
        actor->SetVisibility(visible_ && (section != Section::outline || alarm_));
    }
}

std::size_t ToolActors::triangles() const {
    vtkIdType count = 0;
    for (const auto& [section, actor] : sections_)
        if (actor->GetVisibility() != 0)
            count += vtkPolyDataMapper::SafeDownCast(actor->GetMapper())->GetInput()->GetNumberOfPolys();
    return static_cast<std::size_t>(count);
}

} // namespace burin

// SPDX-FileCopyrightText: 2026 The Burin authors
// SPDX-License-Identifier: Apache-2.0
#include "ui/scene/tool_actors.h"

#include "core/base/units.h"
#include "core/tool/tool_solid.h"
#include "ui/scene/across.h"
#include "ui/scene/actors.h"
#include "ui/scene/film_actor.h"
#include "ui/scene/tool_surface.h"

#include <vtkPolyDataMapper.h>
#include <vtkProperty.h>

#include <algorithm>
#include <cmath>
#include <span>

namespace burin {
namespace {

constexpr double helixAngle = 30.0 * pi / 180.0; // typical for end mills; only for drawing, not used in computations

/// The radius of the flutes at a height above the tip, mm.
double fluteRadius(std::span<const RevolvedPiece> flutes, double height) {
    for (const RevolvedPiece& piece : flutes)
        if (height <= piece.top) return radiusAt(piece, std::max(height, piece.bottom));
    return flutes.back().topRadius;
}

/// The cutting edges as helices on the flutes, slightly outside them.
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

/// A piece enlarged by a margin on every side: its inside faces form an outline.
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
    const auto [x, y] = acrossOf(axis);
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

void ToolActors::setPose(const ToolPose& pose) {
    pose_ = pose;
    burin::setPose(*matrix_, pose);
}

void ToolActors::add(Section section, vtkSmartPointer<vtkActor> actor, vtkSmartPointer<vtkActor> faded) {
    actor->SetUserMatrix(matrix_);
    solids_.AddActor(actor);
    if (faded) {
        faded->SetUserMatrix(matrix_);
        films_.AddActor(faded);
    }
    sections_.push_back({section, std::move(actor), std::move(faded)});
}

void ToolActors::setTool(const std::optional<Tool>& tool) {
    for (const Drawn& section : sections_) {
        solids_.RemoveActor(section.actor);
        if (section.faded) films_.RemoveActor(section.faded);
    }
    sections_.clear();
    cutter_ = tool ? std::optional(tool->cutter) : std::nullopt;
    if (!tool) return;
    const std::vector<RevolvedPiece> stack = pieces(tool->cutter);
    const ToolSolid* solid = tool->cutter.solid.get();
    const bool shankMesh = solid != nullptr && !solid->shank.empty();
    double widest = 0.0;
    for (const RevolvedPiece& piece : stack) widest = std::max(widest, piece.widestRadius());
    for (std::size_t i = 0; i < stack.size(); ++i) {
        const ToolSection part = sectionOf(tool->cutter, i);
        if (part == ToolSection::flutes) {
            if (solid == nullptr) add(Section::flutes, surfaceActor(pieceSurface(stack[i])));
            continue;
        }
        const vtkSmartPointer<vtkPolyData> surface = shankMesh && part == ToolSection::shank
                                                         ? meshSurface(turnedAboutAxis(solid->shank, solid->angle))
                                                         : pieceSurface(stack[i]);
        add(part == ToolSection::shank ? Section::shank : Section::holder, surfaceActor(surface), glassActor(surface));
        vtkSmartPointer<vtkActor> outline = surfaceActor(pieceSurface(grown(stack[i], 0.06 * widest)));
        outline->GetProperty()->LightingOff();
        outline->GetProperty()->FrontfaceCullingOn();
        outline->PickableOff();
        add(Section::outline, outline);
    }
    if (tool->cutter.turns()) add(Section::edges, lineActor(lineData(cuttingEdges(*tool))));
    if (solid != nullptr) add(Section::flutes, surfaceActor(flutesSurface(tool->cutter)));
    refresh();
}

std::optional<CutPlace> ToolActors::cut() const {
    if (!cutter_ || !visible_) return std::nullopt;
    return CutPlace{pose_, cutter_->radius()};
}

void ToolActors::place(const CameraView& view) {
    const bool mayFade = cutter_ && visible_ && !alarm_;
    const double opacity = mayFade ? opacityOver(coveredShare(*cutter_, pose_, view)) : 1.0;
    if (opacity == opacity_) return;
    opacity_ = opacity;
    refresh();
}

bool ToolActors::filmsVisible() const noexcept {
    return cutter_ && visible_ && opacity_ < 1.0;
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

QColor ToolActors::colourOf(Section section) const {
    const bool red = alarm_ && lit_;
    switch (section) {
    case Section::flutes:
        return palette_.flutes;
    case Section::edges:
        return palette_.holder;
    case Section::shank:
        return red ? palette_.force : palette_.shank;
    case Section::holder:
        return red ? palette_.force : palette_.holder;
    case Section::outline:
        break;
    }
    return palette_.force;
}

void ToolActors::refresh() {
    for (const auto& [section, actor, faded] : sections_) {
        setColour(*actor, colourOf(section));
        burin::setLineWidth(*actor, lineWidth_);
        const bool seen = visible_ && (section != Section::outline || alarm_), fades = faded && opacity_ < 1.0;
        actor->SetVisibility(seen && !fades);
        if (!faded) continue;
        setColour(*faded, colourOf(section));
        faded->GetProperty()->SetOpacity(opacity_);
        faded->SetVisibility(seen && fades);
    }
}

std::size_t ToolActors::triangles() const {
    vtkIdType count = 0;
    for (const auto& [section, actor, faded] : sections_)
        if (actor->GetVisibility() != 0)
            count += vtkPolyDataMapper::SafeDownCast(actor->GetMapper())->GetInput()->GetNumberOfPolys();
    return static_cast<std::size_t>(count);
}

} // namespace burin

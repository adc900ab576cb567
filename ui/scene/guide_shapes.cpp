// SPDX-FileCopyrightText: 2026 The Burin authors
// SPDX-License-Identifier: Apache-2.0
#include "ui/scene/guide_shapes.h"

#include "core/base/units.h"
#include "ui/scene/guide_geometry.h"

#include <vtkCellArray.h>
#include <vtkNew.h>
#include <vtkPoints.h>

#include <algorithm>
#include <cmath>
#include <span>

namespace burin {
namespace {

constexpr int arcSteps = 16;

/// Builds VTK data from polylines and polygons.
class ShapeMaker {
public:
    void addLine(std::span<const glm::dvec3> places, bool closed = false) {
        lines_->InsertNextCell(static_cast<int>(places.size()) + (closed ? 1 : 0));
        const vtkIdType first = points_->GetNumberOfPoints();
        for (const glm::dvec3& place : places) lines_->InsertCellPoint(add(place));
        if (closed) lines_->InsertCellPoint(first);
    }
    void addPatch(std::span<const glm::dvec3> places) {
        patches_->InsertNextCell(static_cast<int>(places.size()));
        for (const glm::dvec3& place : places) patches_->InsertCellPoint(add(place));
    }
    vtkSmartPointer<vtkPolyData> made() {
        auto data = vtkSmartPointer<vtkPolyData>::New();
        data->SetPoints(points_);
        data->SetLines(lines_);
        data->SetPolys(patches_);
        return data;
    }

private:
    vtkIdType add(const glm::dvec3& place) { return points_->InsertNextPoint(place.x, place.y, place.z); }
    vtkNew<vtkPoints> points_;
    vtkNew<vtkCellArray> lines_, patches_;
};

struct Makers {
    ShapeMaker film, lines, quiet, tube;
    GuideShapes made() { return {film.made(), lines.made(), quiet.made(), tube.made()}; }
};

void addPlane(Makers& makers, const Box& room, const glm::dvec3& point, const glm::dvec3& normal) {
    const Polygon patch = planeInBox(room, point, normal);
    if (patch.empty()) return;
    makers.film.addPatch(patch);
    makers.lines.addLine(patch, true);
}

void addLevels(Makers& makers, const GuideMark& mark, const Box& room) {
    const Guide& guide = mark.guide;
    const auto range = levelsInBox(room, guide.point, guide.direction, guide.distance);
    if (!range) return;
    const int middle = std::clamp(mark.level, range->first, range->second);
    const int first = std::max(range->first, middle - levelsBeside);
    const int last = std::min(range->second, middle + levelsBeside);
    for (int level = first; level <= last; ++level) {
        const glm::dvec3 point = guide.point + guide.direction * (level * guide.distance);
        if (level == mark.level)
            addPlane(makers, room, point, guide.direction);
        else if (const Polygon outline = planeInBox(room, point, guide.direction); !outline.empty())
            makers.quiet.addLine(outline, true);
    }
}

void addPass(Makers& makers, const GuideMark& mark, const GuideMarks& all) {
    if (!all.lastPass || all.lastPass->size() < 2) return;
    makers.quiet.addLine(*all.lastPass);
    for (const Polygon& curve : besidePass(*all.lastPass, mark.guide.direction, mark.guide.distance))
        makers.lines.addLine(curve);
}

} // namespace

GuideShapes shapesOf(const GuideMark& mark, const GuideMarks& all) {
    Makers makers;
    const Guide& guide = mark.guide;
    switch (guide.kind) {
    case GuideKind::plane:
        addPlane(makers, all.room, guide.point, guide.direction);
        break;
    case GuideKind::levels:
        addLevels(makers, mark, all.room);
        break;
    case GuideKind::line:
        if (const auto ends = lineInBox(all.room, guide.point, guide.direction))
            makers.tube.addLine(std::array{ends->first, ends->second});
        break;
    case GuideKind::curve:
        if (guide.curve != nullptr) makers.tube.addLine(guide.curve->points());
        break;
    case GuideKind::stepOver:
        addPass(makers, mark, all);
        break;
    case GuideKind::surface:
    case GuideKind::axis:
        break;
    }
    return makers.made();
}

GuideShapes leaningShapes(const GuideMark& mark, const glm::dvec3& tip, double length) {
    Makers makers;
    if (mark.axis == glm::dvec3(0.0)) return makers.made();
    const glm::dvec3 normal = mark.guide.direction;
    makers.lines.addLine(std::array{tip, tip + 0.85 * length * normal});
    makers.lines.addLine(std::array{tip, tip + mark.axis * length});
    const double angle = std::acos(std::clamp(glm::dot(normal, mark.axis), -1.0, 1.0));
    if (angle < 1e-3 || angle > pi - 1e-3) return makers.made();
    Polygon arc;
    for (int step = 0; step <= arcSteps; ++step) { // evenly from one to the other
        const double share = static_cast<double>(step) / arcSteps;
        arc.push_back(tip + 0.8 * length / std::sin(angle) *
                                (normal * std::sin((1.0 - share) * angle) + mark.axis * std::sin(share * angle)));
    }
    makers.lines.addLine(arc);
    return makers.made();
}

bool shapedAlike(const GuideMark& one, const GuideMark& other) {
    return one.guide == other.guide && one.level == other.level;
}

} // namespace burin

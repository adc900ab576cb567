// SPDX-FileCopyrightText: 2026 The Burin authors
// SPDX-License-Identifier: Apache-2.0
#include "ui/scene/ground_shadow.h"

#include "core/base/units.h"
#include "ui/theme/colour.h"

#include <vtkCellArray.h>
#include <vtkNew.h>
#include <vtkPointData.h>
#include <vtkPoints.h>
#include <vtkPolyDataMapper.h>
#include <vtkProperty.h>
#include <vtkUnsignedCharArray.h>

#include <algorithm>
#include <array>
#include <cmath>

namespace burin {
namespace {

constexpr int cornerSteps = 8, rings = 9;
constexpr double opacityBelow = 0.5;
constexpr double reachShare = 0.16; // extent of the shadow, fraction of the longer side

/// Closed outlines around the box: the first one inside its footprint, the others increasingly far out and fainter.
class Shadow {
public:
    Shadow(const Box& box, double height, const QColor& colour) : box_(box), height_(height), colour_(colour) {
        colours_->SetNumberOfComponents(4);
        const double reach = reachShare * std::max(box.size().x, box.size().y);
        for (int ring = 0; ring < rings; ++ring) {
            const double share = static_cast<double>(ring) / (rings - 1);
            addRing(share * reach, opacityBelow * (1.0 - share) * (1.0 - share));
        }
        addFaces();
    }
    vtkSmartPointer<vtkPolyData> data() const {
        auto data = vtkSmartPointer<vtkPolyData>::New();
        data->SetPoints(points_);
        data->SetPolys(faces_);
        data->GetPointData()->SetScalars(colours_);
        return data;
    }

private:
    static constexpr int ringPoints = 4 * (cornerSteps + 1);

    void addRing(double outwards, double opacity) {
        const auto byte = [](double value) { return static_cast<unsigned char>(std::lround(255.0 * value)); };
        const std::array<unsigned char, 4> rgba{byte(colour_.redF()), byte(colour_.greenF()), byte(colour_.blueF()),
                                                byte(opacity)};
        for (int i = 0; i < ringPoints; ++i) {
            const int corner = i / (cornerSteps + 1), step = i % (cornerSteps + 1);
            const double angle = 0.5 * pi * (corner + static_cast<double>(step) / cornerSteps);
            const double x = corner == 0 || corner == 3 ? box_.high.x : box_.low.x;
            const double y = corner < 2 ? box_.high.y : box_.low.y;
            points_->InsertNextPoint(x + outwards * std::cos(angle), y + outwards * std::sin(angle), height_);
            colours_->InsertNextTypedTuple(rgba.data());
        }
    }
    void addFaces() {
        faces_->InsertNextCell(ringPoints);
        for (int i = 0; i < ringPoints; ++i) faces_->InsertCellPoint(i);
        for (int ring = 0; ring + 1 < rings; ++ring)
            for (int i = 0; i < ringPoints; ++i) {
                const vtkIdType from = ring * ringPoints + i, to = ring * ringPoints + (i + 1) % ringPoints;
                faces_->InsertNextCell({from, from + ringPoints, to + ringPoints, to});
            }
    }

    Box box_;
    double height_;
    QColor colour_;
    vtkNew<vtkPoints> points_;
    vtkNew<vtkCellArray> faces_;
    vtkNew<vtkUnsignedCharArray> colours_;
};

} // namespace

GroundShadow::GroundShadow(vtkRenderer& renderer) : actor_(surfaceActor(vtkNew<vtkPolyData>())) {
    actor_->GetProperty()->LightingOff();
    actor_->GetProperty()->BackfaceCullingOn();
    actor_->ForceOpaqueOn();
    actor_->PickableOff();
    actor_->VisibilityOff();
    actor_->GetMapper()->ScalarVisibilityOn();
    actor_->GetMapper()->SetColorModeToDirectScalars();
    renderer.AddActor(actor_);
}

void GroundShadow::setPalette(const Palette& palette) {
    colour_ = mixed(palette.sceneBottom, Qt::black, 0.8);
    refresh();
}

void GroundShadow::setContent(const Box& content) {
    if (content.low == content_.low && content.high == content_.high) return;
    content_ = content;
    refresh();
}

void GroundShadow::refresh() {
    actor_->SetVisibility(!content_.empty());
    if (content_.empty()) return;
    const double below = 2e-3 * std::max(content_.size().x, content_.size().y); // above the grid, below the workpiece
    const Shadow shadow(content_, content_.low.z - below, colour_);
    vtkPolyDataMapper::SafeDownCast(actor_->GetMapper())->SetInputData(shadow.data());
}

} // namespace burin

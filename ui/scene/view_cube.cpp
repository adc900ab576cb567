// SPDX-FileCopyrightText: 2026 The Burin authors
// SPDX-License-Identifier: Apache-2.0
#include "ui/scene/view_cube.h"

#include "ui/scene/actors.h"
#include "ui/scene/aim_camera.h"

#include <vtkCamera.h>
#include <vtkCellArray.h>
#include <vtkFloatArray.h>
#include <vtkLight.h>
#include <vtkPointData.h>
#include <vtkPoints.h>
#include <vtkProperty.h>

#include <QGuiApplication>
#include <QPainter>

#include <algorithm>
#include <cmath>

namespace burin {
namespace {

constexpr std::array<StandardView, 6> faces{StandardView::top,  StandardView::bottom, StandardView::front,
                                            StandardView::back, StandardView::left,   StandardView::right};
constexpr int atlasColumns = 3, atlasRows = 2;
constexpr double cellPixels = 72.0; // device-independent
constexpr double eyeDistance = 9.6; // the cube extends from -1 to 1
constexpr double cubeReach = 4.0;   // beyond everything that is drawn of it
constexpr double axisFrom = -1.0, axisTo = 1.35, letterAt = 1.65;

CameraView cubeView(const CameraView& view) {
    CameraView own;
    own.azimuth = view.azimuth;
    own.elevation = view.elevation;
    own.distance = eyeDistance;
    own.convergence = view.convergence;
    return own;
}

/// The upper left corner of the cube's square in the widget.
QPointF cornerOf(const QSizeF& size) {
    return {size.width() - ViewCube::side - ViewCube::margin, ViewCube::margin};
}

/// Each face is oriented as in its own view: right and up of the picture are right and up of the lettering.
vtkSmartPointer<vtkPolyData> cubeData() {
    vtkNew<vtkPoints> points;
    vtkNew<vtkFloatArray> texture, normals;
    texture->SetNumberOfComponents(2);
    normals->SetNumberOfComponents(3);
    vtkNew<vtkCellArray> quads;
    for (std::size_t face = 0; face < faces.size(); ++face) {
        const CameraAxes axes = axesOf(turnedTo({}, faces[face]));
        const double column = static_cast<double>(face % atlasColumns), row = static_cast<double>(face / atlasColumns);
        const vtkIdType first = points->GetNumberOfPoints();
        for (const auto& [right, up] : {std::pair{0.0, 0.0}, {1.0, 0.0}, {1.0, 1.0}, {0.0, 1.0}}) {
            const glm::dvec3 corner = axes.back + axes.right * (2.0 * right - 1.0) + axes.up * (2.0 * up - 1.0);
            points->InsertNextPoint(corner.x, corner.y, corner.z);
            normals->InsertNextTuple3(axes.back.x, axes.back.y, axes.back.z);
            texture->InsertNextTuple2((column + right) / atlasColumns, (atlasRows - 1.0 - row + up) / atlasRows);
        }
        quads->InsertNextCell({first, first + 1, first + 2, first + 3});
    }
    auto data = vtkSmartPointer<vtkPolyData>::New();
    data->SetPoints(points);
    data->SetPolys(quads);
    data->GetPointData()->SetTCoords(texture);
    data->GetPointData()->SetNormals(normals);
    return data;
}

glm::dvec3 axisPlace(int axis, double along) {
    glm::dvec3 place(-1.0);
    place[axis] = along;
    return place;
}

} // namespace

ViewCube::ViewCube(vtkRenderWindow& window, int layer) {
    renderer_->SetLayer(layer);
    renderer_->InteractiveOff();
    renderer_->AutomaticLightCreationOff();
    vtkNew<vtkLight> light;
    light->SetLightTypeToHeadlight();
    renderer_->AddLight(light);
    window.AddRenderer(renderer_);

    const vtkSmartPointer<vtkActor> cube = surfaceActor(cubeData());
    cube->GetProperty()->SetAmbient(0.55);
    cube->GetProperty()->SetDiffuse(0.5);
    cube->GetProperty()->SetSpecular(0.0);
    cube->GetProperty()->BackfaceCullingOn();
    texture_->InterpolateOn();
    texture_->SetColorModeToDirectScalars();
    cube->SetTexture(texture_);
    cube->ForceOpaqueOn();
    renderer_->AddActor(cube);
    for (int axis = 0; axis < 3; ++axis) {
        const auto index = static_cast<std::size_t>(axis);
        const std::array<LineEnds, 1> line{{{axisPlace(axis, axisFrom), axisPlace(axis, axisTo)}}};
        axes_[index] = lineActor(lineData(line));
        renderer_->AddActor(axes_[index]);
        letters_[index] = std::make_unique<Label>(*renderer_);
    }
}

void ViewCube::setPalette(const Palette& palette) {
    palette_ = palette;
    setColour(*axes_[0], palette.force);
    setColour(*axes_[1], palette.inOrder);
    setColour(*axes_[2], palette.part);
    stale_ = true;
}

std::optional<StandardView> ViewCube::faceAt(const CameraView& view, const QSizeF& size, const QPointF& position) {
    const QPointF inSquare = position - cornerOf(size);
    if (!QRectF(0.0, 0.0, side, side).contains(inSquare)) return std::nullopt;
    const Sight sight = sightThrough(cubeView(view), QSizeF(side, side), inSquare);
    for (const StandardView face : faces) {
        const glm::dvec3 outwards = axesOf(turnedTo({}, face)).back;
        const double towards = glm::dot(sight.direction, outwards);
        if (towards >= 0.0) continue; // seen from behind
        const glm::dvec3 place = sight.origin + sight.direction * ((1.0 - glm::dot(sight.origin, outwards)) / towards);
        const glm::dvec3 off = glm::abs(place);
        if (std::max({off.x, off.y, off.z}) <= 1.0 + 1e-9) return face;
    }
    return std::nullopt;
}

bool ViewCube::setHovered(std::optional<StandardView> face) {
    if (face == hovered_) return false;
    hovered_ = face;
    stale_ = true;
    return true;
}

void ViewCube::drawFaces() {
    const std::array<QString, 6> names{tr("TOP"), tr("BOTTOM"), tr("FRONT"), tr("BACK"), tr("LEFT"), tr("RIGHT")};
    QImage atlas((QSizeF(atlasColumns, atlasRows) * cellPixels * ratio_).toSize(), QImage::Format_RGBA8888);
    atlas.setDevicePixelRatio(ratio_);
    QPainter painter(&atlas);
    painter.setRenderHint(QPainter::Antialiasing);
    for (std::size_t face = 0; face < faces.size(); ++face) {
        const QRectF cell(cellPixels * static_cast<double>(face % atlasColumns),
                          cellPixels * static_cast<double>(face / atlasColumns), cellPixels, cellPixels);
        const bool lit = hovered_ == faces[face];
        painter.fillRect(cell, lit ? palette_.accent : palette_.panel);
        painter.setPen(QPen(lit ? palette_.accent : palette_.border, 2.5));
        painter.drawRect(cell.adjusted(1.0, 1.0, -1.0, -1.0));
        QFont font = QGuiApplication::font();
        font.setBold(true);
        font.setPixelSize(17);
        const double wide = QFontMetricsF(font).horizontalAdvance(names[face]);
        if (wide > 0.86 * cellPixels) font.setPixelSize(std::max(6, static_cast<int>(17.0 * 0.86 * cellPixels / wide)));
        painter.setFont(font);
        painter.setPen(lit ? palette_.window : palette_.text);
        painter.drawText(cell, Qt::AlignCenter, names[face]);
    }
    painter.end();
    texture_->SetInputData(imageData(atlas));
}

void ViewCube::place(const CameraView& view, const QSizeF& size, double ratio) {
    if (stale_ || ratio != ratio_) {
        ratio_ = ratio;
        stale_ = false;
        drawFaces();
        for (const auto& axis : axes_) axis->GetProperty()->SetLineWidth(static_cast<float>(2.0 * ratio));
        const std::array<QColor, 3> colours{palette_.force, palette_.inOrder, palette_.part};
        for (std::size_t i = 0; i < letters_.size(); ++i)
            letters_[i]->set(QString(QChar(u'X' + static_cast<char16_t>(i))), colours[i], Qt::transparent, ratio);
    }
    const QPointF corner = cornerOf(size);
    const auto share = [](double value, double whole) { return std::clamp(value / std::max(1.0, whole), 0.0, 1.0); };
    renderer_->SetViewport(share(corner.x(), size.width()), 1.0 - share(corner.y() + side, size.height()),
                           share(corner.x() + side, size.width()), 1.0 - share(corner.y(), size.height()));
    const CameraView own = cubeView(view);
    vtkCamera* camera = renderer_->GetActiveCamera();
    aim(*camera, own, cubeReach);
    camera->SetClippingRange(camera->GetDistance() - cubeReach, camera->GetDistance() + cubeReach);
    for (int axis = 0; axis < 3; ++axis) {
        const QPointF at = appearanceOf(own, QSizeF(side, side), axisPlace(axis, letterAt));
        Label& letter = *letters_[static_cast<std::size_t>(axis)];
        letter.setMiddle(at * ratio, static_cast<int>(std::lround(side * ratio)));
        letter.setVisible(!faceAt(view, size, cornerOf(size) + at).has_value()); // otherwise it would be on the cube
    }
}

} // namespace burin

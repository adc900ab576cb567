// SPDX-FileCopyrightText: 2026 The Burin authors
// SPDX-License-Identifier: Apache-2.0
#include "ui/scene/label.h"

#include <vtkCellArray.h>
#include <vtkFloatArray.h>
#include <vtkNew.h>
#include <vtkPointData.h>
#include <vtkPolyData.h>
#include <vtkPolyDataMapper2D.h>
#include <vtkTexture.h>

#include <QFont>
#include <QFontMetricsF>
#include <QGuiApplication>
#include <QPainter>

#include <algorithm>
#include <cmath>
#include <cstring>

namespace burin {

vtkSmartPointer<vtkImageData> imageData(const QImage& image) {
    const QImage rgba = image.convertToFormat(QImage::Format_RGBA8888);
    auto data = vtkSmartPointer<vtkImageData>::New();
    data->SetDimensions(rgba.width(), rgba.height(), 1);
    data->AllocateScalars(VTK_UNSIGNED_CHAR, 4);
    for (int row = 0; row < rgba.height(); ++row)
        std::memcpy(data->GetScalarPointer(0, rgba.height() - 1 - row, 0), rgba.constScanLine(row),
                    4U * static_cast<std::size_t>(rgba.width()));
    return data;
}

QImage plateImage(const QSizeF& size, double ratio, const QColor& plate) {
    constexpr double radius = 4.0;   // device-independent pixels
    constexpr float opacity = 0.85F; // slightly translucent
    QImage image((size * ratio).toSize(), QImage::Format_RGBA8888);
    image.setDevicePixelRatio(ratio);
    QColor colour = plate;
    colour.setAlpha(0);
    image.fill(colour);
    colour.setAlphaF(opacity);
    QPainter painter(&image);
    painter.setRenderHint(QPainter::Antialiasing);
    painter.setPen(Qt::NoPen);
    painter.setBrush(colour);
    painter.drawRoundedRect(QRectF(QPointF(0.0, 0.0), size), radius, radius);
    return image;
}

ScreenImage::ScreenImage(vtkRenderer& renderer)
    : renderer_(renderer)
    , actor_(vtkSmartPointer<vtkTexturedActor2D>::New())
    , corners_(vtkSmartPointer<vtkPoints>::New()) {
    corners_->SetNumberOfPoints(4);
    for (vtkIdType i = 0; i < 4; ++i) corners_->SetPoint(i, 0.0, 0.0, 0.0);
    vtkNew<vtkFloatArray> texture;
    texture->SetNumberOfComponents(2);
    for (const auto& [u, v] : {std::pair{0.0, 0.0}, {1.0, 0.0}, {1.0, 1.0}, {0.0, 1.0}})
        texture->InsertNextTuple2(u, v);
    vtkNew<vtkCellArray> quad;
    quad->InsertNextCell({0, 1, 2, 3});
    vtkNew<vtkPolyData> data;
    data->SetPoints(corners_);
    data->SetPolys(quad);
    data->GetPointData()->SetTCoords(texture);
    vtkNew<vtkPolyDataMapper2D> mapper;
    mapper->SetInputData(data);
    actor_->SetMapper(mapper);
    actor_->PickableOff();
    renderer.AddActor2D(actor_);
}

ScreenImage::~ScreenImage() {
    renderer_.RemoveActor2D(actor_);
}

void ScreenImage::setImage(const QImage& image) {
    size_ = image.size();
    vtkNew<vtkTexture> texture;
    texture->SetInputData(imageData(image));
    texture->SetColorModeToDirectScalars();
    texture->InterpolateOff();
    actor_->SetTexture(texture);
    const double w = size_.width(), h = size_.height();
    corners_->SetPoint(0, 0.0, 0.0, 0.0);
    corners_->SetPoint(1, w, 0.0, 0.0);
    corners_->SetPoint(2, w, h, 0.0);
    corners_->SetPoint(3, 0.0, h, 0.0);
    corners_->Modified();
}

void ScreenImage::setPosition(const QPointF& upperLeft, int height) {
    actor_->SetPosition(std::round(upperLeft.x()), std::round(height - upperLeft.y() - size_.height()));
}

void Label::set(const QString& text, const QColor& colour, const QColor& plate, double ratio) {
    if (text == text_ && colour == colour_ && plate == plate_ && ratio == ratio_) return;
    text_ = text;
    colour_ = colour;
    plate_ = plate;
    ratio_ = ratio;
    QFont font = QGuiApplication::font();
    font.setBold(true);
    const QFontMetricsF metrics(font);
    const double padX = 6.0, padY = 2.0; // device-independent pixels
    const QSizeF size(metrics.horizontalAdvance(text) + 2.0 * padX, metrics.height() + 2.0 * padY);
    QImage image((size * ratio).toSize() + QSize(1, 1), QImage::Format_RGBA8888);
    image.setDevicePixelRatio(ratio);
    // Where nothing is drawn, edges must not blend towards black.
    QColor empty = plate.alpha() > 0 ? plate : colour;
    empty.setAlpha(0);
    image.fill(empty);
    QPainter painter(&image);
    painter.setRenderHint(QPainter::Antialiasing);
    painter.setFont(font);
    if (plate.alpha() > 0) {
        painter.setPen(Qt::NoPen);
        painter.setBrush(plate);
        painter.drawRoundedRect(QRectF(QPointF(0.0, 0.0), size), 4.0, 4.0);
    }
    painter.setPen(colour);
    painter.drawText(QRectF(QPointF(0.0, 0.0), size), Qt::AlignCenter, text);
    painter.end();
    image_.setImage(image);
}

void Label::setMiddle(const QPointF& middle, int height) {
    image_.setPosition(middle - QPointF(0.5 * image_.size().width(), 0.5 * image_.size().height()), height);
}

} // namespace burin

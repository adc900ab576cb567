// SPDX-FileCopyrightText: 2026 The Burin authors
// SPDX-License-Identifier: Apache-2.0
#pragma once

#include <vtkImageData.h>
#include <vtkPoints.h>
#include <vtkRenderer.h>
#include <vtkSmartPointer.h>
#include <vtkTexturedActor2D.h>

#include <QColor>
#include <QImage>
#include <QPointF>
#include <QSizeF>
#include <QString>

namespace burin {

/// Qt's picture as VTK takes it for a texture: RGBA, lowest row first.
vtkSmartPointer<vtkImageData> imageData(const QImage& image);

/// An empty plate with round corners, for letters and scales. @param size device-independent pixels @param ratio screen
/// pixels a device-independent one
QImage plateImage(const QSizeF& size, double ratio, const QColor& plate);

/// A picture that stands upright on the screen, over everything of its renderer: labels in the window's own font.
class ScreenImage {
public:
    explicit ScreenImage(vtkRenderer& renderer);
    ~ScreenImage();
    ScreenImage(const ScreenImage&) = delete;
    ScreenImage& operator=(const ScreenImage&) = delete;
    void setImage(const QImage& image);
    /// Upper left corner in the renderer's widget, screen pixels; @param height of the widget, screen pixels
    void setPosition(const QPointF& upperLeft, int height);
    void setVisible(bool visible) { actor_->SetVisibility(visible); }
    const QSize& size() const noexcept { return size_; } ///< screen pixels

private:
    vtkRenderer& renderer_; ///< outlives it
    vtkSmartPointer<vtkTexturedActor2D> actor_;
    vtkSmartPointer<vtkPoints> corners_;
    QSize size_;
};

/// A line of text on a quiet plate. Drawn anew only when something about it changes.
class Label {
public:
    explicit Label(vtkRenderer& renderer) : image_(renderer) {}
    /// @param plate behind the text; transparent: none. @param ratio screen pixels a device-independent one
    void set(const QString& text, const QColor& colour, const QColor& plate, double ratio);
    /// Middle of the label in the widget, screen pixels; @param height of the widget, screen pixels
    void setMiddle(const QPointF& middle, int height);
    /// Its upper left corner instead, the same way.
    void setUpperLeft(const QPointF& corner, int height) { image_.setPosition(corner, height); }
    void setVisible(bool visible) { image_.setVisible(visible); }

private:
    ScreenImage image_;
    QString text_;
    QColor colour_, plate_;
    double ratio_ = 0.0;
};

} // namespace burin

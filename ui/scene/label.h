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

/// Converts a Qt image to a VTK texture image: RGBA, lowest row first.
vtkSmartPointer<vtkImageData> imageData(const QImage& image);

/// An empty background plate with rounded corners, for text and scales.
/// @param size device-independent pixels @param ratio screen pixels per device-independent pixel
QImage plateImage(const QSizeF& size, double ratio, const QColor& plate);

/// An image that is upright on the screen, over everything else of its renderer: for labels in the window's own font.
class ScreenImage {
public:
    explicit ScreenImage(vtkRenderer& renderer);
    ~ScreenImage();
    ScreenImage(const ScreenImage&) = delete;
    ScreenImage& operator=(const ScreenImage&) = delete;
    void setImage(const QImage& image);
    /// Sets the position of the upper left corner in the renderer's widget, screen pixels. @param height of the widget,
    /// screen pixels
    void setPosition(const QPointF& upperLeft, int height);
    void setVisible(bool visible) { actor_->SetVisibility(visible); }
    const QSize& size() const noexcept { return size_; } ///< screen pixels

private:
    vtkRenderer& renderer_; ///< must outlive this object
    vtkSmartPointer<vtkTexturedActor2D> actor_;
    vtkSmartPointer<vtkPoints> corners_;
    QSize size_;
};

/// A line of text on a subdued background plate. Redrawn only when something about it changes.
class Label {
public:
    explicit Label(vtkRenderer& renderer) : image_(renderer) {}
    /// @param plate colour behind the text; transparent: none. @param ratio screen pixels per device-independent pixel
    void set(const QString& text, const QColor& colour, const QColor& plate, double ratio);
    /// Sets the centre of the label in the widget, screen pixels. @param height of the widget, screen pixels
    void setMiddle(const QPointF& middle, int height);
    /// Sets the upper left corner instead, likewise.
    void setUpperLeft(const QPointF& corner, int height) { image_.setPosition(corner, height); }
    void setVisible(bool visible) { image_.setVisible(visible); }

private:
    ScreenImage image_;
    QString text_;
    QColor colour_, plate_;
    double ratio_ = 0.0;
};

} // namespace burin

// SPDX-FileCopyrightText: 2026 The Burin authors
// SPDX-License-Identifier: Apache-2.0
#pragma once

#include <QImage>
#include <QWidget>

#include <memory>

class QOpenGLContext;

namespace burin {

/// Interface of the object that draws on a canvas. All functions are called with the canvas's context current.
class CanvasPainter {
public:
    virtual ~CanvasPainter() = default;
    /// Called when a context has been created, before anything is drawn. If the context is not sufficient, nothing must
    /// be drawn with it.
    virtual void begin(QOpenGLContext& context) = 0;
    /// @param framebuffer to draw into, of the size of the canvas in screen pixels
    virtual void paint(unsigned framebuffer) = 0;
    /// Called when the drawn picture is where the window will show it.
    virtual void painted() = 0;
    /// Called before the context is destroyed.
    virtual void end() = 0;
};

/// An OpenGL surface that fills its area of a widget and leaves mouse and keyboard to the widget.
class Canvas {
public:
    /// Creates a canvas as a child of `parent`, of the kind that is fast on this machine. With a graphics card, the
    /// card composes the window. With software rendering that would cost as much again as the picture itself (the whole
    /// window is uploaded, blended and copied again, 40 to 50 ms at 1600 × 1000), so in that case the picture is read
    /// back and shown like that of any other widget.
    /// @param painter must outlive the canvas
    static std::unique_ptr<Canvas> make(QWidget& parent, CanvasPainter& painter);
    virtual ~Canvas() = default;

    virtual QWidget& widget() = 0;
    /// Whether there is a context.
    virtual bool isValid() const = 0;
    /// Requests a repaint because the picture has changed.
    virtual void refresh() = 0;
    /// Draws and returns the picture, in screen pixels.
    virtual QImage grab() = 0;
    /// With software rendering, draws an invisible picture before the widget is shown, because compiling each shader
    /// program takes the processor tens of milliseconds. Does nothing on a graphics card, where the context is created
    /// with the widget.
    virtual void warmUp() = 0;
    virtual void makeCurrent() = 0;
    virtual void doneCurrent() = 0;
};

/// Whether a current context renders in software, without a graphics card.
bool drawsInSoftware(QOpenGLContext& context);

} // namespace burin

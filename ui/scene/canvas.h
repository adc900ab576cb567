// SPDX-FileCopyrightText: 2026 The Burin authors
// SPDX-License-Identifier: Apache-2.0
#pragma once

#include <QImage>
#include <QWidget>

#include <memory>

class QOpenGLContext;

namespace burin {

/// Who draws on a canvas. All with the canvas's context current.
class CanvasPainter {
public:
    virtual ~CanvasPainter() = default;
    /// A context is there; before anything is drawn. It may not do: then nothing must be drawn with it.
    virtual void begin(QOpenGLContext& context) = 0;
    /// @param framebuffer that is to be drawn into, as large as the canvas in screen pixels
    virtual void paint(unsigned framebuffer) = 0;
    /// What was drawn is where the window will show it.
    virtual void painted() = 0;
    /// The context is about to go.
    virtual void end() = 0;
};

/// A surface for OpenGL that fills its place in a widget and leaves mouse and keyboard to it.
class Canvas {
public:
    /// As a child of `parent`, in the way that is fast on this machine: a graphics card composes the window. Drawn in
    /// software that would cost as much again as the picture itself (all of the window is uploaded, blended and copied
    /// anew, 40 to 50 ms at 1600 × 1000), so there the picture is read back and shown like any widget's.
    /// @param painter outlives the canvas
    static std::unique_ptr<Canvas> make(QWidget& parent, CanvasPainter& painter);
    virtual ~Canvas() = default;

    virtual QWidget& widget() = 0;
    /// A context is there.
    virtual bool isValid() const = 0;
    /// There is another picture, to be painted soon.
    virtual void refresh() = 0;
    /// Draws and gives the picture, in screen pixels.
    virtual QImage grab() = 0;
    /// Draws what nobody sees, before the widget is shown, where the processor makes the programs that draw: it takes
    /// tens of milliseconds for each. Nothing on a graphics card, whose context comes with the widget.
    virtual void warmUp() = 0;
    virtual void makeCurrent() = 0;
    virtual void doneCurrent() = 0;
};

/// Whether a current context draws without a graphics card.
bool drawsInSoftware(QOpenGLContext& context);

} // namespace burin

// SPDX-FileCopyrightText: 2026 The Burin authors
// SPDX-License-Identifier: Apache-2.0
#include "ui/scene/canvas.h"

#include "ui/scene/surface_format.h"

#include <QOffscreenSurface>
#include <QOpenGLContext>
#include <QOpenGLFramebufferObject>
#include <QOpenGLFunctions>
#include <QOpenGLWidget>
#include <QPainter>
#include <QTimer>

#include <algorithm>
#include <cstring>
#include <utility>

namespace burin {

namespace {

void layOut(QWidget& canvas) {
    canvas.setAttribute(Qt::WA_TransparentForMouseEvents);
    canvas.setFocusPolicy(Qt::NoFocus);
}

/// A canvas that the graphics card composes into the window.
class CardCanvas final : public QOpenGLWidget, public Canvas {
public:
    CardCanvas(QWidget& parent, CanvasPainter& painter) : QOpenGLWidget(&parent), painter_(painter) {
        setFormat(sceneSurfaceFormat());
        layOut(*this);
    }
    ~CardCanvas() override { end(); }

    QWidget& widget() override { return *this; }
    bool isValid() const override { return QOpenGLWidget::isValid(); }
    void refresh() override { update(); }
    QImage grab() override { return grabFramebuffer(); }
    void warmUp() override {}
    void makeCurrent() override { QOpenGLWidget::makeCurrent(); }
    void doneCurrent() override { QOpenGLWidget::doneCurrent(); }

private:
    void initializeGL() override {
        connect(context(), &QOpenGLContext::aboutToBeDestroyed, this, &CardCanvas::end);
        begun_ = true;
        painter_.begin(*context());
    }
    void paintGL() override {
        painter_.paint(defaultFramebufferObject());
        painter_.painted();
    }
    void end() {
        if (!std::exchange(begun_, false)) return;
        disconnect(context(), nullptr, this, nullptr);
        makeCurrent();
        painter_.end();
        doneCurrent();
    }

    CanvasPainter& painter_;
    bool begun_ = false;
};

/// A canvas with its own context; its picture is copied into the window's pixels at each paint until there is a new
/// one.
class PixelCanvas final : public QWidget, public Canvas {
public:
    PixelCanvas(QWidget& parent, CanvasPainter& painter, std::unique_ptr<QOpenGLContext> context,
                std::unique_ptr<QOffscreenSurface> surface)
        : QWidget(&parent), painter_(painter), surface_(std::move(surface)), context_(std::move(context)) {
        layOut(*this);
        setAttribute(Qt::WA_OpaquePaintEvent);
    }
    ~PixelCanvas() override {
        makeCurrent();
        if (begun_) painter_.end();
        buffer_.reset();
        doneCurrent();
    }

    QWidget& widget() override { return *this; }
    bool isValid() const override { return context_->isValid(); }
    void refresh() override {
        stale_ = true;
        update();
    }
    QImage grab() override {
        draw();
        doneCurrent();
        return picture_;
    }
    void warmUp() override { (void)grab(); }
    void makeCurrent() override { context_->makeCurrent(surface_.get()); }
    void doneCurrent() override { context_->doneCurrent(); }

private:
    void showEvent(QShowEvent*) override { appears_ = true; }
    void paintEvent(QPaintEvent*) override {
        if (std::exchange(appears_, false) && isDue()) return waitForTurn();
        const bool draws = isDue();
        stale_ = false;
        if (draws) draw();
        {
            QPainter painter(this);
            painter.setCompositionMode(QPainter::CompositionMode_Source);
            picture_.isNull() ? painter.fillRect(rect(), Qt::black) : painter.drawImage(QPoint(0, 0), picture_);
        }
        if (!draws) return;
        if (!picture_.isNull()) painter_.painted();
        doneCurrent();
    }
    bool isDue() const { return stale_ || rows_.size() != pixelSize(); }
    /// Many other widgets appear together with the canvas and are laid out and painted for the first time: the picture
    /// follows them.
    void waitForTurn() {
        QPainter(this).fillRect(rect(), palette().window());
        QTimer::singleShot(0, this, [this] { refresh(); });
    }
    QSize pixelSize() const { return (QSizeF(size()) * devicePixelRatioF()).toSize(); }
    void draw() {
        makeCurrent();
        if (!std::exchange(begun_, true)) painter_.begin(*context_);
        const QSize pixels = pixelSize();
        if (!context_->isValid() || pixels.isEmpty()) return;
        if (!buffer_ || buffer_->size() != pixels)
            buffer_ =
                std::make_unique<QOpenGLFramebufferObject>(pixels, QOpenGLFramebufferObject::CombinedDepthStencil);
        painter_.paint(buffer_->handle());
        read(pixels);
    }
    void read(const QSize& pixels) {
        if (rows_.size() != pixels) {
            rows_ = QImage(pixels, QImage::Format_RGB32);
            picture_ = QImage(pixels, QImage::Format_RGB32);
        }
        picture_.setDevicePixelRatio(devicePixelRatioF());
        buffer_->bind();
        context_->functions()->glReadPixels(0, 0, pixels.width(), pixels.height(), bgra, bytesReversed, rows_.bits());
        // OpenGL's first row is the lowest.
        for (int row = 0; row < pixels.height(); ++row)
            std::memcpy(picture_.scanLine(row), rows_.constScanLine(pixels.height() - 1 - row),
                        static_cast<std::size_t>(rows_.bytesPerLine()));
    }

    // A pixel of QImage is the number 0xAARRGGBB, regardless of the byte order of the machine.
    static constexpr GLenum bgra = 0x80E1, bytesReversed = 0x8367;

    CanvasPainter& painter_;
    std::unique_ptr<QOffscreenSurface> surface_;
    std::unique_ptr<QOpenGLContext> context_;
    std::unique_ptr<QOpenGLFramebufferObject> buffer_;
    QImage rows_, picture_;
    bool begun_ = false;
    bool stale_ = true;    ///< whether the picture is outdated
    bool appears_ = false; ///< whether the next paint is the first one since it was hidden
};

} // namespace

bool drawsInSoftware(QOpenGLContext& context) {
    const auto* name = reinterpret_cast<const char*>(context.functions()->glGetString(GL_RENDERER));
    const QByteArray renderer = QByteArray(name).toLower();
    return renderer.contains("llvmpipe") || renderer.contains("softpipe") || renderer.contains("software");
}

std::unique_ptr<Canvas> Canvas::make(QWidget& parent, CanvasPainter& painter) {
    auto context = std::make_unique<QOpenGLContext>();
    auto surface = std::make_unique<QOffscreenSurface>();
    context->setFormat(sceneSurfaceFormat());
    surface->setFormat(sceneSurfaceFormat());
    surface->create();
    const bool current = context->create() && context->makeCurrent(surface.get());
    const bool card = current && !drawsInSoftware(*context);
    if (current) context->doneCurrent();
    if (card) return std::make_unique<CardCanvas>(parent, painter);
    return std::make_unique<PixelCanvas>(parent, painter, std::move(context), std::move(surface));
}

} // namespace burin

// SPDX-FileCopyrightText: 2026 The Burin authors
// SPDX-License-Identifier: Apache-2.0
#include "ui/scene/viewport.h"

#include "ui/scene/camera_motion.h"
#include "ui/scene/frame_clock.h"
#include "ui/scene/scene.h"

#include <vtkGenericOpenGLRenderWindow.h>
#include <vtkNew.h>
#include <vtkOpenGLState.h>

#include <QCoreApplication>
#include <QKeyEvent>
#include <QMouseEvent>
#include <QOpenGLContext>
#include <QPointer>
#include <QStyle>
#include <QThreadPool>
#include <QTimer>
#include <QWheelEvent>

namespace burin {

namespace {

using namespace std::chrono_literals;
constexpr auto flightTime = 180ms;
constexpr auto restTime = 350ms; // after the last motion: then everything is drawn in full detail
constexpr auto flashTime = 167ms;

} // namespace

class Viewport::Impl {
public:
    explicit Impl(Viewport& viewport) : widget(viewport), scene(*window) {
        rest.setSingleShot(true);
        rest.setInterval(restTime);
        flash.setInterval(flashTime);
    }

    CameraMotion::Clock::duration flight() const {
        const int duration = widget.style()->styleHint(QStyle::SH_Widget_Animation_Duration, nullptr, &widget);
        return duration > 0 && widget.isVisible() ? flightTime : 0ms;
    }
    /// Something on the screen moves: coarse detail is enough until it rests.
    void moved() {
        rest.start();
        widget.update();
    }
    void contentChanged() {
        motion.setContent(scene.contentBox());
        widget.update();
    }

    Viewport& widget;
    vtkNew<vtkGenericOpenGLRenderWindow> window;
    Scene scene;
    CameraMotion motion;
    FrameClock clock;
    QTimer rest, flash;
    InteractiveTool* tool = nullptr;
    ToolMarks marks;
    std::uint64_t partOrdered = 0; ///< counts setPart: a part that comes late must not replace a newer one
    bool usable = false;
    bool flashLit = true;
};

Viewport::Viewport(QWidget* parent) : QOpenGLWidget(parent), impl_(std::make_unique<Impl>(*this)) {
    setObjectName(QStringLiteral("viewport"));
    setFocusPolicy(Qt::StrongFocus);
    setMouseTracking(true);
    setMinimumSize(160, 120);
    connect(&impl_->rest, &QTimer::timeout, this, [this] { update(); });
    connect(&impl_->flash, &QTimer::timeout, this, [this] {
        impl_->flashLit = !impl_->flashLit;
        impl_->scene.tool().setAlarm(impl_->marks.alarm, impl_->flashLit);
        update();
    });
}

Viewport::~Viewport() {
    if (!impl_->usable) return;
    makeCurrent();
    impl_->window->Finalize();
    doneCurrent();
    disconnect(context(), nullptr, this, nullptr);
}

void Viewport::setPalette3D(const Palette& palette) {
    impl_->scene.setPalette(palette);
    update();
}

void Viewport::setPart(std::shared_ptr<const Model> model) {
    const std::uint64_t order = ++impl_->partOrdered;
    if (!model) {
        impl_->scene.setPart({}, {});
        impl_->contentChanged();
        return;
    }
    const QPointer<Viewport> self(this);
    QThreadPool::globalInstance()->start([self, model = std::move(model), order] {
        auto bodies = std::make_shared<const std::vector<ShadedBody>>(shadedBodies(*model));
        const Box box = model->box();
        QMetaObject::invokeMethod(qApp, [self, bodies, box, order] {
            if (!self || self->impl_->partOrdered != order) return;
            self->impl_->scene.setPart(*bodies, box);
            self->impl_->contentChanged();
        });
    });
}

void Viewport::setPartVisible(bool visible) {
    impl_->scene.setPartVisible(visible);
    update();
}

void Viewport::setStockOutline(const std::optional<Box>& stock) {
    impl_->scene.setStock(stock);
    impl_->contentChanged();
}

void Viewport::setWorkpiece(const VolumeSnapshot&, std::optional<std::chrono::steady_clock::time_point>) {}
void Viewport::setWorkpieceVisible(bool) {}

void Viewport::setTool(const std::optional<Tool>& tool) {
    impl_->scene.tool().setTool(tool);
    update();
}

void Viewport::setToolMarks(const ToolMarks& marks) {
    impl_->marks = marks;
    impl_->scene.tool().setPose(marks.proxy);
    if (marks.alarm != impl_->flash.isActive()) {
        impl_->flashLit = true;
        marks.alarm ? impl_->flash.start() : impl_->flash.stop();
    }
    impl_->scene.tool().setAlarm(marks.alarm, impl_->flashLit);
    impl_->moved();
}

void Viewport::setToolVisible(bool visible) {
    impl_->scene.tool().setVisible(visible);
    update();
}

void Viewport::appendLivePath(std::span<const glm::vec3>, bool) {}
void Viewport::clearLivePath() {}
void Viewport::setPath(const Path&) {}
void Viewport::setPathVisible(bool) {}

void Viewport::setStandardView(StandardView view) {
    impl_->motion.turnTo(view, CameraMotion::Clock::now(), impl_->flight());
    impl_->moved();
}

void Viewport::fit() {
    impl_->motion.fit(CameraMotion::Clock::now(), impl_->flight());
    impl_->moved();
}

void Viewport::setInteractiveTool(InteractiveTool* tool) {
    if (impl_->tool != nullptr && impl_->tool != tool) impl_->tool->leave();
    impl_->tool = tool;
}

ViewportEvent Viewport::sight(const QPointF& position) const {
    const Sight sight = sightThrough(impl_->motion.view(), QSizeF(size()), position);
    ViewportEvent event;
    event.position = position;
    event.rayOrigin = sight.origin;
    event.rayDirection = sight.direction;
    return event;
}

QPointF Viewport::project(const glm::dvec3& place) const {
    return appearanceOf(impl_->motion.view(), QSizeF(size()), place);
}

FrameStatistics Viewport::statistics() const {
    FrameStatistics statistics = impl_->clock.statistics();
    statistics.triangles = impl_->scene.triangles();
    statistics.fullDetail = !impl_->rest.isActive();
    return statistics;
}

void Viewport::resetStatistics() {
    impl_->clock.reset();
}

void Viewport::initializeGL() {
    const QSurfaceFormat format = context()->format();
    impl_->usable = format.version() >= qMakePair(3, 2) && !context()->isOpenGLES();
    if (!impl_->usable) {
        emit drawingFailed(tr("The 3D view needs OpenGL 3.2 or later; this computer offers %1.%2. Install the graphics "
                              "card's driver.")
                               .arg(format.majorVersion())
                               .arg(format.minorVersion()));
        return;
    }
    vtkGenericOpenGLRenderWindow& window = *impl_->window;
    window.SetMapped(true);
    window.SetIsCurrent(true);
    window.SetReadyForRendering(true);
    window.SetOwnContext(0);
    window.SetMultiSamples(0);
    window.OpenGLInitContext();
    window.SetFrameBlitModeToBlitToCurrent();
    connect(context(), &QOpenGLContext::aboutToBeDestroyed, this, [this] {
        makeCurrent();
        impl_->window->Finalize();
        impl_->usable = false;
        doneCurrent();
    });
}

void Viewport::resizeGL(int width, int height) {
    const double ratio = devicePixelRatio();
    impl_->window->SetSize(static_cast<int>(std::lround(width * ratio)), static_cast<int>(std::lround(height * ratio)));
    impl_->motion.setSize(QSizeF(width, height));
}

void Viewport::paintGL() {
    if (!impl_->usable) return;
    const auto begin = FrameClock::Clock::now();
    const bool flying = impl_->motion.advance(begin);
    impl_->scene.aimCamera(impl_->motion.view());

    vtkGenericOpenGLRenderWindow& window = *impl_->window;
    window.SetIsCurrent(true);
    vtkOpenGLState* state = window.GetState();
    state->ResetGLBlendFuncState();
    state->Reset();
    state->Push();
    state->vtkglBindFramebuffer(GL_FRAMEBUFFER, defaultFramebufferObject());
    window.Render();
    state->Pop();

    impl_->clock.add(begin, FrameClock::Clock::now(), std::nullopt);
    if (flying) impl_->moved();
    emit painted();
}

void Viewport::mousePressEvent(QMouseEvent* event) {
    ViewportEvent sighted = sight(event->position());
    sighted.button = event->button();
    sighted.buttons = event->buttons();
    sighted.modifiers = event->modifiers();
    if (impl_->tool != nullptr && impl_->tool->press(sighted)) return;
    const bool both = event->buttons().testFlags(Qt::MiddleButton | Qt::RightButton);
    const bool camera = event->button() == Qt::MiddleButton || event->button() == Qt::RightButton;
    if (!camera) return;
    const bool pan = both || (event->button() == Qt::MiddleButton && event->modifiers().testFlag(Qt::ShiftModifier));
    impl_->motion.beginDrag(pan ? CameraMotion::Drag::pan : CameraMotion::Drag::orbit, event->position(),
                            impl_->motion.view().focus);
}

void Viewport::mouseMoveEvent(QMouseEvent* event) {
    if (impl_->motion.dragging() != CameraMotion::Drag::none) {
        impl_->motion.drag(event->position());
        impl_->moved();
        return;
    }
    ViewportEvent sighted = sight(event->position());
    sighted.buttons = event->buttons();
    sighted.modifiers = event->modifiers();
    if (impl_->tool != nullptr) impl_->tool->move(sighted);
}

void Viewport::mouseReleaseEvent(QMouseEvent* event) {
    if (!event->buttons().testAnyFlags(Qt::MiddleButton | Qt::RightButton)) impl_->motion.endDrag();
    ViewportEvent sighted = sight(event->position());
    sighted.button = event->button();
    sighted.buttons = event->buttons();
    sighted.modifiers = event->modifiers();
    if (impl_->tool != nullptr) impl_->tool->release(sighted);
}

void Viewport::mouseDoubleClickEvent(QMouseEvent* event) {
    mousePressEvent(event);
}

void Viewport::wheelEvent(QWheelEvent* event) {
    ViewportEvent sighted = sight(event->position());
    sighted.buttons = event->buttons();
    sighted.modifiers = event->modifiers();
    sighted.wheelSteps = event->angleDelta().y() / 120.0;
    event->accept();
    if (impl_->tool != nullptr && impl_->tool->wheel(sighted)) return;
    impl_->motion.zoom(sighted.wheelSteps, impl_->motion.view().focus);
    impl_->moved();
}

void Viewport::keyPressEvent(QKeyEvent* event) {
    if (impl_->tool != nullptr && impl_->tool->key(event->key(), event->modifiers())) return;
    QOpenGLWidget::keyPressEvent(event);
}

void Viewport::leaveEvent(QEvent* event) {
    if (impl_->tool != nullptr) impl_->tool->leave();
    QOpenGLWidget::leaveEvent(event);
}

} // namespace burin

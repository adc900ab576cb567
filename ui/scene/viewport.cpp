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
#include <QOpenGLFunctions>
#include <QPointer>
#include <QStyle>
#include <QThreadPool>
#include <QTimer>
#include <QWheelEvent>

#include <cmath>
#include <utility>

namespace burin {

namespace {

using namespace std::chrono_literals;
constexpr auto flightTime = 180ms;
constexpr auto restTime = 350ms; // after the last motion: then everything is drawn in full detail
constexpr auto flashTime = 167ms;

/// Smooth edges cost nothing on a graphics card, but two to five times a frame in software (measured).
bool drawsInSoftware(QOpenGLContext* context) {
    const auto* name = reinterpret_cast<const char*>(context->functions()->glGetString(GL_RENDERER));
    const QByteArray renderer = QByteArray(name).toLower();
    return renderer.contains("llvmpipe") || renderer.contains("softpipe") || renderer.contains("software");
}

bool same(const ToolMarks& a, const ToolMarks& b) {
    return a.proxy.tip == b.proxy.tip && a.proxy.axis == b.proxy.axis && a.stylusTip == b.stylusTip &&
           a.force == b.force && a.ghost == b.ghost && a.alarm == b.alarm && a.cutting == b.cutting;
}

} // namespace

class Viewport::Impl {
public:
    explicit Impl(Viewport& viewport)
        : widget(viewport), scene(*window, [&viewport] {
            QMetaObject::invokeMethod(
                &viewport, [&viewport] { viewport.update(); }, Qt::QueuedConnection);
        }) {
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
    /// What a movement of the camera turns and scales about: the place under the pointer, or one as far away as what
    /// the camera looks at.
    glm::dvec3 pivotAt(const QPointF& position) const {
        const Sight sight = sightThrough(motion.view(), motion.size(), position);
        const CameraAxes axes = axesOf(motion.view());
        return scene.pick(sight).value_or(
            sight.origin - sight.direction * (motion.view().distance / glm::dot(sight.direction, axes.back)));
    }
    ViewportEvent eventAt(const QSinglePointEvent& event, Qt::KeyboardModifiers modifiers) const {
        ViewportEvent sighted = widget.sight(event.position());
        sighted.button = event.button();
        sighted.buttons = event.buttons();
        sighted.modifiers = modifiers;
        return sighted;
    }
    void hoverCube(const std::optional<QPointF>& position) {
        const auto face = position ? ViewCube::faceAt(motion.view(), motion.size(), *position) : std::nullopt;
        if (scene.cube().setHovered(face)) widget.update();
    }
    void initializeWindow();
    void releaseWindow() {
        if (!usable) return;
        usable = false;
        widget.makeCurrent();
        window->Finalize();
        widget.doneCurrent();
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
    bool usable = false;           ///< there is a context that can draw
    bool failureTold = false;
    bool flashLit = true;
    bool paintedMoving = true; ///< the newest paint was made in motion
};

void Viewport::Impl::initializeWindow() {
    window->SetMapped(true);
    window->SetIsCurrent(true);
    window->SetReadyForRendering(true);
    window->SetOwnContext(0);
    window->SetMultiSamples(drawsInSoftware(widget.context()) ? 0 : 4);
    window->OpenGLInitContext();
    window->SetFrameBlitModeToBlitToCurrent();
}

Viewport::Viewport(QWidget* parent) : QOpenGLWidget(parent), impl_(std::make_unique<Impl>(*this)) {
    setObjectName(QStringLiteral("viewport"));
    setFocusPolicy(Qt::StrongFocus);
    setMouseTracking(true);
    setMinimumSize(160, 120);
    connect(&impl_->rest, &QTimer::timeout, this, [this] { update(); });
    connect(&impl_->flash, &QTimer::timeout, this, [this] {
        impl_->flashLit = !impl_->flashLit;
        impl_->scene.setMarks(impl_->marks, impl_->flashLit);
        update();
    });
}

Viewport::~Viewport() {
    if (context() != nullptr) disconnect(context(), nullptr, this, nullptr);
    impl_->releaseWindow();
}

void Viewport::setPalette3D(const Palette& palette) {
    impl_->scene.setPalette(palette);
    update();
}

void Viewport::setLengthUnit(LengthUnit unit) {
    impl_->scene.setLengthUnit(unit);
    update();
}

void Viewport::setPart(std::shared_ptr<const Model> model) {
    const std::uint64_t order = ++impl_->partOrdered;
    if (!model) {
        impl_->scene.setPart({}, {});
        impl_->contentChanged();
        return;
    }
    // Shading takes some tenths of a second for a large part: on a thread of the pool.
    const QPointer<Viewport> self(this);
    QThreadPool::globalInstance()->start([self, model = std::move(model), order] {
        const auto bodies = std::make_shared<std::vector<ShadedBody>>(shadedBodies(*model));
        const Box box = model->box();
        QMetaObject::invokeMethod(
            QCoreApplication::instance(),
            [self, bodies, box, order] {
                if (!self || self->impl_->partOrdered != order) return;
                self->impl_->scene.setPart(std::move(*bodies), box);
                self->impl_->contentChanged();
            },
            Qt::QueuedConnection);
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

void Viewport::setWorkpiece(const VolumeSnapshot& workpiece,
                            std::optional<std::chrono::steady_clock::time_point> oldestCut) {
    impl_->scene.setWorkpiece(workpiece, oldestCut);
    impl_->motion.setContent(impl_->scene.contentBox());
    oldestCut ? impl_->moved() : update();
}

void Viewport::setWorkpieceVisible(bool visible) {
    impl_->scene.setWorkpieceVisible(visible);
    update();
}

void Viewport::setTool(const std::optional<Tool>& tool) {
    impl_->scene.setTool(tool);
    update();
}

void Viewport::setToolMarks(const ToolMarks& marks) {
    if (same(marks, impl_->marks)) return;
    const bool toolMoved = marks.proxy.tip != impl_->marks.proxy.tip || marks.proxy.axis != impl_->marks.proxy.axis;
    impl_->marks = marks;
    if (marks.alarm != impl_->flash.isActive()) {
        impl_->flashLit = true;
        marks.alarm ? impl_->flash.start() : impl_->flash.stop();
    }
    impl_->scene.setMarks(marks, impl_->flashLit);
    toolMoved || marks.cutting ? impl_->moved() : update();
}

void Viewport::setToolVisible(bool visible) {
    impl_->scene.setToolVisible(visible);
    update();
}

void Viewport::appendLivePath(std::span<const glm::vec3> tips, bool newStroke) {
    if (tips.empty()) return;
    impl_->scene.livePath().append(tips, newStroke);
    update();
}

void Viewport::clearLivePath() {
    impl_->scene.livePath().clear();
    update();
}

void Viewport::setPath(const Path& path) {
    impl_->scene.editedPath().setPath(path);
    update();
}

void Viewport::setPathVisible(bool visible) {
    impl_->scene.editedPath().setVisible(visible);
    update();
}

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
    const WorkpieceActors& workpiece = impl_->scene.workpiece();
    statistics.triangles = impl_->scene.triangles();
    statistics.fullDetail = !impl_->paintedMoving && workpiece.fullDetail();
    statistics.busy = workpiece.busy();
    return statistics;
}

void Viewport::resetStatistics() {
    impl_->clock.reset();
}

QString Viewport::obstacleOf(const QOpenGLContext* context) {
    if (context == nullptr || !context->isValid())
        return tr("The 3D view needs OpenGL 3.2 or later; this computer offers none. A driver of the graphics card may "
                  "be missing.");
    const QSurfaceFormat format = context->format();
    if (format.version() >= qMakePair(3, 2) && !context->isOpenGLES()) return {};
    return tr("The 3D view needs OpenGL 3.2 or later; this computer offers %1.%2. A newer driver of the graphics card "
              "may help.")
        .arg(format.majorVersion())
        .arg(format.minorVersion());
}

QString Viewport::drawingObstacle() {
    QOpenGLContext context;
    return obstacleOf(context.create() ? &context : nullptr);
}

void Viewport::initializeGL() {
    const QString obstacle = obstacleOf(context());
    if (!obstacle.isEmpty()) {
        if (!std::exchange(impl_->failureTold, true)) emit drawingFailed(obstacle);
        return;
    }
    impl_->initializeWindow();
    impl_->usable = true;
    connect(context(), &QOpenGLContext::aboutToBeDestroyed, this, [this] { impl_->releaseWindow(); });
}

void Viewport::resizeGL(int width, int height) {
    impl_->motion.setSize(QSizeF(width, height));
}

void Viewport::paintGL() {
    if (!impl_->usable) return;
    const auto begin = FrameClock::Clock::now();
    const bool flying = impl_->motion.advance(begin);
    const double ratio = devicePixelRatioF();
    impl_->paintedMoving = flying || impl_->motion.moving() || impl_->rest.isActive();
    const auto cut = impl_->scene.prepare(impl_->motion.view(), QSizeF(size()), ratio, impl_->paintedMoving);

    vtkGenericOpenGLRenderWindow& window = *impl_->window;
    window.SetSize(static_cast<int>(std::lround(width() * ratio)), static_cast<int>(std::lround(height() * ratio)));
    window.SetIsCurrent(true);
    vtkOpenGLState* state = window.GetState();
    state->ResetGLBlendFuncState();
    state->Reset();
    state->Push();
    state->vtkglBindFramebuffer(GL_FRAMEBUFFER, defaultFramebufferObject());
    window.Render();
    state->Pop();

    impl_->clock.add(begin, FrameClock::Clock::now(), cut);
    if (flying) impl_->moved();
    emit painted();
}

void Viewport::mousePressEvent(QMouseEvent* event) {
    const QPointF position = event->position();
    if (event->button() == Qt::LeftButton) {
        if (const auto face = ViewCube::faceAt(impl_->motion.view(), impl_->motion.size(), position))
            return setStandardView(*face);
    }
    if (impl_->tool != nullptr && impl_->tool->press(impl_->eventAt(*event, event->modifiers()))) return;
    if (event->button() != Qt::MiddleButton && event->button() != Qt::RightButton) return;
    const bool both = event->buttons().testFlags(Qt::MiddleButton | Qt::RightButton);
    const bool pan = both || (event->button() == Qt::MiddleButton && event->modifiers().testFlag(Qt::ShiftModifier));
    impl_->motion.beginDrag(pan ? CameraMotion::Drag::pan : CameraMotion::Drag::orbit, position,
                            impl_->pivotAt(position));
}

void Viewport::mouseMoveEvent(QMouseEvent* event) {
    if (impl_->motion.dragging() != CameraMotion::Drag::none) {
        impl_->motion.drag(event->position());
        return impl_->moved();
    }
    const bool pressed = event->buttons() != Qt::NoButton;
    impl_->hoverCube(pressed ? std::nullopt : std::optional(event->position()));
    if (impl_->tool != nullptr) impl_->tool->move(impl_->eventAt(*event, event->modifiers()));
}

void Viewport::mouseReleaseEvent(QMouseEvent* event) {
    if (!event->buttons().testAnyFlags(Qt::MiddleButton | Qt::RightButton)) impl_->motion.endDrag();
    if (impl_->tool != nullptr) impl_->tool->release(impl_->eventAt(*event, event->modifiers()));
}

void Viewport::mouseDoubleClickEvent(QMouseEvent* event) {
    mousePressEvent(event); // two quick strokes are two strokes
}

void Viewport::wheelEvent(QWheelEvent* event) {
    event->accept();
    const QPoint angle = event->angleDelta(); // some platforms turn it aside while a modifier is down
    ViewportEvent sighted = impl_->eventAt(*event, event->modifiers());
    sighted.wheelSteps = (angle.y() != 0 ? angle.y() : angle.x()) / 120.0;
    if (impl_->tool != nullptr && impl_->tool->wheel(sighted)) return;
    impl_->motion.zoom(sighted.wheelSteps, impl_->pivotAt(event->position()));
    impl_->moved();
}

void Viewport::keyPressEvent(QKeyEvent* event) {
    // Only what moves by steps may repeat; a spindle that is switched by a key that is held would chatter.
    const bool mayRepeat = event->key() >= Qt::Key_Left && event->key() <= Qt::Key_PageDown;
    if (event->isAutoRepeat() && !mayRepeat) return;
    if (impl_->tool != nullptr && impl_->tool->key(event->key(), event->modifiers())) return;
    QOpenGLWidget::keyPressEvent(event);
}

void Viewport::leaveEvent(QEvent* event) {
    impl_->hoverCube(std::nullopt);
    if (impl_->tool != nullptr) impl_->tool->leave();
    QOpenGLWidget::leaveEvent(event);
}

} // namespace burin

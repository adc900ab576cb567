// SPDX-FileCopyrightText: 2026 The Burin authors
// SPDX-License-Identifier: Apache-2.0
#include "ui/scene/viewport_impl.h"

#include <vtkOpenGLState.h>

#include <QOpenGLContext>
#include <QStyle>

#include <cmath>

namespace burin {

namespace {

using namespace std::chrono_literals;
constexpr auto flightTime = 180ms;
constexpr auto restTime = 350ms; // after the last motion; everything is then drawn in full detail
constexpr auto flashTime = 167ms;
/// A paint is followed by a pause of its duration divided by this number: without pauses, software rendering would
/// leave no processor time for the threads that create its content.
constexpr int pausePerPaint = 4;

} // namespace

Viewport::Impl::Impl(Viewport& viewport)
    : widget(viewport)
    , scene(
          *window,
          [&viewport] {
              QMetaObject::invokeMethod(
                  &viewport, [&viewport] { viewport.impl_->refresh(); }, Qt::QueuedConnection);
          },
          [this](const GuideMarks& of, double distance, GuideActors::Shaped then) {
              makeSurface(of, distance, std::move(then));
          },
          [this](std::shared_ptr<const Obstacle> obstacle, ObstacleActors::Made then) {
              onPool([obstacle] { return surfaceOf(*obstacle); }, std::move(then));
          }) {
    rest.setSingleShot(true);
    breath.setSingleShot(true);
    turn.setSingleShot(true);
    breath.setTimerType(Qt::PreciseTimer);
    rest.setInterval(restTime);
    flash.setInterval(flashTime);
}

CameraMotion::Clock::duration Viewport::Impl::flight() const {
    const int duration = widget.style()->styleHint(QStyle::SH_Widget_Animation_Duration, nullptr, &widget);
    return duration > 0 && widget.isVisible() ? flightTime : 0ms;
}

void Viewport::Impl::showPreview(std::vector<ShadedBody> bodies, const Box& content) {
    if (tool != nullptr) tool->leave();
    scene.setPreview(std::move(bodies), content);
    const bool first = !motionBefore;
    if (first) motionBefore = motion;
    contentChanged();
    if (first) motion.fit(CameraMotion::Clock::now(), flight());
    moved();
}

void Viewport::Impl::endPreview(bool keepView) {
    if (!motionBefore) return;
    scene.clearPreview();
    if (!keepView) {
        motion = *motionBefore;
        motion.setSize(QSizeF(widget.size()));
    }
    motionBefore.reset();
    contentChanged();
}

void Viewport::Impl::begin(QOpenGLContext& context) {
    const QString obstacle = obstacleOf(&context);
    if (!obstacle.isEmpty()) {
        if (!std::exchange(failureTold, true)) emit widget.drawingFailed(obstacle);
        return;
    }
    window->SetMapped(true);
    window->SetIsCurrent(true);
    window->SetReadyForRendering(true);
    window->SetOwnContext(0);
    // Multisampling costs nothing on a graphics card, but multiplies the time of a frame by two to five in software
    // (measured).
    window->SetMultiSamples(drawsInSoftware(context) ? 0 : 4);
    window->OpenGLInitContext();
    window->SetFrameBlitModeToBlitToCurrent();
    usable = true;
}

void Viewport::Impl::end() {
    if (std::exchange(usable, false)) window->Finalize();
}

void Viewport::Impl::paint(unsigned framebuffer) {
    if (!usable) return;
    paintBegan = FrameClock::Clock::now();
    flying = motion.advance(paintBegan);
    const double ratio = widget.devicePixelRatioF();
    paintedMoving = flying || motion.moving() || rest.isActive();
    paintedCut = scene.prepare(motion.view(), QSizeF(widget.size()), ratio, paintedMoving);
    window->SetSize(static_cast<int>(std::lround(widget.width() * ratio)),
                    static_cast<int>(std::lround(widget.height() * ratio)));
    window->SetIsCurrent(true);
    vtkOpenGLState* state = window->GetState();
    state->ResetGLBlendFuncState();
    state->Reset();
    state->Push();
    state->vtkglBindFramebuffer(GL_FRAMEBUFFER, framebuffer);
    window->Render();
    state->Pop();
}

void Viewport::Impl::painted() {
    if (!usable) return;
    const auto end = FrameClock::Clock::now();
    clock.add(paintBegan, end, std::exchange(paintedCut, std::nullopt));
    const auto pause = std::chrono::duration_cast<std::chrono::milliseconds>((end - paintBegan) / pausePerPaint);
    if (pause > 0ms) breath.start(pause);
    if (flying) moved();
    emit widget.painted();
}

} // namespace burin

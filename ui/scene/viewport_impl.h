// SPDX-FileCopyrightText: 2026 The Burin authors
// SPDX-License-Identifier: Apache-2.0
#pragma once

#include "core/base/background.h"
#include "ui/scene/camera_motion.h"
#include "ui/scene/canvas.h"
#include "ui/scene/frame_clock.h"
#include "ui/scene/scene.h"
#include "ui/scene/viewport.h"

#include <vtkGenericOpenGLRenderWindow.h>
#include <vtkNew.h>

#include <QCoreApplication>
#include <QElapsedTimer>
#include <QMouseEvent>
#include <QPointer>
#include <QThreadPool>
#include <QTimer>

#include <functional>
#include <type_traits>
#include <utility>

namespace burin {

/// The parts of a viewport: scene, camera, canvas, and the timing of paints.
class Viewport::Impl final : public CanvasPainter {
public:
    explicit Impl(Viewport& viewport);

    CameraMotion::Clock::duration flight() const;
    /// Requests a paint in a later turn of the event loop, so that input and panels that change at the same time need
    /// not wait for the picture; if painting is costly, only after a pause in which others get their turn.
    void refresh() {
        if (breath.isActive())
            waiting = true;
        else if (!turn.isActive())
            turn.start();
    }
    /// Call when something on the screen moves: coarse detail is sufficient until it comes to rest.
    void moved() {
        rest.start();
        refresh();
    }
    void contentChanged() {
        motion.setContent(scene.contentBox());
        refresh();
    }
    /// The pivot about which camera movements rotate and scale: the point under the pointer, or one as far away as the
    /// camera's focus.
    glm::dvec3 pivotAt(const QPointF& position) const {
        const Sight sight = sightThrough(motion.view(), motion.size(), position);
        return scene.pick(sight).value_or(besideFocus(motion.view(), sight));
    }
    ViewportEvent eventAt(const QSinglePointEvent& event) const {
        ViewportEvent sighted = widget.sight(event.position());
        sighted.button = event.button();
        sighted.buttons = event.buttons();
        sighted.modifiers = event.modifiers();
        sighted.pen = pen;
        return sighted;
    }
    /// The tool that receives pointer and key events; null: only the camera.
    InteractiveTool* toolInHand() const { return scene.previewing() ? nullptr : tool; }
    /// Offers an event to the handles, then to the tool. Returns whether one of them handled it.
    template <class Offer>
    bool offered(Offer offer) {
        if (scene.previewing()) return false;
        return (handles != nullptr && offer(*handles)) || (tool != nullptr && offer(*tool));
    }
    bool onHandle(const ViewportEvent& event) {
        return !scene.previewing() && handles != nullptr && handles->move(event);
    }
    bool onSectionGrip(const QPointF& position) {
        return !scene.previewing() && scene.section().gripAt(motion.view(), motion.size(), position);
    }
    void dragSection(const QPointF& position) {
        const SectionPlane plane = *scene.section().plane();
        const Box content = scene.contentBox();
        const double to = scene.section().dragged(motion.view(), motion.size(), *sectionGrip, position);
        // A pointer that was beyond the ends moves the plane again when it returns.
        if (to < content.low[plane.axis] || to > content.high[plane.axis]) return;
        sectionGrip = position;
        emit widget.sectionDragged(to);
    }
    void hoverCube(const std::optional<QPointF>& position) {
        const auto face = position ? ViewCube::faceAt(motion.view(), motion.size(), *position) : std::nullopt;
        if (scene.cube().setHovered(face)) refresh();
    }
    /// Runs work that takes some tenths of a second on a pool thread and passes the result to `then` on this thread.
    template <class Make, class Then>
    void onPool(Make make, Then then) {
        const QPointer<Viewport> self(&widget);
        QThreadPool::globalInstance()->start([self, make = std::move(make), then = std::move(then)] {
            workInBackground();
            auto made = std::make_shared<const std::invoke_result_t<const Make&>>(make());
            QMetaObject::invokeMethod(
                QCoreApplication::instance(),
                [self, then, made] {
                    if (!self) return;
                    then(made);
                    self->impl_->contentChanged();
                },
                Qt::QueuedConnection);
        });
    }
    void makeSurface(const GuideMarks& of, double distance, GuideActors::Shaped then) {
        onPool([field = of.field, tips = of.tips, distance] { return guideSurface(*field, tips, distance); },
               std::move(then));
    }
    void orderPart(std::shared_ptr<const Model> model, std::function<void()> drawn);
    void showPreview(std::vector<ShadedBody> bodies, const Box& content);
    void endPreview(bool keepView);
    void begin(QOpenGLContext& context) override;
    void paint(unsigned framebuffer) override;
    void painted() override;
    void end() override;

    Viewport& widget;
    vtkNew<vtkGenericOpenGLRenderWindow> window;
    Scene scene;
    CameraMotion motion;
    FrameClock clock;
    QTimer rest, flash, breath, turn;
    bool waiting = false; ///< whether to paint after the pause
    FrameClock::Clock::time_point paintBegan;
    std::optional<FrameClock::Clock::time_point> paintedCut; ///< of the current paint
    InteractiveTool* tool = nullptr;
    InteractiveTool* handles = nullptr; ///< offered events before the tool
    ToolMarks marks;
    std::optional<PressMark> press;
    std::optional<PenState> pen;        ///< the pen that the current event comes from; empty: the mouse
    QPointF penAt;                      ///< position of its last event
    QElapsedTimer penClock;             ///< since then
    bool penNear = false;               ///< whether it was heard since it came near
    bool penTouches = false;            ///< whether its tip or one of its buttons is pressed
    std::optional<QPointF> sectionGrip; ///< where the pointer was last while it drags the section plane
    GuideMarks guides;
    std::vector<ObstacleMark> obstacles;
    std::optional<ZeroPlace> zero;
    std::optional<GizmoMark> gizmo;
    std::shared_ptr<const Model> part;
    std::uint64_t deviationsOrdered = 0; ///< counts setDeviations calls, like partOrdered
    std::uint64_t partOrdered = 0; ///< counts setPart calls: a part that is finished late must not replace a newer one
    std::uint64_t previewOrdered = 0;         ///< counts setPreview calls, like partOrdered
    std::optional<CameraMotion> motionBefore; ///< the camera state before the preview, while the preview is drawn
    bool previewEnds = false;                 ///< whether the preview ends with the part that was ordered last
    bool usable = false;                      ///< whether there is a context that can draw
    bool failureTold = false;
    bool flashLit = true;
    bool paintedMoving = true;      ///< whether the newest paint was made in motion
    bool flying = false;            ///< whether the camera animation continues after the current paint
    std::unique_ptr<Canvas> canvas; ///< last member, because its destruction still uses the above
};

} // namespace burin

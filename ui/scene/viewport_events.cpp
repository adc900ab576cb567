// SPDX-FileCopyrightText: 2026 The Burin authors
// SPDX-License-Identifier: Apache-2.0
#include "ui/scene/camera_view.h"
#include "ui/scene/viewport.h"
#include "ui/scene/viewport_impl.h"

#include <QKeyEvent>
#include <QMouseEvent>
#include <QPointingDevice>
#include <QTabletEvent>
#include <QWheelEvent>

#include <algorithm>
#include <cmath>
#include <utility>

namespace burin {
namespace {

constexpr double mostTilt = 75.0;   // degrees; drivers report 60 at most
constexpr qint64 penSilence = 1000; // ms without an event: a pen that touches was unplugged, as a hand always trembles

/// The pen in the setup frame. Qt's tilts are angles from the perpendicular of the tablet, in degrees: to its right,
/// and towards its user.
PenState penOf(const QTabletEvent& event, const CameraView& view) {
    const glm::dvec3 right = axesOf(view).right;                          // horizontal, as the picture never rolls
    const glm::dvec3 away = glm::cross(glm::dvec3(0.0, 0.0, 1.0), right); // from the user, seen from above
    const auto slope = [](double degrees) { return std::tan(glm::radians(std::clamp(degrees, -mostTilt, mostTilt))); };
    PenState pen;
    pen.pressure = std::clamp(event.pressure(), 0.0, 1.0);
    pen.axis = glm::normalize(glm::dvec3(0.0, 0.0, 1.0) + slope(event.xTilt()) * right - slope(event.yTilt()) * away);
    pen.eraser = event.pointerType() == QPointingDevice::PointerType::Eraser;
    return pen;
}

} // namespace

void Viewport::pressPointer(const QSinglePointEvent& event) {
    const QPointF position = event.position();
    if (event.button() == Qt::LeftButton) {
        if (const auto face = ViewCube::faceAt(impl_->motion.view(), impl_->motion.size(), position))
            return setStandardView(*face);
        if (impl_->onSectionGrip(position)) {
            impl_->sectionGrip = position;
            return;
        }
    }
    const ViewportEvent sighted = impl_->eventAt(event);
    if (impl_->offered([&](InteractiveTool& tool) { return tool.press(sighted); })) return;
    if (event.button() != Qt::MiddleButton && event.button() != Qt::RightButton) return;
    const bool both = event.buttons().testFlags(Qt::MiddleButton | Qt::RightButton);
    const bool pan = both || (event.button() == Qt::MiddleButton && event.modifiers().testFlag(Qt::ShiftModifier));
    impl_->motion.beginDrag(pan ? CameraMotion::Drag::pan : CameraMotion::Drag::orbit, position,
                            impl_->pivotAt(position));
}

void Viewport::movePointer(const QSinglePointEvent& event) {
    const QPointF position = event.position();
    if (impl_->motion.dragging() != CameraMotion::Drag::none) {
        impl_->motion.drag(position, CameraMotion::Clock::now(), impl_->flight());
        return impl_->moved();
    }
    if (impl_->sectionGrip) return impl_->dragSection(position);
    const bool pressed = event.buttons() != Qt::NoButton;
    const ViewportEvent sighted = impl_->eventAt(event);
    const bool onHandle = impl_->onHandle(sighted);
    setCursor(onHandle || (!pressed && impl_->onSectionGrip(position)) ? Qt::SizeAllCursor : Qt::ArrowCursor);
    impl_->hoverCube(pressed ? std::nullopt : std::optional(position));
    if (InteractiveTool* tool = impl_->toolInHand(); tool != nullptr && !onHandle) tool->move(sighted);
}

void Viewport::releasePointer(const QSinglePointEvent& event) {
    if (event.button() == Qt::LeftButton && std::exchange(impl_->sectionGrip, std::nullopt)) return;
    if (!event.buttons().testAnyFlags(Qt::MiddleButton | Qt::RightButton)) impl_->motion.endDrag();
    const ViewportEvent sighted = impl_->eventAt(event);
    impl_->offered([&](InteractiveTool& tool) { return tool.release(sighted); });
}

// Some platforms send the motion of a pen as that of the mouse as well, which then rests.

void Viewport::mousePressEvent(QMouseEvent* event) {
    if (impl_->penTouches && impl_->penClock.hasExpired(penSilence)) losePen();
    if (impl_->penTouches) return;
    impl_->pen.reset();
    pressPointer(*event);
}

void Viewport::mouseMoveEvent(QMouseEvent* event) {
    if (impl_->penTouches) return;
    impl_->pen.reset();
    movePointer(*event);
}

void Viewport::mouseReleaseEvent(QMouseEvent* event) {
    if (impl_->penTouches) return;
    impl_->pen.reset();
    releasePointer(*event);
}

void Viewport::tabletEvent(QTabletEvent* event) {
    event->accept(); // otherwise Qt would send it as a mouse event, without pressure
    impl_->pen = penOf(*event, impl_->motion.view());
    impl_->penAt = event->position();
    impl_->penClock.start();
    impl_->penTouches = event->buttons() != Qt::NoButton;
    if (!std::exchange(impl_->penNear, true)) emit penNoticed();
    if (event->type() == QEvent::TabletPress) {
        setFocus(Qt::MouseFocusReason); // as a click of the mouse does
        pressPointer(*event);
    } else if (event->type() == QEvent::TabletRelease) {
        releasePointer(*event);
    } else {
        movePointer(*event);
    }
}

/// The application alone hears that a pen has left its tablet.
bool Viewport::eventFilter(QObject* watched, QEvent* event) {
    if (event->type() == QEvent::TabletLeaveProximity && impl_->penNear) losePen();
    return QWidget::eventFilter(watched, event);
}

/// Ends what the pen was doing, also if its release was never reported.
void Viewport::losePen() {
    impl_->penNear = impl_->penTouches = false;
    impl_->pen.reset();
    impl_->sectionGrip.reset();
    impl_->motion.endDrag();
    const ViewportEvent sighted = sight(impl_->penAt); // without a button
    impl_->offered([&](InteractiveTool& tool) { return tool.move(sighted); });
}

void Viewport::mouseDoubleClickEvent(QMouseEvent* event) {
    mousePressEvent(event); // two quick strokes are two strokes
}

void Viewport::wheelEvent(QWheelEvent* event) {
    event->accept();
    const QPoint angle = event->angleDelta(); // some platforms swap the axes while a modifier is down
    ViewportEvent sighted = impl_->eventAt(*event);
    sighted.wheelSteps = (angle.y() != 0 ? angle.y() : angle.x()) / 120.0;
    if (impl_->offered([&](InteractiveTool& tool) { return tool.wheel(sighted); })) return;
    impl_->motion.zoom(sighted.wheelSteps, impl_->pivotAt(event->position()));
    impl_->moved();
}

void Viewport::keyPressEvent(QKeyEvent* event) {
    // Only keys that move in steps may repeat; a key that switches the spindle would toggle it rapidly while held.
    const bool mayRepeat = event->key() >= Qt::Key_Left && event->key() <= Qt::Key_PageDown;
    if (event->isAutoRepeat() && !mayRepeat) return;
    if (impl_->offered([&](InteractiveTool& tool) { return tool.key(event->key(), event->modifiers()); })) return;
    QWidget::keyPressEvent(event);
}

void Viewport::leaveEvent(QEvent* event) {
    impl_->hoverCube(std::nullopt);
    for (InteractiveTool* tool : {impl_->handles, impl_->toolInHand()})
        if (tool != nullptr) tool->leave();
    QWidget::leaveEvent(event);
}

} // namespace burin

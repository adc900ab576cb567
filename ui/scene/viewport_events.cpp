// SPDX-FileCopyrightText: 2026 The Burin authors
// SPDX-License-Identifier: Apache-2.0
#include "ui/scene/viewport.h"
#include "ui/scene/viewport_impl.h"

#include <QKeyEvent>
#include <QMouseEvent>
#include <QWheelEvent>

#include <cmath>

namespace burin {

void Viewport::mousePressEvent(QMouseEvent* event) {
    const QPointF position = event->position();
    if (event->button() == Qt::LeftButton) {
        if (const auto face = ViewCube::faceAt(impl_->motion.view(), impl_->motion.size(), position))
            return setStandardView(*face);
        if (impl_->onSectionGrip(position)) {
            impl_->sectionGrip = position;
            return;
        }
    }
    if (InteractiveTool* tool = impl_->toolInHand();
        tool != nullptr && tool->press(impl_->eventAt(*event, event->modifiers())))
        return;
    if (event->button() != Qt::MiddleButton && event->button() != Qt::RightButton) return;
    const bool both = event->buttons().testFlags(Qt::MiddleButton | Qt::RightButton);
    const bool pan = both || (event->button() == Qt::MiddleButton && event->modifiers().testFlag(Qt::ShiftModifier));
    impl_->motion.beginDrag(pan ? CameraMotion::Drag::pan : CameraMotion::Drag::orbit, position,
                            impl_->pivotAt(position));
}

void Viewport::mouseMoveEvent(QMouseEvent* event) {
    if (impl_->motion.dragging() != CameraMotion::Drag::none) {
        impl_->motion.drag(event->position(), CameraMotion::Clock::now(), impl_->flight());
        return impl_->moved();
    }
    if (impl_->sectionGrip) return impl_->dragSection(event->position());
    const bool pressed = event->buttons() != Qt::NoButton;
    setCursor(!pressed && impl_->onSectionGrip(event->position()) ? Qt::SizeAllCursor : Qt::ArrowCursor);
    impl_->hoverCube(pressed ? std::nullopt : std::optional(event->position()));
    if (InteractiveTool* tool = impl_->toolInHand()) tool->move(impl_->eventAt(*event, event->modifiers()));
}

void Viewport::mouseReleaseEvent(QMouseEvent* event) {
    if (event->button() == Qt::LeftButton && std::exchange(impl_->sectionGrip, std::nullopt)) return;
    if (!event->buttons().testAnyFlags(Qt::MiddleButton | Qt::RightButton)) impl_->motion.endDrag();
    if (InteractiveTool* tool = impl_->toolInHand()) tool->release(impl_->eventAt(*event, event->modifiers()));
}

void Viewport::mouseDoubleClickEvent(QMouseEvent* event) {
    mousePressEvent(event); // two quick strokes are two strokes
}

void Viewport::wheelEvent(QWheelEvent* event) {
    event->accept();
    const QPoint angle = event->angleDelta(); // some platforms swap the axes while a modifier is down
    ViewportEvent sighted = impl_->eventAt(*event, event->modifiers());
    sighted.wheelSteps = (angle.y() != 0 ? angle.y() : angle.x()) / 120.0;
    if (InteractiveTool* tool = impl_->toolInHand(); tool != nullptr && tool->wheel(sighted)) return;
    impl_->motion.zoom(sighted.wheelSteps, impl_->pivotAt(event->position()));
    impl_->moved();
}

void Viewport::keyPressEvent(QKeyEvent* event) {
    // Only keys that move in steps may repeat; a key that switches the spindle would toggle it rapidly while held.
    const bool mayRepeat = event->key() >= Qt::Key_Left && event->key() <= Qt::Key_PageDown;
    if (event->isAutoRepeat() && !mayRepeat) return;
    if (InteractiveTool* tool = impl_->toolInHand(); tool != nullptr && tool->key(event->key(), event->modifiers()))
        return;
    QWidget::keyPressEvent(event);
}

void Viewport::leaveEvent(QEvent* event) {
    impl_->hoverCube(std::nullopt);
    if (InteractiveTool* tool = impl_->toolInHand()) tool->leave();
    QWidget::leaveEvent(event);
}

} // namespace burin

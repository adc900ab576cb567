// SPDX-FileCopyrightText: 2026 The Burin authors
// SPDX-License-Identifier: Apache-2.0
#include "ui/input/gizmo_tool.h"

#include "core/base/units.h"
#include "ui/scene/camera_view.h"
#include "ui/scene/gizmo_geometry.h"

#include <cmath>

namespace burin {

namespace {

constexpr double finePart = 0.1; // of the pointer's motion, with Shift
constexpr double inch = 25.4;    // mm
constexpr double clickReach = 3; // pixels: a pointer that stays within this clicks

/// Steps as they are displayed, so that the value beside the pointer is the one that is applied.
GizmoSteps stepsFor(Qt::KeyboardModifiers modifiers, LengthUnit unit) {
    const double size = unit == LengthUnit::inch ? 0.1 * inch : 1.0;
    if (modifiers.testFlag(Qt::ControlModifier)) return {size, pi / 36.0};
    const double share = modifiers.testFlag(Qt::ShiftModifier) ? 0.001 : 0.01;
    return {share * size, share * 10.0 * pi / 180.0};
}

} // namespace

void GizmoTool::setGizmo(const std::optional<Gizmo>& gizmo) {
    if (dragging() && gizmo) return;
    gizmo_ = gizmo;
    if (gizmo_) return;
    drag_.reset();
    light({});
}

void GizmoTool::cancel() {
    if (!dragging()) return;
    drag_.reset();
    emit cancelled();
}

void GizmoTool::light(const std::optional<GizmoHandle>& handle) {
    if (handle == lit_) return;
    lit_ = handle;
    emit litChanged();
}

bool GizmoTool::press(const ViewportEvent& event) {
    if (dragging()) return true; // the view stays as it is during a drag
    if (!gizmo_ || event.button != Qt::LeftButton) return false;
    const CameraView& view = viewport_.cameraView();
    const QSizeF size(viewport_.size());
    const std::optional<GizmoHandle> handle = handleAt(*gizmo_, view, size, event.position);
    if (!handle) return false;
    pointer_ = event.position;
    moves_ = false;
    lit_ = handle;
    drag_.emplace(*handle, gizmo_->centre, sightOf(event), gizmoRingRadius * pixelAt(view, size, gizmo_->centre));
    emit began();
    return true;
}

GizmoMotion GizmoTool::follow(const ViewportEvent& event) {
    pointer_ = event.position;
    drag_->follow(sightOf(event), event.modifiers.testFlag(Qt::ShiftModifier) ? finePart : 1.0);
    return drag_->motion(stepsFor(event.modifiers, unit_));
}

bool GizmoTool::move(const ViewportEvent& event) {
    if (!dragging()) {
        const bool free = gizmo_ && event.buttons == Qt::NoButton;
        light(free ? handleAt(*gizmo_, viewport_.cameraView(), QSizeF(viewport_.size()), event.position)
                   : std::nullopt);
        return lit_.has_value();
    }
    if (!event.buttons.testFlag(Qt::LeftButton)) { // the release was sent to another window
        cancel();
        return true;
    }
    const QPointF drag = event.position - pointer_;
    moves_ = moves_ || std::hypot(drag.x(), drag.y()) > clickReach;
    if (!moves_) return true;
    const GizmoMotion motion = follow(event);
    emit moved(drag_->handle(), motion);
    return true;
}

bool GizmoTool::release(const ViewportEvent& event) {
    if (!dragging() || event.button != Qt::LeftButton) return dragging();
    if (!moves_) {
        drag_.reset();
        emit clicked();
        return true;
    }
    const GizmoMotion motion = follow(event);
    const GizmoHandle handle = drag_->handle();
    drag_.reset();
    emit released(handle, motion);
    return true;
}

bool GizmoTool::wheel(const ViewportEvent&) {
    return dragging();
}

bool GizmoTool::key(int key, Qt::KeyboardModifiers) {
    if (key != Qt::Key_Escape || !dragging()) return dragging();
    cancel();
    return true;
}

QString GizmoTool::escapeMeaning() {
    return dragging() ? tr("Esc: back to where it was") : QString();
}

void GizmoTool::leave() {
    if (!dragging()) light({});
}

} // namespace burin

// SPDX-FileCopyrightText: 2026 The Burin authors
// SPDX-License-Identifier: Apache-2.0
#pragma once

#include "ui/scene/gizmo_drag.h"
#include "ui/scene/viewport.h"

#include <QObject>

#include <optional>

namespace burin {

/// Moves and rotates an object by the handles of a gizmo: drag with the left button; a click is left to what lies
/// behind the handle. Shift: a tenth of the pointer's motion; Ctrl: in whole steps (1 mm or 0.1 in, 5°). Esc returns
/// the object to where it was. Thread: user interface.
class GizmoTool final : public QObject, public InteractiveTool {
    Q_OBJECT
public:
    /// @param viewport that offers its events to this tool; must outlive it
    explicit GizmoTool(const Viewport& viewport, QObject* parent = nullptr) : QObject(parent), viewport_(viewport) {}
    /// Sets the gizmo that can be gripped; while a handle is dragged, it stays the one that was gripped. Empty: none;
    /// this ends a drag without a signal.
    void setGizmo(const std::optional<Gizmo>& gizmo);
    void setUnit(LengthUnit unit) { unit_ = unit; }
    /// The handle under the pointer, or being dragged.
    std::optional<GizmoHandle> lit() const noexcept { return drag_ ? std::optional(drag_->handle()) : lit_; }
    bool dragging() const noexcept { return drag_.has_value(); }
    const QPointF& pointer() const noexcept { return pointer_; } ///< device-independent pixels
    void cancel();                                               ///< does nothing unless dragging

    bool press(const ViewportEvent& event) override;
    bool move(const ViewportEvent& event) override;
    bool release(const ViewportEvent& event) override;
    bool wheel(const ViewportEvent& event) override;
    bool key(int key, Qt::KeyboardModifiers modifiers) override;
    QString escapeMeaning() override;
    void leave() override;

signals:
    void litChanged();
    void began();
    /// @param motion since the press, of the gripped handle
    void moved(const burin::GizmoHandle& handle, const burin::GizmoMotion& motion);
    void released(const burin::GizmoHandle& handle, const burin::GizmoMotion& motion);
    void cancelled();
    void clicked(); ///< at `pointer`: the button was released where it was pressed

private:
    void light(const std::optional<GizmoHandle>& handle);
    GizmoMotion follow(const ViewportEvent& event);

    const Viewport& viewport_;
    LengthUnit unit_ = LengthUnit::millimetre;
    std::optional<Gizmo> gizmo_;
    std::optional<GizmoHandle> lit_; ///< under the pointer
    std::optional<GizmoDrag> drag_;
    QPointF pointer_;
    bool moves_ = false; ///< whether the pointer has left the point of the press
};

} // namespace burin

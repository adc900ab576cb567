// SPDX-FileCopyrightText: 2026 The Burin authors
// SPDX-License-Identifier: Apache-2.0
#pragma once

#include "ui/actions/actions.h"
#include "ui/input/gizmo_tool.h"
#include "ui/panels/job_states.h"
#include "ui/window/presenter.h"
#include "ui/window/setup_presenters.h"

#include <memory>
#include <optional>

namespace burin {

/// The gizmo in the view: on the part while its step is shown and it may be placed, on a fixture while it is placed or
/// moved. A drag of the part is shown at once and becomes one placement when it ends; a fixture follows as by its
/// dialog or by its keys.
class GizmoPresenter final : public Presenter {
    Q_OBJECT
public:
    /// All outlive it.
    GizmoPresenter(Workbench& workbench, Viewport& viewport, const PartPresenter& part, const Actions& actions,
                   QObject* parent);
    ~GizmoPresenter() override;
    void setUnit(LengthUnit unit) override;
    void setShown(JobStep step);

signals:
    void escapeChanged(); ///< the meaning of Esc may have changed

private:
    void present() override;
    std::optional<Gizmo> gizmo() const;
    bool partPlaceable() const;
    bool partDragged() const noexcept { return !fixture_ && !obstacle_; }
    Placement placementOf(const GizmoHandle& handle, const GizmoMotion& motion) const;
    QString valueOf(const GizmoHandle& handle, const GizmoMotion& motion) const;
    void begin();
    void follow(const GizmoHandle& handle, const GizmoMotion& motion);
    void end(const GizmoHandle& handle, const GizmoMotion& motion);
    void click();
    void giveUp();
    void finish();
    void draw();

    Viewport& viewport_;
    const PartPresenter& part_;
    const Actions& actions_;
    GizmoTool tool_;
    JobStep step_ = JobStep::part;
    std::optional<Gizmo> shown_;
    GizmoMark mark_;
    // Of a drag, as it began:
    Gizmo from_;
    std::optional<FixtureDesign> fixture_; ///< of the library, which is being placed
    std::optional<Placement> obstacle_;    ///< motion of any other one; neither: the part is dragged
    /// The part that is drawn moved: the one that is dragged, or whose new placement is being computed.
    std::shared_ptr<const Model> moving_;
};

} // namespace burin

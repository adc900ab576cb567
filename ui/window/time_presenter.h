// SPDX-FileCopyrightText: 2026 The Burin authors
// SPDX-License-Identifier: Apache-2.0
#pragma once

#include "ui/actions/actions.h"
#include "ui/panels/job_states.h"
#include "ui/panels/timeline_panel.h"
#include "ui/window/presenter.h"
#include "ui/window/scene_presenter.h"

namespace burin {

/// The timeline, and the state at its moment in the view: workpiece, tool, hand and force.
class TimePresenter final : public Presenter {
    Q_OBJECT
public:
    TimePresenter(Workbench& workbench, TimelinePanel& panel, ScenePresenter& scene, QObject* parent);
    void setUnit(LengthUnit unit) override;
    void connectActions(const Actions& actions);
    /// In the program step the program's timeline is shown, in the path step the chosen part of the path is marked.
    void setShown(JobStep step);

signals:
    void lineReached(int line); ///< of the program, from 1
    void breakpointAsked();     ///< for the line with the text cursor

private:
    void present() override;
    void showMoment();
    void followProgram();
    void followPath();
    std::vector<TimeMarker> markers() const;
    std::vector<GrowingClip> growing() const;
    std::optional<PointedTime> pointed() const;

    TimelinePanel& panel_;
    ScenePresenter& scene_;
    JobStep step_ = JobStep::part;
    std::optional<SourceInterval> pointed_; ///< on the path, followed last
    int line_ = 0;                          ///< reported last
};

} // namespace burin

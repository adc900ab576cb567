// SPDX-FileCopyrightText: 2026 The Burin authors
// SPDX-License-Identifier: Apache-2.0
#pragma once

#include "ui/actions/actions.h"
#include "ui/panels/path_panel.h"
#include "ui/panels/program_panel.h"
#include "ui/window/path_scene_presenter.h"
#include "ui/window/presenter.h"

namespace burin {

// The panels of the steps after milling.

class PathPresenter final : public Presenter {
    Q_OBJECT
public:
    PathPresenter(Workbench& workbench, PathPanel& panel, PathScenePresenter& scene, QObject* parent);
    void setUnit(LengthUnit unit) override;
    /// New path, evaluation, drawing a part of it, showing it.
    void connectActions(const Actions& actions);
    /// Shows the dialog again after its holes were picked.
    void askAgain(RequestedPass wanted);

signals:
    /// The user picks the holes of a pass in the view; `askAgain` is called then.
    void holesRequested(const burin::RequestedPass& wanted);

private:
    void present() override;
    TimelinesPlace atTime() const;
    void askPass();
    void askChange(std::int64_t pass);
    void askFrom(const RequestedPass& last);
    bool hasPass(std::int64_t id) const;
    std::optional<RequestedPass> asked(const RequestedPass& last, const PlanRegion& painted);

    PathPanel& panel_;
    PathScenePresenter& scene_;
    RequestedPass lastPass_; ///< without its drawings
};

class ProgramPresenter final : public Presenter {
    Q_OBJECT
public:
    ProgramPresenter(Workbench& workbench, ProgramPanel& panel, QObject* parent);
    void setUnit(LengthUnit unit) override;
    /// Posting, and the requests of the panel to the window.
    void connectActions(const Actions& actions);

private:
    void present() override;
    void showPaths(ProgramState& state) const;
    ProgramPanel& panel_;
};

/// The kind of a pass, or the file name of the program that it was read from.
QString passName(const GeneratedInfo& pass);
/// The project's name, or the part's if the project has no name yet.
QString jobName(const Workbench& workbench);
/// The file name of a project's program: the job's name, the setup's name if there are several, and the suffix of the
/// dialect.
QString programName(const Workbench& workbench);

} // namespace burin

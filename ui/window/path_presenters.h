// SPDX-FileCopyrightText: 2026 The Burin authors
// SPDX-License-Identifier: Apache-2.0
#pragma once

#include "ui/actions/actions.h"
#include "ui/panels/path_panel.h"
#include "ui/panels/program_panel.h"
#include "ui/window/path_scene_presenter.h"
#include "ui/window/presenter.h"

namespace burin {

// The panels of what comes after milling.

class PathPresenter final : public Presenter {
    Q_OBJECT
public:
    PathPresenter(Workbench& workbench, PathPanel& panel, PathScenePresenter& scene, QObject* parent);
    void setUnit(LengthUnit unit) override;
    /// A new path, its evaluation, drawing a part of it, showing it.
    void connectActions(const Actions& actions);

private:
    void present() override;
    void askPass();
    void askChange(std::int64_t pass);
    std::optional<WantedPass> asked(const WantedPass& last, const PlanRegion& painted);

    PathPanel& panel_;
    PathScenePresenter& scene_;
    WantedPass lastPass_; ///< without its drawings
};

class ProgramPresenter final : public Presenter {
    Q_OBJECT
public:
    ProgramPresenter(Workbench& workbench, ProgramPanel& panel, QObject* parent);
    void setUnit(LengthUnit unit) override;
    /// Posting, and what the panel asks the window for.
    void connectActions(const Actions& actions);

private:
    void present() override;
    void showPaths(ProgramState& state) const;
    ProgramPanel& panel_;
};

/// What a pass is, or the file of the program that it is of.
QString passName(const GeneratedInfo& pass);
/// The project's name, or that of the part as long as it has none.
QString jobName(const Workbench& workbench);
/// The name of the file that a project's program gets: the job's, that of the setup where there are several, the suffix
/// of its dialect.
QString programName(const Workbench& workbench);

} // namespace burin

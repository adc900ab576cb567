// SPDX-FileCopyrightText: 2026 The Burin authors
// SPDX-License-Identifier: Apache-2.0
#pragma once

#include "ui/window/area_presenter.h"
#include "ui/window/comparison_presenter.h"
#include "ui/window/deviation_presenter.h"
#include "ui/window/excess_presenter.h"
#include "ui/window/face_presenter.h"
#include "ui/window/fixture_presenter.h"
#include "ui/window/gizmo_presenter.h"
#include "ui/window/guide_presenter.h"
#include "ui/window/guide_scene_presenter.h"
#include "ui/window/hand_presenter.h"
#include "ui/window/hole_presenter.h"
#include "ui/window/job_presenter.h"
#include "ui/window/measure_presenter.h"
#include "ui/window/mill_presenter.h"
#include "ui/window/obstacle_move_presenter.h"
#include "ui/window/panel_stack.h"
#include "ui/window/path_presenters.h"
#include "ui/window/path_scene_presenter.h"
#include "ui/window/program_scene_presenter.h"
#include "ui/window/scene_presenter.h"
#include "ui/window/setup_presenters.h"
#include "ui/window/setups_presenter.h"
#include "ui/window/status_presenter.h"
#include "ui/window/stylus_edit_presenter.h"
#include "ui/window/surroundings_presenter.h"
#include "ui/window/time_presenter.h"
#include "ui/window/tree_presenter.h"
#include "ui/window/zero_presenter.h"

namespace burin {

/// The widgets filled by presenters. They outlive the presenters.
struct Stage {
    Viewport& viewport;
    StepBar& stepBar;
    PanelStack& panels;
    StatusLine& status;
    TimelinePanel& timeline;
    ProjectTree& tree;
};

/// All presenters of a window.
class Presenters final : public QObject {
    Q_OBJECT
public:
    Presenters(Workbench& workbench, const Actions& actions, const Stage& stage, QObject* parent);
    void setUnit(LengthUnit unit);
    /// Connects the actions that need only a presenter and its panel.
    void connectActions(const Actions& actions, const Viewport& viewport);

    MillMode millMode;
    PartPresenter part;
    SetupsPresenter setups;
    StockPresenter stock;
    ZeroPresenter zero;
    MaterialPresenter material;
    LayerPresenter layers;
    ToolPresenter tool;
    AllowancePresenter allowance;
    MillPresenter mill;
    SurroundingsPresenter surroundings;
    GuidePresenter guides;
    HandPresenter hand;
    PathScenePresenter pathScene;
    PathPresenter path;
    StylusEditPresenter stylusEdit;
    AreaPresenter area;
    ProgramPresenter program;
    MeterPresenter meters;
    StatusPresenter status;
    JobPresenter job;
    ScenePresenter scene;
    GuideScenePresenter guideScene;
    ProgramScenePresenter programScene;
    DeviationPresenter deviation;
    TimePresenter time;
    MeasurePresenter measure;
    TreePresenter tree;
    ExcessPresenter excess;
    FacePresenter faces;
    ComparisonPresenter comparison;
    FixturePresenter fixtures;
    HolePresenter holes;
    ObstacleMovePresenter obstacleMove;
    GizmoPresenter gizmo;
};

} // namespace burin

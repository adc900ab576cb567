// SPDX-FileCopyrightText: 2026 The Burin authors
// SPDX-License-Identifier: Apache-2.0
#pragma once

#include "core/job/part_update.h"
#include "ui/workbench/area_controller.h"
#include "ui/workbench/axis_tuner.h"
#include "ui/workbench/device_tester.h"
#include "ui/workbench/document_controller.h"
#include "ui/workbench/face_controller.h"
#include "ui/workbench/fixture_controller.h"
#include "ui/workbench/growing_takes.h"
#include "ui/workbench/hand_controller.h"
#include "ui/workbench/material_controller.h"
#include "ui/workbench/measure_controller.h"
#include "ui/workbench/mill_controller.h"
#include "ui/workbench/model_controller.h"
#include "ui/workbench/obstacle_mover.h"
#include "ui/workbench/pass_measurer.h"
#include "ui/workbench/pass_previewer.h"
#include "ui/workbench/pass_refresher.h"
#include "ui/workbench/pass_show.h"
#include "ui/workbench/path_comparer.h"
#include "ui/workbench/path_controller.h"
#include "ui/workbench/path_valuer.h"
#include "ui/workbench/program_controller.h"
#include "ui/workbench/score_controller.h"
#include "ui/workbench/setup_controller.h"
#include "ui/workbench/setups_controller.h"
#include "ui/workbench/sheet_controller.h"
#include "ui/workbench/show_me.h"
#include "ui/workbench/stylus_controller.h"
#include "ui/workbench/stylus_editor.h"
#include "ui/workbench/surroundings_controller.h"
#include "ui/workbench/take_deviations.h"
#include "ui/workbench/target_controller.h"
#include "ui/workbench/time_controller.h"
#include "ui/workbench/tool_controller.h"
#include "ui/workbench/view_device.h"
#include "ui/workbench/workpiece_keeper.h"

#include <QObject>

#include <memory>

namespace burin {

/// The controllers of one window and the connections between them; nothing else.
class Workbench final : public QObject {
    Q_OBJECT
    ProjectThread project_; // before what uses them
    TaskRunner tasks_;
    History undo_{project_};
    Desk desk_{project_, tasks_, undo_};
    std::shared_ptr<KeptLeads> leads_ = std::make_shared<KeptLeads>();
    bool showWhenReady_ = false;

public:
    explicit Workbench(QObject* parent = nullptr);
    ~Workbench() override; ///< ends session and tasks; unsaved work is kept for recovery

    DocumentController document;
    ModelController model;
    SetupController setup;
    StockSolidController stockSolid;
    MaterialController material;
    ToolController tool;
    TargetController target;
    WorkpieceController workpiece;
    StylusController styluses; ///< outlives the session, whose stylus may be of one of its drivers
    SessionRunner session;
    DeviceTester deviceTester;
    AxisTuner axisTuner;
    ViewDevice viewDevice;
    MillController mill;
    SurroundingsController surroundings;
    FixtureController fixtures;
    ObstacleMover mover;
    GuideController guides;
    HandController hand;
    ShowMe showMe;
    PathController path;
    StylusEditor stylusEditor;
    AreaController area;
    PassController passes;
    PassPreviewer passPreview;
    PassShow passShow;
    PassMeasurer passMeasurer;
    PassRefresher passRefresher;
    PathValuer pathValuer;
    PathComparer pathComparer;
    MeasureController measure;
    ProgramController program;
    SetupsController setups;
    SheetController sheet;
    TimeController time;
    WorkpieceKeeper keeper;
    ScoreController score;
    FaceController faces;
    TakeDeviations deviations;
    GrowingTakes growing;

    std::vector<Controller*> controllers();
    TaskRunner& tasks() noexcept { return tasks_; }
    History& undo() noexcept { return undo_; }

    /// Reads `file` and makes it the part as `adoptPart` does. On failure the open project is unchanged.
    void importPart(const std::filesystem::path& file, bool abandon);
    /// Makes a model the part: of the open project as long as it has no recordings and one setup, else of a new
    /// project.
    /// @param abandon whether to discard the unsaved changes of the open project
    void adoptPart(const std::shared_ptr<const Model>& part, bool abandon);
    /// Reads the part again and keeps setups, recordings and paths (core/job/part_update.h); ends recording and
    /// session. Emits `partUpdated`, or `failed` with nothing changed.
    void updatePart(const std::filesystem::path& file);
    bool importNeedsNewProject() const {
        return !document.isOpen() || !mill.takes().empty() || setups.setups().size() > 1;
    }
    /// Replaces the part by the same one, whose file was read in another unit; an entry of the undo stack. Setup, roles
    /// and materials stay. Returns false, and does nothing, if the part is another one by now, or if the project needs
    /// it as it is: for recordings, passes or several setups.
    bool changeUnit(const std::shared_ptr<const Model>& before, const std::shared_ptr<const Model>& part);
    /// Embeds if there is no workpiece yet and the setup allows it.
    void ensureWorkpiece();
    /// Starts the demonstration as soon as part, workpiece and boundary are ready; embeds if needed.
    void showHowItIsDone();
    /// Undoes the newest entry of the undo stack; does nothing during a stroke, while takes are changing or while the
    /// virtual operator mills. It may take a moment (History::busy).
    void undoLast();
    void redoLast();
    bool canUndoNow() const;
    /// Collects text that is still being typed. @return whether the project received any
    bool collectText();
    /// Ends recording and session, then calls `then`.
    void comeToRest(std::function<void()> then);

signals:
    void textRequested(); ///< receivers with text not passed on yet must pass it on now
    void failed(const burin::Error& error);
    void partUpdated(const burin::PartUpdate& update);
    void setupShown(const QString& title); ///< undo or redo switched to it

private:
    void serveHistory();
    WorkState workState() const;
    void goTo(const WorkState& state, const std::optional<SharedStep>& step, std::function<void(bool)> then);
    void restore(const WorkState& state);
    void hideTake(std::int64_t take, bool hidden);
    void takePart(const std::shared_ptr<const Model>& part);
    void putUpdatedInUse(const PartUpdate& update, const SharedStep& step, const WorkState& before);
    void putUpdated(const std::shared_ptr<const Model>& part);
    void wire();
    void load(const ProjectContents& contents);
    void lockSetup();
    void clear();
    void updateRequested();
    void continueShow();
};

} // namespace burin

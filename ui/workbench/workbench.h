// SPDX-FileCopyrightText: 2026 The Burin authors
// SPDX-License-Identifier: Apache-2.0
#pragma once

#include "core/job/part_update.h"
#include "ui/workbench/area_controller.h"
#include "ui/workbench/device_tester.h"
#include "ui/workbench/document_controller.h"
#include "ui/workbench/hand_controller.h"
#include "ui/workbench/material_controller.h"
#include "ui/workbench/measure_controller.h"
#include "ui/workbench/mill_controller.h"
#include "ui/workbench/model_controller.h"
#include "ui/workbench/pass_measurer.h"
#include "ui/workbench/pass_previewer.h"
#include "ui/workbench/path_controller.h"
#include "ui/workbench/path_valuer.h"
#include "ui/workbench/program_controller.h"
#include "ui/workbench/setup_controller.h"
#include "ui/workbench/setups_controller.h"
#include "ui/workbench/sheet_controller.h"
#include "ui/workbench/show_me.h"
#include "ui/workbench/stylus_controller.h"
#include "ui/workbench/surroundings_controller.h"
#include "ui/workbench/target_controller.h"
#include "ui/workbench/time_controller.h"
#include "ui/workbench/tool_controller.h"
#include "ui/workbench/view_device.h"
#include "ui/workbench/workpiece_keeper.h"

#include <QObject>
#include <QUndoStack>

namespace burin {

/// The controllers of one window and the wires between them; nothing else.
class Workbench final : public QObject {
    Q_OBJECT
    ProjectThread project_; // before what uses them
    TaskRunner tasks_;
    QUndoStack undo_;
    Desk desk_{project_, tasks_, undo_};
    bool showWhenReady_ = false;

public:
    explicit Workbench(QObject* parent = nullptr);
    ~Workbench() override; ///< ends session and tasks; what was not saved waits to be taken up again

    DocumentController document;
    ModelController model;
    SetupController setup;
    MaterialController material;
    ToolController tool;
    TargetController target;
    WorkpieceController workpiece;
    StylusController styluses; ///< outlives the session, whose stylus may be of one of its drivers
    SessionRunner session;
    DeviceTester deviceTester;
    ViewDevice viewDevice;
    MillController mill;
    SurroundingsController surroundings;
    GuideController guides;
    HandController hand;
    ShowMe showMe;
    PathController path;
    AreaController area;
    PassController passes;
    PassPreviewer passPreview;
    PassMeasurer passMeasurer;
    PathValuer pathValuer;
    MeasureController measure;
    ProgramController program;
    SetupsController setups;
    SheetController sheet;
    TimeController time;
    WorkpieceKeeper keeper;

    std::vector<Controller*> controllers();
    TaskRunner& tasks() noexcept { return tasks_; }
    QUndoStack& undo() noexcept { return undo_; }

    /// Reads `file`, and makes it the part as `adoptPart` does. What is open stays as it is where that fails.
    /// @param fileUnit mm per unit of a file that states none
    void importPart(const std::filesystem::path& file, bool abandon, double fileUnit = 1.0);
    /// Makes a model the part: in the open project as long as that has no recordings and one setup, in a new one
    /// otherwise.
    /// @param abandon what the project then had unsaved is not wanted
    void adoptPart(const std::shared_ptr<const Model>& part, bool abandon);
    /// Reads the part again and keeps setups, recordings and paths (core/job/part_update.h); ends recording and
    /// session. Tells `partUpdated`, or `failed`, and nothing has changed then.
    void updatePart(const std::filesystem::path& file);
    bool importNeedsNewProject() const {
        return !document.isOpen() || !mill.takes().empty() || setups.setups().size() > 1;
    }
    /// Embeds where there is no workpiece yet and the setup allows one.
    void ensureWorkpiece();
    /// Shows how it is done as soon as part, workpiece and boundary are there; embeds where that is missing.
    void showHowItIsDone();
    /// The newest entry of the undo stack; nothing happens while a stroke is under way or the virtual operator mills.
    void undoLast();
    void redoLast();
    bool canUndoNow() const;
    /// Takes over what is still being typed. @return whether the project got something of it
    bool collectText();
    /// Ends recording and session, then calls `then`.
    void comeToRest(std::function<void()> then);

signals:
    void textWanted(); ///< who has text that was not told yet tells it now
    void failed(const burin::Error& error);
    void partUpdated(const burin::PartUpdate& update);

private:
    void putUpdated(const std::shared_ptr<const Model>& part);
    void wire();
    void load(const ProjectContents& contents);
    void lockSetup();
    void clear();
    void updateWanted();
    void continueShow();
};

} // namespace burin

// SPDX-FileCopyrightText: 2026 The Burin authors
// SPDX-License-Identifier: Apache-2.0
#include "ui/workbench/workbench.h"

#include "core/cad/file_unit.h"

#include <algorithm>
#include <initializer_list>

namespace burin {

namespace {

/// Larger paths are evaluated only on request: edits take some 300 bytes a sample, and opening a project must take 1.5
/// GB at most.
constexpr std::uint64_t mostSamplesUnasked = 5'000'000;

std::uint64_t samplesOf(const std::vector<TakeInfo>& takes) {
    std::uint64_t samples = 0;
    for (const TakeInfo& take : takes) samples += take.sampleCount - take.undoneCount;
    return samples;
}

} // namespace

Workbench::Workbench(QObject* parent)
    : QObject(parent)
    , document(desk_, this)
    , model(desk_, this)
    , setup(desk_, this)
    , stockSolid(desk_, setup, this)
    , material(desk_, this)
    , tool(desk_, this)
    , target(desk_, this)
    , workpiece(desk_, this)
    , styluses(desk_, this)
    , session(desk_, this)
    , deviceTester(desk_, styluses, session, this)
    , axisTuner(desk_, styluses, this)
    , viewDevice(desk_, styluses, session, this)
    , mill(desk_, workpiece, session, styluses, this)
    , surroundings(desk_, workpiece, mill, session, this)
    , fixtures(desk_, workpiece, stockSolid, surroundings, this)
    , mover(desk_, workpiece, stockSolid, surroundings, this)
    , guides(desk_, workpiece, mill, session, this)
    , hand(desk_, workpiece, mill, session, styluses, guides, this)
    , showMe(desk_, workpiece, session, this)
    , path(desk_, workpiece, tool, this)
    , stylusEditor(desk_, workpiece, mill, session, styluses, hand, path, this)
    , area(desk_, this)
    , passes(desk_, workpiece, path, tool, leads_, this)
    , passPreview(desk_, workpiece, path, tool, leads_, this)
    , passShow(desk_, passPreview, this)
    , passMeasurer(desk_, workpiece, path, this)
    , passRefresher(desk_, workpiece, path, tool, leads_, this)
    , pathValuer(desk_, workpiece, path, this)
    , pathComparer(desk_, workpiece, path, this)
    , measure(desk_, setup, workpiece, this)
    , program(desk_, workpiece, path, target, this)
    , setups(desk_, {document, setup, workpiece, program, target}, this)
    , sheet(desk_, this)
    , time(desk_, workpiece, session, mill, this)
    , keeper(desk_, workpiece, session, mill, this)
    , score(desk_, workpiece, session, mill, this)
    , faces(desk_, this)
    , deviations(desk_, workpiece, session, time, this)
    , growing(desk_, session, this) {
    wire();
}

Workbench::~Workbench() {
    for (Controller* controller : controllers()) controller->blockSignals(true); // the receivers no longer exist
    tasks_.cancelAll();
    session.end();
    project_.finish();
}

std::vector<Controller*> Workbench::controllers() {
    return {&document,   &model,        &setup,      &material,      &tool,         &target,     &workpiece, &styluses,
            &session,    &deviceTester, &viewDevice, &mill,          &surroundings, &guides,     &hand,      &showMe,
            &path,       &area,         &passes,     &passMeasurer,  &pathValuer,   &measure,    &program,   &setups,
            &sheet,      &time,         &keeper,     &faces,         &pathComparer, &score,      &fixtures,  &axisTuner,
            &deviations, &growing,      &passShow,   &passRefresher, &stylusEditor, &stockSolid, &mover};
}

void Workbench::wire() {
    for (Controller* controller : controllers()) connect(controller, &Controller::failed, this, &Workbench::failed);
    serveHistory();
    connect(&project_, &ProjectThread::failed, this, &Workbench::failed);
    // Fields show what was refused, until they show the state again. Not those of materials: the setup would store
    // them.
    for (Controller* controller : std::initializer_list<Controller*>{&model, &setup, &tool, &target, &mill,
                                                                     &surroundings, &guides, &hand, &path, &area})
        connect(&project_, &ProjectThread::failed, controller, &Controller::changed);
    connect(&document, &DocumentController::opened, this, [this](const ProjectContents& contents) {
        undo_.clear();
        load(contents);
    });
    connect(&document, &DocumentController::setupUsed, this, &Workbench::load);
    connect(&document, &DocumentController::closed, this, &Workbench::clear);
    connect(&setups, &SetupsController::added, this, &Workbench::ensureWorkpiece);
    setups.setRest([this](std::function<void()> then) { comeToRest(std::move(then)); });
    connect(&model, &ModelController::exchanged, this, [this] {
        setup.exchangeModel(model.model());
        workpiece.clear(); // it is that of the other part
    });
    connect(&model, &ModelController::imported, this, [this] {
        workpiece.clear();
        area.load({});
        path.load({}, {}, {});
        program.load({}, {});
        setup.placeAround(model.model());
    });
    connect(&setup, &SetupController::changed, this, &Workbench::updateRequested);
    connect(&surroundings, &Controller::changed, this, [this] { workpiece.setRequested(surroundings.wanted()); });
    connect(&workpiece, &WorkpieceController::readersStop, &stockSolid, &StockSolidController::pause);
    connect(&workpiece, &WorkpieceController::readersGoOn, &stockSolid, &StockSolidController::goOn);
    connect(&workpiece, &WorkpieceController::surroundingsChanged, &path, &PathController::workpieceRemade);
    connect(&workpiece, &WorkpieceController::machineChanged, &path, &PathController::workpieceRemade);
    connect(&stylusEditor, &StylusEditor::entered, &surroundings, [this] { surroundings.setEditing(true); });
    connect(&stylusEditor, &StylusEditor::left, &surroundings, [this] { surroundings.setEditing(false); });
    connect(&material, &Controller::changed, &setup, &SetupController::readLibrary);
    connect(&tool, &ToolController::chosen, this, &Workbench::updateRequested);
    connect(&target, &Controller::changed, this, [this] { workpiece.setRequested(target.machine()); });
    connect(&mill, &MillController::takesChanged, this, [this] {
        lockSetup();
        path.takesChanged(mill.allTakes(), mill.takes(), mill.newestStrokes());
    });
    connect(&mill, &MillController::takeUndone, this, &Workbench::hideTake);
    connect(&session, &SessionRunner::recordingStarted, this, [this] {
        path.recordingBegins();
        setup.setLocked(true);
    });
    connect(&path, &Controller::changed, this, &Workbench::lockSetup); // passes may have been added or removed
    connect(&program, &ProgramController::textRequested, this, &Workbench::textRequested);
    connect(&workpiece, &Controller::failed, this, [this] { showWhenReady_ = false; });
    connect(&session, &SessionRunner::changed, this, [this] { tool.setLocked(mill.recording() || showMe.showing()); });
    connect(&mill, &MillController::changed, this, [this] {
        std::vector<std::string> ids;
        for (const TakeInfo& take : mill.takes()) ids.push_back(take.toolId);
        tool.setMilledWith(std::move(ids));
    });
    connect(&workpiece, &WorkpieceController::changed, this, &Workbench::continueShow);
    connect(&workpiece, &WorkpieceController::replayed, &mill, &MillController::setStrokes);
    connect(&workpiece, &WorkpieceController::replayed, this, [this] { // a project shows its paths when opened
        if (samplesOf(mill.takes()) <= mostSamplesUnasked) path.evaluate();
    });
    connect(&time, &TimeController::recordedChanged, this, [this] {
        if (!session.running()) growing.clear(); // they are among the takes that were read
    });
    connect(&model, &Controller::failed, this, [this] { showWhenReady_ = false; });
    workpiece.setRequested(target.machine());
    workpiece.setGuard([this](std::function<void()> change) { mill.interrupt(std::move(change)); });
}

void Workbench::load(const ProjectContents& contents) {
    workpiece.clear();
    model.load(contents.model);
    tool.load(contents.tools, contents.takes.empty() ? std::string() : newestTake(contents.takes).toolId);
    setup.load(contents.model, contents.setup, contents.materials);
    setups.load(contents);
    target.load(contents.target);
    fixtures.cancel();
    mover.cancel();
    surroundings.load(contents.obstacles, contents.axis, contents.travel);
    guides.load(contents.guides);
    mill.load(contents.takes);
    mill.setStrokes({});
    area.load({});
    leads_->forget();
    passes.forget();
    passPreview.end();
    passMeasurer.forget();
    passRefresher.forget();
    pathValuer.forget();
    pathComparer.close();
    time.forget();
    keeper.forget();
    score.forget();
    faces.forget();
    deviations.forget();
    growing.clear();
    path.load(contents.paths, contents.takes, contents.generated);
    lockSetup();
    program.load(contents.programs, contents.programDraft, contents.keptProgram);
    updateRequested();
    if (!contents.takes.empty() || !contents.generated.empty()) workpiece.embed();
}

void Workbench::lockSetup() {
    setup.setLocked(mill.recording() || !mill.takes().empty() || path.hasPasses());
}

void Workbench::clear() {
    undo_.clear();
    load({});
}

void Workbench::updateRequested() {
    workpiece.setRequested(setup.part(), setup.setup(), setup.materials(), tool.current());
    path.useTool(tool.current().id);
}

void Workbench::importPart(const std::filesystem::path& file, bool abandon) {
    model.read(file, {}, [this, abandon](const std::shared_ptr<const Model>& part) { adoptPart(part, abandon); });
}

void Workbench::adoptPart(const std::shared_ptr<const Model>& part, bool abandon) {
    if (!importNeedsNewProject()) return takePart(part);
    comeToRest([this, part, abandon] {
        document.createNew(abandon, [this, part](bool made) {
            if (made)
                takePart(part);
            else
                model.dropPreview();
        });
    });
}

void Workbench::updatePart(const std::filesystem::path& file) {
    if (!model.model()) return;
    model.read(file, importOptionsAsBefore(*model.model()),
               [this](const std::shared_ptr<const Model>& part) { comeToRest([this, part] { putUpdated(part); }); });
}

bool Workbench::changeUnit(const std::shared_ptr<const Model>& before, const std::shared_ptr<const Model>& part) {
    const bool sameBodies = before && std::ranges::equal(before->bodies, part->bodies, {}, &Body::name, &Body::name);
    if (before != model.model() || !sameBodies || setup.locked() || importNeedsNewProject()) return false;
    model.exchange(tr("unit of the part"), placed(part, placementAsBefore(*part, *before)));
    return true;
}

void Workbench::putUpdated(const std::shared_ptr<const Model>& part) {
    desk_.project.postStep([part](Project& project) { return burin::updatePart(project, *part); },
                           [this, before = workState()](const Result<PartUpdate>& update, const SharedStep& step) {
                               model.dropPreview();
                               if (update)
                                   putUpdatedInUse(*update, step, before);
                               else
                                   emit failed(update.error());
                           });
}

void Workbench::putUpdatedInUse(const PartUpdate& update, const SharedStep& step, const WorkState& before) {
    document.useSetup(setups.used(), [this, update, step, before](bool used) {
        if (used) {
            if (before.embedded) ensureWorkpiece();
            emit partUpdated(update);
        }
        undo_.pushStep(tr("updated part"), step, before);
    });
}

void Workbench::ensureWorkpiece() {
    if (setup.usable() && !workpiece.embedded()) workpiece.embed();
}

void Workbench::showHowItIsDone() {
    showWhenReady_ = true;
    ensureWorkpiece();
    continueShow();
}

void Workbench::continueShow() {
    if (!showWhenReady_ || session.running()) return;
    if (workpiece.ready() && !workpiece.fieldBusy()) {
        showWhenReady_ = false;
        showMe.start();
    } else if (setup.usable() && !workpiece.embedded() && !workpiece.embedding() && !model.importing()) {
        workpiece.embed();
    }
}

bool Workbench::canUndoNow() const {
    return !showMe.showing() && !mill.changingTakes() && !setups.adding() &&
           !(session.running() && session.state().cutting);
}

void Workbench::undoLast() {
    if (!canUndoNow()) return;
    if (mill.recordsNothingYet()) // it becomes an entry when it ends
        mill.stopRecording([this] { mill.refreshTakes([this] { undo_.undo(); }); });
    else
        undo_.undo();
}

void Workbench::redoLast() {
    if (canUndoNow()) undo_.redo();
}

bool Workbench::collectText() {
    emit textRequested();
    return program.keepDraft();
}

void Workbench::comeToRest(std::function<void()> then) {
    showWhenReady_ = false;
    collectText();
    if (showMe.showing()) showMe.stop();
    session.end([then = std::move(then)](bool) { then(); });
}

} // namespace burin

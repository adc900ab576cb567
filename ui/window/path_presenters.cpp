// SPDX-FileCopyrightText: 2026 The Burin authors
// SPDX-License-Identifier: Apache-2.0
#include "ui/window/path_presenters.h"

#include "core/cad/part_holes.h"
#include "core/job/cut_depth.h"
#include "core/machine/machine_library.h"
#include "core/passes/plan_pass.h"
#include "core/passes/thread_tooth.h"
#include "core/path/hand_interval.h"
#include "core/path/milling_side.h"
#include "ui/messages/messages.h"
#include "ui/panels/program_editor.h"
#include "ui/panels/texts.h"
#include "ui/window/hole_labels.h"
#include "ui/window/pass_dialog.h"

#include <QFileInfo>

#include <algorithm>
#include <cmath>

namespace burin {

namespace {

constexpr int panelMargin = 24; // pixels between the dialog and the window's edge

double cuttingLength(const Path& path) {
    double length = 0.0;
    for (std::size_t i = 1; i < path.points.size(); ++i)
        if (path.points[i].kind == MoveKind::cut || path.points[i].kind == MoveKind::plunge)
            length += lengthOf(path.points[i - 1].pose.tip, path.points[i]);
    return length;
}

/// The milling direction of an interval of a take; empty if it is not the same throughout.
std::optional<MillingSide> sideOf(const EvaluatedPath& path, const SourceInterval& chosen) {
    std::optional<MillingSide> side;
    for (const MillingInterval& interval : path.sides)
        for (std::size_t i = interval.first; i <= interval.last; ++i) {
            const PathPoint& point = path.path.points[i];
            const Moment from = i == 0 ? Moment{} : momentOf(path.path.points[i - 1]);
            if (point.kind != MoveKind::cut || !leadsThrough(from, momentOf(point), chosen)) continue;
            if (side && *side != interval.side) return std::nullopt;
            side = interval.side;
        }
    return side;
}

/// A pass by its kind, with the value that distinguishes it from others of its kind.
PassRow rowOf(const GeneratedInfo& pass, LengthUnit unit) {
    PassRow row{pass.id, passName(pass), {}};
    const Result<PassRequest> request = passRequestFromJson(pass.request, pass.name);
    row.computed = request.hasValue();
    if (!request) return row; // read from a program
    if (request->kind == PassKind::thread)
        row.figures =
            QStringLiteral("%1 × %2").arg(lengthText(request->majorDiameter, unit), lengthText(request->pitch, unit));
    else if (request->stepOver > 0.0)
        row.figures = lengthText(request->stepOver, unit);
    else if (request->scallop > 0.0)
        row.figures = lengthText(request->scallop, unit);
    else if (request->allowance > 0.0)
        row.figures = lengthText(request->allowance, unit);
    return row;
}

/// The holes of a part in which passes of some kinds work, and its studs.
std::vector<UprightHole> wallsFor(const std::vector<PassKind>& kinds, const Model& part) {
    if (std::ranges::none_of(kinds, isInHoles)) return {};
    std::vector<UprightHole> walls = uprightHoles(part);
    if (std::ranges::find(kinds, PassKind::thread) != kinds.end())
        for (const UprightHole& stud : uprightStuds(part)) walls.push_back(stud);
    return walls;
}

std::vector<PassKind> kindsFor(const Tool& tool) {
    std::vector<PassKind> kinds;
    for (const PassKindRow& row : passKinds)
        if (mayPlan(row.kind, tool)) kinds.push_back(row.kind);
    return kinds;
}

/// The smallest coarse thread that a tool cuts; without a name if there is none.
ThreadSize threadOf(const Cutter& cutter) {
    const auto fits = [&](const ThreadSize& size) {
        return cutter.diameter < minorDiameter(size) && threadTooth(cutter, size.pitch);
    };
    const auto size = std::ranges::find_if(coarseThreads, fits);
    return size != coarseThreads.end() ? *size : ThreadSize{};
}

/// The estimate of a pass; empty if there is none.
QString previewText(const PassPreviewer& previewer, LengthUnit unit) {
    if (previewer.problem()) return Messages::sentence(*previewer.problem());
    const PassPreview* preview = previewer.preview();
    if (preview == nullptr) return {};
    if (preview->strokes.empty()) return PathPresenter::tr("Preview: nothing is left to do there.");
    QString text = PathPresenter::tr("Preview: about %1 of cutting, %2 without links.")
                       .arg(wayText(preview->length, unit), durationText(preview->duration));
    if (preview->leftToHand > 0.0)
        text += QLatin1Char(' ') + PathPresenter::tr("%1 are skipped: already finished by hand strokes.")
                                       .arg(wayText(preview->leftToHand, unit));
    if (preview->every > 1.5)
        text += QLatin1Char(' ') + PathPresenter::tr("One row in %1 is drawn.").arg(std::lround(preview->every));
    return text;
}

/// The effect of a pass on the stock, and what it leaves.
QString measuredText(const PassFigures& pass, LengthUnit unit) {
    QString text = PathPresenter::tr("%1 in %2, %3 % in air; engagement within %4° for 95 % of the cut, at most %5°.")
                       .arg(wayText(pass.length, unit), durationText(pass.duration),
                            QString::number(100.0 * pass.airShare, 'f', 0),
                            QString::number(glm::degrees(pass.engagement95), 'f', 0),
                            QString::number(glm::degrees(pass.engagementMost), 'f', 0));
    if (pass.left && pass.left->reachable > 0.0)
        text += QLatin1Char(' ') + PathPresenter::tr("Stock left on 99 % of the reachable part: at most %1 (most: %2).")
                                       .arg(lengthText(pass.left->within99, unit), lengthText(pass.left->most, unit));
    return text;
}

QStringList toolNames(const Workbench& workbench, const std::vector<std::string>& ids) {
    QStringList names;
    for (const std::string& id : ids) names.append(toolName(workbench.tool.tools(), id));
    return names;
}

} // namespace

QString passName(const GeneratedInfo& pass) {
    const Result<PassRequest> request = passRequestFromJson(pass.request, pass.name);
    if (!request) return QString::fromStdString(pass.name); // read from a program: its file
    const TextId title = rowOf(request->kind).title;
    return QCoreApplication::translate(title.context, title.text);
}

QString jobName(const Workbench& workbench) {
    QString name = workbench.document.title();
    if (workbench.document.isUnnamed() && workbench.model.model())
        name = QFileInfo(QString::fromStdString(workbench.model.model()->sourceFile)).completeBaseName();
    return name.isEmpty() ? QStringLiteral("program") : name;
}

QString programName(const Workbench& workbench) {
    QString name = jobName(workbench);
    // Each setup has a program of its own: files must not overwrite each other on the way to the machine.
    if (workbench.setups.setups().size() > 1)
        name += QLatin1Char('-') +
                workbench.setups.title(workbench.setups.used()).replace(QLatin1Char('/'), QLatin1Char('-'));
    const TargetController& target = workbench.target;
    const auto dialect = std::ranges::find(target.dialects(), target.dialect(), &DialectDescription::id);
    const bool known = dialect != target.dialects().end() && !dialect->fileSuffix.empty();
    return name + QLatin1Char('.') + (known ? QString::fromStdString(dialect->fileSuffix) : QStringLiteral("ngc"));
}

PathPresenter::PathPresenter(Workbench& workbench, PathPanel& panel, PathScenePresenter& scene, QObject* parent)
    : Presenter(workbench,
                {&workbench.path, &workbench.passes, &workbench.passMeasurer, &workbench.passRefresher, &workbench.mill,
                 &workbench.workpiece, &workbench.tool},
                parent)
    , panel_(panel)
    , scene_(scene) {
    yieldWhileHidden(panel);
    const auto showTime = [this] {
        if (panel_.isVisible()) panel_.setAtTime(atTime());
    };
    connect(&workbench.time, &Controller::changed, this, showTime);
    connect(&workbench.time, &TimeController::momentChanged, this, showTime);
    connect(&panel, &PathPanel::toolChosen, &workbench.tool, &ToolController::choose);
    connect(&panel, &PathPanel::newPathRequested, &workbench.path, &PathController::makeNew);
    connect(&panel, &PathPanel::measureRequested, &workbench.passMeasurer, &PassMeasurer::measure);
    connect(&panel, &PathPanel::refreshRequested, &workbench.passRefresher, &PassRefresher::refresh);
    connect(&panel, &PathPanel::passRemoved, &workbench.path, &PathController::removePass);
    connect(&panel, &PathPanel::passMovedUp, &workbench.path, &PathController::movePassUp);
    connect(&panel, &PathPanel::passRequested, this, &PathPresenter::askPass);
    connect(&panel, &PathPanel::passChangeRequested, this, &PathPresenter::askChange);
    connect(&panel, &PathPanel::editChanged, &workbench.path, &PathController::changeEdit);
    connect(&panel, &PathPanel::editAdded, &scene, &PathScenePresenter::addEdit);
    connect(&panel, &PathPanel::placeRequested, &scene, &PathScenePresenter::lookAt);
    connect(&panel, &PathPanel::fieldDrawingRequested, &scene, &PathScenePresenter::setFieldDrawing);
    connect(&panel, &PathPanel::editRemoved, &workbench.path, &PathController::removeEdit);
    connect(&panel, &PathPanel::editMoved, &workbench.path, &PathController::moveEdit);
    connect(&panel, &PathPanel::dragChosen, &scene, &PathScenePresenter::setDrag);
    connect(&panel, &PathPanel::drawingRequested, &scene, &PathScenePresenter::setDrawing);
    connect(&panel, &PathPanel::selectionCleared, &workbench.path, &PathController::clearSelection);
    connect(&scene, &PathScenePresenter::changed, this, &Presenter::presentSoon);
    connect(&panel, &PathPanel::evaluateRequested, &workbench.path, &PathController::evaluate);
}

void PathPresenter::connectActions(const Actions& actions) {
    PathController& path = workbench_.path;
    connect(actions[ActionId::newPath], &QAction::triggered, &path, [&path] { path.makeNew(); });
    connect(actions[ActionId::newPass], &QAction::triggered, this, &PathPresenter::askPass);
    connect(actions[ActionId::pickHoles], &QAction::triggered, this, [this] { emit holesRequested(lastPass_); });
    connect(actions[ActionId::measurePasses], &QAction::triggered, &workbench_.passMeasurer, &PassMeasurer::measure);
    connect(actions[ActionId::refreshPasses], &QAction::triggered, &workbench_.passRefresher, &PassRefresher::refresh);
    connect(actions[ActionId::evaluatePath], &QAction::triggered, &path, [&path] { path.evaluate(); });
    connect(actions[ActionId::drawInterval], &QAction::triggered, this,
            [this] { scene_.setDrawing(!scene_.drawing()); });
    connect(actions[ActionId::insertPoint], &QAction::triggered, &scene_, &PathScenePresenter::insertAtSelection);
    connect(&panel_, &PathPanel::visibilityToggled, actions[ActionId::showPath], &QAction::setChecked);
}

void PathPresenter::askPass() {
    if (workbench_.passes.possible()) askFrom(lastPass_);
}

/// Computes the pass for which the user asks.
void PathPresenter::askFrom(const RequestedPass& last) {
    const std::optional<RequestedPass> wanted = asked(last, workbench_.area.area());
    if (!wanted) return;
    if (!wanted->instead) {
        lastPass_ = *wanted;
        lastPass_.request.area = {};
        lastPass_.request.lines.clear();
        lastPass_.request.leads.clear(); // they name those lines
        lastPass_.request.places.clear();
    }
    workbench_.passes.compute(*wanted);
}

bool PathPresenter::hasPass(std::int64_t id) const {
    return std::ranges::any_of(workbench_.path.passes(), [id](const GeneratedInfo& pass) { return pass.id == id; });
}

void PathPresenter::askAgain(RequestedPass wanted) {
    if (!workbench_.passes.possible()) return;
    if (wanted.instead && !hasPass(*wanted.instead)) wanted.instead.reset(); // it was removed meanwhile
    askFrom(wanted);
}

/// Shows the pass's request; the new pass takes its position.
void PathPresenter::askChange(std::int64_t id) {
    if (!workbench_.passes.possible()) return;
    const std::vector<GeneratedInfo> passes = workbench_.path.passes();
    const auto pass = std::ranges::find(passes, id, &GeneratedInfo::id);
    if (pass == passes.end()) return;
    RequestedPass before{{}, {}, id};
    if (const Result<PassRequest> request = passRequestFromJson(pass->request, pass->name)) before.request = *request;
    askFrom(before);
}

/// The user's request; empty: none.
std::optional<RequestedPass> PathPresenter::asked(const RequestedPass& last, const PlanRegion& painted) {
    const std::filesystem::path project = workbench_.document.file();
    const MillingContext& milling = *workbench_.workpiece.milling();
    const double diameter = milling.tool.cutter.diameter;
    const Box part = milling.partModel->box();
    const bool free = milling.partModel->bodies.empty();
    const std::vector<PassKind> kinds = kindsFor(milling.tool);
    if (kinds.empty()) return std::nullopt; // a tool that does not turn
    const ClearingSteps steps = clearingSteps(milling);
    const PassDefaults defaults{steps.stepOver,
                                usualFineStep * diameter,
                                steps.levelDepth,
                                usualStairs * diameter,
                                milling.setup.stock.high.z,
                                free ? milling.setup.stock.low.z : part.low.z,
                                free ? milling.setup.stock.low.z : part.high.z,
                                threadOf(milling.tool.cutter)};
    RequestedPass begun = last;
    if (std::ranges::find(kinds, last.request.kind) == kinds.end()) { // values for another tool do not apply
        begun.request = {};
        begun.request.kind = kinds.front();
        begun.request.places = last.request.places;
        begun.request.external = last.request.external && kinds.front() == PassKind::thread;
    }
    PassDialog dialog({toolName(workbench_.tool.current()), workbench_.mill.takes(), begun, defaults, painted,
                       QString::fromStdString(project.parent_path().string()), kinds,
                       wallsFor(kinds, *milling.partModel), unit()},
                      panel_.window());
    PassPreviewer& previewer = workbench_.passPreview;
    connect(&dialog, &PassDialog::previewRequested, &previewer, &PassPreviewer::show);
    connect(&dialog, &PassDialog::previewUnwanted, &previewer, &PassPreviewer::clear);
    connect(&previewer, &PassPreviewer::changed, &dialog, [&] { dialog.showPreview(previewText(previewer, unit())); });
    PassShow& show = workbench_.passShow;
    // A copy: the workpiece may be exchanged while the dialog is open.
    connect(&dialog, &PassDialog::showMeRequested, &show,
            [&previewer, &show, &dialog, around = free ? milling.setup.stock : part](RequestedPass shown) {
                if (shown.leads.empty()) shown.request = withSample(shown.request, around);
                previewer.show(shown);
                show.start();
                dialog.setShowing(show.showing());
            });
    connect(&dialog, &PassDialog::showStopped, &show, &PassShow::stop);
    connect(&show, &PassShow::finished, &dialog, [&] { dialog.setShowing(false); });
    // Next to the part, which shows the preview.
    dialog.fit();
    const QRect window = panel_.window()->geometry();
    dialog.move(window.right() - dialog.width() - panelMargin, window.top() + panelMargin);
    const int answer = dialog.exec();
    show.stop();
    previewer.end();
    if (answer == PassDialog::pickHoles) emit holesRequested(dialog.wanted());
    return answer == QDialog::Accepted ? std::optional(dialog.wanted()) : std::nullopt;
}

void PathPresenter::setUnit(LengthUnit unit) {
    panel_.setUnit(unit);
    Presenter::setUnit(unit);
}

TimelinesPlace PathPresenter::atTime() const {
    TimelinesPlace at;
    const std::shared_ptr<const EvaluatedPath> path = workbench_.path.evaluated();
    if (path) at.moment = workbench_.time.handMoment();
    if (at.moment) at.place = placeAt(path->path, *at.moment, workbench_.time.handTip());
    return at;
}

void PathPresenter::present() {
    const PathController& path = workbench_.path;
    PathState state;
    state.hasTakes = path.hasTakes();
    if (const ComputedPass* newest = workbench_.passes.newest()) {
        state.passLeftOut = newest->leftOut;
        state.passInTheWay = newest->inTheWay;
        state.unreachedHoles = newest->unreachedHoles;
        state.holeWork = holeWorkOf(newest->moves.info);
    }
    state.passPossible = workbench_.passes.possible();
    state.toolTurns = workbench_.tool.current().cutter.turns();
    for (const std::string& tool : path.toolsThatMilled())
        state.milled.push_back({tool, toolName(workbench_.tool.tools(), tool)});
    state.tool = {workbench_.tool.current().id, toolName(workbench_.tool.current())};
    state.someWithoutPath = !path.toolsWithoutPath().empty();
    state.exists = path.stored() != nullptr;
    if (path.stored()) state.path = *path.stored();
    const std::vector<PassFigures> measured = workbench_.passMeasurer.figures();
    const std::vector<std::int64_t>& outdated = workbench_.passRefresher.outdated();
    for (const GeneratedInfo& pass : path.passes()) {
        state.passes.push_back(rowOf(pass, unit()));
        const auto figures = std::ranges::find(measured, pass.id, &PassFigures::pass);
        if (figures != measured.end()) state.passes.back().measured = measuredText(*figures, unit());
        state.passes.back().outdated = std::ranges::find(outdated, pass.id) != outdated.end();
    }
    state.refreshPossible = workbench_.passRefresher.possible();
    state.measurePossible = workbench_.passMeasurer.possible();
    state.takes = workbench_.mill.takes();
    if (workbench_.workpiece.milling()) state.zero = workbench_.workpiece.milling()->setup.workOffset;
    if (path.evaluated()) {
        state.reports = path.evaluated()->reports;
        state.errorBudget = path.evaluated()->errorBudget;
        state.points = path.evaluated()->path.points.size();
        state.cuttingLength = cuttingLength(path.evaluated()->path);
        const auto bySide = lengthsBySide(path.evaluated()->path, path.evaluated()->sides);
        state.climbLength = bySide[static_cast<std::size_t>(MillingSide::climb)];
        state.conventionalLength = bySide[static_cast<std::size_t>(MillingSide::conventional)];
        if (path.selection()) state.selectedSide = sideOf(*path.evaluated(), *path.selection());
    }
    state.outdated = path.outdated();
    state.busy = path.busy();
    state.waiting = path.waiting();
    if (path.problem()) state.problem = Messages::sentence(*path.problem());
    state.missingBefore = toolNames(workbench_, path.toolsMissingBefore()).join(QStringLiteral(", "));
    state.selection = path.selection();
    state.atTime = atTime();
    state.drag = scene_.drag();
    state.drawing = scene_.drawing();
    state.drawnField = scene_.drawnField();
    panel_.setState(state);
}

ProgramPresenter::ProgramPresenter(Workbench& workbench, ProgramPanel& panel, QObject* parent)
    : Presenter(workbench, {&workbench.program, &workbench.path, &workbench.target, &workbench.tool}, parent)
    , panel_(panel) {
    connect(&panel, &ProgramPanel::machineChosen, &workbench.target, &TargetController::chooseMachine);
    connect(&panel, &ProgramPanel::dialectChosen, &workbench.target, &TargetController::chooseDialect);
    connect(&panel, &ProgramPanel::unitsChosen, &workbench.target, &TargetController::chooseUnits);
    connect(&panel, &ProgramPanel::pathIncluded, &workbench.program, &ProgramController::include);
    connect(&panel, &ProgramPanel::postRequested, this, [this] { workbench_.program.post(programName(workbench_)); });
    connect(&panel, &ProgramPanel::textEdited, &workbench.program, &ProgramController::editText);
    connect(&workbench, &Workbench::textRequested, &panel.editor(), &ProgramEditor::tellTextNow);
    connect(&panel, &ProgramPanel::textCheckRequested, this,
            [this] { workbench_.program.checkText(programName(workbench_)); });
    connect(&panel, &ProgramPanel::gougeToleranceEdited, &workbench.program, &ProgramController::setGougeTolerance);
    connect(&panel, &ProgramPanel::excessToleranceEdited, &workbench.program, &ProgramController::setExcessTolerance);
}

void ProgramPresenter::connectActions(const Actions& actions) {
    connect(actions[ActionId::post], &QAction::triggered, this,
            [this] { workbench_.program.post(programName(workbench_)); });
    connect(&panel_, &ProgramPanel::machinesRequested, actions[ActionId::machines], &QAction::trigger);
    connect(&panel_, &ProgramPanel::overrideRequested, actions[ActionId::overrideCheck], &QAction::trigger);
}

void ProgramPresenter::setUnit(LengthUnit unit) {
    panel_.setUnit(unit);
    Presenter::setUnit(unit);
}

void ProgramPresenter::showPaths(ProgramState& state) const {
    const PathController& path = workbench_.path;
    for (const StoredPath& each : path.jobPaths()) {
        state.paths.push_back(
            {each.id, toolName(workbench_.tool.tools(), path.toolOf(each.id)), workbench_.program.includes(each.id)});
        state.hasPath = state.hasPath || state.paths.back().included;
    }
    state.upToDate = path.stored() == nullptr || (path.evaluated() && !path.outdated());
    state.withoutPath = toolNames(workbench_, path.toolsWithoutPath());
}

void ProgramPresenter::present() {
    const ProgramController& program = workbench_.program;
    ProgramState state;
    showPaths(state);
    const TargetController& target = workbench_.target;
    for (const MachineProfile& machine : target.machines())
        state.machines.push_back({machine.id, QCoreApplication::translate("Resource", machine.name.c_str())});
    for (const DialectDescription& dialect : target.dialects())
        state.dialects.push_back({dialect.id, QCoreApplication::translate("Resource", dialect.name.c_str())});
    state.machine = target.machine().id;
    state.typicalMachine = isTypicalMachine(state.machine);
    state.missingMachine = QString::fromStdString(target.missingMachine());
    state.dialect = target.dialect();
    state.units = target.target().units;
    state.text = program.storedText();
    state.edited = program.edited();
    state.lint = program.lint();
    if (program.program() && !program.edited()) {
        state.blocks = program.program()->parsed.blocks;
        state.report = {program.program(), &program.program()->report}; // shares ownership of the program
        state.released = program.program()->released();
        state.judgedTolerance = program.program()->gougeTolerance;
    }
    state.gougeTolerance = program.gougeTolerance();
    state.excessTolerance = program.excessTolerance();
    state.outdated = program.outdated();
    state.busy = program.busy();
    if (program.problem()) state.problem = Messages::sentence(*program.problem());
    panel_.setState(state);
}

} // namespace burin

// SPDX-FileCopyrightText: 2026 The Burin authors
// SPDX-License-Identifier: Apache-2.0
#include "ui/workbench/program_controller.h"

#include "core/base/file.h"
#include "core/nc/dialect_library.h"
#include "core/verify/report_json.h"
#include "ui/workbench/value_command.h"

#include <algorithm>
#include <chrono>

namespace burin {

ProgramController::ProgramController(const Desk& desk, BenchController& bench, PathController& path,
                                     const TargetController& target, QObject* parent)
    : Controller(desk, parent), bench_(bench), path_(path), target_(target) {
    draftDue_.setSingleShot(true);
    draftDue_.setInterval(std::chrono::seconds(1));
    connect(&draftDue_, &QTimer::timeout, this, &ProgramController::storeDraft);
    connect(&bench_, &BenchController::readersStop, this, &ProgramController::stop);
    connect(&path_, &PathController::versionChanged, this, &Controller::changed);
    connect(&target_, &Controller::changed, this, &Controller::changed);
}

/// What the user wrote is kept until it is part of a released program: also what the check refused.
void ProgramController::storeDraft() {
    const bool refusedByCheck = program_ && !program_->released() && byHand_;
    const bool isDraft = edited_ || refusedByCheck;
    store([draft = isDraft ? storedText_.toStdString() : std::string()](Project& project) {
        return project.setProgramDraft(draft);
    });
}

bool ProgramController::keepDraft() {
    if (!draftDue_.isActive()) return false;
    draftDue_.stop();
    storeDraft();
    return true;
}

void ProgramController::load(const std::vector<StoredProgram>& programs, const std::string& draft) {
    draftDue_.stop();
    desk_.tasks.abandon(TaskKind::program);
    program_.reset();
    problem_.reset();
    edited_ = byHand_ = reading_ = false;
    ++generation_;
    leftOut_.clear();
    lint_.clear();
    storedText_ = programs.empty() ? QString() : QString::fromStdString(programs.back().text);
    if (!draft.empty()) {
        storedText_ = QString::fromStdString(draft);
        edited_ = byHand_ = true;
        lintText();
    }
    emit changed();
}

void ProgramController::setGougeTolerance(double millimetres) {
    if (millimetres == gougeTolerance_) return;
    gougeTolerance_ = millimetres;
    emit changed();
}

ProgramController::Basis ProgramController::basis() const {
    return {path_.version(), target_.dialect(), target_.target().units, gougeTolerance_, leftOut_};
}

/// The bench is about to change: what is made for it as it was is abandoned, and the user told.
void ProgramController::stop() {
    if (!busy()) return;
    reading_ = false;
    ++generation_;
    desk_.tasks.abandon(TaskKind::program);
    problem_ = Error{ErrorCode::cancelled, "program", {}, {}};
    emit changed();
}

ProgramRequest ProgramController::request(const QString& name) const {
    ProgramRequest request;
    request.name = name.toStdString();
    request.dialect = target_.dialect();
    request.units = target_.target().units;
    request.gougeTolerance = gougeTolerance_;
    return request;
}

bool ProgramController::postable() const {
    const bool upToDate = path_.stored() == nullptr || (path_.evaluated() && !path_.outdated());
    return upToDate && !postedPaths().empty() && bench_.bench() && !bench_.changing();
}

std::vector<StoredPath> ProgramController::postedPaths() const {
    std::vector<StoredPath> paths = path_.jobPaths();
    std::erase_if(paths, [this](const StoredPath& path) { return !includes(path.id); });
    return paths;
}

StoredProgram ProgramController::stored(const ProgramRequest& request) const {
    return {request.name, request.dialect, bench_.bench()->machine.id, {}, {}};
}

void ProgramController::include(std::int64_t path, bool wanted) {
    if (wanted == includes(path)) return;
    if (wanted)
        leftOut_.erase(path);
    else
        leftOut_.insert(path);
    emit changed();
}

void ProgramController::post(const QString& name) {
    if (!postable() || busy()) return;
    emit textWanted();
    const ProgramRequest wanted = request(name);
    read(postedPaths(), [this, wanted, asked = Asked{stored(wanted), basis(), textVersion_, false}](Matters matters) {
        postPaths(std::move(matters), wanted, asked);
    });
}

void ProgramController::read(const std::vector<StoredPath>& paths, std::function<void(Matters)> then) {
    reading_ = true;
    desk_.project.ask(
        [paths](Project& project) -> Result<Matters> {
            const Result<std::vector<TakeInfo>> takes = project.takes();
            if (!takes) return takes.error();
            Matters matters;
            for (StoredPath path : paths) {
                addNewerTakes(path, *takes);
                Result<PathMatter> matter = matterOf(project, path);
                if (!matter) return std::move(matter).error();
                matters.push_back(std::move(*matter));
            }
            return matters;
        },
        [this, then = std::move(then), generation = generation_](Result<Matters> matters) {
            if (generation != generation_) return; // another project
            reading_ = false;
            if (matters && bench_.bench()) {
                then(std::move(*matters));
            } else if (!matters) {
                problem_ = matters.error();
            }
            emit changed();
        });
    emit changed();
}

void ProgramController::postPaths(Matters matters, const ProgramRequest& wanted, const Asked& asked) {
    if (asked.basis.paths == path_.version()) // as the view shows them
        for (PathMatter& matter : matters) matter.evaluated = path_.current(matter.path.id);
    desk_.tasks.start(
        TaskKind::program, tr("Posting and checking"),
        [bench = bench_.bench(), matters = std::move(matters), wanted](Progress& progress) -> Result<CheckedProgram> {
            Result<EvaluatedPaths> paths = evaluateInOrder(*bench, matters, progress);
            if (!paths) return std::move(paths).error();
            return makeProgram(*bench, paths->program, wanted, progress);
        },
        [this, asked](Result<CheckedProgram> outcome) { take(asked, std::move(outcome)); });
}

void ProgramController::editText(const QString& text) {
    if (text == storedText_) return;
    storedText_ = text;
    edited_ = byHand_ = true;
    ++textVersion_;
    desk_.tasks.cancel(TaskKind::program); // it would be of another text
    draftDue_.start();
    problem_.reset();
    lintText();
    emit changed();
}

void ProgramController::lintText() {
    const auto& bench = bench_.bench();
    const bool oneTool = bench && path_.jobPaths().size() < 2;
    lint_ =
        burin::lint(storedText_.toStdString(), {&controlOfDialect(target_.dialect()), bench ? &bench->machine : nullptr,
                                                oneTool ? &bench->tool : nullptr});
}

void ProgramController::checkText(const QString& name) {
    emit textWanted();
    if (!bench_.bench() || bench_.changing() || !edited_ || busy()) return;
    const ProgramRequest wanted = request(name);
    read(path_.jobPaths(), [this, wanted, basis = basis()](const Matters& matters) { check(matters, wanted, basis); });
}

/// The text may call every tool of the job.
void ProgramController::check(const Matters& matters, ProgramRequest wanted, const Basis& basis) {
    for (const PathMatter& matter : matters) wanted.tools.push_back(matter.tool);
    desk_.tasks.start(
        TaskKind::program, tr("Checking"),
        [bench = bench_.bench(), text = storedText_.toStdString(), wanted](Progress& progress) {
            return checkProgram(*bench, text, wanted.name, wanted, progress);
        },
        [this, asked = Asked{stored(wanted), basis, textVersion_, true}](Result<CheckedProgram> outcome) {
            take(asked, std::move(outcome));
        });
}

void ProgramController::take(const Asked& asked, Result<CheckedProgram> outcome) {
    emit textWanted();
    if (asked.text != textVersion_) { // what was typed since is newer
        emit changed();
        return;
    }
    if (!outcome) {
        problem_ = outcome.error();
        emit changed();
        return;
    }
    const auto program = std::make_shared<const CheckedProgram>(std::move(*outcome));
    keep(asked.posted, *program);
    const Shown next{program, QString::fromStdString(program->text), false, asked.basis, asked.byHand};
    edited_ ? change(next) : show(next); // what the user wrote is worth an undo
}

void ProgramController::keep(const StoredProgram& posted, const CheckedProgram& program) {
    if (!program.released()) return;
    StoredProgram kept = posted;
    kept.text = program.text;
    kept.reportJson = toJson(program.report);
    store([kept](Project& project) { return project.addProgram(kept); });
}

void ProgramController::change(const Shown& next) {
    desk_.undo.push(new ValueCommand<Shown>(tr("text of the program"), -1,
                                            {program_, storedText_, edited_, basis_, byHand_}, next,
                                            [this](const Shown& value) { show(value); }));
}

void ProgramController::overrideCheck(const QString& name, const QString& reason) {
    if (!refused() || !bench_.bench()) return;
    const MachineProfile& machine = bench_.bench()->machine;
    Result<CheckedProgram> wanted = burin::overrideCheck(*program_, reason.trimmed().toStdString(), machine);
    if (!wanted) {
        emit failed(wanted.error());
        return;
    }
    const auto program = std::make_shared<const CheckedProgram>(std::move(*wanted));
    keep({name.toStdString(), program->dialect, machine.id, {}, {}}, *program);
    change({program, QString::fromStdString(program->text), false, basis_, byHand_});
}

void ProgramController::show(const Shown& shown) {
    problem_.reset();
    ++textVersion_;
    program_ = shown.program;
    storedText_ = shown.text;
    if (edited_ || byHand_ || shown.edited || shown.byHand) draftDue_.start();
    edited_ = shown.edited;
    byHand_ = shown.byHand;
    if (edited_)
        lintText();
    else
        lint_ = program_->lint;
    basis_ = shown.basis;
    emit changed();
}

void ProgramController::exportTo(const std::filesystem::path& file) {
    if (!exportable()) return;
    // A program is some hundred kilobytes; still the disk is the project thread's.
    desk_.project.ask([file, program = program_](Project&) { return writeFileAtomically(file, program->text); },
                      [this, file](const Result<void>& written) {
                          if (written)
                              emit exported(QString::fromStdString(file.string()));
                          else
                              emit failed(written.error());
                      });
}

} // namespace burin

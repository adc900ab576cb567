// SPDX-FileCopyrightText: 2026 The Burin authors
// SPDX-License-Identifier: Apache-2.0
#include "ui/workbench/program_controller.h"

#include "core/base/file.h"
#include "core/verify/report_json.h"

namespace burin {

ProgramController::ProgramController(const Desk& desk, BenchController& bench, PathController& path,
                                     const TargetController& target, QObject* parent)
    : Controller(desk, parent), bench_(bench), path_(path), target_(target) {}

void ProgramController::load(const std::vector<StoredProgram>& programs) {
    desk_.tasks.abandon(TaskKind::program);
    program_.reset();
    problem_.reset();
    outdated_ = true;
    storedText_ = programs.empty() ? QString() : QString::fromStdString(programs.back().text);
    emit changed();
}

void ProgramController::pathChanged() {
    becomeOutdated();
}

void ProgramController::targetChanged() {
    becomeOutdated();
}

void ProgramController::becomeOutdated() {
    if (outdated_) return;
    outdated_ = true;
    emit changed();
}

void ProgramController::setGougeTolerance(double millimetres) {
    if (millimetres == gougeTolerance_) return;
    gougeTolerance_ = millimetres;
    outdated_ = true;
    emit changed();
}

void ProgramController::post(const QString& name, const QString& overrideReason) {
    if (!bench_.bench() || !path_.evaluated()) return;
    ProgramRequest request;
    request.name = name.toStdString();
    request.dialect = target_.dialect();
    request.gougeTolerance = gougeTolerance_;
    request.overrideReason = overrideReason.trimmed().toStdString();
    desk_.tasks.start(
        TaskKind::program, tr("Posting and checking"),
        [bench = bench_.bench(), path = path_.evaluated(), request](Progress& progress) {
            return makeProgram(*bench, path->path, request, progress);
        },
        [this, posted = StoredProgram{request.name, request.dialect, bench_.bench()->machine.id, {}, {}}](
            Result<CheckedProgram> outcome) { take(posted, std::move(outcome)); });
    emit changed();
}

void ProgramController::take(const StoredProgram& posted, Result<CheckedProgram> outcome) {
    if (!outcome) {
        problem_ = outcome.error();
        emit changed();
        return;
    }
    problem_.reset();
    program_ = std::make_shared<const CheckedProgram>(std::move(*outcome));
    storedText_ = QString::fromStdString(program_->text);
    outdated_ = path_.outdated();
    if (program_->released())
        store([posted, program = program_](Project& project) {
            return project.addProgram(
                {posted.name, posted.dialect, posted.machine, program->text, toJson(program->report)});
        });
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

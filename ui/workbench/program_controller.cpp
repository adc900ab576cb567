// SPDX-FileCopyrightText: 2026 The Burin authors
// SPDX-License-Identifier: Apache-2.0
#include "ui/workbench/program_controller.h"

#include "core/base/file.h"
#include "core/nc/dialect_library.h"
#include "core/verify/report_json.h"
#include "ui/workbench/value_command.h"

namespace burin {

ProgramController::ProgramController(const Desk& desk, BenchController& bench, PathController& path,
                                     const TargetController& target, QObject* parent)
    : Controller(desk, parent), bench_(bench), path_(path), target_(target) {}

void ProgramController::load(const std::vector<StoredProgram>& programs) {
    desk_.tasks.abandon(TaskKind::program);
    program_.reset();
    problem_.reset();
    outdated_ = true;
    edited_ = false;
    lint_.clear();
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

ProgramRequest ProgramController::request(const QString& name) const {
    ProgramRequest request;
    request.name = name.toStdString();
    request.dialect = target_.dialect();
    request.gougeTolerance = gougeTolerance_;
    return request;
}

void ProgramController::post(const QString& name) {
    if (!bench_.bench() || !path_.evaluated()) return;
    const ProgramRequest wanted = request(name);
    desk_.tasks.start(
        TaskKind::program, tr("Posting and checking"),
        [bench = bench_.bench(), path = path_.evaluated(), wanted](Progress& progress) {
            return makeProgram(*bench, path->path, wanted, progress);
        },
        [this, posted = StoredProgram{wanted.name, wanted.dialect, bench_.bench()->machine.id, {}, {}}](
            Result<CheckedProgram> outcome) { take(posted, std::move(outcome)); });
    emit changed();
}

void ProgramController::editText(const QString& text) {
    if (text == storedText_) return;
    storedText_ = text;
    edited_ = true;
    problem_.reset();
    lintText();
    emit changed();
}

void ProgramController::lintText() {
    const auto& bench = bench_.bench();
    lint_ = burin::lint(storedText_.toStdString(), {&controlOfDialect(target_.dialect()),
                                                    bench ? &bench->machine : nullptr, bench ? &bench->tool : nullptr});
}

void ProgramController::checkText(const QString& name) {
    if (!bench_.bench() || !edited_) return;
    const ProgramRequest wanted = request(name);
    desk_.tasks.start(
        TaskKind::program, tr("Checking"),
        [bench = bench_.bench(), text = storedText_.toStdString(), wanted](Progress& progress) {
            return checkProgram(*bench, text, wanted.name, wanted, progress);
        },
        [this, posted = StoredProgram{wanted.name, wanted.dialect, bench_.bench()->machine.id, {}, {}}](
            Result<CheckedProgram> outcome) { take(posted, std::move(outcome)); });
    emit changed();
}

void ProgramController::take(const StoredProgram& posted, Result<CheckedProgram> outcome) {
    if (!outcome) {
        problem_ = outcome.error();
        emit changed();
        return;
    }
    const auto program = std::make_shared<const CheckedProgram>(std::move(*outcome));
    keep(posted, *program);
    const Shown next{program, QString::fromStdString(program->text), false};
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
    desk_.undo.push(new ValueCommand<Shown>(tr("text of the program"), -1, {program_, storedText_, edited_}, next,
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
    change({program, QString::fromStdString(program->text), false});
}

void ProgramController::show(const Shown& shown) {
    problem_.reset();
    program_ = shown.program;
    storedText_ = shown.text;
    edited_ = shown.edited;
    if (edited_)
        lintText();
    else
        lint_ = program_->lint;
    outdated_ = path_.outdated();
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

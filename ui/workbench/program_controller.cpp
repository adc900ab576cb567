// SPDX-FileCopyrightText: 2026 The Burin authors
// SPDX-License-Identifier: Apache-2.0
#include "ui/workbench/program_controller.h"

#include "core/base/file.h"
#include "core/document/companions.h"
#include "core/nc/dialect_library.h"
#include "core/verify/kept_check.h"
#include "core/verify/report_json.h"
#include "ui/workbench/value_command.h"

#include <algorithm>
#include <array>
#include <chrono>
#include <utility>

namespace burin {

namespace {

/// The input of a program, read from the project.
struct ReadJob {
    std::vector<PathMatter> matters;
    std::uint64_t judged = 0; ///< `judgedBasis`
};

} // namespace

ProgramController::ProgramController(const Desk& desk, WorkpieceController& workpiece, PathController& path,
                                     const TargetController& target, QObject* parent)
    : Controller(desk, parent), workpiece_(workpiece), path_(path), target_(target) {
    draftDue_.setSingleShot(true);
    draftDue_.setInterval(std::chrono::seconds(1));
    connect(&draftDue_, &QTimer::timeout, this, &ProgramController::storeDraft);
    judgeSoon_.setSingleShot(true);
    judgeSoon_.setInterval(std::chrono::milliseconds(150));
    connect(&judgeSoon_, &QTimer::timeout, this, &ProgramController::judgeReopened);
    connect(&desk_.project, &ProjectThread::worked, this, [this] {
        if (reopened_ && !judgeSoon_.isActive()) judgeSoon_.start();
    });
    connect(&workpiece_, &WorkpieceController::readersStop, this, &ProgramController::stop);
    connect(&workpiece_, &WorkpieceController::readersGoOn, this, &ProgramController::goOn);
    connect(&path_, &Controller::changed, this, &ProgramController::goOn);
    connect(&path_, &PathController::versionChanged, this, &Controller::changed);
    connect(&target_, &Controller::changed, this, &Controller::changed);
}

/// The user's text is stored until it is part of a released program, also if the check refused it.
void ProgramController::storeDraft() {
    const bool refusedByCheck = program_ && !program_->released() && byHand_;
    const bool isDraft = edited_ || refusedByCheck;
    store([draft = isDraft ? storedText_.toStdString() : std::string()](Project& project) {
        return project.setProgramDraft(draft);
    });
}

/// Stores the newest checked program, together with the user's draft.
void ProgramController::storeProgram() {
    KeptProgram kept;
    if (reopened_) {
        kept = reopened_->kept;
    } else if (program_) {
        kept = keptOf(*program_, target_.machine().id, basis_.units, judged_);
        kept.byHand = byHand_;
        kept.leftOut.assign(basis_.leftOut.begin(), basis_.leftOut.end());
    }
    store([json = program_ ? toJson(kept) : std::string()](Project& project) { return project.setKeptProgram(json); });
}

bool ProgramController::keepDraft() {
    if (!draftDue_.isActive()) return false;
    draftDue_.stop();
    storeDraft();
    return true;
}

void ProgramController::load(const std::vector<StoredProgram>& programs, const std::string& draft,
                             const std::optional<ReopenedProgram>& kept) {
    draftDue_.stop();
    desk_.tasks.abandon(TaskKind::program);
    interrupted_ = nullptr;
    kept_.reset();
    program_.reset();
    reopened_.reset();
    judgeSoon_.stop();
    problem_.reset();
    edited_ = byHand_ = reading_ = false;
    ++generation_;
    leftOut_.clear();
    lint_.clear();
    storedText_ = programs.empty() ? QString() : QString::fromStdString(programs.back().text);
    if (kept) takeKept(*kept);
    if (!draft.empty() && !(kept && kept->kept.text == draft)) {
        storedText_ = QString::fromStdString(draft);
        edited_ = byHand_ = true;
        lintText();
    }
    emit changed();
}

void ProgramController::takeKept(const ReopenedProgram& kept) {
    program_ = kept.program;
    storedText_ = QString::fromStdString(kept.program->text);
    lint_ = program_->lint;
    byHand_ = kept.kept.byHand;
    gougeTolerance_ = kept.kept.gougeTolerance;
    excessTolerance_ = kept.kept.excessTolerance;
    leftOut_ = std::set<std::int64_t>(kept.kept.leftOut.begin(), kept.kept.leftOut.end());
    judged_ = kept.basis;
    basis_ = basis();
    reopened_ = std::make_shared<Reopened>(Reopened{kept.kept, kept.upToDate});
}

/// A program of an earlier session is compared by the checksum of everything that it was judged by, as there are no
/// version counters from then.
bool ProgramController::outdated() const {
    if (!program_) return true;
    if (!reopened_) return basis_ != basis();
    const KeptProgram& kept = reopened_->kept;
    return !reopened_->upToDate || kept.machine != target_.machine().id || kept.dialect != target_.dialect() ||
           kept.units != target_.target().units || kept.gougeTolerance != gougeTolerance_ ||
           kept.excessTolerance != excessTolerance_ || basis_.leftOut != leftOut_;
}

std::shared_ptr<const CheckedProgram> ProgramController::upToDate() const {
    return program_ && !edited_ && !outdated() && workpiece_.milling() ? program_ : nullptr;
}

void ProgramController::judgeReopened() {
    if (!reopened_) return;
    desk_.project.ask([kept = reopened_->kept](Project& project) { return isJudgedSo(project, kept); },
                      [this, asked = reopened_](const Result<bool>& same) {
                          const bool upToDate = same && *same;
                          if (asked->upToDate == upToDate) return;
                          asked->upToDate = upToDate;
                          emit changed();
                      });
}

void ProgramController::setGougeTolerance(double millimetres) {
    if (millimetres == gougeTolerance_) return;
    gougeTolerance_ = millimetres;
    emit changed();
}

void ProgramController::setExcessTolerance(double millimetres) {
    if (millimetres == excessTolerance_) return;
    excessTolerance_ = millimetres;
    emit changed();
}

ProgramController::Basis ProgramController::basis() const {
    return {path_.version(), target_.dialect(), target_.target().units, gougeTolerance_, excessTolerance_, leftOut_};
}

/// What checks found out on the present workpiece, for the next one.
std::shared_ptr<KeptCheck> ProgramController::kept() {
    if (!kept_ || keptOn_.lock() != workpiece_.milling()) {
        kept_ = std::make_shared<KeptCheck>();
        keptOn_ = workpiece_.milling();
    }
    return kept_;
}

/// The workpiece is about to change: work on the present one is abandoned, and requested again after the change.
void ProgramController::stop() {
    kept_.reset();
    if (!busy()) return;
    reading_ = false;
    ++generation_;
    desk_.tasks.abandon(TaskKind::program);
    interrupted_ = asked_;
    emit changed();
}

/// Waits until the paths have been evaluated again.
void ProgramController::goOn() {
    if (!interrupted_ || workpiece_.changing() || path_.busy()) return;
    std::exchange(interrupted_, nullptr)();
    if (!busy()) problem_ = Error{ErrorCode::cancelled, "program", {}, {}}; // it can't be made any more
    emit changed();
}

ProgramRequest ProgramController::request(const QString& name) const {
    ProgramRequest request;
    request.name = name.toStdString();
    request.setupName = setupName_;
    request.dialect = target_.dialect();
    request.units = target_.target().units;
    request.gougeTolerance = gougeTolerance_;
    request.excessTolerance = excessTolerance_;
    return request;
}

bool ProgramController::postable() const {
    const bool upToDate = path_.stored() == nullptr || (path_.evaluated() && !path_.outdated());
    return upToDate && !postedPaths().empty() && workpiece_.milling() && !workpiece_.changing();
}

std::vector<StoredPath> ProgramController::postedPaths() const {
    std::vector<StoredPath> paths = path_.jobPaths();
    std::erase_if(paths, [this](const StoredPath& path) { return !includes(path.id); });
    return paths;
}

StoredProgram ProgramController::stored(const ProgramRequest& request) const {
    return {request.name, request.dialect, workpiece_.milling()->machine.id, {}, {}};
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
    asked_ = [this, name] { post(name); };
    emit textRequested();
    const ProgramRequest wanted = request(name);
    const Asked asked{stored(wanted), basis(), 0, textVersion_, false};
    readWhatIsNeeded(postedPaths(), asked.basis.paths, [this, wanted, asked](Matters matters, std::uint64_t judged) {
        Asked now = asked;
        now.judged = judged;
        postPaths(std::move(matters), wanted, now);
    });
}

/// Takes over the evaluations that the view shows, if nothing has changed since. @return whether no path has to be
/// evaluated
bool ProgramController::takeEvaluated(Matters& matters, quint64 version) const {
    if (version != path_.version()) return false;
    for (PathMatter& matter : matters) matter.evaluated = path_.current(matter.path.id);
    return areEvaluated(matters);
}

/// A long take is read in some tenths of a second, as long as a check after one edit takes.
void ProgramController::readWhatIsNeeded(const std::vector<StoredPath>& paths, quint64 version,
                                         const std::function<void(Matters, std::uint64_t)>& then) {
    const bool known =
        std::ranges::all_of(paths, [this](const StoredPath& path) { return path_.current(path.id) != nullptr; });
    read(paths, !known, [this, paths, version, known, then](Matters matters, std::uint64_t judged) {
        if (takeEvaluated(matters, version) || !known)
            then(std::move(matters), judged);
        else
            read(paths, true, [this, version, then](Matters all, std::uint64_t judgedNow) {
                takeEvaluated(all, version);
                then(std::move(all), judgedNow);
            });
    });
}

void ProgramController::read(const std::vector<StoredPath>& paths, bool strokes,
                             std::function<void(Matters, std::uint64_t)> then) {
    reading_ = true;
    desk_.project.ask(
        [paths, strokes, machine = target_.machine().id](Project& project) -> Result<ReadJob> {
            const Result<std::vector<SourceInfo>> sources = sourcesOf(project);
            if (!sources) return sources.error();
            ReadJob job;
            for (StoredPath path : paths) {
                addNewerTakes(path, *sources);
                Result<PathMatter> matter = strokes ? matterOf(project, path) : outlinedMatterOf(project, path);
                if (!matter) return std::move(matter).error();
                job.matters.push_back(std::move(*matter));
            }
            const Result<std::uint64_t> judged = judgedBasis(project, machine);
            if (!judged) return judged.error();
            job.judged = *judged;
            return job;
        },
        [this, then = std::move(then), generation = generation_](Result<ReadJob> job) {
            if (generation != generation_) return; // another project
            reading_ = false;
            if (job && workpiece_.milling()) {
                then(std::move(job->matters), job->judged);
            } else if (!job) {
                problem_ = job.error();
            }
            emit changed();
        });
    emit changed();
}

void ProgramController::postPaths(Matters matters, const ProgramRequest& wanted, const Asked& asked) {
    ProgramRequest request = wanted;
    request.kept = kept();
    desk_.tasks.start(
        TaskKind::program, tr("Posting and checking"),
        [workpiece = workpiece_.milling(), matters = std::move(matters),
         request](Progress& progress) -> Result<CheckedProgram> {
            Result<EvaluatedPaths> paths = evaluateInOrder(*workpiece, matters, progress);
            if (!paths) return std::move(paths).error();
            return makeProgram(*workpiece, paths->program, request, progress);
        },
        [this, asked](Result<CheckedProgram> outcome) { take(asked, std::move(outcome)); });
}

void ProgramController::editText(const QString& text) {
    if (text == storedText_) return;
    storedText_ = text;
    edited_ = byHand_ = true;
    ++textVersion_;
    desk_.tasks.cancel(TaskKind::program); // it would be for another text
    interrupted_ = nullptr;
    draftDue_.start();
    problem_.reset();
    lintText();
    emit changed();
}

void ProgramController::openText(const QString& text) {
    desk_.tasks.cancel(TaskKind::program); // it would be for another text
    Shown next = shown();
    next.text = text;
    next.edited = next.byHand = true;
    change(next);
}

void ProgramController::lintText() {
    const auto& milling = workpiece_.milling();
    lint_ = burin::lint(storedText_.toStdString(),
                        {&controlOfDialect(target_.dialect(), milling ? milling->machine.axes() : linearAxes),
                         milling ? &milling->machine : nullptr});
}

void ProgramController::checkText(const QString& name) {
    emit textRequested();
    if (!workpiece_.milling() || workpiece_.changing() || !edited_ || busy()) return;
    asked_ = [this, name] { checkText(name); };
    const ProgramRequest wanted = request(name);
    readWhatIsNeeded(path_.jobPaths(), basis().paths,
                     [this, wanted, basis = basis()](Matters matters, std::uint64_t judged) {
                         check(std::move(matters), wanted, Asked{stored(wanted), basis, judged, textVersion_, true});
                     });
}

/// The text may call every tool of the job, and must follow the job's paths.
void ProgramController::check(Matters matters, ProgramRequest wanted, const Asked& asked) {
    wanted.kept = kept();
    for (const PathMatter& matter : matters) wanted.tools.push_back(matter.tool);
    desk_.tasks.start(
        TaskKind::program, tr("Checking"),
        [milling = workpiece_.milling(), text = storedText_.toStdString(), wanted,
         matters = std::move(matters)](Progress& progress) -> Result<CheckedProgram> {
            ProgramRequest request = wanted;
            if (!matters.empty() && isPosted(text)) {
                Result<EvaluatedPaths> paths = evaluateInOrder(*milling, matters, progress);
                if (paths)
                    request.promised = std::make_shared<const std::vector<Path>>(std::move(paths->program.paths));
                else if (paths.error().code != ErrorCode::pathEmpty) // then there is no promised path
                    return std::move(paths).error();
            }
            return checkProgram(*milling, text, request.name, request, progress);
        },
        [this, asked](Result<CheckedProgram> outcome) { take(asked, std::move(outcome)); });
}

void ProgramController::take(const Asked& asked, Result<CheckedProgram> outcome) {
    emit textRequested();
    if (asked.text != textVersion_) { // newer text was typed meanwhile
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
    const Shown next{program, QString::fromStdString(program->text), false, asked.basis, asked.byHand, asked.judged};
    edited_ ? change(next) : show(next); // replacing text of the user can be undone
}

void ProgramController::keep(const StoredProgram& posted, const CheckedProgram& program) {
    if (!program.released()) return;
    StoredProgram kept = posted;
    kept.text = program.text;
    kept.reportJson = toJson(program.report);
    store([kept](Project& project) { return project.addProgram(kept); });
}

void ProgramController::change(const Shown& next) {
    desk_.undo.push(new ValueCommand<Shown>(tr("text of the program"), -1, shown(), next,
                                            [this](const Shown& value) { show(value); }));
}

ProgramController::Shown ProgramController::shown() const {
    return {program_, storedText_, edited_, basis_, byHand_, judged_, reopened_};
}

void ProgramController::overrideCheck(const QString& name, const QString& reason) {
    if (!refused() || !workpiece_.milling()) return;
    const MachineProfile& machine = workpiece_.milling()->machine;
    Result<CheckedProgram> wanted = burin::overrideCheck(*program_, reason.trimmed().toStdString(), machine);
    if (!wanted) {
        emit failed(wanted.error());
        return;
    }
    const auto program = std::make_shared<const CheckedProgram>(std::move(*wanted));
    keep({name.toStdString(), program->dialect, machine.id, {}, {}}, *program);
    Shown next = shown();
    next.program = program;
    next.text = QString::fromStdString(program->text);
    if (reopened_) {
        KeptProgram kept = keptOf(*program, machine.id, reopened_->kept.units, judged_);
        kept.byHand = byHand_;
        kept.leftOut = reopened_->kept.leftOut;
        next.reopened = std::make_shared<Reopened>(Reopened{std::move(kept), true});
    }
    change(next);
}

void ProgramController::show(const Shown& shown) {
    problem_.reset();
    interrupted_ = nullptr;
    ++textVersion_;
    program_ = shown.program;
    storedText_ = shown.text;
    if (edited_ || byHand_ || shown.edited || shown.byHand) draftDue_.start();
    edited_ = shown.edited;
    byHand_ = shown.byHand;
    if (edited_)
        lintText();
    else
        lint_ = program_ ? program_->lint : std::vector<LintMark>();
    basis_ = shown.basis;
    judged_ = shown.judged;
    reopened_ = shown.reopened;
    if (reopened_) judgeSoon_.start();
    storeProgram();
    emit changed();
}

void ProgramController::restart(std::uint32_t line, const QString& name) {
    if (!restartable()) return;
    asked_ = [this, line, name] { restart(line, name); };
    ProgramRequest wanted = request(name);
    wanted.dialect = program_->dialect;
    wanted.units = reopened_ ? reopened_->kept.units : basis_.units;
    wanted.tools = program_->tools;
    desk_.tasks.start(
        TaskKind::program, tr("Making and checking the rest of the program"),
        [milling = workpiece_.milling(), text = program_->text, line, wanted](Progress& progress) {
            return makeRestart(*milling, text, line, wanted, progress);
        },
        [this](Result<RestartedProgram> rest) {
            emit changed();
            if (rest)
                emit restarted(std::make_shared<const RestartedProgram>(std::move(*rest)));
            else
                emit failed(rest.error());
        });
    emit changed();
}

void ProgramController::exportRestart(const std::filesystem::path& file, const RestartedProgram& rest,
                                      const QString& reason) {
    std::string text = rest.program.text;
    if (!rest.program.released()) {
        if (reason.isEmpty() || !workpiece_.milling()) return;
        Result<CheckedProgram> wanted =
            burin::overrideCheck(rest.program, reason.toStdString(), workpiece_.milling()->machine);
        if (!wanted) {
            emit failed(wanted.error());
            return;
        }
        text = std::move(wanted->text);
    }
    desk_.project.ask(
        [file, text = std::move(text)](Project& project) -> Result<void> {
            const std::array<std::filesystem::path, 1> inputs{project.file()};
            if (Result<void> free = checkOutput("file", file, inputs); !free) return free;
            return writeFileAtomically(file, text);
        },
        [this, file, line = rest.from](const Result<void>& written) {
            if (written)
                emit restartExported(line, QString::fromStdString(file.string()));
            else
                emit failed(written.error());
        });
}

void ProgramController::exportTo(const std::filesystem::path& file) {
    if (!exportable()) return;
    // A program has some hundred kilobytes; disk access is left to the project's thread nevertheless.
    desk_.project.ask(
        [file, program = program_,
         kept = reopened_ ? std::optional(reopened_->kept) : std::nullopt](Project& project) -> Result<bool> {
            if (kept) { // a program must not be exported after a change made a moment ago
                const Result<bool> same = isJudgedSo(project, *kept);
                if (!same || !*same) return same;
            }
            const std::array<std::filesystem::path, 1> inputs{project.file()};
            if (Result<void> free = checkOutput("file", file, inputs); !free) return std::move(free).error();
            if (Result<void> written = writeFileAtomically(file, program->text); !written)
                return std::move(written).error();
            return true;
        },
        [this, file](const Result<bool>& written) {
            if (written && !*written)
                judgeReopened();
            else if (written)
                emit exported(QString::fromStdString(file.string()));
            else
                emit failed(written.error());
        });
}

} // namespace burin

// SPDX-FileCopyrightText: 2026 The Burin authors
// SPDX-License-Identifier: Apache-2.0
#include "ui/workbench/pass_controller.h"

#include <memory>
#include <utility>

namespace burin {

/// What is needed to compute a pass without the project.
struct PassController::Matter {
    PassRequest request;
    std::vector<LeadTake> leads; ///< whose strokes become lines of the request
    std::vector<PathMatter> before;
    std::optional<std::int64_t> instead;
    quint64 load = 0;
};

PassController::PassController(const Desk& desk, WorkpieceController& workpiece, PathController& path,
                               const ToolController& tools, std::shared_ptr<KeptLeads> leads, QObject* parent)
    : Controller(desk, parent), workpiece_(workpiece), path_(path), tools_(tools), leads_(std::move(leads)) {
    for (const auto signal : {&WorkpieceController::readersStop, &WorkpieceController::readersGoOn})
        connect(&workpiece_, signal, this, &PassController::goOn);
    connect(&workpiece_, &WorkpieceController::changed, this, &PassController::goOn);
    connect(&desk_.tasks, &TaskRunner::changed, this, [this] { // others compute passes, too
        if (wanted_ && !asked_ && ready() && !desk_.tasks.running(TaskKind::pass)) goOn();
    });
}

bool PassController::ready() const {
    return workpiece_.embedded() && workpiece_.milling() && !workpiece_.changing() &&
           workpiece_.milling()->tool.id == tools_.current().id;
}

bool PassController::possible() const {
    return !busy() && ready();
}

void PassController::compute(const RequestedPass& wanted) {
    if (!possible()) return;
    wanted_ = wanted;
    newest_.reset();
    tool_ = tools_.current().id;
    goOn();
}

/// Starts the requested pass if it is not under way: now, or as soon as the workpiece is ready again.
void PassController::goOn() {
    emit changed();
    if (!wanted_ || asked_ || desk_.tasks.running(TaskKind::pass)) return;
    if (tools_.current().id != tool_) {
        emit failed({ErrorCode::pathEmpty,
                     rowOf(wanted_->request.kind).title.text,
                     {},
                     "another tool was loaded before it was computed"});
        return end();
    }
    if (!ready()) return;
    asked_ = true;
    reading_ = std::make_shared<Progress>();
    const StoredPath path = path_.stored() != nullptr ? *path_.stored() : StoredPath{};
    desk_.project.ask(
        [wanted = *wanted_, path, tool = tool_, load = loads_, leads = leads_,
         reading = reading_](const Project& project) -> Result<Matter> {
            Result<std::vector<LeadTake>> takes = readLeads(project, wanted.leads, *leads, *reading);
            if (!takes) return std::move(takes).error();
            Matter matter{wanted.request, std::move(*takes), {}, wanted.instead, load};
            Result<std::vector<PathMatter>> before =
                pathsBeforePass(project, path, tool, matter.request, matter.instead);
            if (!before) return std::move(before).error();
            matter.before = std::move(*before);
            return matter;
        },
        [this, load = loads_](Result<Matter> matter) {
            if (load != loads_) return; // another project
            asked_ = false;
            if (!matter) {
                emit failed(matter.error());
                return end();
            }
            if (ready() && tools_.current().id == tool_ && !desk_.tasks.running(TaskKind::pass))
                run(std::move(*matter));
            else
                goOn();
        });
}

void PassController::run(Matter matter) {
    const quint64 load = matter.load;
    const std::optional<std::int64_t> instead = matter.instead;
    desk_.tasks.start(
        TaskKind::pass, tr("Computing the pass"),
        [milling = workpiece_.milling(), leads = leads_,
         matter = std::move(matter)](Progress& progress) mutable -> Result<std::shared_ptr<const ComputedPass>> {
            const Result<PassRequest> request =
                ledBy(std::move(matter.request), std::move(matter.leads), *leads, progress);
            if (!request) return request.error();
            Result<ComputedPass> pass = computePass(*milling, std::move(matter.before), *request, progress);
            if (!pass) return std::move(pass).error();
            return std::make_shared<const ComputedPass>(std::move(*pass));
        },
        [this, load, instead, tool = tools_.current()](const Result<std::shared_ptr<const ComputedPass>>& pass) {
            if (load != loads_) return; // another project
            if (pass) {
                newest_ = *pass;
                path_.addPass((*pass)->moves, tool, instead);
            } else if (pass.error().code != ErrorCode::cancelled) {
                emit failed(pass.error());
            }
            end();
        });
}

void PassController::addProgram(std::string text, const std::string& file, const std::string& dialect) {
    if (!possible()) return;
    desk_.project.ask(
        [](const Project& project) { return project.tools(); },
        [this, text = std::move(text), file, dialect, load = loads_](const Result<std::vector<Tool>>& tools) mutable {
            if (load != loads_ || !possible()) return;
            if (!tools) {
                emit failed(tools.error());
                return;
            }
            readProgram(std::move(text), file, dialect, *tools);
        });
}

void PassController::readProgram(std::string text, const std::string& file, const std::string& dialect,
                                 const std::vector<Tool>& tools) {
    using Read = std::shared_ptr<const ProgramPasses>;
    desk_.tasks.start(
        TaskKind::pass, tr("Reading the program"),
        [milling = workpiece_.milling(), tool = tools_.current(), tools, text = std::move(text), file,
         dialect](Progress& progress) -> Result<Read> {
            const ToolChoice meant{tools, false, tool};
            Result<ProgramPasses> passes = passesOfProgram(text, file, dialect, *milling, meant, progress);
            if (!passes) return std::move(passes).error();
            return std::make_shared<const ProgramPasses>(std::move(*passes));
        },
        [this, load = loads_](const Result<Read>& read) {
            if (load != loads_) return; // another project
            if (read) {
                path_.addProgram((*read)->passes);
                emit programAdded(**read);
            } else if (read.error().code != ErrorCode::cancelled) {
                emit failed(read.error());
            }
            emit changed();
        });
    emit changed();
}

const ComputedPass* PassController::newest() const {
    return newest_ && newest_->moves.info.toolId == tools_.current().id ? newest_.get() : nullptr;
}

void PassController::end() {
    wanted_.reset();
    emit changed();
}

void PassController::forget() {
    asked_ = false;
    if (reading_) reading_->cancel();
    ++loads_;
    newest_.reset();
    desk_.tasks.abandon(TaskKind::pass);
    end();
}

} // namespace burin

// SPDX-FileCopyrightText: 2026 The Burin authors
// SPDX-License-Identifier: Apache-2.0
#include "ui/workbench/pass_controller.h"

#include "core/job/computed_pass.h"

#include <memory>
#include <utility>

namespace burin {

/// What it takes to compute a pass, without the project.
struct PassController::Matter {
    PassRequest request;
    std::vector<PathMatter> before;
    quint64 load = 0;
};

PassController::PassController(const Desk& desk, WorkpieceController& workpiece, PathController& path,
                               const ToolController& tools, QObject* parent)
    : Controller(desk, parent), workpiece_(workpiece), path_(path), tools_(tools) {
    connect(&workpiece_, &WorkpieceController::changed, this, &Controller::changed);
    connect(&workpiece_, &WorkpieceController::readersStop, this, &Controller::changed);
}

bool PassController::possible() const {
    return !busy() && workpiece_.embedded() && workpiece_.milling() && !workpiece_.changing() &&
           workpiece_.milling()->tool.id == tools_.current().id;
}

void PassController::compute(const WantedPass& wanted) {
    if (!possible()) return;
    asked_ = true;
    const StoredPath path = path_.stored() != nullptr ? *path_.stored() : StoredPath{};
    desk_.project.ask(
        [wanted, path, tool = tools_.current().id, load = loads_](const Project& project) -> Result<Matter> {
            Matter matter{wanted.request, {}, load};
            Progress unseen;
            for (const std::int64_t take : wanted.leads) {
                Result<std::vector<PassLine>> lines = linesOfTake(project, take, unseen);
                if (!lines) return std::move(lines).error();
                for (PassLine& line : *lines) matter.request.lines.push_back(std::move(line));
            }
            Result<std::vector<PathMatter>> before = pathsBeforePass(project, path, tool, matter.request);
            if (!before) return std::move(before).error();
            matter.before = std::move(*before);
            return matter;
        },
        [this](Result<Matter> matter) {
            if (!std::exchange(asked_, false)) return; // another project
            if (!matter)
                emit failed(matter.error());
            else if (possible())
                run(std::move(*matter));
            emit changed();
        });
    emit changed();
}

void PassController::run(Matter matter) {
    const quint64 load = matter.load;
    desk_.tasks.start(
        TaskKind::pass, tr("Computing the pass"),
        [milling = workpiece_.milling(),
         matter = std::move(matter)](Progress& progress) mutable -> Result<std::shared_ptr<const ComputedPass>> {
            Result<ComputedPass> pass = computePass(*milling, std::move(matter.before), matter.request, progress);
            if (!pass) return std::move(pass).error();
            return std::make_shared<const ComputedPass>(std::move(*pass));
        },
        [this, load, tool = tools_.current()](const Result<std::shared_ptr<const ComputedPass>>& pass) {
            if (load == loads_ && pass)
                path_.addPass((*pass)->moves, tool);
            else if (!pass && pass.error().code != ErrorCode::cancelled)
                emit failed(pass.error());
            emit changed();
        });
}

void PassController::forget() {
    asked_ = false;
    ++loads_;
    desk_.tasks.abandon(TaskKind::pass);
    emit changed();
}

} // namespace burin

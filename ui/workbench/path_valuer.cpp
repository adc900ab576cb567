// SPDX-FileCopyrightText: 2026 The Burin authors
// SPDX-License-Identifier: Apache-2.0
#include "ui/workbench/path_valuer.h"

#include "core/job/pass_figures.h"

#include <utility>

namespace burin {

/// What is needed to compute a quantity without the project.
struct PathValuer::Matter {
    std::vector<MilledPath> before;
    std::vector<SourceStrokes> sources; ///< for the deviation only
};

PathValuer::PathValuer(const Desk& desk, const WorkpieceController& workpiece, const PathController& path,
                       QObject* parent)
    : Controller(desk, parent), workpiece_(workpiece), path_(path) {
    connect(&path_, &PathController::changed, this, &PathValuer::goOn);
    connect(&workpiece_, &WorkpieceController::changed, this, &PathValuer::goOn);
}

void PathValuer::choose(std::optional<PathQuantity> quantity) {
    if (quantity == chosen_) return;
    forget();
    chosen_ = quantity;
    goOn();
    emit changed();
}

std::shared_ptr<const PathValues> PathValuer::values() const {
    return of_ && of_ == path_.evaluated() ? values_ : nullptr;
}

void PathValuer::goOn() {
    const auto path = path_.evaluated();
    if (!chosen_ || !path || path_.stored() == nullptr || path == of_ || path == asked_ || !workpiece_.milling() ||
        workpiece_.changing() || workpiece_.milling()->tool.id != path->path.toolId)
        return;
    asked_ = path;
    desk_.project.ask(
        [path, stored = *path_.stored(), quantity = *chosen_](const Project& project) -> Result<Matter> {
            Result<FigureMatter> figures = figureMatter(project, *path);
            if (!figures) return std::move(figures).error();
            Matter matter{std::move(figures->before), {}};
            if (quantity != PathQuantity::deviation) return matter;
            Result<std::vector<SourceStrokes>> strokes = strokesOf(project, stored);
            if (!strokes) return std::move(strokes).error();
            matter.sources = std::move(*strokes);
            return matter;
        },
        [this, path, question = questions_](Result<Matter> matter) {
            if (question != questions_ || path != asked_) return;
            if (matter && workpiece_.milling() && !workpiece_.changing()) return run(std::move(*matter));
            if (!matter) emit failed(matter.error());
            asked_.reset();
        });
}

void PathValuer::run(Matter matter) {
    using Made = std::shared_ptr<const PathValues>;
    desk_.tasks.start(
        TaskKind::pathValues, tr("Colouring the path"),
        [milling = workpiece_.milling(), matter = std::move(matter), path = asked_,
         quantity = *chosen_](Progress& progress) -> Result<Made> {
            Result<PathValues> values =
                pathValues(quantity, {path, milling->tool}, matter.before, matter.sources, *milling, progress);
            if (!values) return std::move(values).error();
            return std::make_shared<const PathValues>(std::move(*values));
        },
        [this, path = asked_, question = questions_](const Result<Made>& made) {
            if (question != questions_ || path != asked_) return;
            if (made) {
                of_ = std::exchange(asked_, nullptr);
                values_ = *made;
            } else {
                forget(); // after cancelling, the path has its plain colours again
                if (made.error().code != ErrorCode::cancelled) emit failed(made.error());
            }
            emit changed();
        });
}

void PathValuer::forget() {
    ++questions_;
    chosen_.reset();
    of_.reset();
    asked_.reset();
    values_.reset();
    desk_.tasks.abandon(TaskKind::pathValues);
    emit changed();
}

} // namespace burin

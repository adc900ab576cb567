// SPDX-FileCopyrightText: 2026 The Burin authors
// SPDX-License-Identifier: Apache-2.0
#include "ui/workbench/path_comparer.h"

#include "core/job/pass_figures.h"

#include <algorithm>
#include <utility>

namespace burin {

/// The data needed to evaluate a path without access to the project.
struct PathComparer::Matter {
    PathMatter path;
    std::vector<MilledPath> before;
};

PathComparer::PathComparer(const Desk& desk, const WorkpieceController& workpiece, const PathController& path,
                           QObject* parent)
    : Controller(desk, parent), workpiece_(workpiece), path_(path) {
    connect(&path_, &PathController::changed, this, &PathComparer::goOn);
    connect(&path_, &PathController::evaluatedAnew, this, &PathComparer::goOn);
    connect(&path_, &PathController::othersChanged, this, &PathComparer::goOn);
    connect(&workpiece_, &WorkpieceController::changed, this, &PathComparer::goOn);
    connect(&workpiece_, &WorkpieceController::readersStop, this, [this] {
        asked_.reset(); // requested again once the workpiece has been updated
        desk_.tasks.abandon(TaskKind::comparison);
    });
}

void PathComparer::open() {
    if (!possible()) return;
    if (open_) {
        if (busy() || !problem()) return;
        answered_.reset();
        problem_.reset();
    } else {
        open_ = true;
        version_ = {};
    }
    goOn();
    emit changed();
}

void PathComparer::close() {
    if (!open_) return;
    open_ = false;
    asked_.reset();
    answered_.reset();
    compared_.reset();
    problem_.reset();
    desk_.tasks.abandon(TaskKind::comparison);
    emit changed();
}

std::vector<PathVersion> PathComparer::versions() const {
    using Kind = PathVersion::Kind;
    std::vector<PathVersion> versions;
    const StoredPath* own = path_.stored();
    if (own == nullptr) return versions;
    versions.push_back({Kind::recorded});
    for (std::size_t i = 0; i < own->edits.size(); ++i)
        if (own->edits[i].enabled) versions.push_back({Kind::withoutEdit, i});
    for (const StoredPath& path : path_.all())
        if (path.id != own->id && jobPathOf({Kind::path, 0, path.id}) != nullptr)
            versions.push_back({Kind::path, 0, path.id});
    return versions;
}

void PathComparer::choose(const PathVersion& version) {
    if (version == version_) return;
    version_ = version;
    goOn();
    emit changed();
}

void PathComparer::setTolerance(double tolerance) {
    if (tolerance == tolerance_) return;
    tolerance_ = tolerance;
    goOn();
    emit changed();
}

std::shared_ptr<const ComparedPaths> PathComparer::compared() const {
    return other() && answered_->tolerance == tolerance_ ? compared_ : nullptr;
}

std::shared_ptr<const EvaluatedPath> PathComparer::other() const {
    const bool fits =
        compared_ && !path_.outdated() && compared_->first == path_.evaluated() && answered_->version == version_;
    return fits ? compared_->second : nullptr;
}

/// Returns the path that the job mills with the tool of a version; null if there is none.
const StoredPath* PathComparer::jobPathOf(const PathVersion& version) const {
    if (version.kind != PathVersion::Kind::path) return path_.stored();
    const std::string tool = path_.toolOf(version.path);
    const std::vector<StoredPath>& all = path_.all();
    const auto found = std::ranges::find_if(all, [&](const StoredPath& path) { return path_.toolOf(path.id) == tool; });
    return tool.empty() || found == all.end() ? nullptr : &*found;
}

StoredPath PathComparer::storedOf(const PathVersion& version) const {
    if (version.kind == PathVersion::Kind::path) return *std::ranges::find(path_.all(), version.path, &StoredPath::id);
    StoredPath path = *path_.stored();
    if (version.kind == PathVersion::Kind::recorded)
        path.edits.clear();
    else
        path.edits.erase(path.edits.begin() + static_cast<std::ptrdiff_t>(version.edit));
    return path;
}

void PathComparer::goOn() {
    const auto first = path_.evaluated();
    if (!open_ || !first || path_.stored() == nullptr || path_.outdated() || !workpiece_.milling() ||
        workpiece_.changing())
        return;
    const std::vector<PathVersion> versions = this->versions();
    if (std::ranges::find(versions, version_) == versions.end()) version_ = {};
    const StoredPath* jobPath = jobPathOf(version_);
    const Question question{first, jobPath != nullptr ? path_.current(jobPath->id) : nullptr, version_, tolerance_};
    if (!question.base || question == asked_ || (!asked_ && question == answered_)) return;
    asked_ = question;
    if (compared_ && answered_->isOfSamePaths(question))
        run(question, compared_->second, nullptr);
    else if (version_.kind == PathVersion::Kind::path && jobPath->id == version_.path)
        run(question, question.base, nullptr);
    else
        gather(question);
}

void PathComparer::gather(const Question& question) {
    using Gathered = std::shared_ptr<Matter>;
    desk_.project.ask(
        [stored = storedOf(question.version), base = question.base](const Project& project) -> Result<Gathered> {
            Result<PathMatter> path = matterOf(project, stored);
            if (!path) return std::move(path).error();
            Result<FigureMatter> figures = figureMatter(project, *base);
            if (!figures) return std::move(figures).error();
            return std::make_shared<Matter>(Matter{std::move(*path), std::move(figures->before)});
        },
        [this, question](const Result<Gathered>& matter) {
            if (question != asked_) return;
            if (!matter) return answer(question, nullptr, matter.error());
            if (workpiece_.milling() && !workpiece_.changing()) return run(question, nullptr, *matter);
            asked_.reset(); // requested again once the workpiece has been updated
        });
}

/// @param second null if it has to be evaluated from `matter` first
void PathComparer::run(const Question& question, std::shared_ptr<const EvaluatedPath> second,
                       std::shared_ptr<Matter> matter) {
    using Made = std::shared_ptr<const ComparedPaths>;
    desk_.tasks.start(
        TaskKind::comparison, tr("Comparing paths"),
        [milling = workpiece_.milling(), question, second = std::move(second),
         matter = std::move(matter)](Progress& progress) mutable -> Result<Made> {
            constexpr double evaluating = 0.8; // fraction of the work
            if (!second) {
                const ProgressPart part(progress, 0.0, evaluating);
                Result<EvaluatedPath> made =
                    evaluateStored(std::move(matter->path.sources), *milling, matter->path.tool, matter->path.path,
                                   matter->before, progress);
                if (!made) return std::move(made).error();
                second = std::make_shared<const EvaluatedPath>(std::move(*made));
            }
            const ProgressPart part(progress, evaluating, 1.0);
            Result<PathDifference> values =
                differenceOf(question.first->path, second->path, question.tolerance, progress);
            if (!values) return std::move(values).error();
            return std::make_shared<const ComparedPaths>(
                ComparedPaths{question.first, std::move(second), std::move(*values)});
        },
        [this, question](const Result<Made>& made) {
            if (question != asked_) return;
            if (made)
                answer(question, *made, std::nullopt);
            else
                answer(question, nullptr, made.error());
        });
}

void PathComparer::answer(const Question& question, std::shared_ptr<const ComparedPaths> compared,
                          std::optional<Error> problem) {
    asked_.reset();
    answered_ = question;
    compared_ = std::move(compared);
    problem_ = std::move(problem);
    emit changed();
}

} // namespace burin

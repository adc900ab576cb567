// SPDX-FileCopyrightText: 2026 The Burin authors
// SPDX-License-Identifier: Apache-2.0
// What the undo stack needs from the workbench.
#include "ui/workbench/workbench.h"

namespace burin {

namespace {

/// A take that no longer counts is not milled by a path. Evaluation adds it to the path again once it counts.
Result<void> removeFromPaths(Project& project, std::int64_t take) {
    const Result<TakeOutline> outline = project.takeOutline(take);
    if (!outline) return outline.error();
    Result<std::vector<StoredPath>> paths = project.paths(outline->info.setup);
    if (!paths) return std::move(paths).error();
    for (StoredPath& path : *paths) {
        if (std::erase(path.sources, PathSource{take}) == 0) continue;
        Result<void> stored = path.sources.empty() ? project.removePath(path.id) : project.setPath(path);
        if (!stored) return stored;
    }
    return {};
}

} // namespace

void Workbench::serveHistory() {
    undo_.serve({[this] { return workState(); }, [this] { return !session.running(); },
                 [this](std::function<void()> then) { comeToRest(std::move(then)); },
                 [this](std::int64_t take, bool hidden) { hideTake(take, hidden); },
                 [this](const WorkState& state, const std::optional<SharedStep>& step, std::function<void(bool)> then) {
                     goTo(state, step, std::move(then));
                 },
                 [this] { ensureWorkpiece(); }});
}

WorkState Workbench::workState() const {
    return {setups.used(),
            tool.current().id,
            mill.allowance(),
            area.area(),
            setup.problem() ? std::optional(setup.setup()) : std::nullopt,
            workpiece.embedded() || workpiece.embedding()};
}

void Workbench::goTo(const WorkState& state, const std::optional<SharedStep>& step, std::function<void(bool)> then) {
    comeToRest([this, state, step, then = std::move(then), before = setups.used()] {
        document.useSetup(
            state.setup,
            [this, state, then, before](bool used) {
                if (used) restore(state);
                if (used && before != state.setup) emit setupShown(setups.title(state.setup));
                then(used);
            },
            step);
    });
}

/// What the project doesn't keep. Embedding is a task of its own, which can be cancelled.
void Workbench::restore(const WorkState& state) {
    tool.show(state.tool);
    mill.showAllowance(state.allowance);
    area.load(state.area);
    if (state.unstored) setup.showUnstored(*state.unstored);
    if (state.embedded) ensureWorkpiece();
}

/// The strokes of a take that is hidden are undone, so the workpiece stays.
void Workbench::hideTake(std::int64_t take, bool hidden) {
    const auto change = [this, take, hidden] {
        if (hidden) path.forgetTake(take);
        desk_.project.post(
            [take, hidden](Project& project) -> Result<void> {
                if (!hidden) return project.restoreTake(take);
                if (Result<void> removed = removeFromPaths(project, take); !removed) return removed;
                return project.removeTake(take);
            },
            [this](const Result<void>& done) {
                if (!done) emit failed(done.error());
                mill.refreshTakes();
            });
    };
    if (hidden && mill.recording())
        mill.stopRecording(change);
    else
        change();
}

void Workbench::takePart(const std::shared_ptr<const Model>& part) {
    if (undo_.busy()) { // what is being read again would replace the part in the window
        connect(
            &undo_, &History::settled, this, [this, part] { adoptPart(part, false); }, Qt::SingleShotConnection);
        return;
    }
    undo_.makeStep(tr("import of a part"), [this, part] { model.adopt(part); });
}

} // namespace burin

// SPDX-FileCopyrightText: 2026 The Burin authors
// SPDX-License-Identifier: Apache-2.0
// Adding passes and programs as sources of paths.
#include "core/job/computed_pass.h"
#include "ui/workbench/path_controller.h"
#include "ui/workbench/value_command.h"

#include <algorithm>
#include <utility>

namespace burin {

namespace {

bool sameEdits(const std::vector<Edit>& some, const std::vector<Edit>& others) {
    return std::ranges::equal(
        some, others, {}, [](const Edit& edit) { return toJson(edit); }, [](const Edit& edit) { return toJson(edit); });
}

} // namespace

/// What the project has stored already.
struct PathController::AddedSources {
    std::vector<GeneratedInfo> sources;
    std::map<std::string, ChangedPath> paths; ///< by tool
};

void PathController::addPass(const GeneratedMoves& moves, const Tool& tool, std::optional<std::int64_t> instead) {
    addSources(tr("computed pass"), {{moves, tool, [info = moves.info, instead](StoredPath path, std::int64_t source) {
                                          return withPass(std::move(path), info, source, instead);
                                      }}});
}

void PathController::replacePasses(const std::vector<ReplacedPass>& passes, const Tool& tool) {
    std::vector<NewSource> added;
    for (const ReplacedPass& pass : passes)
        added.push_back(
            {pass.moves, tool, [info = pass.moves.info, instead = pass.instead](StoredPath path, std::int64_t source) {
                 return withPass(std::move(path), info, source, instead);
             }});
    addSources(tr("passes computed again"), std::move(added));
}

void PathController::addProgram(const std::vector<ProgramPass>& passes) {
    std::vector<NewSource> added;
    for (const ProgramPass& pass : passes)
        added.push_back({pass.moves, pass.tool,
                         [use = useOf(pass), name = pass.moves.info.name](StoredPath path, std::int64_t source) {
                             return withProgram(std::move(path), name, use, source);
                         }});
    addSources(tr("path of a program"), std::move(added));
}

void PathController::addSources(const QString& text, std::vector<NewSource> added) {
    std::map<std::string, ChangedPath> paths;
    for (const NewSource& each : added) {
        const StoredPath* own = pathOf(each.tool.id);
        const StoredPath before = own != nullptr ? *own : StoredPath{};
        paths.try_emplace(each.tool.id, ChangedPath{before, before});
    }
    desk_.project.postStep(
        [added = std::move(added), paths = std::move(paths)](Project& project) mutable -> Result<AddedSources> {
            AddedSources made{{}, std::move(paths)};
            for (const NewSource& each : added) {
                const Result<std::int64_t> source = project.addGenerated(each.moves);
                if (!source) return source.error();
                if (Result<void> kept = project.setTool(each.tool); !kept) return std::move(kept).error();
                made.sources.push_back(each.moves.info);
                made.sources.back().id = *source;
                StoredPath& path = made.paths.at(each.tool.id).after;
                path = each.into(std::move(path), *source);
            }
            for (auto& [tool, path] : made.paths) {
                if (path.before.id != 0) {
                    if (Result<void> stored = project.setPath(path.after); !stored) return std::move(stored).error();
                    continue;
                }
                const Result<std::int64_t> id = project.addPath(path.after);
                if (!id) return id.error();
                path.after.id = *id;
            }
            return made;
        },
        [this, text, load = loads_](const Result<AddedSources>& made, const SharedStep& step) {
            if (load != loads_) return; // another project
            if (made)
                keepSources(text, *made, step);
            else
                emit failed(made.error());
        });
}

/// The project has stored them already; its step belongs to the first entry.
void PathController::keepSources(const QString& text, const AddedSources& added, const SharedStep& step) {
    if (desk_.undo.busy()) { // a macro that begins now would delete the entry that is being undone
        connect(
            &desk_.undo, &History::settled, this,
            [this, text, added, step, load = loads_] {
                if (load == loads_) keepSources(text, added, step);
            },
            Qt::SingleShotConnection);
        return;
    }
    learn(added.sources);
    std::vector<StoredPath> made;
    std::vector<ChangedPath> changed;
    for (const auto& [tool, path] : added.paths) {
        if (path.before.id == 0)
            made.push_back(path.after);
        else
            changed.push_back(path);
    }
    if (changed.empty()) {
        keepNew(made, added.sources, step);
        return;
    }
    desk_.undo.beginMacro(text);
    if (!made.empty()) keepNew(made, added.sources, step);
    for (const ChangedPath& path : changed) {
        auto* sources = new ValueCommand<std::vector<PathSource>>(
            text, -1, path.before.sources, path.after.sources,
            [this, id = path.after.id, added = added.sources](const std::vector<PathSource>& wanted) {
                learn(added);
                applySources(id, wanted);
            });
        if (made.empty() && &path == &changed.front())
            desk_.undo.pushStored(sources, step);
        else
            desk_.undo.push(sources);
        if (!sameEdits(path.before.edits, path.after.edits))
            desk_.undo.push(new ValueCommand<std::vector<Edit>>(
                text, -1, path.before.edits, path.after.edits,
                [this, id = path.after.id](const std::vector<Edit>& edits) { apply(id, edits); }));
    }
    desk_.undo.endMacro();
}

/// Notes sources that are new, or that were undone when the project was read.
void PathController::learn(const std::vector<GeneratedInfo>& sources) {
    for (const GeneratedInfo& source : sources) {
        if (std::ranges::find(generated_, source.id, &GeneratedInfo::id) != generated_.end()) continue;
        generated_.push_back(source);
        sources_.push_back(sourceOf(source));
    }
}

const StoredPath* PathController::pathOf(const std::string& tool) const {
    const auto path =
        std::ranges::find_if(paths_, [&](const StoredPath& each) { return burin::toolOf(each, sources_) == tool; });
    return path != paths_.end() ? &*path : nullptr;
}

const StoredPath* PathController::pathFor(std::int64_t take) const {
    const auto source = std::ranges::find(sources_, PathSource{take}, &SourceInfo::source);
    return source != sources_.end() ? pathOf(source->toolId) : nullptr;
}

bool PathController::isMilled(std::int64_t take) const {
    const StoredPath* path = pathFor(take);
    return path != nullptr && std::ranges::find(path->sources, PathSource{take}) != path->sources.end();
}

void PathController::millTake(std::int64_t take, bool milled) {
    const StoredPath* path = pathFor(take);
    if (path == nullptr || isMilled(take) == milled) return;
    std::vector<PathSource> after = path->sources;
    if (milled)
        after.push_back({take});
    else
        std::erase(after, PathSource{take});
    if (after.empty()) return;
    desk_.undo.push(new ValueCommand<std::vector<PathSource>>(
        milled ? tr("take in the path") : tr("take out of the path"), -1, path->sources, std::move(after),
        [this, own = path->id](const std::vector<PathSource>& sources) { applySources(own, sources); }));
}

} // namespace burin

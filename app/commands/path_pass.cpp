// SPDX-FileCopyrightText: 2026 The Burin authors
// SPDX-License-Identifier: Apache-2.0
#include "app/commands/path_pass.h"

#include "app/path_report.h"
#include "app/surroundings.h"
#include "app/wording.h"
#include "core/base/numbers.h"
#include "core/job/pass_preview.h"
#include "ui/panels/omission_labels.h"

#include <algorithm>
#include <array>

namespace burin {

namespace {

/// What was left out and why; lines to append to others, empty if nothing was. @param pass computed or a preview
template <class Pass>
std::string textOfOmissions(const Pass& pass, HoleWork work) {
    std::string text;
    const auto add = [&text](double length, TextId why) {
        if (length > 0.0) text += "\n" + worded(why, {formatFixed(length, 1)});
    };
    add(pass.leftOut, BURIN_TEXT("Command", "%1 mm were skipped: too much stock is in the way of the tool. Rough it "
                                            "first, or use a longer tool."));
    add(pass.inTheWay, BURIN_TEXT("Command", "%1 mm were skipped: fixtures or keep-out volumes are in the way."));
    add(pass.leftToHand, BURIN_TEXT("Command", "%1 mm were skipped: already finished by hand strokes."));
    if (pass.unreachedHoles > 0) text += "\n" + unreachedHolesText(pass.unreachedHoles, work).toStdString();
    return text;
}

/// Whether any path of the project uses a source. Errors: those of Project::paths.
Result<bool> isUsed(const Project& project, PathSource source) {
    const Result<std::vector<StoredPath>> paths = project.paths();
    if (!paths) return paths.error();
    return std::ranges::any_of(
        *paths, [&](const StoredPath& path) { return std::ranges::find(path.sources, source) != path.sources.end(); });
}

/// Removes passes that no path uses. Errors: also those of Project::removeGenerated.
Result<void> removeUnused(Project& project, const std::vector<PathSource>& sources) {
    for (const PathSource source : sources) {
        if (!source.isGenerated()) continue;
        const Result<bool> used = isUsed(project, source);
        if (!used) return used.error();
        if (*used) continue;
        if (Result<void> removed = project.removeGenerated(source.id); !removed) return removed;
    }
    return {};
}

} // namespace

namespace {

/// The result of a pass.
struct KeptPass {
    StoredPath path;
    std::int64_t source = 0;
    ComputedPass pass;

    nlohmann::json json() const {
        return {{"pass", source},
                {"length_mm", pass.length},
                {"left_out_mm", pass.leftOut},
                {"in_the_way_mm", pass.inTheWay},
                {"left_to_hand_mm", pass.leftToHand},
                {"unreached_holes", pass.unreachedHoles},
                {"strokes", pass.moves.strokes.size()}};
    }
    std::string text() const {
        return "\n" +
               worded(BURIN_TEXT("Command", "%1 mm in %2 strokes"),
                      {formatFixed(pass.length, 1), std::to_string(pass.moves.strokes.size())}) +
               textOfOmissions(pass, holeWorkOf(pass.moves.info));
    }
};

/// Computes a pass and stores it in the project as a source of the path. Errors: those of pathsBeforePass, computePass
/// and Project.
Result<KeptPass> keepPass(Project& project, const MillingContext& milling, StoredPath path, const PassRequest& request,
                          std::optional<std::int64_t> instead, CommandContext& context) {
    context.stage(BURIN_TEXT("Command", "Computing the pass"));
    Result<std::vector<PathMatter>> before = pathsBeforePass(project, path, milling.tool.id, request, instead);
    if (!before) return std::move(before).error();
    Result<ComputedPass> pass = computePass(milling, std::move(*before), request, context.progress());
    if (!pass) return std::move(pass).error();
    const Result<std::int64_t> source = project.addGenerated(pass->moves);
    if (!source) return source.error();
    if (const Result<void> kept = project.setTool(milling.tool); !kept) return kept.error();
    const bool isNew = path.sources.empty();
    path = withPass(std::move(path), pass->moves.info, *source, instead);
    const Result<std::int64_t> id = isNew ? project.addPath(path) : Result<std::int64_t>(path.id);
    if (!id) return id.error();
    path.id = *id;
    if (!isNew)
        if (const Result<void> stored = project.setPath(path); !stored) return stored.error();
    if (instead)
        if (const Result<void> removed = removeUnused(project, {{*instead}}); !removed) return removed.error();
    return KeptPass{std::move(path), *source, std::move(*pass)};
}

/// Reports an estimate of a pass without storing anything.
int tellPreview(const Project& project, const MillingContext& milling, const StoredPath& path,
                const PassRequest& request, std::optional<std::int64_t> instead, CommandContext& context) {
    context.stage(BURIN_TEXT("Command", "Computing the preview"));
    Result<std::vector<PathMatter>> before = pathsBeforePass(project, path, milling.tool.id, request, instead);
    if (!before) return context.fail(before.error());
    const Result<PassBasis> basis = passBasis(milling, std::move(*before), request.allowance,
                                              request.hand != HandStrokes::ignore, context.progress());
    if (!basis) return context.fail(basis.error());
    const Result<PassPreview> preview = previewPass(*basis, milling, request, context.progress());
    if (!preview) return context.fail(preview.error());
    context.answer({{"estimated_length_mm", preview->length},
                    {"estimated_time_s", preview->duration},
                    {"planned_share", 1.0 / preview->every}},
                   worded(BURIN_TEXT("Command", "about %1 mm in %2 s at the feed of tool and material, without links"),
                          {formatFixed(preview->length, 0), formatFixed(preview->duration, 0)}) +
                       textOfOmissions(*preview, holeWorkOf(request)));
    return 0;
}

/// Errors: nameUnknown.
Result<void> checkPassOf(const StoredPath& path, std::optional<std::int64_t> pass) {
    if (!pass ||
        (PathSource{*pass}.isGenerated() && std::ranges::find(path.sources, PathSource{*pass}) != path.sources.end()))
        return {};
    return Error{ErrorCode::nameUnknown, "pass", std::to_string(*pass), {}};
}

} // namespace

Result<std::vector<std::int64_t>> outdatedPassesOf(const Project& project, const StoredPath& path,
                                                   const MillingContext& milling, KeptLeads& kept,
                                                   CommandContext& context) {
    Result<LedPasses> led = ledPasses(project, path, kept, context.progress());
    if (!led) return std::move(led).error();
    return outdatedPasses(std::move(*led), milling, kept, context.progress());
}

int addPassTo(ProjectChange& project, StoredPath path, const PassArguments& arguments, const std::string& machine,
              CommandContext& context) {
    if (const Result<void> known = checkPassOf(path, arguments.instead); !known) return context.fail(known.error());
    const Result<std::vector<SourceInfo>> sources = sourcesOf(*project);
    if (!sources) return context.fail(sources.error());
    const std::string own = path.sources.empty() ? std::string() : toolOf(path, *sources);
    const std::string toolId = arguments.tool.empty() ? own : arguments.tool;
    if (toolId.empty())
        return context.fail(
            {ErrorCode::argumentInvalid, "--tool", "", worded(BURIN_TEXT("Command", "a tool for the pass"))});
    if (!own.empty() && toolId != own)
        return context.fail(
            {ErrorCode::argumentInvalid, "--tool", toolId,
             worded(BURIN_TEXT("Command", "%1, the tool of this path; make a new path for another tool"), {own})});
    const Result<Tool> tool = toolFor(*project, toolId);
    if (!tool) return context.fail(tool.error());
    context.stage(BURIN_TEXT("Command", "Opening"));
    const Result<MillingContext> milling =
        makeMillingContext(*project, *tool, machineFor(*project, machine, context), context.progress());
    if (!milling) return context.fail(milling.error());
    const Result<PassRequest> request = requestOf(arguments, *project, *milling->partModel, context);
    if (!request) return context.fail(request.error());
    if (arguments.preview) return tellPreview(*project, *milling, path, *request, arguments.instead, context);
    const Result<KeptPass> kept = keepPass(*project, *milling, std::move(path), *request, arguments.instead, context);
    if (!kept) return context.fail(kept.error());
    return saveAndAnswer(project, kept->path, context, kept->json(), kept->text());
}

int recompute(ProjectChange& project, StoredPath path, const PassChoice& choice, const std::string& machine,
              CommandContext& context) {
    const std::optional<std::int64_t> pass = choice.pass;
    if (const Result<void> known = checkPassOf(path, pass); !known) return context.fail(known.error());
    Result<std::vector<GeneratedInfo>> passes = passesOf(*project, path);
    if (!passes) return context.fail(passes.error());
    std::erase_if(*passes, [](const GeneratedInfo& each) { return each.request.empty(); }); // those of programs
    if (passes->empty())
        return context.fail({ErrorCode::argumentInvalid, "PATH", std::to_string(path.id),
                             worded(BURIN_TEXT("Command", "a path with a computed pass"))});
    const Result<Tool> tool = toolFor(*project, passes->front().toolId);
    if (!tool) return context.fail(tool.error());
    context.stage(BURIN_TEXT("Command", "Opening"));
    const Result<MillingContext> milling =
        makeMillingContext(*project, *tool, machineFor(*project, machine, context), context.progress());
    if (!milling) return context.fail(milling.error());
    KeptLeads leads;
    if (choice.outdatedOnly) {
        const Result<std::vector<std::int64_t>> outdated = outdatedPassesOf(*project, path, *milling, leads, context);
        if (!outdated) return context.fail(outdated.error());
        std::erase_if(*passes, [&](const GeneratedInfo& each) {
            return std::ranges::find(*outdated, each.id) == outdated->end();
        });
    }
    nlohmann::json made = nlohmann::json::array();
    if (passes->empty())
        return answerUnchanged(*project, path, context, {{"computed", std::move(made)}},
                               "\n" + worded(BURIN_TEXT("Command", "all passes are up to date")));
    std::string text;
    for (const GeneratedInfo& each : *passes) {
        if (pass && each.id != *pass) continue;
        Result<PassRequest> request = passRequestFromJson(each.request, each.name);
        if (!request) return context.fail(request.error());
        Result<std::vector<LeadTake>> takes = readLeads(*project, takesOf(*request), leads, context.progress());
        if (!takes) return context.fail(takes.error());
        request = ledAnew(std::move(*request), std::move(*takes), leads, context.progress());
        if (!request) return context.fail(request.error());
        Result<KeptPass> kept = keepPass(*project, *milling, std::move(path), *request, each.id, context);
        if (!kept) return context.fail(kept.error());
        made.push_back(kept->json());
        text += kept->text();
        path = std::move(kept->path);
    }
    return saveAndAnswer(project, path, context, {{"computed", std::move(made)}}, text);
}

int removeFrom(ProjectChange& project, StoredPath path, std::optional<std::int64_t> pass, CommandContext& context) {
    std::vector<PathSource> gone = path.sources;
    if (pass) {
        gone = {{*pass}};
        if (!gone.front().isGenerated() || std::erase(path.sources, gone.front()) == 0)
            return context.fail({ErrorCode::nameUnknown, "pass", std::to_string(*pass), {}});
    }
    const bool whole = !pass || path.sources.empty();
    const Result<void> changed = whole ? project->removePath(path.id) : project->setPath(path);
    if (!changed) return context.fail(changed.error());
    if (const Result<void> removed = removeUnused(*project, gone); !removed) return context.fail(removed.error());
    if (!whole) return saveAndAnswer(project, path, context, {{"deleted", false}});
    if (const Result<void> saved = project.save(); !saved) return context.fail(saved.error());
    tellKeptEarlier(context, *project);
    context.answer({{"id", path.id}, {"deleted", true}},
                   worded(BURIN_TEXT("Command", "path %1 was deleted"), {std::to_string(path.id)}));
    return 0;
}

} // namespace burin

// SPDX-FileCopyrightText: 2026 The Burin authors
// SPDX-License-Identifier: Apache-2.0
#include "core/job/computed_pass.h"

#include "core/base/numbers.h"
#include "core/job/cut_depth.h"
#include "core/job/job_paths.h"
#include "core/passes/plan_pass.h"
#include "core/passes/surface_pass.h"
#include "core/path/path_source.h"

#include <algorithm>
#include <limits>

namespace burin {

namespace {

/// Placeholder in the order of a path's sources for a source without an id; no source of a project has this id.
constexpr std::int64_t yetToCome = std::numeric_limits<std::int64_t>::min();

/// The same for threads.
std::string whyNoThread(const PlannedPass& planned, const PassRequest& request) {
    const std::string needed = formatFixed(planned.neededDrilling, 3) + " mm in the coordinates of the setup";
    if (!request.external && planned.unreachedHoles > 0)
        return "the holes are not drilled as deep as the thread: drill them first, with the full diameter down to Z " +
               needed;
    if (!request.external) return "the part has no upright hole of the thread's major diameter there";
    if (planned.unmilledStud && planned.unmilledStud->diameter < planned.unmilledStud->allowed)
        return "the studs are milled to " + formatFixed(planned.unmilledStud->diameter, 2) +
               " mm, too narrow for the thread's major diameter, " + formatFixed(planned.unmilledStud->allowed, 2) +
               " mm";
    if (planned.unmilledStud)
        return "the stock around the studs is in the way: mill it to the thread's major diameter first, " +
               formatFixed(planned.unmilledStud->allowed, 2) + " mm, down to Z " + needed;
    if (planned.unreachedHoles > 0) return "the part is in the way of the tool around its studs, or it is too short";
    return "the part has no upright stud of the thread's minor diameter there";
}

/// Returns why a pass has nothing to do, worded as an error's detail.
std::string whyEmpty(const PlannedPass& planned, const PassRequest& request) {
    if (planned.inTheWay > 0.0) return "fixtures or keep-out volumes are in the way: move them";
    if (planned.leftOut > 0.0) return "too much stock is in the way of the tool: rough it first, or use a longer tool";
    if (planned.leftToHand > 0.0) return "strokes of the hand have finished the part there";
    if (request.kind == PassKind::pencil && !request.restOnly)
        return "the part has no concave edge for this tool there";
    if (request.kind == PassKind::thread) return whyNoThread(planned, request);
    if (planned.unreachedHoles > 0) return "the part is in the way of the drill, or the drill is too short";
    if (request.kind == PassKind::drill && request.places.empty())
        return "the part has no upright hole there that fits this drill and is not drilled yet";
    return "no stock is left there";
}

/// Moves whose planner shares out the cutting feed get feeds and speed of tool and material.
void stateFeeds(const PlannedPass& planned, const CuttingConditions& conditions, GeneratedMoves& moves) {
    if (planned.feedShares.empty()) return;
    for (std::size_t s = 0; s < moves.strokes.size(); ++s)
        for (std::size_t i = 0; i < moves.strokes[s].size(); ++i) {
            moves.strokes[s][i].feed = plannedFeed(planned, s, i, conditions);
            moves.strokes[s][i].spindleSpeed = conditions.spindleSpeed;
        }
}

} // namespace

Result<std::vector<PathMatter>> pathsBeforePass(const Project& project, StoredPath path, const std::string& toolId,
                                                const PassRequest& request, std::optional<std::int64_t> instead) {
    if (instead) path.sources.erase(std::ranges::find(path.sources, PathSource{*instead}), path.sources.end());
    return pathsBefore(project, path, {{yetToCome}, toolId, request.allowance, 0.0});
}

Result<PassBasis> passBasis(const MillingContext& milling, std::vector<PathMatter> before, double allowance,
                            bool heedsHand, Progress& progress) {
    PassBasis basis;
    basis.allowance = allowance;
    // The path of the pass itself is the last, and the only one of its tool.
    if (heedsHand) basis.handStrokes.emplace();
    if (heedsHand && !before.empty() && before.back().tool.id == milling.tool.id) {
        const ProgressPart part(progress, 0.0, 0.1);
        Result<std::vector<TipLine>> strokes =
            handStrokes(before.back().sources, before.back().path, milling, progress);
        if (!strokes) return std::move(strokes).error();
        basis.handStrokes = std::move(*strokes);
    }
    {
        const ProgressPart part(progress, 0.1, 0.7);
        const auto look = [&](RunVolume& stock) -> Result<void> {
            basis.standing = seenFromAbove(stock);
            return {};
        };
        if (Result<void> seen = lendStockBehind(milling, std::move(before), look, progress); !seen)
            return std::move(seen).error();
    }
    if (!needsField(milling.tool)) return basis;
    const ProgressPart part(progress, 0.7, 1.0);
    Result<std::unique_ptr<const ClearanceField>> field = clearanceField(milling, allowance, progress);
    if (!field) return std::move(field).error();
    basis.field = std::move(*field);
    return basis;
}

Result<PlannedPass> planOn(const PassBasis& basis, const MillingContext& milling, const PassRequest& request,
                           double coarseness, Progress& progress) {
    const Tool tool = plannedTool(milling);
    const ClearingSteps steps = clearingSteps(milling);
    const double stated = milling.tool.maximumDepthOfCut; // bending and breaking limit feeds only: a row is narrow
    const std::vector<ObstacleSolid> obstacles = solidsOf(milling.surroundings());
    const PassGround ground{milling.part,
                            basis.field.get(),
                            tool,
                            milling.setup.stock,
                            obstacles,
                            basis.standing,
                            steps.levelDepth,
                            stated > 0.0 ? stated : tool.cutter.fluteLength,
                            coarseness,
                            steps.stepOver,
                            basis.handStrokes.value_or(std::vector<TipLine>{})};
    return planPass(request, ground, progress);
}

double plannedFeed(const PlannedPass& planned, std::size_t stroke, std::size_t point,
                   const CuttingConditions& conditions) {
    const double share = planned.feedShares.empty() ? 1.0 : planned.feedShares[stroke][point];
    if (share > 0.0) return share * conditions.feed;
    const TipLine& tips = planned.strokes[stroke];
    return point > 0 && tips[point].z < tips[point - 1].z ? conditions.plungeFeed : conditions.feed;
}

Result<ComputedPass> computePass(const MillingContext& milling, std::vector<PathMatter> before,
                                 const PassRequest& request, Progress& progress) {
    if (Result<void> good = checkPass(request, milling.tool); !good) return std::move(good).error();
    const Result<PassBasis> basis = [&] {
        const ProgressPart part(progress, 0.0, 0.6);
        return passBasis(milling, std::move(before), request.allowance, request.hand != HandStrokes::ignore, progress);
    }();
    if (!basis) return basis.error();
    const ProgressPart part(progress, 0.6, 1.0);
    const Result<PlannedPass> planned = planOn(*basis, milling, request, 1.0, progress);
    if (!planned) return planned.error();
    if (planned->strokes.empty())
        return Error{ErrorCode::pathEmpty, rowOf(request.kind).title.text, "", whyEmpty(*planned, request)};
    GeneratedInfo info;
    info.name = rowOf(request.kind).title.text;
    info.toolId = milling.tool.id;
    info.allowance = request.allowance;
    PassRequest computed = request;
    computed.strokesDigest = basis->handStrokes ? digestOf(*basis->handStrokes) : std::string();
    info.request = toJson(computed);
    GeneratedMoves moves = movesOf(*planned, std::move(info));
    stateFeeds(*planned, milling.conditions, moves);
    return ComputedPass{std::move(moves),  lengthOf(*planned),  planned->leftOut,
                        planned->inTheWay, planned->leftToHand, planned->unreachedHoles};
}

HoleWork holeWorkOf(const GeneratedInfo& pass) {
    const Result<PassRequest> request = passRequestFromJson(pass.request, pass.name);
    return request ? holeWorkOf(*request) : HoleWork::drilling;
}

bool millsThreads(const GeneratedInfo& pass) {
    return holeWorkOf(pass) != HoleWork::drilling;
}

StoredPath withPass(StoredPath path, const GeneratedInfo& pass, std::int64_t source,
                    std::optional<std::int64_t> instead) {
    constexpr double arcTolerance = 0.003; // mm: arcs of threads stay near their helix
    const bool isNew = path.sources.empty() && !instead;
    if (isNew) path.edits = computedEdits();
    if (millsThreads(pass))
        for (Edit& edit : path.edits) {
            if (auto* feeds = std::get_if<SetFeed>(&edit.parameters)) feeds->feeds = SetFeed::Feeds::program;
            if (auto* arcs = std::get_if<FitArcs>(&edit.parameters); arcs != nullptr && isNew)
                arcs->tolerance = arcTolerance;
        }
    if (instead) {
        std::ranges::replace(path.sources, PathSource{*instead}, PathSource{source});
        return path;
    }
    if (isNew && path.name.empty()) path.name = pass.name;
    path.sources.push_back({source});
    return path;
}

Result<std::vector<PathSource>> movedSource(std::vector<PathSource> sources, PathSource moved, std::size_t position) {
    const auto found = std::ranges::find(sources, moved);
    if (found == sources.end()) return Error{ErrorCode::nameUnknown, "pass", std::to_string(moved.id), {}};
    if (position >= sources.size())
        return Error{ErrorCode::argumentInvalid, "position", std::to_string(position),
                     "0 to " + std::to_string(sources.size() - 1)};
    sources.erase(found);
    sources.insert(sources.begin() + static_cast<std::ptrdiff_t>(position), moved);
    return sources;
}

} // namespace burin

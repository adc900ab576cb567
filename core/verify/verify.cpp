// SPDX-FileCopyrightText: 2026 The Burin authors
// SPDX-License-Identifier: Apache-2.0
#include "core/verify/verify.h"

#include "core/base/units.h"
#include "core/geometry/revolved_piece.h"
#include "core/tool/hollow_tip.h"
#include "core/verify/causes.h"
#include "core/verify/check_memory.h"
#include "core/verify/corner_cutting.h"
#include "core/verify/deviation_map.h"
#include "core/verify/excess.h"
#include "core/verify/findings.h"
#include "core/verify/gouge.h"
#include "core/verify/limits.h"
#include "core/verify/load_chart.h"
#include "core/verify/load_limits.h"
#include "core/verify/near_pass.h"
#include "core/verify/obstacles.h"
#include "core/verify/outline.h"
#include "core/verify/program_settings.h"
#include "core/verify/program_tools.h"
#include "core/verify/promised_path.h"
#include "core/verify/replay.h"
#include "core/verify/side_lines.h"
#include "core/verify/tool_moves.h"
#include "core/verify/touched_voxels.h"

#include <algorithm>
#include <cmath>
#include <optional>
#include <utility>

namespace burin {

namespace {

/// The part's outline, shrunk by the radius of each tool.
std::vector<ShrunkOutline> outlinesFor(const std::vector<Tool>& tools, const RunVolume& workpiece) {
    std::vector<ShrunkOutline> outlines;
    for (const Tool& tool : tools) outlines.emplace_back(workpiece, tool.cutter.radius());
    return outlines;
}

void summariseExcess(VerifyReport& report) {
    const ExcessSummary summary = summaryOf(report.deviations);
    report.excessMax = summary.most;
    report.excessMean = summary.mean;
    report.reachableShare = summary.reachableShare;
}

/// Assigns each gouge beyond the tolerance to the sample of the part that is nearest to it.
void markGouges(const std::vector<GougePlace>& places, double voxel, std::vector<DeviationSample>& samples) {
    if (places.empty()) return;
    const DeviationMap map(samples, voxel);
    for (const GougePlace& gouge : places) {
        const std::optional<std::size_t> nearest = map.nearest(gouge.place, 2.0 * voxel);
        if (nearest) samples[*nearest].gouge = std::max(samples[*nearest].gouge, gouge.depth);
    }
}

/// The moves that milled the workpiece before.
struct EarlierMoves {
    std::vector<ToolMove> moves;
    std::vector<Tool> tools;
};

/// Cuts what an earlier program cut; faults of that program are not attributed to the one that is judged.
Result<EarlierMoves> millBefore(const VerifyRequest& request, RunVolume& workpiece, Progress& progress) {
    if (request.before == nullptr) return EarlierMoves{};
    VerifyRequest earlier;
    earlier.program = request.before;
    if (request.toolsBefore.size() == 1) earlier.tool = request.toolsBefore.front();
    if (request.toolsBefore.size() > 1) earlier.tools = request.toolsBefore;
    const Result<ProgramTools> tools = toolsOf(earlier);
    if (!tools) return tools.error();
    if (tools->known < request.before->motions.size()) return unknownTool(earlier, *tools);
    EarlierMoves earlierMoves{toolMoves(*request.before, request.setup.workOffset, request.machine, tools->ofMotion),
                              tools->tools};
    Findings unwanted;
    const Result<std::vector<MoveCut>> cuts =
        replay(earlierMoves.moves, earlierMoves.tools, workpiece, unwanted, progress);
    if (!cuts) return cuts.error();
    return earlierMoves;
}

void judgeProtection(const EmbeddedSetup& embedded, Findings& findings) {
    double bodies = 0.0;
    for (const EmbeddingFinding& finding : embedded.findings)
        if (finding.kind == EmbeddingFinding::Kind::tooSmall)
            findings.add(FindingKind::partNotProtected, 0, finding.place.centre(), ++bodies);
}

void take(const GougeJudgement& gouges, VerifyReport& report) {
    report.gougeMax = gouges.maximum;
    report.gougeMaxMesh = gouges.maximumMesh;
    report.samples = gouges.samples;
    report.exactSamples = gouges.exactSamples;
    report.onPartSamples = gouges.finishSamples;
    if (gouges.finishSamples > 0)
        report.onPartShare = static_cast<double>(gouges.onPart) / static_cast<double>(gouges.finishSamples);
}

void judgeLoads(const ReplayedProgram& replayed, const VerifyRequest& request, const PropertyList& properties,
                Findings& findings, VerifyReport& report) {
    LoadJudge judge(request.machine, replayed.tools, request.gougeTolerance);
    LoadRecord record = recordLoads(replayed, properties, [&](const ToldLoad& told) { judge.look(told); });
    report.loads = std::move(record.motions);
    report.loadSteps = std::move(record.steps);
    judge.conclude(findings, report.warnings);
    report.feedLimits = judge.feedLimits();
}

/// A tool that cuts as a solid does so upright only.
Result<void> checkTilts(const std::vector<ToolMove>& moves, const std::vector<Tool>& tools) {
    for (const ToolMove& move : moves)
        if (move.tilted() && tools[move.tool].cutter.solid != nullptr)
            return Error{ErrorCode::notSupported, "tilted tool axis",
                         "tools that turn and are not hollow, unlike " + tools[move.tool].name,
                         "line " + std::to_string(move.line)};
    return {};
}

/// Height of material that a tool which does not cut at its centre may meet straight from above, mm: crumbs.
constexpr double plungeAllowed = 0.15;

/// Section of the flutes at the height of a crumb above the tip, mm².
double sectionAtTip(const Cutter& cutter) {
    double radius = 0.0;
    for (const RevolvedPiece& piece : flutePieces(cutter))
        if (piece.bottom <= plungeAllowed && piece.top >= plungeAllowed)
            radius = std::max(radius, radiusAt(piece, plungeAllowed));
    return pi * radius * radius;
}

/// How deep a move straight down has cut below the centre of a tool, mm. A hollow tip leaves a core at first: only what
/// is removed beyond the ring around it counts, with a margin for the scanlines. A hollow around a pin leaves none.
double depthBelowCentre(const Cutter& cutter, double down, double volume) {
    constexpr double ringMargin = 1.1;
    const bool leavesCore = cutter.isHollow() && boreAt(*cutter.solid, 0.5 * cutter.hollow().height) > 0.0;
    if (!leavesCore) return std::min(down, volume / sectionAtTip(cutter));
    const double core = pi * cutter.hollow().radius * cutter.hollow().radius;
    const double ring = pi * cutter.radius() * cutter.radius() - core;
    return std::clamp((volume - ringMargin * ring * down) / core, 0.0, down);
}

/// Reports feeds straight down, or nearly so, into material below the centre of a tool that does not cut there.
/// Consecutive moves count as one plunge.
void judgePlunges(const ReplayedProgram& replayed, Findings& findings) {
    constexpr double steepest = 0.1; // sideways over down
    double depth = 0.0;
    for (std::size_t i = 0; i < replayed.moves->size(); ++i) {
        const ToolMove& move = (*replayed.moves)[i];
        const Tool& tool = replayed.tools[move.tool];
        const glm::dvec3 way = move.to.tip - move.begin().tip;
        const bool down = !move.tilted() && way.z < 0.0 && std::hypot(way.x, way.y) < -steepest * way.z;
        if (tool.centreCutting || !tool.cutter.turns() || move.rapid || !down) {
            depth = 0.0;
            continue;
        }
        const MoveCut& cut = (*replayed.cuts)[i];
        if (!(cut.volume > 0.0)) continue;
        if (std::hypot(cut.centroid.x - move.to.tip.x, cut.centroid.y - move.to.tip.y) > 0.5 * tool.cutter.radius())
            continue;
        depth += depthBelowCentre(tool.cutter, -way.z, cut.volume);
        if (depth > plungeAllowed) findings.add(FindingKind::centrePlunge, move.line, move.to.tip, depth);
    }
}

/// Uses a workpiece of its own, and only if something collided: keeping it from the beginning would cost every check
/// the memory of a second one.
Result<void> addTouchedVoxels(const VerifyRequest& request, const std::vector<ToolMove>& moves,
                              std::span<const Tool> tools, const Findings& findings, VerifyReport& report,
                              Progress& progress) {
    const std::vector<Finding> found = findings.inProgramOrder();
    if (std::ranges::none_of(found, isShankOrHolder)) return {};
    Result<EmbeddedSetup> embedded = embed(*request.model, request.setup, request.materials, progress);
    if (!embedded) return std::move(embedded).error();
    if (const Result<EarlierMoves> earlier = millBefore(request, embedded->workpiece, progress); !earlier)
        return earlier.error();
    Result<std::vector<TouchedVoxels>> touched = findTouchedVoxels(moves, tools, embedded->workpiece, found, progress);
    if (!touched) return std::move(touched).error();
    report.touched = std::move(*touched);
    return {};
}

/// What a check and its steps share.
struct CheckGround {
    const VerifyRequest& request;
    EmbeddedSetup& embedded; ///< fresh
    const std::vector<ToolMove>& moves;
    const std::vector<Tool>& tools;
    const std::vector<std::uint32_t>& numbers; ///< of the moves (KnownMoves)
    CheckMemory& memory;
};

/// What no move does to the stock: bodies, limits, corners and paths.
Result<PathComparison> judgeMoves(const CheckGround& ground, Findings& findings, NearPasses& passes,
                                  Progress& progress) {
    const auto& [request, embedded, moves, tools, numbers, memory] = ground;
    judgeSettings(request, findings);
    if (Result<void> judged =
            judgeLimits(moves, request.program->maximumSpindleSpeed, request.machine, request.travel, findings);
        !judged)
        return std::move(judged).error();
    judgeRotaryAxes(*request.program, request.machine, findings);
    if (Result<void> judged = judgeObstacles(moves, tools, request, numbers, memory.obstacles, findings, progress);
        !judged)
        return std::move(judged).error();
    if (Result<void> judged = judgeCorners(moves, tools, request, findings, progress); !judged)
        return std::move(judged).error();
    Result<PathComparison> comparison = comparePaths(moves, tools, request, findings, progress);
    if (!comparison) return comparison;
    judgeProtection(embedded, findings);
    if (Result<void> judged = judgeNearPasses(moves, tools, request, numbers, memory.passes, passes, progress); !judged)
        return std::move(judged).error();
    return comparison;
}

/// Cuts the moves: out of a volume of its own if the fresh workpiece is kept, otherwise out of that.
struct CutStock {
    std::optional<RunVolume> own;
    std::vector<MoveCut> cuts;
    std::vector<StepCut> steps;

    Result<void> make(const CheckGround& ground, const ExactStock& exact, bool keepsFresh, Findings& findings,
                      NearPasses& passes, Progress& progress) {
        const NearWatch near{ground.request.nearDistance, &passes};
        RunVolume& fresh = ground.embedded.workpiece;
        if (!keepsFresh) {
            Result<std::vector<MoveCut>> made =
                replay(ground.moves, ground.tools, fresh, findings, progress, near, &steps, &exact);
            if (!made) return std::move(made).error();
            cuts = std::move(*made);
            return {};
        }
        Result<MachinedWorkpiece> made = replay(ground.moves, ground.tools, fresh, ground.memory.rows, ground.numbers,
                                                findings, progress, near, &steps, &exact);
        if (!made) return std::move(made).error();
        cuts = std::move(made->cuts);
        own.emplace(std::move(made->workpiece));
        return {};
    }
};

/// Embeds the workpiece, unless a fresh one is kept. A large one is taken out of the memory: it will be cut.
Result<std::optional<EmbeddedSetup>> prepare(const VerifyRequest& request, const std::vector<Tool>& tools, bool mayKeep,
                                             CheckMemory& memory, Progress& progress) {
    if (!memory.embedded) {
        Result<EmbeddedSetup> embedded = embed(*request.model, request.setup, request.materials, progress);
        if (!embedded) return std::move(embedded).error();
        memory.embedded.emplace(std::move(*embedded));
    }
    if (memory.outlines.empty()) memory.outlines = outlinesFor(tools, memory.embedded->workpiece);
    const bool keeps = mayKeep && memory.embedded->workpiece.reservedBytes() <= KeptCheck::mostBytes / 2;
    return keeps ? std::optional<EmbeddedSetup>() : std::exchange(memory.embedded, std::nullopt);
}

Result<VerifyReport> check(const VerifyRequest& request, const ProgramTools& tools, CheckMemory& memory, bool mayKeep,
                           Progress& progress, VolumeSnapshot* machined) {
    progress.stage(0.0, 0.05);
    Result<std::optional<EmbeddedSetup>> own = prepare(request, tools.tools, mayKeep, memory, progress);
    if (!own) return std::move(own).error();
    const bool keepsFresh = !own->has_value();
    EmbeddedSetup& embedded = keepsFresh ? *memory.embedded : **own;
    RunVolume& fresh = embedded.workpiece;
    const Result<EarlierMoves> earlier = millBefore(request, fresh, progress);
    if (!earlier) return earlier.error();

    std::vector<ToolMove> moves =
        toolMoves(*request.program, request.setup.workOffset, request.machine, tools.ofMotion);
    std::erase_if(moves, [&](const ToolMove& move) { return move.motion >= tools.known; });
    if (Result<void> cut = checkTilts(moves, tools.tools); !cut) return std::move(cut).error();
    const std::vector<std::uint32_t> numbers = memory.moves.numbersOf(moves);
    memory.movesOfProgram = moves.size();
    const CheckGround ground{request, embedded, moves, tools.tools, numbers, memory};
    Findings findings;
    NearPasses passes;
    VerifyReport report;
    const Result<PathComparison> comparison = judgeMoves(ground, findings, passes, progress);
    if (!comparison) return comparison.error();
    const MachiningTime time = machiningTime(*request.program, request.machine);
    report.machiningSeconds = time.seconds;
    report.secondsWithoutAcceleration = time.withoutAcceleration;
    report.rapids = request.machine.rapids;
    report.pathModes = statedPathModes(*request.program);

    progress.stage(0.05, 0.4);
    const ExactStock exact{request.setup.stock, earlier->moves, earlier->tools};
    // The exact width of a stock is only known for a box.
    const std::optional<SideLines> sides = request.setup.form == StockForm::box
                                               ? std::optional<SideLines>(std::in_place, fresh, request.setup.stock)
                                               : std::nullopt;
    CutStock stock;
    if (Result<void> cut = stock.make(ground, exact, keepsFresh, findings, passes, progress); !cut)
        return std::move(cut).error();
    RunVolume& workpiece = stock.own ? *stock.own : fresh;
    for (const MoveCut& cut : stock.cuts) report.removed += cut.volume;
    if (sides) report.removed += sides->removedBeside(workpiece);
    const ReplayedProgram replayed{request.program, &moves, &stock.cuts,        &stock.steps,
                                   tools.tools,     &time,  request.setup.voxel};
    judgeLoads(replayed, request, workpiece.properties(), findings, report);
    judgePlunges(replayed, findings);
    report.times = time.motions;
    report.toolChanges = time.toolChanges;
    report.untimedMoves = time.untimedMoves;

    progress.stage(0.4, 0.9);
    const Result<GougeJudgement> gouges =
        judgeGouges(moves, tools.tools, memory.outlines, request, numbers, memory.gouges, findings, progress);
    if (!gouges) return gouges.error();
    take(*gouges, report);

    progress.stage(0.9, 1.0);
    Result<std::vector<DeviationSample>> deviations =
        measureExcess(workpiece, request, tools.tools, memory.reach, progress);
    if (!deviations) return std::move(deviations).error();
    report.deviations = std::move(*deviations);
    markGouges(gouges->places, request.setup.voxel, report.deviations);
    summariseExcess(report);

    report.findings = byCause(findings.inProgramOrder(), *request.program, *comparison);
    report.nearPasses = passes.byPlace();
    if (machined != nullptr) *machined = workpiece.snapshot();
    if (Result<void> found = addTouchedVoxels(request, moves, tools.tools, findings, report, progress); !found)
        return std::move(found).error();
    progress.report(1.0);
    return report;
}

} // namespace

Result<VerifyReport> verify(const VerifyRequest& request, Progress& progress, VolumeSnapshot* machined,
                            KeptCheck* kept) {
    const Result<ProgramTools> tools = toolsOf(request);
    if (!tools) return tools.error();
    if (kept == nullptr || request.before != nullptr) {
        CheckMemory nothing;
        return check(request, *tools, nothing, false, progress, machined);
    }
    CheckMemory& memory = kept->begin(basisText(request, tools->tools));
    Result<VerifyReport> report = check(request, *tools, memory, true, progress, machined);
    kept->end();
    return report;
}

} // namespace burin

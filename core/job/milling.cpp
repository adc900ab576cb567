// SPDX-FileCopyrightText: 2026 The Burin authors
// SPDX-License-Identifier: Apache-2.0
#include "core/job/milling.h"

#include "core/base/text.h"
#include "core/base/units.h"
#include "core/haptics/operator/hostile_stylus.h"
#include "core/job/cut_depth.h"
#include "core/job/milling_session.h"
#include "core/job/planning_frame.h"

#include <algorithm>
#include <chrono>
#include <thread>

namespace burin {

namespace {

/// How far the tip can be moved above the stock's top and beyond its sides.
constexpr double travelMargin = 10.0; // mm
/// Room below a part's surface, which the hand needs to press on it.
constexpr double pressMargin = 5.0; // mm
/// Interval for checking whether a session has ended.
constexpr std::chrono::milliseconds glance{5};

/// Accumulates the samples of a take.
class TakeFigures {
public:
    explicit TakeFigures(std::span<const SampleRange> undone) noexcept : undone_(undone) {}

    void add(std::span<const Sample> next) noexcept {
        outcome_.samples += next.size();
        for (const Sample& sample : next)
            if (!undone_.holds(index_++)) add(sample);
    }
    TakeOutcome outcome(const Grid& grid) const {
        TakeOutcome outcome = outcome_;
        outcome.removed = static_cast<double>(units_) * grid.unitVolume();
        return outcome;
    }

private:
    void add(const Sample& sample) noexcept {
        for (const RemovedMaterial& removed : sample.removed) units_ += removed.units;
        if ((sample.flags & sampleShankContact) != 0) ++outcome_.shankTicks;
        if ((sample.flags & sampleOnObstacle) != 0) ++outcome_.obstacleTicks;
        if ((sample.flags & sampleAxisHeld) != 0) ++outcome_.axisHeldTicks;
        outcome_.largestForce = std::max(outcome_.largestForce, glm::length(sample.force));
        outcome_.largestTorque = std::max(outcome_.largestTorque, glm::length(sample.torque));
        outcome_.largestCuttingForce = std::max(outcome_.largestCuttingForce, glm::length(sample.cuttingForce));
    }

    TakeOutcome outcome_;
    UndoneSamples undone_;
    std::uint64_t units_ = 0, index_ = 0;
};

/// Returns the values of a take from the project: from what is on the disk, not from what should have been written.
Result<TakeOutcome> outcomeOf(const Project& project, const MillingContext& milling, std::int64_t id) {
    const Result<TakeOutline> take = project.takeOutline(id);
    if (!take) return take.error();
    TakeFigures figures(take->undone);
    Result<void> read = project.visitSamples(id, [&](std::span<const Sample> samples) -> Result<void> {
        figures.add(samples);
        return {};
    });
    if (!read) return std::move(read).error();
    TakeOutcome outcome = figures.outcome(milling.embedded.workpiece.grid());
    outcome.take = id;
    return outcome;
}

/// Returns grooves as scribbled by a hand into a block: a frame, then waves across it, at half the cutter's depth.
std::vector<IntentPoint> freeHandGrooves(const MillingContext& milling) {
    const Box& stock = milling.setup.stock;
    const double radius = milling.tool.cutter.radius();
    const double depth = stock.high.z - radius, above = stock.high.z + std::max(1.0, radius);
    const HandSpeeds speeds;
    const double cutting = std::min(speeds.cutting, 20.0 * radius); // takes as long on a small block as on a large one
    const glm::dvec3 centre = stock.centre(), half = 0.5 * stock.size() - glm::dvec3(2.0 * radius);
    std::vector<IntentPoint> points;
    const auto at = [&](double x, double y, double z, double speed) {
        points.push_back({glm::dvec3(centre.x + x * half.x, centre.y + y * half.y, z), speed});
    };
    at(-1.0, -1.0, above, speeds.travelling);
    at(-1.0, -1.0, depth, cutting);
    for (const auto& [x, y] : {std::pair{1.0, -1.0}, {1.0, 1.0}, {-1.0, 1.0}, {-1.0, -1.0}}) at(x, y, depth, cutting);
    at(-1.0, -1.0, above, speeds.travelling);
    at(-0.8, 0.0, above, speeds.travelling);
    constexpr int steps = 240;
    for (int i = 0; i <= steps; ++i) {
        const double part = static_cast<double>(i) / steps;
        at(-0.8 + 1.6 * part, 0.6 * std::sin(6.0 * pi * part), depth, cutting);
    }
    at(0.8, 0.0, above, speeds.travelling);
    return points;
}

/// Returns the height map of the stock left by earlier takes; empty if the stock is complete.
StandingStock standingStock(const MillingContext& milling) {
    constexpr double untouched = 1e-6; // share of its volume
    if (milling.workpieceVolume() > (1.0 - untouched) * milling.embedded.stockVolume) return {};
    return seenFromAbove(milling.embedded.workpiece);
}

Result<MillingPlan> planFor(const MillingContext& milling, const PlanningFrame& frame, const OperatorRequest& request,
                            const OperatorSettings& hand, double scale) {
    if (milling.partModel->bodies.empty()) {
        MillingPlan plan;
        plan.roughing = freeHandGrooves(milling);
        return plan;
    }
    MillingRequest wanted;
    wanted.stock = frame.stock();
    wanted.roughing.bottom = frame.part().low.z;
    wanted.roughing.allowance = request.allowance;
    wanted.roughing.stepOver = request.roughingStepOver;
    wanted.roughing.levelDepth = request.levelDepth;
    wanted.roughing.finishingDepth = request.finishingDepth;
    wanted.finishing.part = frame.part();
    wanted.finishing.floor = frame.part().low.z;
    wanted.finishing.press = request.press;
    wanted.finishing.stepOver = request.finishingStepOver;
    const Tool tool = plannedTool(milling);
    constexpr double allowances = 2.0; // what the levels leave protrudes further than the allowance
    wanted.finishing.deepest =
        deepestCut(milling, std::max(allowances * request.allowance, 0.1 * tool.cutter.diameter));
    wanted.finishing.deepestBelow = tool.maximumDepthOfCut;
    wanted.motion = inSetup(hand.motion, scale);
    wanted.timeLimit = request.timeLimit;
    if (frame.upright()) wanted.standing = standingStock(milling);
    return planMilling(frame.field(), tool, wanted);
}

/// Returns the region in which a hand without a plan moves: from a little above the stock down to its middle.
Box freeRegion(const MillingContext& milling) {
    Box region = milling.setup.stock;
    region.high.z += travelHeight;
    region.low.z = milling.setup.stock.centre().z;
    return region;
}

double freeSeconds(const OperatorRequest& request) {
    constexpr double usual = 20.0;
    return request.timeLimit > 0.0 ? request.timeLimit : usual;
}

std::vector<IntentPoint> inSetupFrame(const PlanningFrame& frame, std::vector<IntentPoint> points) {
    for (IntentPoint& point : points) point.tip = frame.toSetup(point.tip);
    return points;
}

/// Returns the region around a stock in which the tip can be moved, mm.
Box ledRegion(const Box& stock, const Tool& tool) {
    Box region = stock.grown(tool.cutter.diameter + travelMargin);
    region.low.z = stock.low.z - pressMargin;
    return region;
}

/// Adds the operator's intents, divided into takes.
Result<void> addStages(const MillingContext& milling, const PlanningFrame& frame, const OperatorRequest& request,
                       OperatorPlan& planned) {
    const bool freeHand = milling.partModel->bodies.empty();
    if (request.intent == OperatorIntent::scribble) {
        ScribbleRequest scribble{.region = freeRegion(milling), .seconds = freeSeconds(request), .seed = request.seed};
        Result<std::vector<IntentPoint>> way = planScribble(scribble);
        if (!way) return std::move(way).error();
        planned.stages = {{BURIN_TEXT("Take", "scribble").text, std::move(*way), request.allowance}};
        return {};
    }
    if (request.intent == OperatorIntent::contour && !freeHand) {
        ContourRequest contour;
        contour.stock = frame.stock();
        contour.bottom = frame.part().low.z;
        contour.levelDepth = request.levelDepth;
        contour.press = request.press;
        Result<std::vector<IntentPoint>> way = planContours(frame.field(), milling.tool, contour);
        if (!way) return std::move(way).error();
        planned.stages = {{BURIN_TEXT("Take", "contours").text, inSetupFrame(frame, *way), 0.0}};
        return {};
    }
    Result<MillingPlan> plan = planFor(milling, frame, request, planned.hand, planned.mapping.scale);
    if (!plan) return std::move(plan).error();
    planned.plan = std::move(*plan);
    if (!freeHand) {
        planned.plan.roughing = inSetupFrame(frame, planned.plan.roughing);
        planned.plan.finishing = inSetupFrame(frame, planned.plan.finishing);
    }
    planned.stages = {{(freeHand ? BURIN_TEXT("Take", "free hand") : BURIN_TEXT("Take", "roughing")).text,
                       planned.plan.roughing, freeHand ? 0.0 : request.allowance},
                      {BURIN_TEXT("Take", "finishing").text, planned.plan.finishing, 0.0}};
    return {};
}

HostileSettings hostility(const MillingContext& milling, const OperatorRequest& request) {
    HostileSettings settings;
    settings.stylus = touchLikeStylus();
    const WorkspaceMapping mapping = mappingFor(milling, settings.stylus);
    const Box region = freeRegion(milling);
    settings.region = {mapping.toDevice(region.low), mapping.toDevice(region.high)};
    settings.hand = request.hand;
    settings.seed = request.seed;
    return settings;
}

bool changesWorkpiece(const SessionTrace& trace) {
    return std::ranges::any_of(
        trace.changes, [](const TimedChange& timed) { return std::holds_alternative<WorkpieceChange>(timed.change); });
}

} // namespace

WorkspaceMapping mappingFor(const MillingContext& milling, const StylusDescription& stylus) {
    return mappingFor(ledRegion(milling.setup.stock, milling.tool), stylus);
}

Result<TakeOutcome> recordTake(Project& project, MillingContext& milling, const ToolBounds& bounds,
                               const StylusHandle& stylus, const TakeRequest& request, const std::atomic<bool>& stop) {
    const double volumeBefore = milling.workpieceVolume();
    SessionRequest session;
    session.allowance = request.allowance;
    session.mapping = request.mapping;
    session.pace = request.pace;
    // Nobody could undo anything but a trace.
    session.undoable = request.replayed != nullptr && changesWorkpiece(*request.replayed);
    session.takeName = request.name;
    session.maximumSeconds = request.maximumSeconds;
    session.period = request.period;
    session.cutsOnButton = request.cutsOnButton;
    session.felt = request.felt;
    session.stock = request.stock;
    session.gains = request.gains;
    session.forceButtons = request.forceButtons;
    session.guides = request.guides;
    session.trace = request.trace;
    session.traceOutput = request.traceOutput;
    session.replayed = request.replayed;
    session.flights = request.flights;
    StrokeHistory strokes;
    const Result<std::unique_ptr<MillingSession>> live =
        MillingSession::begin(project, milling, bounds, stylus, strokes, session);
    if (!live) return live.error();
    const auto tellFaults = [&] {
        while (const std::optional<Error> fault = (*live)->takeFault())
            if (request.heardFault) request.heardFault(*fault);
    };
    Result<void> followed;
    while (!(*live)->ended() && !stop && followed) {
        tellFaults();
        std::this_thread::sleep_for(glance);
        followed = (*live)->followTrace();
    }
    if (followed && !stop) followed = (*live)->followTrace(); // what follows the last reading
    const Result<LoopStatistics> loop = (*live)->end();
    tellFaults();
    if (!followed) return std::move(followed).error();
    if (!loop) return loop.error();
    if (request.saves)
        if (const Result<void> saved = project.save(); !saved) return saved.error();
    Result<TakeOutcome> outcome = outcomeOf(project, milling, (*live)->take());
    if (!outcome) return outcome;
    outcome->loop = *loop;
    outcome->drop = volumeBefore - milling.workpieceVolume();
    outcome->layerTicks.assign(bounds.layers().size(), 0);
    if (SessionState last; (*live)->newest(last)) {
        std::ranges::transform(last.layers, outcome->layerTicks.begin(), &LayerNews::ticksHeld);
        if (last.stock) outcome->stockTicks = last.stock->ticksHeld;
        outcome->heaviestCut = last.heaviestCut;
        outcome->heaviestFeed =
            proposeFeed(last.heaviestCut, milling.tool, milling.machine, milling.embedded.workpiece.properties());
    }
    return outcome;
}

Result<OperatorPlan> planOperator(const MillingContext& milling, const ToolBounds& bounds,
                                  const OperatorRequest& request) {
    std::unique_ptr<const ClearanceField> ownField;
    if (bounds.field() == nullptr) {
        Progress unseen;
        Result<std::unique_ptr<const ClearanceField>> made = clearanceField(milling, request.allowance, unseen);
        if (!made) return std::move(made).error();
        ownField = std::move(*made);
    }
    const PlanningFrame frame(milling, ownField ? *ownField : *bounds.field(),
                              ownField ? AxisMode{}.direction : bounds.axis().direction);
    OperatorPlan planned;
    planned.hand.seed = request.seed;
    planned.hand.hand = request.hand;
    planned.mapping = frame.upright()
                          ? mappingFor(milling, planned.hand.stylus)
                          : mappingFor(frame.toSetup(ledRegion(frame.stock(), milling.tool)), planned.hand.stylus);
    Result<void> made = addStages(milling, frame, request, planned);
    if (!made) return std::move(made).error();
    std::erase_if(planned.stages, [](const OperatorStage& stage) { return stage.intent.empty(); });
    return planned;
}

Result<OperatorOutcome> millWithOperator(Project& project, MillingContext& milling, const ToolBounds& bounds,
                                         const OperatorRequest& request, const std::atomic<bool>& stop) {
    OperatorOutcome outcome;
    const auto record = [&](Stylus& stylus, const OperatorStage& stage, const WorkspaceMapping& mapping,
                            const FeltCutting& felt) -> Result<void> {
        if (stop.load()) return Error{ErrorCode::cancelled, "milling", {}, {}};
        TakeRequest take;
        take.name = stage.name;
        take.allowance = stage.allowance;
        take.mapping = mapping;
        take.felt = felt;
        take.stock = request.stock;
        take.pace = request.pace;
        take.saves = request.saves;
        if (request.timeLimit > 0.0) take.maximumSeconds = request.timeLimit;
        if (request.intent == OperatorIntent::hostile) take.maximumSeconds = freeSeconds(request); // it has no end
        Result<TakeOutcome> recorded = recordTake(project, milling, bounds, stylus, take, stop);
        if (!recorded) return std::move(recorded).error();
        outcome.takes.push_back(*recorded);
        return {};
    };
    if (request.intent == OperatorIntent::hostile) {
        HostileStylus stylus(hostility(milling, request));
        const WorkspaceMapping mapping = mappingFor(milling, stylus.description());
        const OperatorStage stage{BURIN_TEXT("Take", "hostile hand").text, {}, request.allowance};
        if (Result<void> milled = record(stylus, stage, mapping, {}); !milled) return std::move(milled).error();
        return outcome;
    }
    Result<OperatorPlan> planned = planOperator(milling, bounds, request);
    if (!planned) return std::move(planned).error();
    for (const OperatorStage& stage : planned->stages) {
        VirtualOperator stylus(stage.intent, planned->mapping, planned->hand);
        if (Result<void> milled = record(stylus, stage, planned->mapping, planned->felt); !milled)
            return std::move(milled).error();
    }
    outcome.plan = std::move(planned->plan);
    return outcome;
}

} // namespace burin

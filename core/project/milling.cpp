// SPDX-FileCopyrightText: 2026 The Burin authors
// SPDX-License-Identifier: Apache-2.0
#include "core/project/milling.h"

#include "core/base/units.h"
#include "core/haptics/operator.h"
#include "core/project/recorder.h"

#include <algorithm>
#include <chrono>
#include <thread>

namespace burin {

namespace {

/// A second of ticks at 1 kHz and then some: what the disk may keep the recorder waiting for.
constexpr std::size_t ringCapacity = 16384;
/// The tip may be led this far above the stock's top and beyond its sides.
constexpr double travelMargin = 10.0; // mm
/// A part's surface is pressed on, but the hand needs way below it.
constexpr double pressMargin = 5.0; // mm

double unixTime() {
    return std::chrono::duration<double>(std::chrono::system_clock::now().time_since_epoch()).count();
}

TakeInfo takeInfo(const Bench& bench, const Stylus& stylus, const TakeRequest& request, double period) {
    TakeInfo info;
    info.name = request.name;
    info.toolId = bench.tool.id;
    info.allowance = request.allowance;
    info.tickPeriod = period;
    info.startedUnixTime = unixTime();
    info.stylus = stylus.description().name;
    return info;
}

HapticSettings hapticSettings(const Bench& bench, const Stylus& stylus, const TakeRequest& request) {
    HapticSettings settings;
    settings.mapping = request.mapping;
    settings.stylus = stylus.description();
    settings.allowance = request.allowance;
    settings.cuttingSpeed = bench.conditions.surfaceSpeed;
    return settings;
}

/// Ends the loop when the user stops it, or when the disk refuses what was recorded: nobody mills on into a recording
/// that can't be kept.
class SessionWatch {
public:
    SessionWatch(const std::atomic<bool>& stop, const Recorder& recorder)
        : thread_([this, &stop, &recorder] {
            while (!ended_ && !stop && !recorder.failing()) std::this_thread::sleep_for(std::chrono::milliseconds(10));
            endLoop_ = true;
        }) {}
    ~SessionWatch() {
        ended_ = true;
        thread_.join();
    }
    SessionWatch(const SessionWatch&) = delete;
    SessionWatch& operator=(const SessionWatch&) = delete;
    const std::atomic<bool>& endLoop() const noexcept { return endLoop_; }

private:
    std::atomic<bool> ended_{false}, endLoop_{false};
    std::thread thread_; // last: it uses the flags
};

/// Figures of a take out of the project: what is on the disk, not what was meant to be.
Result<TakeOutcome> outcomeOf(const Project& project, const Bench& bench, std::int64_t id) {
    const Result<Take> take = project.take(id);
    if (!take) return take.error();
    TakeOutcome outcome;
    outcome.take = id;
    outcome.samples = take->samples.size();
    std::uint64_t units = 0;
    for (const Sample& sample : take->samples) {
        for (const RemovedMaterial& removed : sample.removed) units += removed.units;
        if ((sample.flags & sampleShankContact) != 0) ++outcome.shankTicks;
        outcome.largestForce = std::max(outcome.largestForce, glm::length(sample.force));
        outcome.largestCuttingForce = std::max(outcome.largestCuttingForce, glm::length(sample.cuttingForce));
    }
    outcome.removed = static_cast<double>(units) * bench.embedded.workpiece.grid().unitVolume();
    return outcome;
}

/// Grooves a hand would scribble into a block: a frame, then waves across it, at half the cutter's depth.
std::vector<IntentPoint> freeHandGrooves(const Bench& bench) {
    const Box& stock = bench.setup.stock;
    const double radius = bench.tool.cutter.radius();
    const double depth = stock.high.z - radius, above = stock.high.z + std::max(1.0, radius);
    const HandSpeeds speeds;
    const double cutting = std::min(speeds.cutting, 20.0 * radius); // as long a look at a small block as at a large one
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

Result<MillingPlan> planFor(const Bench& bench, const ClearanceField& field, const OperatorRequest& request,
                            const OperatorSettings& hand, double scale) {
    if (bench.model.bodies.empty()) {
        MillingPlan plan;
        plan.roughing = freeHandGrooves(bench);
        return plan;
    }
    MillingRequest wanted;
    wanted.stock = bench.setup.stock;
    wanted.roughing.bottom = bench.model.box().low.z;
    wanted.roughing.allowance = request.allowance;
    wanted.roughing.stepOver = request.roughingStepOver;
    wanted.roughing.levelDepth = request.levelDepth;
    wanted.roughing.finishingDepth = request.finishingDepth;
    wanted.finishing.part = bench.model.box();
    wanted.finishing.floor = bench.model.box().low.z;
    wanted.finishing.press = request.press;
    wanted.finishing.stepOver = request.finishingStepOver;
    wanted.motion = inSetup(hand.motion, scale);
    wanted.timeLimit = request.timeLimit;
    return planMilling(field, bench.tool, wanted);
}

} // namespace

WorkspaceMapping mappingFor(const Bench& bench, const StylusDescription& stylus) {
    Box region = bench.setup.stock.grown(bench.tool.cutter.diameter + travelMargin);
    region.low.z = bench.setup.stock.low.z - pressMargin;
    return mappingFor(region, stylus);
}

Result<TakeOutcome> recordTake(Project& project, Bench& bench, const ClearanceField& field, Stylus& stylus,
                               const TakeRequest& request, const std::atomic<bool>& stop) {
    if (const Result<void> opened = stylus.open(); !opened) return opened.error();
    if (const Result<void> kept = project.setTool(bench.tool); !kept) return kept.error();
    RunVolume& workpiece = bench.embedded.workpiece;
    const double volumeBefore = bench.workpieceVolume();
    ServoSettings servo;
    servo.pace = request.pace;
    servo.maximumSeconds = request.maximumSeconds;
    Result<Project::TakeWriter> writer = project.beginTake(takeInfo(bench, stylus, request, servo.period));
    if (!writer) return std::move(writer).error();
    Ring<Sample> ring(ringCapacity);
    HapticStep step(workpiece, field, bench.tool, hapticSettings(bench, stylus, request));
    Recorder recorder(ring, std::move(*writer));
    const Result<LoopStatistics> loop = [&] {
        const SessionWatch watch(stop, recorder);
        return runServoLoop(stylus, step, ring, servo, watch.endLoop());
    }();
    stylus.close();
    const Result<std::uint64_t> kept = recorder.finish();
    const Result<void> saved = project.save();
    if (!kept) return kept.error(); // the disk's refusal, not the full ring that came of it
    if (!loop) return loop.error();
    if (!saved) return saved.error();
    Result<TakeOutcome> outcome = outcomeOf(project, bench, recorder.take());
    if (!outcome) return outcome;
    outcome->loop = *loop;
    outcome->drop = volumeBefore - bench.workpieceVolume();
    return outcome;
}

Result<OperatorOutcome> millWithOperator(Project& project, Bench& bench, const ClearanceField& field,
                                         const OperatorRequest& request, const std::atomic<bool>& stop) {
    OperatorSettings hand;
    hand.seed = request.seed;
    const WorkspaceMapping mapping = mappingFor(bench, hand.stylus);
    Result<MillingPlan> plan = planFor(bench, field, request, hand, mapping.scale);
    if (!plan) return std::move(plan).error();
    OperatorOutcome outcome;
    const bool freeHand = bench.model.bodies.empty();
    struct Stage {
        const char* name;
        const std::vector<IntentPoint>* intent;
        double allowance;
    };
    const Stage stages[] = {{freeHand ? "free hand" : "roughing", &plan->roughing, freeHand ? 0.0 : request.allowance},
                            {"finishing", &plan->finishing, 0.0}};
    for (const Stage& stage : stages) {
        if (stage.intent->empty()) continue;
        if (stop.load()) return Error{ErrorCode::cancelled, "milling", {}, {}};
        VirtualOperator stylus(*stage.intent, mapping, hand);
        TakeRequest take;
        take.name = stage.name;
        take.allowance = stage.allowance;
        take.mapping = mapping;
        take.pace = request.pace;
        if (request.timeLimit > 0.0) take.maximumSeconds = request.timeLimit;
        Result<TakeOutcome> recorded = recordTake(project, bench, field, stylus, take, stop);
        if (!recorded) return std::move(recorded).error();
        outcome.takes.push_back(*recorded);
    }
    outcome.plan = std::move(*plan);
    return outcome;
}

} // namespace burin

// SPDX-FileCopyrightText: 2026 The Burin authors
// SPDX-License-Identifier: Apache-2.0
#include "core/passes/milling_plan.h"

#include "core/base/numbers.h"
#include "core/geometry/pose.h"

#include <algorithm>
#include <cmath>

namespace burin {

namespace {

// of the finishing step-over: with a larger one, roughing would take longer than it
constexpr double mostWidening = 1.25;
constexpr int mostReplans = 3;
constexpr int heightHalvings = 6;   // of the part's height: half a millimetre for a hand-sized part
constexpr double longestLift = 1.0; // s, reserved for the retract at the end of what was truncated

HandSpeeds raised(const HandSpeeds& speeds, double factor) {
    const auto raise = [factor](double speed, double fastest) {
        return std::max(speed, std::min(speed * factor, fastest));
    };
    return {raise(speeds.cutting, fastestHand.cutting), raise(speeds.plunging, fastestHand.plunging),
            raise(speeds.travelling, fastestHand.travelling)};
}

/// The greatest height of stock that a finishing pass may meet.
double deepestFinishing(const Cutter& cutter, double maximumDepthOfCut) {
    const double depth = usableFlutes(cutter) - lateralMargin(cutter);
    return maximumDepthOfCut > 0.0 ? std::min(depth, maximumDepthOfCut) : depth;
}

/// Rows, then crosswise passes.
Result<std::vector<IntentPoint>> planAllFinishing(const ClearanceField& field, const Tool& tool,
                                                  const MillingRequest& request, WorkpieceHeights& heights) {
    Result<std::vector<IntentPoint>> points = planFinishing(field, tool, request.finishing, heights);
    if (!points || !request.crosswise || request.finishing.restOnly) return points;
    const Result<std::vector<IntentPoint>> crosswise = planCrosswiseFinishing(field, tool, request.finishing, heights);
    if (!crosswise) return crosswise.error();
    points->insert(points->end(), crosswise->begin(), crosswise->end());
    return points;
}

/// Plans once, with the request as it is.
Result<MillingPlan> attempt(const ClearanceField& field, const Tool& tool, const MillingRequest& request) {
    WorkpieceHeights heights(request.stock, tool.cutter);
    heights.lowerTo(request.standing);
    Result<RoughingPlan> roughing = planRoughing(field, tool, request.roughing, heights);
    if (!roughing) return roughing.error();
    Result<std::vector<IntentPoint>> finishing = planAllFinishing(field, tool, request, heights);
    if (!finishing) return finishing.error();
    MillingPlan plan;
    plan.roughing = std::move(roughing->points);
    plan.levels = std::move(roughing->levels);
    plan.finishing = std::move(*finishing);
    plan.roughingSeconds = estimateSeconds(plan.roughing, request.motion);
    plan.finishingSeconds = estimateSeconds(plan.finishing, request.motion);
    plan.finishingStepOver = request.finishing.stepOver;
    plan.bottom = request.finishing.floor;
    return plan;
}

double seconds(const MillingPlan& plan) {
    return plan.roughingSeconds + plan.finishingSeconds;
}

/// Truncates the intent so that it ends, retracted, within `limit`. Returns its new duration.
double truncate(std::vector<IntentPoint>& points, double limit, double travelLevel, double travelSpeed,
                const MotionLimits& motion) {
    const double kept = std::max(0.0, limit - longestLift);
    std::size_t fits = 0, tooMany = points.size() + 1;
    while (tooMany - fits > 1) {
        const std::size_t middle = (fits + tooMany) / 2;
        const bool within = estimateSeconds(std::span(points).first(middle), motion) <= kept;
        (within ? fits : tooMany) = middle;
    }
    if (fits == points.size()) return estimateSeconds(points, motion);
    points.resize(fits < 2 ? 0 : fits); // a single point is no motion
    if (!points.empty() && points.back().tip.z < travelLevel)
        points.push_back({{points.back().tip.x, points.back().tip.y, travelLevel}, travelSpeed});
    return estimateSeconds(points, motion);
}

void truncateBoth(MillingPlan& plan, const MillingRequest& request) {
    const double travelLevel = request.stock.high.z + travelHeight;
    plan.truncated = true;
    plan.finishingSeconds = truncate(plan.finishing, request.timeLimit - plan.roughingSeconds, travelLevel,
                                     request.finishing.speeds.travelling, request.motion);
    if (plan.roughingSeconds > request.timeLimit)
        plan.roughingSeconds =
            truncate(plan.roughing, request.timeLimit, travelLevel, request.roughing.speeds.travelling, request.motion);
}

/// The request for only the part above a height. What the finishing passes can remove at once need not be roughed.
MillingRequest above(MillingRequest request, double height, const Tool& tool) {
    const double depth = deepestFinishing(tool.cutter, tool.maximumDepthOfCut);
    request.finishing.floor = height;
    request.finishing.floorMargin = 0.0; // on a gentle slope, the passes would extend far over stock that stays
    request.roughing.finishingDepth = depth;
    request.roughing.nearPartOnly = true;
    request.roughing.bottom = request.stock.high.z - height > depth ? height : request.stock.high.z;
    return request;
}

/// As much of the upper part as the time allows; the smallest upper part if it allows none.
Result<MillingPlan> planUpperPart(const ClearanceField& field, const Tool& tool, MillingRequest& request) {
    double tooLow = request.finishing.floor, high = request.finishing.part.high.z;
    const MillingRequest whole = request;
    Result<MillingPlan> best = MillingPlan{};
    bool fits = false;
    for (int i = 0; i < heightHalvings; ++i) {
        const double height = 0.5 * (tooLow + high);
        const MillingRequest now = above(whole, height, tool);
        Result<MillingPlan> plan = attempt(field, tool, now);
        if (!plan) return plan;
        const bool inTime = seconds(*plan) <= request.timeLimit;
        (inTime ? high : tooLow) = height;
        if (!inTime && fits) continue;
        fits = inTime;
        best = std::move(plan);
        request = now;
    }
    best->truncated = true;
    return best;
}

/// Whether a profile narrows upwards, as that of a T-slot cutter does above its disc.
bool narrowsUpwards(const std::vector<ProfileElement>& profile) {
    double widest = 0.0;
    for (const ProfileElement& element : profile) {
        if (element.radius < widest) return true;
        widest = element.radius;
    }
    return false;
}

} // namespace

double estimateSeconds(std::span<const IntentPoint> points, const MotionLimits& limits) {
    const Result<IntentMotion> motion = IntentMotion::make(points, limits);
    return motion ? motion->duration() : 0.0;
}

MotionLimits inSetup(MotionLimits device, double scale) {
    device.acceleration *= scale;
    device.maximumSpeed *= scale;
    return device;
}

Result<void> checkPlannable(const Tool& tool) {
    if (Result<void> turns = checkTurns(tool.cutter, "the virtual operator with a tool that doesn't turn"); !turns)
        return turns;
    const CutterType type = tool.cutter.type;
    if (type != CutterType::drill && type != CutterType::lollipop && !narrowsUpwards(tool.cutter.profile)) return {};
    return Error{ErrorCode::notSupported,
                 "the virtual operator with this kind of tool",
                 "a tool that cuts sideways and is nowhere wider below than above",
                 {}};
}

Result<MillingPlan> planMilling(const ClearanceField& field, const Tool& tool, const MillingRequest& request) {
    if (Result<void> plannable = checkPlannable(tool); !plannable) return plannable.error();
    if (!(std::isfinite(request.timeLimit) && request.timeLimit >= 0.0))
        return Error{ErrorCode::argumentInvalid, "time limit", formatShortest(request.timeLimit), "s, not below 0"};
    if (request.stock.empty() || !isFinite(request.stock.size()))
        return Error{ErrorCode::argumentInvalid, "stock", "", "a box that is not empty"};
    MillingRequest now = request;
    now.roughing.restOnly = now.finishing.restOnly = !request.standing.heights.empty();
    if (now.finishing.stepOver <= 0.0) now.finishing.stepOver = tool.cutter.diameter / 15.0;
    const double widest = mostWidening * now.finishing.stepOver;
    Result<MillingPlan> plan = attempt(field, tool, now);
    if (!plan || request.timeLimit == 0.0 || seconds(*plan) <= request.timeLimit) return plan;

    double factor = 1.0;
    for (int i = 0; i < mostReplans && plan && seconds(*plan) > request.timeLimit; ++i) {
        // A little more than in proportion, because corners and short strokes don't get faster.
        factor *= 1.1 * seconds(*plan) / request.timeLimit;
        now.roughing.speeds = raised(request.roughing.speeds, factor);
        now.finishing.speeds = raised(request.finishing.speeds, factor);
        plan = attempt(field, tool, now);
    }
    for (int i = 0; i < mostReplans && plan && seconds(*plan) > request.timeLimit; ++i) {
        const double left = std::max(request.timeLimit - plan->roughingSeconds, 1e-3);
        now.finishing.stepOver = std::min(widest, 1.02 * now.finishing.stepOver * plan->finishingSeconds / left);
        plan = attempt(field, tool, now);
        if (now.finishing.stepOver >= widest) break;
    }
    if (plan && seconds(*plan) > request.timeLimit) {
        now.crosswise = false;
        plan = attempt(field, tool, now);
    }
    if (plan && seconds(*plan) > request.timeLimit) plan = planUpperPart(field, tool, now);
    if (!plan) return plan;
    plan->speedFactor = std::max(now.finishing.speeds.cutting / request.finishing.speeds.cutting,
                                 now.roughing.speeds.cutting / request.roughing.speeds.cutting);
    if (seconds(*plan) > request.timeLimit) truncateBoth(*plan, now);
    return plan;
}

} // namespace burin

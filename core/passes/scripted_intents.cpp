// SPDX-FileCopyrightText: 2026 The Burin authors
// SPDX-License-Identifier: Apache-2.0
#include "core/passes/scripted_intents.h"

#include "core/base/seeded_random.h"
#include "core/base/units.h"
#include "core/geometry/pose.h"
#include "core/passes/stroke_writer.h"

#include <algorithm>
#include <array>
#include <cmath>
#include <optional>

namespace burin {
namespace {

constexpr double outlineTolerance = 0.01; // mm
constexpr double usableGradient = 0.2;
constexpr double enteringDistance = 1.0; // mm beside the part
constexpr int corrections = 12;
constexpr std::size_t mostOutlinePoints = 20'000;

/// A point of an outline, and the direction out of the part there; both at one height.
struct OutlinePoint {
    glm::dvec2 place{0.0}, outwards{0.0};
};

/// The outline of the grown part at one height.
class Outline {
public:
    Outline(const ClearanceField& field, double height, double allowance, double step)
        : field_(field), height_(height), allowance_(allowance), step_(step) {}

    /// Once around; empty if there is no outline, or it cannot be followed.
    std::vector<OutlinePoint> follow(const Box& stock, double radius) const;

private:
    glm::dvec3 at(const glm::dvec2& place) const { return {place, height_}; }
    double gap(const glm::dvec2& place) const { return field_.at(at(place)).clearance - allowance_; }
    std::optional<OutlinePoint> corrected(glm::dvec2 place) const;
    std::optional<OutlinePoint> met(const Box& stock, double radius) const;

    const ClearanceField& field_;
    double height_, allowance_, step_;
};

/// The nearest point on the outline, by Newton's method.
std::optional<OutlinePoint> Outline::corrected(glm::dvec2 place) const {
    for (int i = 0; i < corrections; ++i) {
        const FieldSample sample = field_.at(at(place));
        const glm::dvec2 slope(sample.gradient);
        const double steepness = glm::length(slope);
        if (steepness < usableGradient) return std::nullopt;
        const double missing = (allowance_ - sample.clearance) / steepness;
        if (std::abs(missing) <= outlineTolerance) return OutlinePoint{place, slope / steepness};
        place += slope / steepness * std::clamp(missing, -step_, step_);
    }
    return std::nullopt;
}

std::optional<OutlinePoint> Outline::met(const Box& stock, double radius) const {
    const glm::dvec3 centre = stock.centre();
    for (double x = stock.high.x + radius; x > stock.low.x - radius; x -= step_)
        if (gap({x, centre.y}) < 0.0) return corrected({x + 0.5 * step_, centre.y});
    return std::nullopt;
}

std::vector<OutlinePoint> Outline::follow(const Box& stock, double radius) const {
    const std::optional<OutlinePoint> first = met(stock, radius);
    if (!first) return {};
    std::vector<OutlinePoint> outline{*first};
    while (outline.size() < mostOutlinePoints) {
        const OutlinePoint& here = outline.back();
        const glm::dvec2 forward(-here.outwards.y, here.outwards.x);
        const std::optional<OutlinePoint> next = corrected(here.place + step_ * forward);
        if (!next || glm::length(next->place - here.place) < 0.05 * step_) return {}; // caught in a corner
        outline.push_back(*next);
        if (outline.size() > 4 && glm::length(next->place - first->place) < step_) {
            outline.push_back(*first);
            return outline;
        }
    }
    return {};
}

Result<void> checkContours(const Tool& tool, const ContourRequest& request) {
    if (request.stock.empty() || !isFinite(request.stock.low) || !isFinite(request.stock.high))
        return Error{ErrorCode::argumentInvalid, "stock", {}, "a box"};
    if (!std::isfinite(request.bottom)) return Error{ErrorCode::argumentInvalid, "bottom", {}, "a height"};
    if (Result<void> good = checkAbove({{"radius", tool.cutter.radius()}}); !good) return good;
    if (Result<void> good = checkNotBelow(
            {{"allowance", request.allowance}, {"level depth", request.levelDepth}, {"press", request.press}});
        !good)
        return good;
    return checkSpeeds(request.speeds);
}

/// One coordinate of a scribble: sines whose sum stays within -1 … 1.
class Wander {
public:
    Wander(SeededRandom& random, double slowest) {
        double sum = 0.0;
        for (Wave& wave : waves_) {
            wave = {2.0 * pi / random.between(shortestPeriod, slowest), 2.0 * pi * random.share(),
                    random.between(0.3, 1.0)};
            sum += wave.amplitude;
        }
        for (Wave& wave : waves_) wave.amplitude /= sum;
    }
    double at(double time) const {
        double value = 0.0;
        for (const Wave& wave : waves_) value += wave.amplitude * std::sin(wave.angularFrequency * time + wave.phase);
        return value;
    }

private:
    static constexpr double shortestPeriod = 0.8; // s
    struct Wave {
        double angularFrequency = 0.0, phase = 0.0, amplitude = 0.0;
    };
    std::array<Wave, 3> waves_;
};

} // namespace

Result<std::vector<IntentPoint>> planContours(const ClearanceField& field, const Tool& tool,
                                              const ContourRequest& request) {
    if (const Result<void> plannable = checkPlannable(tool); !plannable) return plannable.error();
    if (const Result<void> good = checkContours(tool, request); !good) return good.error();
    const double radius = tool.cutter.radius();
    const double depth = request.levelDepth > 0.0 ? request.levelDepth : radius;
    const double lowest = std::max(request.bottom, request.stock.high.z - tool.cutter.fluteLength);
    const double travel = request.stock.high.z + travelHeight;
    std::vector<IntentPoint> points;
    const auto go = [&](const glm::dvec2& place, double height, double speed) {
        points.push_back({glm::dvec3(place, height), speed});
    };
    for (double height = request.stock.high.z; height > lowest + heightTolerance;) {
        height = std::max(lowest, height - depth);
        const Outline outline(field, height, request.allowance, std::min(1.0, 0.25 * radius));
        const std::vector<OutlinePoint> way = outline.follow(request.stock, radius);
        if (way.empty()) continue;
        const glm::dvec2 beside = way.front().place + enteringDistance * way.front().outwards;
        go(beside, travel, request.speeds.travelling);
        go(beside, height, request.speeds.plunging);
        for (const OutlinePoint& point : way)
            go(point.place - request.press * point.outwards, height, request.speeds.cutting);
        go(beside, height, request.speeds.cutting);
        go(beside, travel, request.speeds.travelling);
    }
    return points;
}

Result<std::vector<IntentPoint>> planScribble(const ScribbleRequest& request) {
    constexpr double longest = 86400.0, interval = 0.02; // s
    if (request.region.empty() || !isFinite(request.region.low) || !isFinite(request.region.high))
        return Error{ErrorCode::argumentInvalid, "region", {}, "a box"};
    if (const Result<void> good = checkAbove({{"seconds", request.seconds}, {"speed", request.speed}}); !good)
        return good.error();
    const glm::dvec3 half = 0.5 * request.region.size();
    // The mean speed of a sine is four amplitudes per period; periods are longer for a larger region.
    const double slowest = std::max(1.6, 4.0 * glm::length(half) / request.speed);
    SeededRandom random(request.seed);
    const std::array<Wander, 3> wander{Wander(random, slowest), Wander(random, slowest), Wander(random, slowest)};
    const auto at = [&](double time) {
        const glm::dvec3 share(wander[0].at(time), wander[1].at(time), wander[2].at(time));
        return request.region.centre() + half * share;
    };
    std::vector<IntentPoint> points{{glm::dvec3(at(0.0).x, at(0.0).y, request.region.high.z + travelHeight), 1.0}};
    points.push_back({at(0.0), request.speed});
    const int count = static_cast<int>(std::min(request.seconds, longest) / interval);
    for (int i = 1; i <= count; ++i) {
        const glm::dvec3 tip = at(i * interval);
        const double length = glm::length(tip - points.back().tip);
        if (length > heightTolerance) points.push_back({tip, length / interval});
    }
    points.push_back({glm::dvec3(points.back().tip.x, points.back().tip.y, request.region.high.z + travelHeight),
                      HandSpeeds{}.travelling});
    return points;
}

} // namespace burin

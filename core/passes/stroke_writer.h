// SPDX-FileCopyrightText: 2026 The Burin authors
// SPDX-License-Identifier: Apache-2.0
#pragma once

#include "core/passes/milling_plan.h"

#include <initializer_list>
#include <utility>

namespace burin {

/// Writes an intent stroke by stroke and keeps the heights of the workpiece up to date with it.
class StrokeWriter {
public:
    /// @param heights must outlive the writer.
    StrokeWriter(WorkpieceHeights& heights, const HandSpeeds& speeds) : heights_(&heights), speeds_(speeds) {}

    /// Aims at `aim`, cutting; the part holds the tip back at `tip`.
    void cutTo(const glm::dvec3& aim, const glm::dvec3& tip);
    void cutTo(const glm::dvec3& tip) { cutTo(tip, tip); }
    /// The same in the air, so slowly that the hand, which rounds its corners, gets as far as what it aimed at before.
    void creepTo(const glm::dvec3& tip);
    /// Lifts, travels above the stock, comes down: fast in the air, slowly in stock. Without a point so far: begins
    /// there.
    void enterAt(const glm::dvec3& aim, const glm::dvec3& tip);
    /// The same, but in stock down a ramp: to and fro between the entry and another tip at the same height, with the
    /// part and all that shank and holder may touch below that interval. Ends at the entry.
    void rampInto(const glm::dvec3& entry, const glm::dvec3& other);
    /// Lifts above the stock, where anything was done.
    void finish();

    bool empty() const noexcept { return points_.empty(); }
    const glm::dvec3& tip() const noexcept { return tip_; } ///< where the last stroke ended
    /// How far a tip is below the stock that stands in its way from above, mm; 0: not at all.
    double depthAt(const glm::dvec3& tip) const noexcept;
    double travelLevel() const noexcept { return heights_->stock().high.z + travelHeight; }
    std::vector<IntentPoint> take() { return std::move(points_); }

private:
    void rampTo(const glm::dvec3& tip);

    WorkpieceHeights* heights_;
    HandSpeeds speeds_;
    std::vector<IntentPoint> points_;
    glm::dvec3 tip_{0.0};
};

/// How steep the operator goes down into stock, as a slope: makers of end mills allow 3 to 10 degrees.
inline constexpr double rampSlope = 0.07;
/// mm of stock that a tool may meet straight from above: what the tremor of a hand leaves.
inline constexpr double plungeDepth = 0.15;

using NamedNumbers = std::initializer_list<std::pair<const char*, double>>;
/// Errors: argumentInvalid where a number is not finite or not above 0.
Result<void> checkAbove(NamedNumbers numbers);
/// Errors: argumentInvalid where a number is not finite or below 0.
Result<void> checkNotBelow(NamedNumbers numbers);
Result<void> checkSpeeds(const HandSpeeds& speeds);
/// Evenly spaced places over an interval, both its ends among them.
struct EvenPlaces {
    double low = 0.0, length = 0.0; ///< mm
    int intervals = 1;
    double at(int i) const noexcept { return low + length * i / intervals; }
};
/// @param spacing mm, > 0, that neighbours keep at most (but for what a sum of doubles loses)
EvenPlaces evenPlaces(double low, double high, double spacing);
/// Where finishing passes run along one axis (0: x, 1: y): over the part, and as far beside it as tool and margin
/// reach.
EvenPlaces passesOver(const FinishingRequest& request, const Cutter& cutter, int axis, double spacing);
/// How far apart the places of a pass are looked at, mm: fine enough for walls and fillets, no finer than a field can
/// say.
double passSampling(const Cutter& cutter);
/// mm: what lowestFeasibleHeight resolves.
inline constexpr double heightTolerance = 1e-3;
/// mm of clearance: good enough to foresee where the tip will be.
inline constexpr double surfaceTolerance = 0.1;

/// What both kinds of finishing passes need. Errors: argumentInvalid.
Result<void> checkFinishing(const Tool& tool, const FinishingRequest& request);
/// The request with its own rules put in for step-overs of 0.
FinishingRequest withStepOvers(FinishingRequest request, const Cutter& cutter);

} // namespace burin

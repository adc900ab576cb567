// SPDX-FileCopyrightText: 2026 The Burin authors
// SPDX-License-Identifier: Apache-2.0
#pragma once

#include "core/passes/milling_plan.h"

#include <initializer_list>
#include <utility>

namespace burin {

/// Writes an intent stroke by stroke and updates the heights of the workpiece accordingly.
class StrokeWriter {
public:
    /// @param heights must outlive the writer.
    StrokeWriter(WorkpieceHeights& heights, const HandSpeeds& speeds) : heights_(&heights), speeds_(speeds) {}

    /// Cuts towards `aim`, while the part holds the tip back at `tip`.
    void cutTo(const glm::dvec3& aim, const glm::dvec3& tip);
    void cutTo(const glm::dvec3& tip) { cutTo(tip, tip); }
    /// The same in the air, so slowly that the hand, which rounds its corners, still reaches the previous aim.
    void creepTo(const glm::dvec3& tip);
    /// Retracts, travels above the stock and comes down: fast in the air, slowly in stock. If there is no point yet,
    /// the intent begins there.
    void enterAt(const glm::dvec3& aim, const glm::dvec3& tip);
    /// The same, but enters stock along a ramp: to and fro between the entry and another tip at the same height, where
    /// the part and everything that shank and holder may touch lie below that interval. Ends at the entry.
    void rampInto(const glm::dvec3& entry, const glm::dvec3& other);
    /// Retracts above the stock unless nothing was written.
    void finish();

    bool empty() const noexcept { return points_.empty(); }
    const glm::dvec3& tip() const noexcept { return tip_; } ///< where the last stroke ended
    /// How far a tip is below the stock that blocks it from above, mm; 0 if nothing blocks it.
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

/// Slope at which the operator enters stock: makers of end mills allow 3 to 10 degrees.
inline constexpr double rampSlope = 0.07;
/// Height of stock that a tool may meet straight from above, mm: what the tremor of a hand leaves.
inline constexpr double plungeDepth = 0.15;

using NamedNumbers = std::initializer_list<std::pair<const char*, double>>;
/// Errors: argumentInvalid if a number is not finite or not above 0.
Result<void> checkAbove(NamedNumbers numbers);
/// Errors: argumentInvalid if a number is not finite or below 0.
Result<void> checkNotBelow(NamedNumbers numbers);
Result<void> checkSpeeds(const HandSpeeds& speeds);
/// Evenly spaced positions over an interval, including both its ends.
struct EvenPlaces {
    double low = 0.0, length = 0.0; ///< mm
    int intervals = 1;
    double at(int i) const noexcept { return low + length * i / intervals; }
};
/// @param spacing largest distance between neighbours, mm, > 0 (except for rounding of doubles)
EvenPlaces evenPlaces(double low, double high, double spacing);
/// The positions of finishing passes along one axis (0: x, 1: y): over the part and as far beyond it as tool and margin
/// reach.
EvenPlaces passesOver(const FinishingRequest& request, const Cutter& cutter, int axis, double spacing);
/// Sampling distance along a pass, mm: fine enough for walls and fillets, no finer than the resolution of a field.
double passSampling(const Cutter& cutter);
/// Resolution of lowestFeasibleHeight, mm.
inline constexpr double heightTolerance = 1e-3;
/// Accuracy of clearance that suffices to predict the position of the tip, mm.
inline constexpr double surfaceTolerance = 0.1;

/// Checks the request that both kinds of finishing passes have in common. Errors: argumentInvalid.
Result<void> checkFinishing(const Tool& tool, const FinishingRequest& request);
/// The request with step-overs of 0 replaced by their defaults.
FinishingRequest withStepOvers(FinishingRequest request, const Cutter& cutter);

} // namespace burin

// SPDX-FileCopyrightText: 2026 The Burin authors
// SPDX-License-Identifier: Apache-2.0
#pragma once

#include "core/setup/fixture_kind.h"
#include "core/setup/obstacle.h"
#include "core/setup/stock_solid.h"

#include <optional>
#include <span>
#include <string>
#include <vector>

namespace burin {

/// Returns how deep the fixture is in the stock, mm. In a box: the shortest way by which each of its solids gets out of
/// it, the longest of these; in a stock of another form: that of the stock's deepest point in one of its solids. 0:
/// they touch at most. Solids that may be in the stock don't count, nor what is cut away.
/// @param design has passed checkFixture
double depthIn(const FixtureDesign& design, const StockSolid& stock);

/// Returns the gap between the fixture and the stock in the direction in which it clamps, mm: of a vise the
/// sum at both jaws, of clamps at the nose. 0: they touch, or the fixture is in the stock. Infinity: nothing of the
/// stock is there. Empty: a fixture of this kind need not touch the stock.
/// @param design has passed checkFixture
std::optional<double> gapTo(const FixtureDesign& design, const StockSolid& stock);

/// How a fixture fits the stock.
struct FixtureFit {
    double depth = 0.0; ///< mm that it is in the stock
    /// mm between it and the stock that it has to touch; infinity: there is no stock where it clamps
    double gap = 0.0;

    bool isGood() const noexcept { return depth == 0.0 && gap == 0.0; }
    friend bool operator==(const FixtureFit&, const FixtureFit&) = default;
};

/// By depthIn and gapTo. @param design has passed checkFixture
FixtureFit fitOf(const FixtureDesign& design, const StockSolid& stock);
/// The same for any obstacle: a box and an upright cylinder may be in the stock, too. Other shapes and keep-out volumes
/// fit always, as nothing is known about how they hold the stock. @param obstacle has passed checkObstacle
FixtureFit fitOf(const Obstacle& obstacle, const StockSolid& stock);

/// A fixture that does not fit the stock.
struct BadFit {
    std::string name;
    FixtureFit fit;
};

/// Returns the fixtures in force that do not fit the stock, in order. The stock's form is only made if there is a
/// fixture to judge. @param model in the setup frame @param setup as placed by placeStock
/// Errors: cancelled, those of StockSolid::of.
Result<std::vector<BadFit>> badFits(const Model& model, const Setup& setup, std::span<const Obstacle> obstacles,
                                    Progress& progress);

} // namespace burin

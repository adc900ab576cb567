// SPDX-FileCopyrightText: 2026 The Burin authors
// SPDX-License-Identifier: Apache-2.0
#pragma once

#include "core/setup/fixture_kind.h"
#include "core/setup/stock_solid.h"

#include <optional>

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

} // namespace burin

// SPDX-FileCopyrightText: 2026 The Burin authors
// SPDX-License-Identifier: Apache-2.0
#pragma once

#include "core/base/result.h"
#include "core/setup/fixture_kind.h"
#include "core/setup/obstacle.h"
#include "core/setup/stock_solid.h"

#include <set>
#include <span>
#include <string>

namespace burin {

/// Where fixtures are placed: around the stock, on the table. mm, setup frame.
struct FixtureSite {
    StockSolid stock;
    double table = 0.0; ///< height of the table's top
};

/// The site of a setup. The table is the top of the table plate that was added last; without one, it is below the
/// lowest parallels, else below the stock. Fixtures that are not of the library are not looked at.
FixtureSite siteOf(const StockSolid& stock, std::span<const Obstacle> fixtures);

/// Returns the design placed by a click at a point of the stock or of the table: its origin, its turn to the side of
/// the stock that is nearest to the point, and the values that follow the stock.
/// @param given parameters that keep their value @param point mm, setup frame; a point beside the stock stands for the
/// nearest one of it where the fixture has to touch the stock
FixtureDesign placedAt(FixtureDesign design, const std::set<std::string>& given, const FixtureSite& site,
                       const glm::dvec3& point);

/// A point that suits a fixture of a kind: at an end of the stock; for a vise on a long side, preferably the rear one,
/// so that its spindle is in front.
glm::dvec3 firstPoint(FixtureKind kind, const Box& stock) noexcept;

/// The error of a fixture that would enter the stock. @param depth mm
Error inStock(const std::string& name, double depth);

/// Returns the fixture as a solid. Errors: those of checkFixture, fixtureInStock if it would enter the stock.
/// @param margin distance that the tool keeps from it, mm
Result<Obstacle> fixtureOf(const FixtureDesign& design, const StockSolid& stock, const std::string& name,
                           double margin);

} // namespace burin

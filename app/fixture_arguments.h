// SPDX-FileCopyrightText: 2026 The Burin authors
// SPDX-License-Identifier: Apache-2.0
#pragma once

#include "app/command_line.h"
#include "core/setup/fixture_placement.h"

#include <nlohmann/json.hpp>

#include <string>
#include <vector>

namespace burin {

/// The arguments for fixtures of the library, as given by the user.
struct FixtureArguments {
    std::vector<std::string> add, change;

    bool empty() const { return add.empty() && change.empty(); }
};

/// Declares --add-fixture and --change-fixture.
void addFixtures(CommandParser command, FixtureArguments& arguments);

/// Changes fixtures and keep-out volumes, then adds the new ones, each placed as by a click in the window. Nothing is
/// changed after an error. Errors: argumentInvalid, nameUnknown, those of fixtureOf and moved.
/// @param clearance of new ones, mm
Result<void> changeFixtures(std::vector<Obstacle>& obstacles, const FixtureArguments& arguments,
                            const StockSolid& stock, double clearance);

/// {"kind", "values_mm", "place_mm", "turn_deg"}
nlohmann::json jsonOf(const FixtureDesign& design);

} // namespace burin

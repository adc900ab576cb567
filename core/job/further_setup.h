// SPDX-FileCopyrightText: 2026 The Burin authors
// SPDX-License-Identifier: Apache-2.0
#pragma once

#include "core/document/project.h"
#include "core/job/left_stock.h"

#include <string>

namespace burin {

/// A further clamping of the same part.
struct FurtherSetup {
    std::string name;           ///< empty: no name
    SetupId after = setupInUse; ///< preceding setup: part, roles, materials, machine and voxels are taken from it
    Placement turn;             ///< of the part, relative to its placement there
    bool leftStock = true;      ///< whether its stock is what that setup leaves; otherwise new with the same margins
};

struct AddedSetup {
    SetupId id = firstSetup;
    bool byProgram = false;            ///< LeftStock::byProgram
    double greatestDisplacement = 0.0; ///< mm, as LeftStock::greatestDisplacement
};

/// Returns the setup as it is to be stored: with the part turned, in the stock that was left or in a stock of its own.
/// @param before the preceding setup @param model in its own frame @param stock null: the setup gets its own stock
/// Errors: those of placeStock.
Result<Setup> furtherSetup(const Setup& before, const Placement& turn, const std::shared_ptr<const Model>& model,
                           const LeftStock* stock);
/// Adds a setup with this content and target and returns its id. On failure nothing is added.
Result<SetupId> storeFurtherSetup(Project& project, const std::string& name, const Setup& setup,
                                  const ProgramTarget& target);

/// Adds a further setup; the setup in use stays the same. Errors: those of leftStock and placeStock; nothing is added
/// then.
Result<AddedSetup> addFurtherSetup(Project& project, const FurtherSetup& further, Progress& progress);

/// Whether a setup's stock was left by another setup that has changed since. Errors: those of Project::setup.
Result<bool> isStockOutOfDate(const Project& project, SetupId setup = setupInUse);
/// Updates the stock of a setup from the setup that leaves it. Errors: those of leftStock, argumentInvalid (no setup
/// left it, or it was milled already).
Result<AddedSetup> takeStockAnew(Project& project, SetupId setup, Progress& progress);

} // namespace burin

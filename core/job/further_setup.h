// SPDX-FileCopyrightText: 2026 The Burin authors
// SPDX-License-Identifier: Apache-2.0
#pragma once

#include "core/document/project.h"
#include "core/job/left_stock.h"

#include <string>

namespace burin {

/// A further clamping of the same part.
struct FurtherSetup {
    std::string name;           ///< empty: none
    SetupId after = setupInUse; ///< that it comes after: part, roles, materials, machine and voxels are as there
    Placement turn;             ///< of the part, from how it lies there
    bool leftStock = true;      ///< its stock is what that setup leaves; else a new one with the same margins
};

struct AddedSetup {
    SetupId id = firstSetup;
    bool byProgram = false;            ///< LeftStock::byProgram
    double greatestDisplacement = 0.0; ///< mm, as LeftStock::greatestDisplacement
};

/// As it is to be stored: the part turned, in what was left, or in a stock of its own.
/// @param before the setup that it comes after @param model in its own frame @param stock null: a stock of its own
/// Errors: those of placeStock.
Result<Setup> furtherSetup(const Setup& before, const Placement& turn, const std::shared_ptr<const Model>& model,
                           const LeftStock* stock);
/// Adds a setup of that content and target; its id. Nothing is added where something fails.
Result<SetupId> storeFurtherSetup(Project& project, const std::string& name, const Setup& setup,
                                  const ProgramTarget& target);

/// Adds it; the project is used in the same setup as before. Errors: those of leftStock and placeStock; nothing is
/// added then.
Result<AddedSetup> addFurtherSetup(Project& project, const FurtherSetup& further, Progress& progress);

/// Whether a setup's stock is what another one left, and that has changed since. Errors: those of Project::setup.
Result<bool> isStockOutOfDate(const Project& project, SetupId setup = setupInUse);
/// Takes the stock of a setup anew from the one that leaves it. Errors: those of leftStock, argumentInvalid (no setup
/// left it, or something is milled of it already).
Result<AddedSetup> takeStockAnew(Project& project, SetupId setup, Progress& progress);

} // namespace burin

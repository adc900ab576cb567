// SPDX-FileCopyrightText: 2026 The Burin authors
// SPDX-License-Identifier: Apache-2.0
#pragma once

#include "app/command_line.h"
#include "core/setup/setup.h"

#include <nlohmann/json.hpp>

#include <string>
#include <vector>

namespace burin {

/// The arguments for a stock, its materials and the roles of bodies, as given by the user.
struct StockArguments {
    std::string form = "box", box, cylinder, axis = "z", file, table, material = "aluminium-6061";
    double margin = 5.0; ///< mm
    std::vector<std::string> roles, bodyMaterials, layers, grades, gradeTables;
    int bands = 8;
    bool freeCarving = false;
};

/// Declares --stock, --stock-box, --stock-cylinder, --stock-axis, --stock-file, --stock-table, --margin, --material,
/// --role, --body-material, --layer, --grade, --grade-table, --bands and --free-carving.
void addStock(CommandParser command, StockArguments& arguments);

/// Applies the arguments to a setup; placeStock does the rest. Errors: argumentInvalid, nameUnknown (a body, a layer).
Result<Setup> withStock(Setup setup, const StockArguments& arguments, const Model& model);

/// Gives bodies, or all bodies of an assembly, the colours of "BODY=#RRGGBB". Errors: argumentInvalid, nameUnknown.
Result<void> setColours(const std::vector<std::string>& colours, Model& model);

/// {"name", "material", "axis", "from_mm", "to_mm", "graded"}, ordered by priority.
nlohmann::json jsonOfLayers(const Setup& setup);
/// The role of each body by its name.
nlohmann::json jsonOfRoles(const Model& model, const Setup& setup);
/// The form of the stock, roles other than part, and layers, one line each; empty for a box of one material.
std::string textOfStock(const Model& model, const Setup& setup);

/// Each material with its volume and mass, each graded layer with its error.
nlohmann::json jsonOfMaterials(const EmbeddedSetup& embedded);
nlohmann::json jsonOfGradings(const EmbeddedSetup& embedded);
/// The same as readable text, one line each; states if nothing pushes the tool back. Empty for one material and a part.
std::string textOfMaterials(const Setup& setup, const EmbeddedSetup& embedded);

} // namespace burin

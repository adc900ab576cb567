// SPDX-FileCopyrightText: 2026 The Burin authors
// SPDX-License-Identifier: Apache-2.0
#pragma once

#include "app/command_line.h"
#include "core/setup/setup.h"

#include <nlohmann/json.hpp>

#include <string>
#include <vector>

namespace burin {

/// What the command line says of a stock, its materials and the roles of bodies, as it was written.
struct StockArguments {
    std::string form = "box", box, cylinder, axis = "z", file, table, material = "aluminium-6061";
    double margin = 5.0; ///< mm
    std::vector<std::string> roles, bodyMaterials, layers, grades, gradeTables;
    int bands = 8;
    bool freeCarving = false;
};

/// Declares --stock, --stock-box, --stock-cylinder, --stock-axis, --stock-file, --stock-table, --margin, --material,
/// --role, --body-material,
/// --layer, --grade, --grade-table, --bands and --free-carving.
void addStock(CommandParser command, StockArguments& arguments);

/// A setup with all that they say; what is left is for placeStock. Errors: argumentInvalid, nameUnknown (a body, a
/// layer).
Result<Setup> withStock(Setup setup, const StockArguments& arguments, const Model& model);

/// {"name", "material", "axis", "from_mm", "to_mm", "graded"}, in the order of their priority.
nlohmann::json jsonOfLayers(const Setup& setup);
/// The role of each body by its name.
nlohmann::json jsonOfRoles(const Model& model, const Setup& setup);
/// The form of the stock, roles that are no part, and layers, a line each; empty for a box of one material.
std::string textOfStock(const Model& model, const Setup& setup);

/// Each material with its volume and mass, each graded layer with its error.
nlohmann::json jsonOfMaterials(const EmbeddedSetup& embedded);
nlohmann::json jsonOfGradings(const EmbeddedSetup& embedded);
/// The same for people, a line each; says when nothing pushes back. Empty where there is one material and a part.
std::string textOfMaterials(const Setup& setup, const EmbeddedSetup& embedded);

} // namespace burin

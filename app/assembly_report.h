// SPDX-FileCopyrightText: 2026 The Burin authors
// SPDX-License-Identifier: Apache-2.0
#pragma once

#include "core/cad/body_path.h"
#include "core/setup/setup.h"

#include <nlohmann/json.hpp>

#include <functional>
#include <string>

namespace burin {

/// The assemblies of a model, each with its name, path, number and volume of its bodies, and the assemblies in it.
nlohmann::json jsonOfAssemblies(const Model& model);
/// The tree of a model, one line for each body and each assembly, which stands above what is in it, indented.
/// @param bodyText a body's line with this name
std::string textOfTree(const Model& model,
                       const std::function<std::string(std::size_t body, const std::string& name)>& bodyText);
/// The tree of a model in assemblies with the role of each body, lines to append to others; empty for any other model.
std::string textOfRoles(const Model& model, const Setup& setup);

} // namespace burin

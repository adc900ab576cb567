// SPDX-FileCopyrightText: 2026 The Burin authors
// SPDX-License-Identifier: Apache-2.0
#pragma once

#include "core/cad/model.h"

#include <cstddef>
#include <optional>
#include <string>
#include <string_view>
#include <vector>

namespace burin {

// A body of an assembly is named by its path: "Vice/Jaws/Bolt:2" is the second instance of Bolt in the assembly Jaws,
// which is in Vice. The path is unique in its model and is the same when the file is read again.

/// Returns a name of a file as one element of a path: '/' becomes '⁄' (U+2044).
std::string pathElement(std::string_view name);
/// @param assembly path; empty: none
std::string bodyPath(std::string_view assembly, std::string_view name);
/// The path of the assembly that a body is in; empty if it is in none.
std::string_view assemblyOf(std::string_view path);
std::string_view lastElement(std::string_view path);
/// "Bolt:2" becomes "Bolt".
std::string_view withoutInstance(std::string_view element);
/// Makes equal names unique by adding ":1", ":2", … in their order. Empty names stay empty.
void numberInstances(std::vector<std::string>& names);

/// A body or an assembly of a model's tree.
struct BodyNode {
    std::string name;                  ///< the last element of its path
    std::string path;                  ///< of an assembly without the number of a body
    std::optional<std::size_t> body{}; ///< its index in the model; empty: it is an assembly
    std::vector<BodyNode> children{};  ///< of an assembly, in the order of the bodies
};

/// Returns the tree of bodies with these paths; a flat list if none is in an assembly. Elements below the 32nd level
/// count as one.
std::vector<BodyNode> bodyTree(const std::vector<std::string>& paths);
std::vector<BodyNode> bodyTree(const Model& model);
bool hasAssemblies(const Model& model);
/// All bodies below a node, in order; of a body itself.
std::vector<std::size_t> bodiesOf(const BodyNode& node);
/// Returns the bodies that a path names: those of that name, or else all of that assembly.
std::vector<std::size_t> bodiesNamed(const Model& model, std::string_view path);

} // namespace burin

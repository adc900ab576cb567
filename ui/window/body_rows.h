// SPDX-FileCopyrightText: 2026 The Burin authors
// SPDX-License-Identifier: Apache-2.0
#pragma once

#include "core/cad/body_path.h"
#include "core/setup/setup.h"
#include "ui/panels/project_tree.h"

#include <set>
#include <vector>

namespace burin {

/// The bodies of a model as the project tree shows them.
struct ShownBodies {
    const Model& model;
    const Setup& setup;                     ///< for their roles
    const std::vector<BodyColour>& colours; ///< of all bodies
    const std::set<std::size_t>& hidden;
};

/// Returns the rows of the model's tree. The id of a body's row is its index.
std::vector<ProjectRow> rowsOfBodies(const ShownBodies& shown);
/// The assembly of a row with that id; null if there is none.
const BodyNode* assemblyOfRow(const std::vector<BodyNode>& tree, qint64 id);

} // namespace burin

// SPDX-FileCopyrightText: 2026 The Burin authors
// SPDX-License-Identifier: Apache-2.0
#pragma once

#include "core/setup/setup.h"
#include "core/volume/operations/graded.h"

#include <array>
#include <optional>
#include <vector>

namespace burin {

/// The property list of a setup's workpiece, and which entry stands for what: air, the stock (all that a file brings),
/// then the bodies, then the layers. What is protected has an entry of its own; machinable bodies and layers of one
/// material share its entry, but a graded layer has one.
struct SetupMaterials {
    PropertyList list;
    PropertyIndex stock = airProperty;
    std::array<PropertyIndex, 256> volume{}; ///< per entry of a stock from a file; air for what it has none of
    std::vector<PropertyIndex> bodies;       ///< per body; air where it is not embedded
    std::vector<PropertyIndex> regions;      ///< per layer; of a graded one what its grades belong to
    std::vector<std::optional<GradedMaterial>> graded; ///< per layer
};

/// Errors: nameUnknown, resourceInvalid (a material); argumentInvalid (more materials than a list holds, one that is
/// milled without a specific cutting energy or Kienzle force, those of gradingOf).
/// @param known looked through by id before the library
Result<SetupMaterials> setupMaterials(const Model& model, const Setup& setup, const std::vector<Property>& known);

} // namespace burin

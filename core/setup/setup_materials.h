// SPDX-FileCopyrightText: 2026 The Burin authors
// SPDX-License-Identifier: Apache-2.0
#pragma once

#include "core/setup/setup.h"
#include "core/volume/operations/graded.h"

#include <array>
#include <optional>
#include <vector>

namespace burin {

/// The property list of a setup's workpiece, and the meaning of its entries: air, the stock (all materials of a stock
/// from a file), then the bodies, then the layers. Each protected body has its own entry; machinable bodies and layers
/// of one material share an entry, but a graded layer has its own.
struct SetupMaterials {
    PropertyList list;
    PropertyIndex stock = airProperty;
    std::array<PropertyIndex, 256> volume{};           ///< per entry of a stock from a file; air for unused entries
    std::vector<PropertyIndex> bodies;                 ///< per body; air where it is not embedded
    std::vector<PropertyIndex> regions;                ///< per layer; of a graded layer the base material of its grades
    std::vector<std::optional<GradedMaterial>> graded; ///< per layer
};

/// Errors: nameUnknown (a material); resourceInvalid (a material, or a machinable one without a specific cutting energy
/// or Kienzle force); argumentInvalid (more materials than a list holds, those of gradingOf).
/// @param known searched by id before the library
Result<SetupMaterials> setupMaterials(const Model& model, const Setup& setup, const std::vector<Property>& known);

} // namespace burin

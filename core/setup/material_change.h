// SPDX-FileCopyrightText: 2026 The Burin authors
// SPDX-License-Identifier: Apache-2.0
#pragma once

#include "core/setup/setup.h"

#include <string>
#include <vector>

namespace burin {

/// Returns the property list of a setup's workpiece: air, the stock, then one entry per body. Samples refer to its
/// entries by index; files refer to them by id. Errors: nameUnknown, resourceInvalid (a material).
Result<PropertyList> propertyListOf(const Model& model, const Setup& setup, const std::vector<Property>& materials);
/// Returns the ids of the entries, each at its index.
std::vector<std::string> idsOf(const PropertyList& list);

/// Returns a copy of a workpiece with other materials. Its runs hold indices into the property list, so only the list
/// changes. The lines are copied on all cores; nothing is voxelised. `embedded` is only read.
/// @param setup has the shape that `embedded` was made from @param materials searched by id before the library
/// Errors: nameUnknown, resourceInvalid (a material), outOfMemory.
Result<EmbeddedSetup> withMaterials(const EmbeddedSetup& embedded, const Model& model, const Setup& setup,
                                    const std::vector<Property>& materials);

} // namespace burin

// SPDX-FileCopyrightText: 2026 The Burin authors
// SPDX-License-Identifier: Apache-2.0
#pragma once

#include "core/setup/setup.h"

#include <string>
#include <vector>

namespace burin {

/// The property list of a setup's workpiece: air, the stock, then one entry a body. Samples name its entries by their
/// index; files name them by their ids. Errors: nameUnknown, resourceInvalid (a material).
Result<PropertyList> propertyListOf(const Model& model, const Setup& setup, const std::vector<Property>& materials);
/// Each at its index.
std::vector<std::string> idsOf(const PropertyList& list);

/// A workpiece as it is, of other materials: its runs hold places of the property list, so that only the list changes.
/// The lines are copied on all cores; nothing is voxelised. `embedded` is only read.
/// @param setup of the shape that `embedded` was made of @param materials looked through by id before the library
/// Errors: nameUnknown, resourceInvalid (a material), outOfMemory.
Result<EmbeddedSetup> withMaterials(const EmbeddedSetup& embedded, const Model& model, const Setup& setup,
                                    const std::vector<Property>& materials);

} // namespace burin

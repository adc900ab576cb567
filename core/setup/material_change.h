// SPDX-FileCopyrightText: 2026 The Burin authors
// SPDX-License-Identifier: Apache-2.0
#pragma once

#include "core/setup/setup.h"

namespace burin {

/// A workpiece as it is, of other materials: its runs hold places of the property list, so that only the list changes.
/// The lines are copied on all cores; nothing is voxelised. `embedded` is only read.
/// @param setup of the shape that `embedded` was made of @param materials looked through by id before the library
/// Errors: nameUnknown, resourceInvalid (a material), outOfMemory.
Result<EmbeddedSetup> withMaterials(const EmbeddedSetup& embedded, const Model& model, const Setup& setup,
                                    const std::vector<Property>& materials);

} // namespace burin

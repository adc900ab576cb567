// SPDX-FileCopyrightText: 2026 The Burin authors
// SPDX-License-Identifier: Apache-2.0
#pragma once

#include "core/job/milling_context.h"

namespace burin {

/// Gives a milling context the materials of `setup`, whose shape must be that of the milling context. The milled shape
/// of the workpiece is kept. Errors: those of withMaterials and cuttingConditions; the milling context is then
/// unchanged.
Result<void> changeMaterials(MillingContext& milling, const Setup& setup, const std::vector<Property>& materials);

} // namespace burin

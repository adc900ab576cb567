// SPDX-FileCopyrightText: 2026 The Burin authors
// SPDX-License-Identifier: Apache-2.0
#pragma once

#include "core/job/milling_context.h"

namespace burin {

/// Gives a milling context the materials of `setup`, whose shape must be the milling context's own: the workpiece stays
/// as it was milled. Errors: those of withMaterials and cuttingConditions; the milling context is then unchanged.
Result<void> changeMaterials(MillingContext& milling, const Setup& setup, const std::vector<Property>& materials);

} // namespace burin

// SPDX-FileCopyrightText: 2026 The Burin authors
// SPDX-License-Identifier: Apache-2.0
#pragma once

#include "core/job/bench.h"

namespace burin {

/// Gives a bench the materials of `setup`, whose shape must be the bench's own: the workpiece stays as it was milled.
/// Errors: those of withMaterials and cuttingConditions; the bench is then unchanged.
Result<void> changeMaterials(Bench& bench, const Setup& setup, const std::vector<Property>& materials);

} // namespace burin

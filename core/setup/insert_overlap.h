// SPDX-FileCopyrightText: 2026 The Burin authors
// SPDX-License-Identifier: Apache-2.0
#pragma once

#include "core/setup/setup.h"

namespace burin {

/// Checks that no two inserts of a stock overlap. Each pair whose boxes intersect is voxelised on its own; a shared
/// volume of at most a thousandth of the smaller insert counts as touching.
/// Errors: argumentInvalid (both bodies and the volume that they share), those of voxelise().
Result<void> requireInsertsApart(const Model& model, const Setup& setup, Progress& progress);

} // namespace burin

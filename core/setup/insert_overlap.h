// SPDX-FileCopyrightText: 2026 The Burin authors
// SPDX-License-Identifier: Apache-2.0
#pragma once

#include "core/setup/setup.h"

namespace burin {

/// Whether each place of a stock has one insert at most. Pairs whose boxes meet are voxelised by themselves; one that
/// is off by less than a thousandth of the smaller insert counts as touching.
/// Errors: argumentInvalid (both bodies and the volume that they share), those of voxelise().
Result<void> requireInsertsApart(const Model& model, const Setup& setup, Progress& progress);

} // namespace burin

// SPDX-FileCopyrightText: 2026 The Burin authors
// SPDX-License-Identifier: Apache-2.0
#pragma once

#include "tests/benchmarks/measure/session.h"

#include <cstdint>
#include <optional>

namespace burin::benchmarks {

/// s of OpenVDB's meshToLevelSet (half width 3) for the bumpy part of so many triangles in a scene of so many voxels;
/// it takes many seconds, so it is run once a round and its time serves all figures that stand beside it.
std::optional<double> meshLevelSetSeconds(Session& session, std::int32_t side, double triangles);

} // namespace burin::benchmarks

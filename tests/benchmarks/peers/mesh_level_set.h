// SPDX-FileCopyrightText: 2026 The Burin authors
// SPDX-License-Identifier: Apache-2.0
#pragma once

#include "tests/benchmarks/measure/session.h"

#include <cstdint>
#include <optional>

namespace burin::benchmarks {

/// The time, s, of OpenVDB's meshToLevelSet (half width 3) for the bumpy part with a number of triangles in a scene
/// with a number of voxels. It takes many seconds, so it is run once per round, and its time serves all figures that
/// are compared with it.
std::optional<double> meshLevelSetSeconds(Session& session, std::int32_t side, double triangles);

} // namespace burin::benchmarks

// SPDX-FileCopyrightText: 2026 The Burin authors
// SPDX-License-Identifier: Apache-2.0
#pragma once

#include "core/base/progress.h"
#include "core/path/path.h"
#include "core/tool/tool.h"
#include "core/volume/runs/run_volume.h"

namespace burin {

/// Takes what a path sweeps out of a stock. Rapids cut nothing; arcs are gone in chords that leave them by a fiftieth
/// of a voxel at most. Errors: volumeOutOfMemory, cancelled; part of it is cut then.
Result<void> cutPath(const Path& path, const Cutter& cutter, RunVolume& stock, Progress& progress);

} // namespace burin

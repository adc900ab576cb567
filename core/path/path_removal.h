// SPDX-FileCopyrightText: 2026 The Burin authors
// SPDX-License-Identifier: Apache-2.0
#pragma once

#include "core/base/progress.h"
#include "core/path/path.h"
#include "core/tool/tool.h"
#include "core/volume/runs/run_volume.h"

namespace burin {

/// Removes the swept volume of a path from a stock. Rapids cut nothing; arcs are followed in chords that leave them by
/// a fiftieth of a voxel at most. Errors: volumeOutOfMemory, cancelled; the stock is then partly cut.
Result<void> cutPath(const Path& path, const Cutter& cutter, RunVolume& stock, Progress& progress);

} // namespace burin

// SPDX-FileCopyrightText: 2026 The Burin authors
// SPDX-License-Identifier: Apache-2.0
#pragma once

#include "tests/benchmarks/measure/run.h"

namespace burin::benchmarks {

// One file a group. Each measures those of its figures that the run wants; README.md says how.

void peersAgree(Run& run);          ///< peers.*: that all ways to cut cut the same
void cuttingFigures(Run& run);      ///< cut.*
void contactFigures(Run& run);      ///< contact.*
void smoothnessFigures(Run& run);   ///< ripple.*, floor.*
void memoryFigures(Run& run);       ///< memory.*
void snapshotFigures(Run& run);     ///< snapshot.*
void boundaryFigures(Run& run);     ///< boundary.*
void meshFigures(Run& run);         ///< mesh.*
void booleanFigures(Run& run);      ///< boolean.*
void voxelisationFigures(Run& run); ///< voxelise.*
void fieldFigures(Run& run);        ///< field.*
void loopFigures(Run& run);         ///< loop.*

} // namespace burin::benchmarks

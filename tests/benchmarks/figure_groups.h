// SPDX-FileCopyrightText: 2026 The Burin authors
// SPDX-License-Identifier: Apache-2.0
#pragma once

#include "tests/benchmarks/measure/session.h"

namespace burin::benchmarks {

// One file a group. Each measures those of its figures that the run wants; README.md says how.

void peersAgree(Session& session);          ///< peers.*: that all ways to cut cut the same
void axesAreRight(Session& session);        ///< no figure: that tools take the right voxels at any axis
void cuttingFigures(Session& session);      ///< cut.*
void contactFigures(Session& session);      ///< contact.*
void smoothnessFigures(Session& session);   ///< ripple.*, floor.*
void memoryFigures(Session& session);       ///< memory.*
void snapshotFigures(Session& session);     ///< snapshot.*
void boundaryFigures(Session& session);     ///< boundary.*
void meshFigures(Session& session);         ///< mesh.*
void booleanFigures(Session& session);      ///< boolean.*
void voxelisationFigures(Session& session); ///< voxelise.*
void fieldFigures(Session& session);        ///< field.*
void loopFigures(Session& session);         ///< loop.*

} // namespace burin::benchmarks

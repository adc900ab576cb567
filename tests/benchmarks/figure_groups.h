// SPDX-FileCopyrightText: 2026 The Burin authors
// SPDX-License-Identifier: Apache-2.0
#pragma once

#include "tests/benchmarks/measure/session.h"

namespace burin::benchmarks {

// Each group has a file of its own and measures those of its figures that are requested; see README.md.

void peersAgree(Session& session);          ///< peers.*: that all cutting methods give the same result
void axesAreRight(Session& session);        ///< no figure: that tools remove the right voxels with any axis
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

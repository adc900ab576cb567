// SPDX-FileCopyrightText: 2026 The Burin authors
// SPDX-License-Identifier: Apache-2.0
// burin-bench-volume: the figures of the S-RLE engine and of cutting, compared with their peers. `burin bench volume`
// starts it.
#include "tests/benchmarks/figure_groups.h"
#include "tests/benchmarks/measure/program.h"
#include "tests/benchmarks/peers/openvdb.h"

namespace {

using namespace burin::benchmarks;

void nameWhatIsMissing(Session& session) {
    if (!hasOpenVdb()) session.note("Built without OpenVDB: its figures are left out.");
}

} // namespace

int main(int argc, char** argv) {
    return run({"burin-bench-volume",
                "Figures of the S-RLE engine and of cutting, beside their peers",
                {nameWhatIsMissing, peersAgree, axesAreRight, cuttingFigures, loopFigures, contactFigures,
                 smoothnessFigures, snapshotFigures, memoryFigures, boundaryFigures, meshFigures, booleanFigures,
                 voxelisationFigures, fieldFigures}},
               argc, argv);
}

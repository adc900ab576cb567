// SPDX-FileCopyrightText: 2026 The Burin authors
// SPDX-License-Identifier: Apache-2.0
// burin-bench-haptics: the figures of the haptic loop. `burin bench haptics` starts it.
#include "tests/benchmarks/haptics/haptic_groups.h"
#include "tests/benchmarks/measure/program.h"

int main(int argc, char** argv) {
    using namespace burin::benchmarks;
    return run({"burin-bench-haptics",
                "Figures of the haptic loop: cost, push-back, stability, guards",
                {pushBackFigures, peerFigures, contactForceFigures, stabilityFigures, slotFigures, shankFigures,
                 stockLayerFigures, guardFigures, stopFigures, tickFigures, deviceFigures, firstCutFigures}},
               argc, argv);
}

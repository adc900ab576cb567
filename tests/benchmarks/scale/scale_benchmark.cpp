// SPDX-FileCopyrightText: 2026 The Burin authors
// SPDX-License-Identifier: Apache-2.0
// burin-bench-scale: the cost of works at three sizes, and its growth. `burin bench scale` starts it.
#include "tests/benchmarks/measure/program.h"
#include "tests/benchmarks/scale/scale.h"

int main(int argc, char** argv) {
    using namespace burin::benchmarks;
    return run({"burin-bench-scale",
                "How costs grow with samples, blocks, points, voxels and triangles",
                {sampleScale, blockScale, pointScale, solidScale, importFigures}},
               argc, argv);
}

// SPDX-FileCopyrightText: 2026 The Burin authors
// SPDX-License-Identifier: Apache-2.0
#pragma once

#include "tests/benchmarks/measure/session.h"

#include <functional>
#include <string>

namespace burin::benchmarks {

/// One work that is done at three sizes.
struct ScaledWork {
    std::string name;                        ///< "samples.mill": what is counted and what is done with it
    double limit = 1.2;                      ///< for the exponent of its CPU time
    std::function<double(int step)> size{};  ///< actual size of step 0, 1 or 2: samples, blocks, voxels, …
    std::function<void(int step)> prepare{}; ///< makes what the work needs, each time, not counted; may be empty
    std::function<void(int step)> work{};
};

/// Adds for each size `scale.NAME.SIZE.cpu` (s, of all threads, the least of three runs) and `.peak` (MB, the most that
/// the work took in addition to the memory in use before), and `scale.NAME.exponent` of the CPU time from the smallest
/// size to the largest, with `.exponent.lower` and `.exponent.upper` of the two steps.
void scaleFigures(Session& session, const ScaledWork& work);

// The measured works, each in a file of its own.
void sampleScale(Session& session);
void blockScale(Session& session);
void pointScale(Session& session);
void solidScale(Session& session); ///< voxels and triangles

/// import.cancel.*: the time from cancelling an import to its return.
void importFigures(Session& session);

} // namespace burin::benchmarks

// SPDX-FileCopyrightText: 2026 The Burin authors
// SPDX-License-Identifier: Apache-2.0
#pragma once

#include "core/recording/sample.h"

#include <cstddef>

namespace burin {

/// Strokes of a recording that stand: stretches with the spindle turning that were not taken back.
inline std::size_t strokeCount(const Take& take) {
    UndoneSamples undone(take);
    std::size_t strokes = 0;
    bool before = false;
    for (std::size_t i = 0; i < take.samples.size(); ++i) {
        const bool cutting = (take.samples[i].flags & sampleSpindleOff) == 0 && !undone.holds(i);
        if (cutting && !before) ++strokes;
        before = cutting;
    }
    return strokes;
}

} // namespace burin

// SPDX-FileCopyrightText: 2026 The Burin authors
// SPDX-License-Identifier: Apache-2.0
#pragma once

#include "core/volume/runs/run_volume.h"

#include <cstdlib>
#include <span>

namespace burin::fuzz {

/// Checks that a line has no gaps from its start to its end, that neighbours differ, and that its properties exist in
/// the list, whatever it was read from. Adds its content to `sum`.
inline void checkLine(std::span<const Segment> line, RunPosition lineEnd, int properties, RunAmounts& sum) {
    RunPosition start = 0;
    for (std::size_t i = 0; i < line.size(); ++i) {
        if (line[i].end() <= start || line[i].property() >= properties) std::abort();
        if (i > 0 && line[i].property() == line[i - 1].property()) std::abort();
        sum.units[line[i].property()] += line[i].end() - start;
        start = line[i].end();
    }
    if (start != lineEnd) std::abort();
}

/// Checks that all lines of a volume are valid and that its amounts are the sums over its lines, whatever it was read
/// from.
inline void checkVolume(const RunVolume& volume) {
    const Grid& grid = volume.grid();
    RunAmounts sum;
    for (LineIndex line; line.v < grid.lineCountV(); ++line.v)
        for (line.u = 0; line.u < grid.lineCountU(); ++line.u)
            checkLine(volume.line(line), grid.lineEnd(), volume.properties().size(), sum);
    if (sum != volume.amounts()) std::abort();
}

} // namespace burin::fuzz

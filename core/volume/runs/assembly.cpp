// SPDX-FileCopyrightText: 2026 The Burin authors
// SPDX-License-Identifier: Apache-2.0
#include "core/volume/runs/assembly.h"

#include <algorithm>
#include <new>
#include <utility>

namespace burin {

Result<RunVolume> assembleBricks(const Grid& grid, const PropertyList& properties,
                                 const std::function<void(std::int32_t row, BrickSink& sink)>& describe,
                                 std::size_t reservedBytes) {
    try {
        // The number of runs is known only once they are made. The reserve suffices for everything except lattices.
        for (std::size_t reserve = reservedBytes == 0 ? RunVolume::defaultReserve(grid) : reservedBytes;;) {
            Result<RunVolume> volume = RunVolume::make(grid, properties, reserve);
            if (!volume) return volume;
            if (!volume->rewriteBricks(describe))
                reserve *= 2;
            else if (volume->usedBytes() > volume->reservedBytes() / 2)
                reserve = 2 * volume->usedBytes();
            else
                return volume;
        }
    } catch (const std::bad_alloc&) {
        return Error{ErrorCode::outOfMemory, "volume", {}, {}};
    }
}

Result<RunVolume> assemble(const Grid& grid, PropertyList properties,
                           const std::function<void(LineIndex, std::vector<Segment>&)>& describe) {
    return assembleBricks(grid, properties, [&](std::int32_t row, BrickSink& sink) {
        BrickLines lines(grid.lineEnd());
        std::vector<Segment> segments;
        for (LineIndex low{0, row * brickSide}; low.u < grid.lineCountU(); low.u += brickSide) {
            lines.clear();
            for (std::int32_t v = low.v; v < low.v + brickSide; ++v)
                for (std::int32_t u = low.u; u < low.u + brickSide; ++u) {
                    if (grid.contains(LineIndex{u, v})) {
                        segments.clear();
                        describe({u, v}, segments);
                        lines.append(segments);
                    }
                    lines.endLine();
                }
            sink.put(low, lines);
        }
    });
}

} // namespace burin

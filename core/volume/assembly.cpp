// SPDX-FileCopyrightText: 2026 The Burin authors
// SPDX-License-Identifier: Apache-2.0
#include "core/volume/assembly.h"
#include "core/base/parallel.h"

#include <algorithm>
#include <new>
#include <utility>

namespace burin {

namespace {

/// Segments of a row of lines, one line after the other, and where each ends.
struct Row {
    std::vector<Segment> segments;
    std::vector<std::size_t> ends;
};

} // namespace

Result<RunVolume> assemble(const Grid& grid, PropertyList properties,
                           const std::function<void(LineIndex, std::vector<Segment>&)>& describe) {
    try {
        std::vector<Row> rows(static_cast<std::size_t>(grid.lineCountV()));
        parallelFor(std::int32_t{0}, grid.lineCountV(), [&](std::int32_t v) {
            Row& row = rows[static_cast<std::size_t>(v)];
            for (std::int32_t u = 0; u < grid.lineCountU(); ++u) {
                describe({u, v}, row.segments);
                row.ends.push_back(row.segments.size());
            }
        });
        std::size_t segments = 0;
        for (const Row& row : rows) segments += row.segments.size();
        // Twice what the segments take: a tile is rewritten while it grows, and editing goes on afterwards.
        const std::size_t reserve = RunVolume::defaultReserve(grid) + 2 * segments * sizeof(Segment);
        Result<RunVolume> volume = RunVolume::make(grid, std::move(properties), reserve);
        if (!volume) return volume;
        for (std::int32_t v = 0; v < grid.lineCountV(); ++v) {
            const Row& row = rows[static_cast<std::size_t>(v)];
            std::size_t begin = 0;
            for (std::int32_t u = 0; u < grid.lineCountU(); ++u) {
                const std::size_t end = row.ends[static_cast<std::size_t>(u)];
                if (!volume->setLine({u, v}, std::span(row.segments).subspan(begin, end - begin)))
                    return Error{ErrorCode::volumeOutOfMemory, std::to_string(volume->reservedBytes()), {}, {}};
                begin = end;
            }
        }
        return volume;
    } catch (const std::bad_alloc&) {
        return Error{ErrorCode::outOfMemory, "volume", {}, {}};
    }
}

} // namespace burin

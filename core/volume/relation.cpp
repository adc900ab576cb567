// SPDX-FileCopyrightText: 2026 The Burin authors
// SPDX-License-Identifier: Apache-2.0
#include "core/volume/relation.h"

#include "core/base/parallel.h"
#include "core/volume/stretches.h"

#include <atomic>

namespace burin {

namespace {

struct Contact {
    bool overlap = false, touch = false;
};

Contact contactOf(const std::vector<Stretch>& a, const std::vector<Stretch>& b) {
    Contact contact;
    for (std::size_t i = 0, k = 0; i < a.size() && k < b.size();) {
        const std::int64_t from = std::max(a[i].from, b[k].from), to = std::min(a[i].to, b[k].to);
        contact.overlap |= from < to;
        contact.touch |= from <= to;
        if (a[i].to < b[k].to)
            ++i;
        else
            ++k;
    }
    return contact;
}

void stretchesOf(std::span<const Segment> line, PropertyIndex property, std::vector<Stretch>& stretches) {
    stretches.clear();
    RunPosition start = 0;
    for (const Segment segment : line) {
        if (segment.property() == property) stretches.push_back({start, segment.end()});
        start = segment.end();
    }
}

/// @param readA, readB fill the stretches of a line.
template <class ReadA, class ReadB>
SpatialRelation compare(const Grid& grid, ReadA readA, ReadB readB) {
    std::atomic<bool> intersecting{false}, adjacent{false};
    parallelFor(std::int32_t{0}, grid.lineCountV(), [&](std::int32_t v) {
        std::vector<Stretch> a, b;
        for (std::int32_t u = 0; u < grid.lineCountU() && !intersecting; ++u) {
            readA({u, v}, a);
            if (a.empty()) continue;
            for (std::int32_t dv = -1; dv <= 1; ++dv)
                for (std::int32_t du = -1; du <= 1; ++du) {
                    const LineIndex line{u + du, v + dv};
                    if (!grid.contains(line)) continue;
                    readB(line, b);
                    const Contact contact = contactOf(a, b);
                    if (contact.overlap && du == 0 && dv == 0) intersecting = true;
                    if (contact.touch) adjacent = true;
                }
        }
    });
    return intersecting ? SpatialRelation::intersecting
           : adjacent   ? SpatialRelation::adjacent
                        : SpatialRelation::separate;
}

} // namespace

Result<SpatialRelation> relation(const VolumeSnapshot& a, const VolumeSnapshot& b) {
    if (!sameGrid(a.grid(), b.grid()))
        return Error{ErrorCode::argumentInvalid, "grid of the second volume", {}, "the grid of the first"};
    return compare(
        a.grid(), [&](LineIndex line, std::vector<Stretch>& out) { materialUnits(a.line(line), out); },
        [&](LineIndex line, std::vector<Stretch>& out) { materialUnits(b.line(line), out); });
}

SpatialRelation relation(const VolumeSnapshot& volume, PropertyIndex a, PropertyIndex b) {
    return compare(
        volume.grid(), [&](LineIndex line, std::vector<Stretch>& out) { stretchesOf(volume.line(line), a, out); },
        [&](LineIndex line, std::vector<Stretch>& out) { stretchesOf(volume.line(line), b, out); });
}

} // namespace burin

// SPDX-FileCopyrightText: 2026 The Burin authors
// SPDX-License-Identifier: Apache-2.0
#pragma once

#include "core/cutting/footprint.h"
#include "core/cutting/removed_units.h"

namespace burin {

/// Whether a line contains anything machinable between two positions.
inline bool machinableWithin(const RunVolume& workpiece, LineIndex line, RunPosition from, RunPosition to) noexcept {
    for (const Segment segment : workpiece.line(line)) {
        if (segment.end() > from && segment.property() != airProperty &&
            !workpiece.properties().isProtected(segment.property()))
            return true;
        if (segment.end() >= to) return false;
    }
    return false;
}

/// Removes the machinable runs between two positions of a line from a workpiece and counts them with their moments.
/// @param taken  receives the units by property (`removed.byProperty` does not)
/// @return false if the workpiece's memory is used up: the line is then uncut and `removed.outOfMemory` set
inline bool removeCounted(RunVolume& workpiece, LineIndex line, RunPosition from, RunPosition to, RunAmounts& taken,
                          RemovedUnits& removed) noexcept {
    const PropertyList& properties = workpiece.properties();
    std::uint64_t units = 0;
    double along = 0.0;
    forEachPiece(workpiece.line(line), from, to, [&](PropertyIndex property, RunPosition start, RunPosition end) {
        if (properties.isProtected(property)) return;
        units += end - start;
        along += 0.5 * (static_cast<double>(start) + static_cast<double>(end)) * (end - start);
    });
    if (units == 0) return true;
    removed.outOfMemory = workpiece.removeSpan(line, from, to, taken) == Removal::outOfMemory;
    if (removed.outOfMemory) return false;
    removed.total += units;
    removed.momentU += static_cast<double>(units) * line.u;
    removed.momentV += static_cast<double>(units) * line.v;
    removed.momentAlong += along;
    return true;
}

} // namespace burin

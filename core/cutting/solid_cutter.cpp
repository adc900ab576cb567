// SPDX-FileCopyrightText: 2026 The Burin authors
// SPDX-License-Identifier: Apache-2.0
#include "core/cutting/solid_cutter.h"

#include "core/cutting/counted_removal.h"

namespace burin {

void SolidCutter::cut(RunVolume& workpiece, const glm::dvec3& from, const glm::dvec3& to,
                      RemovedUnits& removed) noexcept {
    const Grid& grid = workpiece.grid();
    std::optional<SolidStay> before;
    if (cleared_ == from) {
        if (from == to) return;
        before = SolidTrack::at(*columns_, grid, from);
    }
    cleared_.reset();
    RunAmounts taken;
    const LineInterval rows{0, grid.lineCountV() - 1};
    SolidTrack track(*columns_, grid, from, to);
    while (const std::optional<SolidStay> stay = track.next()) {
        columns_->forEachSpan(SolidColumns::Section::flutes, grid, *stay, before ? &*before : nullptr, rows,
                              [&](LineIndex line, RunPosition low, RunPosition high) {
                                  return removeCounted(workpiece, line, low, high, taken, removed);
                              });
        if (removed.outOfMemory) break;
        before = stay;
    }
    for (std::size_t property = 0; property < taken.units.size(); ++property)
        removed.byProperty[property] += taken.units[property];
    if (!removed.outOfMemory) cleared_ = to;
}

} // namespace burin

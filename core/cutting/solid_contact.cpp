// SPDX-FileCopyrightText: 2026 The Burin authors
// SPDX-License-Identifier: Apache-2.0
#include "core/cutting/solid_contact.h"

#include "core/cutting/contact_overlap.h"
#include "core/cutting/footprint.h"

namespace burin {

ShankContact SolidContact::at(const RunVolume& workpiece, const glm::dvec3& tip) noexcept {
    ShankContact contact;
    const Grid& grid = workpiece.grid();
    const std::optional<SolidStay> stay = SolidTrack::at(*columns_, grid, tip);
    if (!stay) return contact;
    const std::optional<SolidStay> before = free_ ? SolidTrack::at(*columns_, grid, *free_) : std::nullopt;
    ContactOverlap overlap;
    columns_->forEachSpan(SolidColumns::Section::shank, grid, *stay, before ? &*before : nullptr,
                          {0, grid.lineCountV() - 1}, [&](LineIndex line, RunPosition from, RunPosition to) {
                              std::uint64_t units = 0;
                              forEachPiece(
                                  workpiece.line(line), from, to,
                                  [&](PropertyIndex, RunPosition start, RunPosition end) { units += end - start; });
                              if (units > solidContactTolerance)
                                  forEachPiece(workpiece.line(line), from, to,
                                               [&](PropertyIndex property, RunPosition start, RunPosition end) {
                                                   overlap.add(grid, line, property, start, end);
                                               });
                              return true;
                          });
    if (overlap.units == 0) free_ = tip;
    overlap.describe(workpiece, contact);
    if (contact.touches) contact.piece = piece_;
    return contact;
}

} // namespace burin

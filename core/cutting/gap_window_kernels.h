// SPDX-FileCopyrightText: 2026 The Burin authors
// SPDX-License-Identifier: Apache-2.0
#pragma once

#include "core/cutting/gap_window.h"

// Within core/cutting: the inner loops of GapWindow.
namespace burin::kernels {

/// Groups of a row, counted from its first, in which a span reaches out of its gap. @param hits room for all groups
std::int32_t findHits(const GapWindow::Row& row, std::int32_t* hits) noexcept;

/// What `growGaps` leaves to the one who calls it.
struct Growth {
    std::uint32_t* cutLanes = nullptr;  ///< by hit: bits of the lines whose gap grew
    std::int32_t* open = nullptr;       ///< hits with lines that need the volume …
    std::uint32_t* openLanes = nullptr; ///< … and bits of those
    std::int32_t openCount = 0;
};
/// Grows the gaps of the hits where their neighbours hold enough; sums up what that takes.
void growGaps(const GapWindow::Row& row, const std::int32_t* hits, std::int32_t hitCount, GapWindow::Sums& sums,
              Growth& growth) noexcept;

} // namespace burin::kernels

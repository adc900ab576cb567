// SPDX-FileCopyrightText: 2026 The Burin authors
// SPDX-License-Identifier: Apache-2.0
#pragma once

#include "core/cutting/gap_window.h"

// Within core/cutting: the inner loop of GapWindow.
namespace burin::kernels {

/// What `growGaps` leaves to the one who calls it.
struct Growth {
    std::int32_t* open = nullptr;       ///< groups with lines that need the volume …
    std::uint32_t* openLanes = nullptr; ///< … and bits of those
    std::int32_t openCount = 0;
};
/// Grows the gaps of a row in which spans reach out of them and the neighbours hold enough; sums up what that takes.
/// @param group to begin with
/// @return the first group that it did not come to: its brick is not ready for cuts; or the row's end
std::int32_t growGaps(const GapWindow::Row& row, std::int32_t group, GapWindow::Sums& sums, Growth& growth) noexcept;

} // namespace burin::kernels

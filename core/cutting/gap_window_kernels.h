// SPDX-FileCopyrightText: 2026 The Burin authors
// SPDX-License-Identifier: Apache-2.0
#pragma once

#include "core/cutting/gap_window.h"

// Within core/cutting: the inner loop of GapWindow.
namespace burin::kernels {

/// How far `growGaps` has come, and what it leaves to the one who calls it.
struct Growth {
    GapWindow::Open* open = nullptr; ///< room for all rows of all bricks
    std::size_t openCount = 0;
    std::int32_t brick = 0; ///< along u, to go on with
};
/// Grows the gaps in which spans reach out of them and the neighbours hold enough; sums up what that takes.
/// False: the brick to go on with is not ready for cuts.
bool growGaps(const GapWindow::BrickRow& row, GapWindow::Sums& sums, Growth& growth) noexcept;

/// The same for processors without AVX-512; to the last bit, which a test asks of it.
namespace any_processor {
bool grow(const GapWindow::BrickRow& row, GapWindow::Sums& sums, Growth& growth) noexcept;
}

} // namespace burin::kernels

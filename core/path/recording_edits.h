// SPDX-FileCopyrightText: 2026 The Burin authors
// SPDX-License-Identifier: Apache-2.0
#pragma once

#include "core/path/edit_values.h"

namespace burin {

// Edits of what the hand did, in any order. Points stay a tick apart, so that filters in time may follow any of them.

/// Leaves out stretches that removed nothing, unless the boundary held the tool (a finishing pass over finished stock
/// is work, not air) or the stretch is shorter than `shortest`. A stroke in which nothing was done at all goes as well.
struct DropAirCuts {
    double shortest = 3.0; ///< mm
};

/// Leaves out samples while the tip stays slower than `speed` for longer than `time` and removes nothing. A tip that
/// creeps keeps a point every 0.05 mm, so that the shape stays.
struct DropDwells {
    double speed = 1.0; ///< mm/s
    double time = 0.15; ///< s
};

/// Zero-phase low pass in time (forward-backward Butterworth, second order), cut-off in Hz, held within `tolerance` of
/// the recorded tips. Steps of an encoder are taken out first, so that holding the tolerance does not bring them back.
/// Never across a gap.
struct Smooth {
    double cutOff = 5.0;     ///< Hz
    double tolerance = 0.03; ///< mm
};

} // namespace burin

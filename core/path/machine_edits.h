// SPDX-FileCopyrightText: 2026 The Burin authors
// SPDX-License-Identifier: Apache-2.0
#pragma once

#include "core/path/edit_values.h"

namespace burin {

// Edits that make strokes one path of a machine: links, then feeds.

/// Joins the stretches: retract to `clearanceAbove` over the top of the stock and of what stands there, rapid across,
/// rapid down to `approach` above what is left at the entry, plunge. What is left is known from a conservative height
/// map of the strokes before. Ends no farther apart than the cutter's diameter are joined straight at the cutting feed,
/// where that keeps the allowance and shank and holder stay in empty space. Under an overhang the tool leaves along the
/// way it came.
struct Link {
    double clearanceAbove = 5.0; ///< mm
    double approach = 1.0;       ///< mm
};

/// Feed, plunge feed and spindle speed from tool, material and machine. Plunges, and moves that go down by more than
/// 45°, get the plunge feed.
struct SetFeed {};

/// Feeds in an area are multiplied by a factor; the machine's limit holds. Lines are split at its border; an arc counts
/// where its middle lies.
struct AreaFeed : Area {
    double factor = 0.5;
};

} // namespace burin

// SPDX-FileCopyrightText: 2026 The Burin authors
// SPDX-License-Identifier: Apache-2.0
#pragma once

#include "core/path/edit_values.h"
#include "core/path/path.h"

#include <vector>

namespace burin {

/// Whether a moment of a source lies behind a point; what an edit made of nothing has none.
bool hasMoment(const PathPoint& point) noexcept;

/// The moment behind a point; take 0: none.
Moment momentOf(const PathPoint& point) noexcept;

/// The moment on the move from one point to the next, at a share of its time, to the next tick; where no hand led the
/// whole move, that behind the nearer one of the points. @param share 0 … 1
Moment momentAt(const PathPoint& from, const PathPoint& to, double share) noexcept;

/// Whether the move from one point to the next leads through any moment of a stretch. Its start does not count: that
/// belongs to the move before. @param from, to moments behind the points; take 0: none
bool leadsThrough(const Moment& from, const Moment& to, const SourceStretch& stretch) noexcept;

/// Where a path goes during a stretch of the hand: points that follow each other, chain by chain, a single moment as a
/// chain of one. A moment whose own point an edit left out stands on the move that leads past it, at its share of the
/// time between the points on either side: within what that edit may be off, of where the hand was at another time.
/// Copies that an edit made have chains of their own; a stretch that left the path has none. Cost: linear.
std::vector<std::vector<PathPoint>> pointsOf(const Path& path, const SourceStretch& stretch);

} // namespace burin

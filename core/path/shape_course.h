// SPDX-FileCopyrightText: 2026 The Burin authors
// SPDX-License-Identifier: Apache-2.0
#pragma once

#include "core/base/progress.h"
#include "core/path/stroke.h"

#include <span>
#include <vector>

namespace burin {

/// The progress of a stroke along its own shape at each point: its timing, separated from the shape. Steps back of less
/// than `slack` are tremor and not progress (the result is then the nearest non-decreasing sequence by least squares);
/// longer ones are intended by the hand, and count as progress. While the hand rests, the length stays constant.
/// @param chord mm, by which the shape may bend away from the chords along which progress is measured
/// @return mm, one per point, non-decreasing; the first is 0
std::vector<double> shapeCourse(std::span<const StrokePoint> points, double chord, double slack,
                                const Progress& progress);

/// A course without the tremor along it: for each point the mean over equally many points before and behind it, as far
/// as `reach` allows on the nearer side; non-decreasing. First and last stay.
/// @param course mm, as from shapeCourse @param reach mm
std::vector<double> evenCourse(std::span<const double> course, double reach);

/// The nearest non-decreasing sequence by least squares (pool adjacent violators; Barlow and others 1972).
void makeMonotone(std::span<double> values);

} // namespace burin

// SPDX-FileCopyrightText: 2026 The Burin authors
// SPDX-License-Identifier: Apache-2.0
#pragma once

#include "core/base/progress.h"
#include "core/path/stroke.h"

#include <span>
#include <vector>

namespace burin {

/// How far along its own shape a stroke is at each point: the law of time, apart from the shape. Steps back of less
/// than `slack` are tremor and no progress (the law of time is then the nearest one that never goes back, by least
/// squares); longer ones are the hand's, and progress. A hand that rests stays at one length.
/// @param chord mm that the shape may bend away from the chords that progress is measured along
/// @return mm, one a point, never less than the one before; the first is 0
std::vector<double> shapeCourse(std::span<const StrokePoint> points, double chord, double slack,
                                const Progress& progress);

/// A course without the tremor along it: each point's mean with as many points before as behind it, as far as `reach`
/// goes on the nearer side, and never less than the one before. First and last stay.
/// @param course mm, as from shapeCourse @param reach mm
std::vector<double> evenCourse(std::span<const double> course, double reach);

/// The nearest sequence that never falls, by least squares (pool adjacent violators; Barlow and others 1972).
void makeMonotone(std::span<double> values);

} // namespace burin

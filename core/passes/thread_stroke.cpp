// SPDX-FileCopyrightText: 2026 The Burin authors
// SPDX-License-Identifier: Apache-2.0
#include "core/passes/thread_stroke.h"

#include "core/passes/keep_clear.h"

#include <algorithm>
#include <cmath>
#include <utility>

namespace burin {

int threadSteps(double sweep, double radius) noexcept {
    constexpr double chord = 0.0005; // mm
    const double step = 2.0 * std::acos(std::max(0.5, 1.0 - chord / radius));
    return std::max(2, static_cast<int>(std::ceil(sweep / step)));
}

void addThread(ThreadStroke stroke, std::span<const RevolvedPiece> tool, std::span<const ObstacleSolid> obstacles,
               const Progress& progress, PlannedPass& planned) {
    PlannedPass alone;
    alone.strokes = {stroke.tips};
    keepClear(alone, tool, obstacles, progress);
    if (alone.inTheWay > 0.0) {
        planned.inTheWay += lengthOf(stroke.tips);
        return;
    }
    planned.strokes.push_back(std::move(stroke.tips));
    planned.feedShares.push_back(std::move(stroke.shares));
}

} // namespace burin

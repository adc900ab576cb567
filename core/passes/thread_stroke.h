// SPDX-FileCopyrightText: 2026 The Burin authors
// SPDX-License-Identifier: Apache-2.0
#pragma once

#include "core/base/progress.h"
#include "core/passes/pass_ground.h"

#include <span>
#include <vector>

namespace burin {

/// The stroke of a thread with the feed of each of its points, as in PlannedPass.
struct ThreadStroke {
    TipLine tips;
    std::vector<double> shares;

    void add(const glm::dvec3& tip, double share) {
        tips.push_back(tip);
        shares.push_back(share);
    }
};

/// The number of equal chords, 2 at least, that leave an arc by at most 0.0005 mm. @param sweep rad @param radius mm
int threadSteps(double sweep, double radius) noexcept;

/// Adds the stroke of a thread to a pass, unless anything of it comes too near to an obstacle: half a thread is none.
void addThread(ThreadStroke stroke, std::span<const RevolvedPiece> tool, std::span<const ObstacleSolid> obstacles,
               const Progress& progress, PlannedPass& planned);

} // namespace burin

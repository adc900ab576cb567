// SPDX-FileCopyrightText: 2026 The Burin authors
// SPDX-License-Identifier: Apache-2.0
#pragma once

#include "core/path/path.h"
#include "ui/scene/actors.h"

#include <vector>

namespace burin {

/// Adds a move of a path as lines: straight, or its arc as chords that deviate from it by 0.02 mm at most.
void addMove(std::vector<LineEnds>& lines, const glm::dvec3& from, const PathPoint& point);

/// Returns the cutting and plunging moves of a path as lines.
std::vector<LineEnds> millingLines(const Path& path);

} // namespace burin

// SPDX-FileCopyrightText: 2026 The Burin authors
// SPDX-License-Identifier: Apache-2.0
#pragma once

#include "core/path/edit.h"
#include "core/path/evaluate.h"

#include <cstddef>
#include <vector>

namespace burin {

/// A point that an edit inserted into a path.
struct InsertedPoint {
    glm::dvec3 place{0.0}; ///< mm, setup frame, displaced by the edit
    std::size_t edit = 0;  ///< index of the edit
};

/// The points that edits inserted into a path, in the order of the edits. @param path evaluated with exactly these
/// edits
std::vector<InsertedPoint> insertedPoints(const EvaluatedPath& path, const std::vector<Edit>& edits);

} // namespace burin

// SPDX-FileCopyrightText: 2026 The Burin authors
// SPDX-License-Identifier: Apache-2.0
#pragma once

#include "core/base/progress.h"
#include "core/path/part_guard.h"
#include "core/path/stroke.h"
#include "core/path/surface_edits.h"

#include <optional>

namespace burin {

/// Moves a tool until it touches the part, grown by a distance.
class Lowering {
public:
    /// Keeps a reference to the guard. @param distance mm, from the part @param floor mm, the lowest tip
    Lowering(const PartGuard& guard, double distance, double floor, LayOnPart::Along along)
        : guard_(guard), distance_(distance), floor_(floor), along_(along) {}

    /// Empty if the tool touches nowhere.
    std::optional<glm::dvec3> bring(const glm::dvec3& tip) const {
        return along_ == LayOnPart::Along::axis ? alongAxis(tip) : alongNormal(tip);
    }

private:
    std::optional<glm::dvec3> alongAxis(const glm::dvec3& tip) const;
    std::optional<glm::dvec3> alongNormal(glm::dvec3 tip) const;

    const PartGuard& guard_;
    double distance_, floor_;
    LayOnPart::Along along_;
};

/// The strokes that a stroke becomes on the part, with points at most `sampling` mm apart.
std::vector<PathStroke> lowered(const PathStroke& stroke, const Lowering& lowering, double sampling,
                                const Progress& progress);

} // namespace burin

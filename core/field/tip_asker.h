// SPDX-FileCopyrightText: 2026 The Burin authors
// SPDX-License-Identifier: Apache-2.0
#pragma once

#include "core/field/sample_grid.h"
#include "core/field/tool_field.h"

namespace burin {

inline constexpr double farthestClearance = 1e6; ///< mm: what an empty part answers

/// Clearance with the tip at a place.
struct TipSample {
    DistanceSample clearance; ///< mm, and its gradient
    /// How much of the tip's way out is gained in clearance when the tool is inside: less than 1 where it touches with
    /// a rim, whose faces are nearer than the rim is.
    float gain = 1.0F;

    /// The clearance without the kink that it has at 0 for a rim: stretched inside, so that lines across go on
    /// straight.
    DistanceSample straightened() const noexcept {
        if (clearance.distance >= 0.0F) return clearance;
        return {clearance.distance / gain, clearance.gradient / gain};
    }
};
/// What is between such samples, as a clearance again. @param gain  between theirs
inline float bentBack(float straightened, float gain) noexcept {
    return straightened < 0.0F ? straightened * gain : straightened;
}

/// Asks a part for the clearance of a tool, one tip after the other, each best near the last. One thread each.
class TipAsker {
public:
    TipAsker(const MeshDistance& part, const ToolFieldRequest& request, const ClearanceTolerance& tolerance);

    /// The gradient is, on a ridge of the tool, the one that the part's surface tells.
    TipSample ask(const glm::dvec3& tip);

private:
    const ToolFieldRequest& request_;
    ClearanceTolerance tolerance_;
    ClearanceAsker asker_;
};

} // namespace burin

// SPDX-FileCopyrightText: 2026 The Burin authors
// SPDX-License-Identifier: Apache-2.0
#pragma once

#include "core/field/sample_grid.h"
#include "core/field/tool_field.h"

namespace burin {

inline constexpr double farthestClearance = 1e6; ///< mm: clearance from an empty part

/// The clearance for one position of the tip.
struct TipSample {
    DistanceSample clearance; ///< mm, and its gradient
    /// Gain of clearance per distance that the tip moves out while the tool is inside: less than 1 if it touches with a
    /// rim, whose faces are nearer than the rim itself.
    float gain = 1.0F;

    /// The clearance without the kink that it has at 0 for a rim: scaled inside, so that lines across continue
    /// straight.
    DistanceSample straightened() const noexcept {
        if (clearance.distance >= 0.0F) return clearance;
        return {clearance.distance / gain, clearance.gradient / gain};
    }
};
/// Converts a value interpolated between straightened samples back to a clearance. @param gain  interpolated between
/// theirs
inline float bentBack(float straightened, float gain) noexcept {
    return straightened < 0.0F ? straightened * gain : straightened;
}

/// Evaluates the clearance of a tool from a part, one tip after the other, preferably each near the one before. One
/// object per thread.
class TipAsker {
public:
    TipAsker(const MeshDistance& part, const ToolFieldRequest& request, const ClearanceTolerance& tolerance);

    /// On a ridge of the tool, the gradient is the one that follows from the part's surface.
    TipSample ask(const glm::dvec3& tip);

private:
    const ToolFieldRequest& request_;
    ClearanceTolerance tolerance_;
    ClearanceAsker asker_;
};

} // namespace burin

// SPDX-FileCopyrightText: 2026 The Burin authors
// SPDX-License-Identifier: Apache-2.0
#pragma once

#include "core/geometry/pose.h"
#include "core/geometry/revolved_piece.h"

#include <functional>
#include <span>
#include <vector>

namespace burin::oracles {

/// A solid as a function that returns the signed distance of a point, mm, negative inside.
using SolidDistance = std::function<double(const glm::dvec3&)>;

/// Depth of a tool in a solid, mm, by dense sampling of both surfaces; negative or 0 if the tool is outside. Slow and
/// obvious: it uses neither meshes nor searches.
class ToolDepth {
public:
    /// @param pieces of the tool @param spacing mm, of the samples on its surface, at most
    ToolDepth(std::span<const RevolvedPiece> pieces, double spacing);

    /// The largest depth of the tool's surface in the solid, refined around the deepest sample to 1e-4 mm, and of some
    /// points of the solid's surface in the tool.
    double at(const ToolPose& pose, const SolidDistance& solid, std::span<const glm::dvec3> ofSolid) const;

private:
    struct Ring {
        double radius, height;
    };
    std::vector<RevolvedPiece> pieces_;
    std::vector<Ring> profile_; ///< samples of the surface
    double spacing_;
};

} // namespace burin::oracles

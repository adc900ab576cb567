// SPDX-FileCopyrightText: 2026 The Burin authors
// SPDX-License-Identifier: Apache-2.0
#pragma once

#include "core/geometry/pose.h"
#include "core/geometry/revolved_piece.h"

#include <functional>
#include <span>
#include <vector>

namespace burin::oracles {

/// A solid that answers signed distances of points, mm, negative inside.
using SolidDistance = std::function<double(const glm::dvec3&)>;

/// How deep a tool is in a solid, mm, by dense sampling of both surfaces; negative or 0 where it is out. Slow and
/// obvious: it knows neither meshes nor searches.
class ToolDepth {
public:
    /// @param pieces of the tool @param spacing mm, of the samples on its surface, at most
    ToolDepth(std::span<const RevolvedPiece> pieces, double spacing);

    /// The deepest of the tool's surface in the solid, around the deepest sample to 1e-4 mm; and the deepest of some
    /// points of the solid's surface in the tool.
    double at(const ToolPose& pose, const SolidDistance& solid, std::span<const glm::dvec3> ofSolid) const;

private:
    struct Ring {
        double radius, height;
    };
    std::vector<RevolvedPiece> pieces_;
    std::vector<Ring> profile_; ///< of the surface, by samples
    double spacing_;
};

} // namespace burin::oracles

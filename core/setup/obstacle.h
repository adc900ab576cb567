// SPDX-FileCopyrightText: 2026 The Burin authors
// SPDX-License-Identifier: Apache-2.0
#pragma once

#include "core/base/result.h"
#include "core/cad/model.h"
#include "core/geometry/box.h"
#include "core/geometry/mesh_distance.h"
#include "core/geometry/triangle_mesh.h"
#include "core/setup/cylinder_shape.h"

#include <cstdint>
#include <memory>
#include <span>
#include <string>
#include <variant>
#include <vector>

namespace burin {

enum class ObstacleKind : std::uint8_t {
    fixture, ///< holds the stock, or stands beside it
    keepOut, ///< a space that is to be kept clear
};

/// What a tool must stay out of besides the part: a fixture, or a space that is to be kept clear.
struct Obstacle {
    std::string name;
    std::variant<Box, CylinderShape, TriangleMesh> shape; ///< setup frame; a mesh is closed and outward
    double margin = 0.0;                                  ///< mm that the tool keeps from it, >= 0
    bool on = true;                                       ///< in force from the start; off: it is not there for now
    ObstacleKind kind = ObstacleKind::fixture;

    friend bool operator==(const Obstacle& one, const Obstacle& other);
};

/// Errors: argumentInvalid (subject: its name, place: what of it, detail: what is allowed), modelNotWatertight (a mesh
/// with open edges, or inside out).
Result<void> checkObstacle(const Obstacle& obstacle);

/// Box of its shape, without the margin, mm.
Box boundsOf(const Obstacle& obstacle);

/// The bodies of a model as fixtures, as they lie in its frame, which has to be the part's. A body of a model with
/// several is called "NAME: BODY". A mesh that is inside out is turned. Errors: modelNotWatertight (place: the body and
/// its open edges), modelHasNoSolid.
Result<std::vector<Obstacle>> fixturesOf(const Model& model, const std::string& name, double margin);

/// An obstacle, ready to be asked how far a tool keeps from it; any number of askers share its surface.
struct ObstacleSolid {
    std::shared_ptr<const MeshDistance> surface; ///< never null
    double margin = 0.0;                         ///< mm
    bool on = true;
};

/// Allocates; builds a search tree for each obstacle.
std::vector<ObstacleSolid> solidsOf(std::span<const Obstacle> obstacles);

/// Its surface, closed and outward. A cylinder is never smaller than it says, and wider by `cylinderChord` at most.
TriangleMesh meshOf(const Obstacle& obstacle);
inline constexpr double cylinderChord = 0.005; ///< mm

} // namespace burin

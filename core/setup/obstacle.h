// SPDX-FileCopyrightText: 2026 The Burin authors
// SPDX-License-Identifier: Apache-2.0
#pragma once

#include "core/base/result.h"
#include "core/cad/model.h"
#include "core/geometry/box.h"
#include "core/geometry/mesh_distance.h"
#include "core/geometry/triangle_mesh.h"
#include "core/setup/cylinder_shape.h"
#include "core/setup/fixture_kind.h"

#include <cstdint>
#include <memory>
#include <optional>
#include <span>
#include <string>
#include <variant>
#include <vector>

namespace burin {

enum class ObstacleKind : std::uint8_t {
    fixture, ///< holds the stock, or is mounted next to it
    keepOut, ///< a space that is to be kept clear
};

/// A solid that the tool must not enter, in addition to the part: a fixture, or a space that is to be kept clear.
struct Obstacle {
    std::string name;
    std::variant<Box, CylinderShape, TriangleMesh> shape; ///< setup frame; a mesh is closed and oriented outwards
    double margin = 0.0;                                  ///< distance that the tool keeps from it, mm, >= 0
    bool on = true;                                       ///< in force from the start; off: ignored for now
    ObstacleKind kind = ObstacleKind::fixture;
    std::optional<FixtureDesign> design{}; ///< of a fixture from the library: what its mesh was made of

    friend bool operator==(const Obstacle& one, const Obstacle& other);
};

/// Errors: argumentInvalid (subject: its name, place: the offending field, detail: what is allowed), modelNotWatertight
/// (a mesh with open edges, or inside out).
Result<void> checkObstacle(const Obstacle& obstacle);

/// Returns the bounding box of the shape, without the margin, mm.
Box boundsOf(const Obstacle& obstacle);

/// Returns the bodies of a model as fixtures, in the coordinates of the model, whose frame has to be the part's. If the
/// model has several bodies, each fixture is named "NAME: BODY". A mesh that is inside out is reversed. Errors:
/// modelNotWatertight (place: the body and its open edges), modelHasNoSolid.
Result<std::vector<Obstacle>> fixturesOf(const Model& model, const std::string& name, double margin);

/// An obstacle prepared for distance queries; any number of users share its surface.
struct ObstacleSolid {
    std::shared_ptr<const MeshDistance> surface; ///< never null
    double margin = 0.0;                         ///< mm
    bool on = true;
};

/// Allocates; builds a search tree for each obstacle.
std::vector<ObstacleSolid> solidsOf(std::span<const Obstacle> obstacles);

/// Returns the surface, closed and oriented outwards. The mesh of a cylinder encloses the exact cylinder and is wider
/// by `cylinderChord` at most.
TriangleMesh meshOf(const Obstacle& obstacle);
inline constexpr double cylinderChord = 0.005; ///< mm

} // namespace burin

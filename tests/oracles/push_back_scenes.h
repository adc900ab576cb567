// SPDX-FileCopyrightText: 2026 The Burin authors
// SPDX-License-Identifier: Apache-2.0
#pragma once

#include "core/geometry/box.h"
#include "core/geometry/mesh_distance.h"
#include "core/haptics/boundary/boundary_layers.h"
#include "core/tool/tool.h"
#include "tests/oracles/tool_depth.h"

#include <cstdint>
#include <memory>
#include <span>
#include <string>
#include <vector>

namespace burin::oracles {

/// A solid that tools are pressed against: as a mesh for the tested code, and in the form that the result is judged by.
struct PushBackScene {
    std::string name;
    bool smooth = true; ///< no edges, except those that no tool can reach
    std::shared_ptr<const MeshDistance> mesh;
    SolidDistance distance;         ///< by a closed formula; for a part from CAD by points on its fine mesh
    std::vector<glm::dvec3> points; ///< of the solid's edges
    Box region;                     ///< the region in which the hand moves
    glm::dvec3 start{0.0};          ///< a tip position with clearance around the tool, axis +Z
};

/// Plane, sphere, torus (smooth), box and box with a pocket. Meshes deviate from the formulas by at most 0.002 mm.
std::vector<PushBackScene> analyticPushBackScenes();
/// A part from a closed mesh, with edges. Its points are judged by the mesh's signed distance.
PushBackScene partPushBackScene(std::string name, const TriangleMesh& mesh);

/// Ball R 3 and R 0.5, flat, bull nose, taper; shank and holder on top.
std::vector<Tool> pushBackTools();

enum class PushBackAxis : std::uint8_t {
    upright,           ///< three axes: a field over tips
    chosen,            ///< 3+2: a field as seen along an axis
    freeWithoutTorque, ///< the axis follows the hand
    freeWithTorque     ///< hand and part share the axis
};
std::string nameOf(PushBackAxis axis);

/// The boundary for a tool in a scene. Cost: about a second for a field.
BoundaryLayers pushBackLayers(const PushBackScene& scene, const Tool& tool, PushBackAxis axis, double voxel,
                              double maximumAllowance);

struct PushBackRun {
    PushBackAxis axis = PushBackAxis::upright;
    double voxel = 0.5;     ///< mm
    double allowance = 0.0; ///< mm
    int ticks = 2000;       ///< of 1 ms
    std::uint32_t seed = 1;
    bool pressing = true; ///< the hand is drawn through the solid; otherwise it moves at random, with slams and jumps
};

struct PushBackFigures {
    double gouge = 0.0;         ///< mm, deepest at the ends of ticks; with an allowance, into the grown part
    double gougeOnTheWay = 0.0; ///< mm, deepest between the ends of ticks
    double deepestPress = 0.0;  ///< mm, largest distance of the hand behind the tool
    int touching = 0;           ///< ticks in contact
    int turning = 0;            ///< ticks that rotated the axis while in contact
    int mostIterations = 0;
    std::vector<double> microseconds; ///< processor time of this thread for each tick's proxy
};

/// Greatest gouges of many runs, in voxels: at the ends of ticks and between them.
struct PushBackGouges {
    double smooth = 0.0; ///< in scenes without edges
    double edge = 0.0;   ///< in those with edges
    std::string worst;   ///< the run with the greatest share of the limit for its kind of scene
};
/// Every tool and every kind of axis in every scene, pressing and at random. Cost: about a second for 300 ticks of a
/// run and a field for each tool, more for parts.
PushBackGouges pushBackGouges(std::span<const PushBackScene> scenes, int ticks, double voxel = 0.5);
inline constexpr double smoothGougeLimit = 0.05; ///< voxels
inline constexpr double edgeGougeLimit = 0.5;    ///< voxels

/// Moves a proxy that follows a hand through a scene and measures every tick. Deterministic for a seed.
PushBackFigures measurePushBack(const PushBackScene& scene, const Tool& tool, BoundaryLayers& layers,
                                const PushBackRun& run);

} // namespace burin::oracles

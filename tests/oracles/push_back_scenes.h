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

/// A solid to press tools against: as a mesh for what is tested, and as what it is judged by.
struct PushBackScene {
    std::string name;
    bool smooth = true; ///< no edges but such that a tool can't reach
    std::shared_ptr<const MeshDistance> mesh;
    SolidDistance distance;         ///< by a closed formula; of a part from CAD by points on its fine mesh
    std::vector<glm::dvec3> points; ///< of the solid's edges
    Box region;                     ///< where the hand goes
    glm::dvec3 start{0.0};          ///< a tip with room around the tool, axis +Z
};

/// Plane, sphere, torus (smooth), box and box with a pocket. Meshes stand off the formulas by 0.002 mm at most.
std::vector<PushBackScene> analyticPushBackScenes();
/// A part from a closed mesh, with edges. Points are judged by the mesh's signed distance.
PushBackScene partPushBackScene(std::string name, const TriangleMesh& mesh);

/// Ball R 3 and R 0.5, flat, bull nose, taper; shank and holder on top.
std::vector<Tool> pushBackTools();

enum class PushBackAxis : std::uint8_t {
    upright,           ///< three axes: a field over tips
    chosen,            ///< 3+2: a field as seen along an axis
    freeWithoutTorque, ///< the axis follows the hand
    freeWithTorque     ///< hand and part share it
};
std::string nameOf(PushBackAxis axis);

/// What bounds a tool in a scene. Cost: a second for a field.
BoundaryLayers pushBackLayers(const PushBackScene& scene, const Tool& tool, PushBackAxis axis, double voxel,
                              double maximumAllowance);

struct PushBackRun {
    PushBackAxis axis = PushBackAxis::upright;
    double voxel = 0.5;     ///< mm
    double allowance = 0.0; ///< mm
    int ticks = 2000;       ///< of 1 ms
    std::uint32_t seed = 1;
    bool pressing = true; ///< the hand is drawn through the solid; else it goes at random, with slams and jumps
};

struct PushBackFigures {
    double gouge = 0.0;         ///< mm, deepest at the ends of ticks: with the allowance, into the grown part
    double gougeOnTheWay = 0.0; ///< mm, deepest between them
    double deepestPress = 0.0;  ///< mm, hand behind the tool
    int touching = 0;           ///< ticks in contact
    int turning = 0;            ///< ticks that turned the axis while in contact
    int mostIterations = 0;
    std::vector<double> microseconds; ///< of each tick's proxy, this thread's processor time
};

/// Greatest gouges of many runs, in voxels: at the ends of ticks and on the way between them.
struct PushBackGouges {
    double smooth = 0.0; ///< in scenes without edges
    double edge = 0.0;   ///< in those with edges
    std::string worst;   ///< the run with the greatest share of what its kind of scene allows
};
/// Every tool and every kind of axis in every scene, pressing and at random. Cost: about a second for 300 ticks a run
/// and a field of each tool, more for parts.
PushBackGouges pushBackGouges(std::span<const PushBackScene> scenes, int ticks, double voxel = 0.5);
inline constexpr double smoothGougeLimit = 0.05; ///< voxels
inline constexpr double edgeGougeLimit = 0.5;    ///< voxels

/// Moves a proxy under a hand through a scene and measures every tick. Deterministic for a seed.
PushBackFigures measurePushBack(const PushBackScene& scene, const Tool& tool, BoundaryLayers& layers,
                                const PushBackRun& run);

} // namespace burin::oracles

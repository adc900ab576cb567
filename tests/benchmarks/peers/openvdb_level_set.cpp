// SPDX-FileCopyrightText: 2026 The Burin authors
// SPDX-License-Identifier: Apache-2.0
#include "tests/benchmarks/measure/replay.h"
#include "tests/benchmarks/peers/openvdb.h"

#include <openvdb/openvdb.h>
#include <openvdb/tools/Composite.h>
#include <openvdb/tools/Interpolation.h>
#include <openvdb/tools/LevelSetSphere.h>
#include <openvdb/tools/MeshToVolume.h>
#include <openvdb/tools/Prune.h>
#include <tbb/task_arena.h>

#include <algorithm>
#include <cmath>

namespace burin::benchmarks {

namespace {

using openvdb::FloatGrid;

/// OpenVDB has to be initialised before the first grid is made.
void initialise() {
    static const bool done = (openvdb::initialize(), true);
    (void)done;
}

FloatGrid::Ptr meshLevelSet(const TriangleMesh& mesh, float halfWidth) {
    initialise();
    std::vector<openvdb::Vec3s> points;
    points.reserve(mesh.vertices.size());
    for (const glm::dvec3& vertex : mesh.vertices)
        points.emplace_back(static_cast<float>(vertex.x), static_cast<float>(vertex.y), static_cast<float>(vertex.z));
    std::vector<openvdb::Vec3I> triangles;
    triangles.reserve(mesh.triangles.size());
    for (const auto& corners : mesh.triangles) triangles.emplace_back(corners[0], corners[1], corners[2]);
    return openvdb::tools::meshToLevelSet<FloatGrid>(*openvdb::math::Transform::createLinearTransform(1.0), points,
                                                     triangles, halfWidth);
}

/// Signed distance to a box, mm.
double boxDistance(const Box& box, const glm::dvec3& place) {
    const glm::dvec3 beyond = glm::abs(place - box.centre()) - 0.5 * box.size();
    return glm::length(glm::max(beyond, glm::dvec3(0.0))) + std::min(0.0, std::max({beyond.x, beyond.y, beyond.z}));
}

/// A level set with voxels of 1 mm and half bandwidth 3, made leaf by leaf, as createLevelSetBox takes half a minute
/// for 1024 voxels.
FloatGrid::Ptr boxLevelSet(const Box& box) {
    initialise();
    constexpr float halfWidth = 3.0F;
    constexpr std::int32_t leafSide = 8;
    constexpr double leafReach = 7.0; // from a leaf's centre to its farthest voxel's, rounded up
    const FloatGrid::Ptr grid = FloatGrid::create(halfWidth);
    grid->setGridClass(openvdb::GRID_LEVEL_SET);
    openvdb::FloatTree& tree = grid->tree();
    const auto corner = [](const glm::dvec3& place, double inwards) {
        const glm::ivec3 voxel(glm::round(place + inwards));
        return openvdb::Coord(voxel.x, voxel.y, voxel.z);
    };
    tree.fill({corner(box.low, 1.0), corner(box.high, -1.0)}, -halfWidth, false);
    const openvdb::Coord low = corner(box.low, -leafSide) & ~(leafSide - 1), high = corner(box.high, leafSide);
    for (std::int32_t x = low.x(); x <= high.x(); x += leafSide)
        for (std::int32_t y = low.y(); y <= high.y(); y += leafSide)
            for (std::int32_t z = low.z(); z <= high.z(); z += leafSide) {
                const glm::dvec3 middle = glm::dvec3(x, y, z) + 0.5 * (leafSide - 1);
                if (std::abs(boxDistance(box, middle)) > halfWidth + leafReach) continue;
                auto* const leaf = tree.touchLeaf({x, y, z});
                for (openvdb::Index i = 0; i < openvdb::FloatTree::LeafNodeType::SIZE; ++i) {
                    const openvdb::Coord voxel = leaf->offsetToGlobalCoord(i);
                    const auto distance =
                        static_cast<float>(boxDistance(box, glm::dvec3(voxel.x(), voxel.y(), voxel.z())));
                    if (std::abs(distance) < halfWidth)
                        leaf->setValueOn(i, distance);
                    else
                        leaf->setValueOff(i, std::copysign(halfWidth, distance));
                }
            }
    openvdb::tools::pruneLevelSet(tree);
    return grid;
}

/// Subtracts a level-set sphere that stands on its tip from a workpiece with voxels of 1 mm and half bandwidth 3.
void takeSphere(FloatGrid& workpiece, const glm::dvec3& tip, double radius) {
    const openvdb::Vec3f centre(openvdb::Vec3d(tip.x, tip.y, tip.z + radius));
    const FloatGrid::Ptr tool =
        openvdb::tools::createLevelSetSphere<FloatGrid>(static_cast<float>(radius), centre, 1.0F, 3.0F);
    openvdb::tools::csgDifference(workpiece, *tool);
}

} // namespace

std::optional<std::vector<double>> csgDifferenceTimes(double side, double radius, const std::vector<glm::dvec3>& tips) {
    const FloatGrid::Ptr block = boxLevelSet({glm::dvec3(0.03 * side), glm::dvec3(0.97 * side)});
    FloatGrid::Ptr workpiece;
    tbb::task_arena one(1); // as Burin cuts
    constexpr ReplayRule fourReplays{4, 4, 0.0};
    return leastOfReplays(
        tips.size(), [&] { workpiece = block->deepCopy(); },
        [&](std::size_t i) { one.execute([&] { takeSphere(*workpiece, tips[i], radius); }); }, fourReplays);
}

std::optional<double> meshToLevelSetSeconds(const TriangleMesh& mesh, float halfWidth) {
    initialise();
    return leastSeconds(4, [&] { (void)meshLevelSet(mesh, halfWidth); });
}

std::optional<std::array<double, 3>> levelSetBooleanTimes(const Box& a, const Box& b, int runs) {
    const FloatGrid::Ptr first = boxLevelSet(a), second = boxLevelSet(b);
    using openvdb::tools::csgDifferenceCopy;
    using openvdb::tools::csgIntersectionCopy;
    using openvdb::tools::csgUnionCopy;
    return std::array<double, 3>{1e3 * leastSeconds(runs, [&] { (void)csgUnionCopy(*first, *second); }),
                                 1e3 * leastSeconds(runs, [&] { (void)csgIntersectionCopy(*first, *second); }),
                                 1e3 * leastSeconds(runs, [&] { (void)csgDifferenceCopy(*first, *second); })};
}

std::optional<double> levelSetQueryNanoseconds(const TriangleMesh& mesh, const std::vector<glm::dvec3>& places) {
    const FloatGrid::Ptr levelSet = meshLevelSet(mesh, 4.0F);
    const openvdb::tree::ValueAccessor<const openvdb::FloatTree> access(levelSet->constTree());
    float sum = 0.0F;
    const double spent = leastSeconds(5, [&] {
        for (const glm::dvec3& place : places) {
            float value = 0.0F;
            openvdb::tools::BoxSampler::sample(access, openvdb::Vec3d(place.x, place.y, place.z), value);
            sum += value;
        }
    });
    volatile float kept = sum; // so that the work is not optimised away
    (void)kept;
    return 1e9 * spent / static_cast<double>(places.size());
}

} // namespace burin::benchmarks

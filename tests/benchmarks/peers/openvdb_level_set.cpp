// SPDX-FileCopyrightText: 2026 The Burin authors
// SPDX-License-Identifier: Apache-2.0
#include "tests/benchmarks/measure/replay.h"
#include "tests/benchmarks/peers/openvdb.h"

#include <openvdb/openvdb.h>
#include <openvdb/tools/Composite.h>
#include <openvdb/tools/Interpolation.h>
#include <openvdb/tools/LevelSetPlatonic.h>
#include <openvdb/tools/LevelSetSphere.h>
#include <openvdb/tools/MeshToVolume.h>

namespace burin::benchmarks {

namespace {

using openvdb::FloatGrid;

/// OpenVDB wants to be initialised before the first grid is made.
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

FloatGrid::Ptr boxLevelSet(const Box& box) {
    initialise();
    constexpr double voxel = 1.0;
    constexpr float halfWidth = 3.0F;
    const openvdb::BBoxd bounds(openvdb::Vec3d(box.low.x, box.low.y, box.low.z),
                                openvdb::Vec3d(box.high.x, box.high.y, box.high.z));
    return openvdb::tools::createLevelSetBox<FloatGrid>(bounds, *openvdb::math::Transform::createLinearTransform(voxel),
                                                        halfWidth);
}

} // namespace

std::optional<std::vector<double>> csgDifferenceTimes(double side, double radius, const std::vector<glm::dvec3>& tips) {
    constexpr float voxel = 1.0F, halfWidth = 3.0F;
    const FloatGrid::Ptr workpiece = boxLevelSet({glm::dvec3(0.03 * side), glm::dvec3(0.97 * side)});
    std::vector<double> times;
    for (const glm::dvec3& tip : tips) {
        Session::throwIfCancelled();
        const Clock::time_point start = Clock::now();
        const openvdb::Vec3f centre(openvdb::Vec3d(tip.x, tip.y, tip.z + radius));
        const FloatGrid::Ptr tool =
            openvdb::tools::createLevelSetSphere<FloatGrid>(static_cast<float>(radius), centre, voxel, halfWidth);
        openvdb::tools::csgDifference(*workpiece, *tool);
        times.push_back(microseconds(Clock::now() - start));
    }
    return times;
}

std::optional<double> meshToLevelSetSeconds(const TriangleMesh& mesh, float halfWidth) {
    initialise();
    return leastSeconds(1, [&] { (void)meshLevelSet(mesh, halfWidth); });
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
    volatile float kept = sum; // the work has to be done
    (void)kept;
    return 1e9 * spent / static_cast<double>(places.size());
}

} // namespace burin::benchmarks

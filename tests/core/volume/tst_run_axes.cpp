// SPDX-FileCopyrightText: 2026 The Burin authors
// SPDX-License-Identifier: Apache-2.0
#include "core/volume/operations/boolean.h"
#include "core/volume/operations/boundary.h"
#include "core/volume/operations/dense.h"
#include "core/volume/operations/ray_cast.h"
#include "core/volume/operations/relation.h"
#include "tests/core/volume/voxelised.h"
#include "tests/test_program.h"

#include <QtTest>
#include <rapidcheck.h>

#include <random>
#include <set>

namespace burin::tst_run_axes {

using namespace burin::test;

namespace {

/// Random runs, line by line; the same for the same seed and line counts, whatever the axis.
RunVolume someRuns(const Grid& grid, std::uint32_t seed) {
    std::mt19937 random(seed);
    RunVolume volume = emptyVolume(grid, 2'000'000);
    for (int i = 0; i < 60; ++i) {
        const LineIndex low{static_cast<int>(random() % static_cast<unsigned>(grid.lineCountU())),
                            static_cast<int>(random() % static_cast<unsigned>(grid.lineCountV()))};
        const LineIndex high{low.u + static_cast<int>(random() % 6), low.v + static_cast<int>(random() % 6)};
        const auto from = static_cast<RunPosition>(random() % grid.lineEnd());
        const auto length = static_cast<RunPosition>(random() % 2000);
        volume.fillBlock(low, high, from, from + length, static_cast<PropertyIndex>(random() % 4));
    }
    return volume;
}

bool sameLines(const RunVolume& a, const RunVolume& b) {
    for (LineIndex line; line.v < a.grid().lineCountV(); ++line.v)
        for (line.u = 0; line.u < a.grid().lineCountU(); ++line.u)
            if (!std::ranges::equal(a.line(line), b.line(line))) return false;
    return true;
}

/// The point with the coordinates of `point`, which belongs to a grid of runs along z, in a grid along another axis.
glm::dvec3 moved(const glm::dvec3& point, const Grid& goal) {
    glm::dvec3 place(0.0);
    place[goal.axisOfU()] = point.x;
    place[goal.axisOfV()] = point.y;
    place[goal.axisOfRuns()] = point.z;
    return place;
}

std::set<std::array<int, 3>> asSet(const std::vector<VoxelIndex>& voxels, const Grid& grid) {
    std::set<std::array<int, 3>> all;
    for (const VoxelIndex voxel : voxels) {
        const LineIndex line = grid.lineOf(voxel);
        all.insert({line.u, line.v, grid.alongOf(voxel)});
    }
    return all;
}

} // namespace

/// The result of an operation with runs along x and y equals that for the rotated volume along z.
class TestRunAxes : public QObject {
    Q_OBJECT

private slots:
    void everyOperationWorksAlongEveryAxis() {
        QVERIFY(rc::check("axes", [] {
            const auto seed = *rc::gen::arbitrary<std::uint32_t>();
            const glm::ivec3 count(*rc::gen::inRange(2, 20), *rc::gen::inRange(2, 20), *rc::gen::inRange(2, 20));
            const Grid gridZ = cubeGrid(count);
            RunVolume a = someRuns(gridZ, seed), b = someRuns(gridZ, seed + 1);
            for (const RunAxis axis : {RunAxis::x, RunAxis::y}) {
                const Grid probe = cubeGrid({1, 1, 1}, axis);
                const Grid grid = cubeGrid(glm::ivec3(moved(count, probe)), axis);
                RunVolume turnedA = someRuns(grid, seed), turnedB = someRuns(grid, seed + 1);
                RC_ASSERT(sameLines(turnedA, a));
                RC_ASSERT(
                    sameLines(*unionOf(turnedA.snapshot(), turnedB.snapshot()), *unionOf(a.snapshot(), b.snapshot())));
                RC_ASSERT(sameLines(*intersectionOf(turnedA.snapshot(), turnedB.snapshot()),
                                    *intersectionOf(a.snapshot(), b.snapshot())));
                RC_ASSERT(sameLines(*differenceOf(turnedA.snapshot(), turnedB.snapshot()),
                                    *differenceOf(a.snapshot(), b.snapshot())));
                RC_ASSERT(*relation(turnedA.snapshot(), turnedB.snapshot()) == *relation(a.snapshot(), b.snapshot()));
                RC_ASSERT(asSet(boundaryVoxels(turnedA.snapshot()), grid) ==
                          asSet(boundaryVoxels(a.snapshot()), gridZ));
                RC_ASSERT(sameLines(*fromDense(grid, someProperties(), toDense(turnedA.snapshot())),
                                    *fromDense(gridZ, someProperties(), toDense(a.snapshot()))));
                castRays(a.snapshot(), turnedA.snapshot(), seed);
            }
        }));
    }

private:
    static void castRays(const VolumeSnapshot& along, const VolumeSnapshot& turned, std::uint32_t seed) {
        std::mt19937 random(seed);
        std::uniform_real_distribution<double> number(-1.0, 1.0);
        for (int i = 0; i < 30; ++i) {
            const glm::dvec3 from = 30.0 * glm::dvec3(number(random), number(random), number(random));
            const glm::dvec3 way = glm::dvec3(along.grid().count()) * 0.5 - from + glm::dvec3(3.0 * number(random));
            const auto hit = castRay(along, from, way);
            const auto same = castRay(turned, moved(from, turned.grid()), moved(way, turned.grid()));
            RC_ASSERT(hit.has_value() == same.has_value());
            if (!hit) continue;
            RC_ASSERT(hit->property == same->property);
            RC_ASSERT(std::abs(hit->distance - same->distance) < 1e-9);
            RC_ASSERT(glm::distance(moved(hit->place, turned.grid()), same->place) < 1e-9);
        }
    }
};

BURIN_TEST(TestRunAxes, NoApplication)

} // namespace burin::tst_run_axes

#include "tst_run_axes.moc"

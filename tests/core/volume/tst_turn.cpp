// SPDX-FileCopyrightText: 2026 The Burin authors
// SPDX-License-Identifier: Apache-2.0
#include "core/volume/operations/dense.h"
#include "core/volume/operations/turn.h"
#include "tests/core/volume/shapes.h"
#include "tests/core/volume/voxelised.h"
#include "tests/test_program.h"

#include <QtTest>
#include <rapidcheck.h>

#include <random>

namespace burin::tst_turn {

using namespace burin::test;

namespace {

TurnedVolume turn(const RunVolume& volume, RunAxis axis) {
    Progress progress;
    return *turned(const_cast<RunVolume&>(volume).snapshot(), axis, progress);
}

bool sameLines(const RunVolume& a, const RunVolume& b) {
    for (LineIndex line; line.v < a.grid().lineCountV(); ++line.v)
        for (line.u = 0; line.u < a.grid().lineCountU(); ++line.u)
            if (!std::ranges::equal(a.line(line), b.line(line))) return false;
    return true;
}

glm::ivec3 someCount() {
    return {*rc::gen::inRange(1, 30), *rc::gen::inRange(1, 30), *rc::gen::inRange(1, 30)};
}

/// Random runs; ends at multiples of `unit` run units.
RunVolume someRuns(const Grid& grid, std::mt19937& random, RunPosition unit) {
    RunVolume volume = emptyVolume(grid, 4'000'000);
    for (int i = 0; i < 300; ++i) {
        const LineIndex low{static_cast<int>(random() % static_cast<unsigned>(grid.lineCountU())),
                            static_cast<int>(random() % static_cast<unsigned>(grid.lineCountV()))};
        const LineIndex high{low.u + static_cast<int>(random() % 6), low.v + static_cast<int>(random() % 6)};
        const auto place = [&] { return static_cast<RunPosition>(random() % grid.lineEnd()) / unit * unit; };
        const RunPosition from = place(), to = place();
        volume.fillBlock(low, high, std::min(from, to), std::max(from, to), static_cast<PropertyIndex>(random() % 4));
    }
    return volume;
}

/// Everything below a plane: z < offset + slope · (x, y), at the centres of scanlines along z.
RunVolume belowPlane(const Grid& grid, double offset, const glm::dvec2& slope) {
    RunVolume volume = emptyVolume(grid);
    for (LineIndex line; line.v < grid.lineCountV(); ++line.v)
        for (line.u = 0; line.u < grid.lineCountU(); ++line.u)
            volume.fillSpan(line, 0, grid.toRunPosition(offset + glm::dot(slope, grid.lineCentre(line))), wax);
    return volume;
}

} // namespace

class TestTurn : public QObject {
    Q_OBJECT

private slots:
    void wholeVoxelsAreTurnedWithoutLossThereAndBack() {
        QVERIFY(rc::check("whole voxels", [] {
            std::mt19937 random(*rc::gen::arbitrary<std::uint32_t>());
            const glm::ivec3 count = someCount();
            for (const RunAxis from : everyAxis)
                for (const RunAxis to : everyAxis) {
                    RunVolume volume = someRuns(cubeGrid(count, from), random, unitsPerVoxel);
                    TurnedVolume result = turn(volume, to);
                    RC_ASSERT(result.volume.grid().axis() == to);
                    RC_ASSERT(toDense(result.volume.snapshot()) == toDense(volume.snapshot()));
                    RC_ASSERT(result.volume.amounts() == volume.amounts());
                    RC_ASSERT(result.loss.greatestDisplacement == 0.0);
                    for (const double change : result.loss.changed) RC_ASSERT(change == 0.0);
                    RC_ASSERT(sameLines(turn(result.volume, from).volume, volume));
                }
        }));
    }

    void everyVoxelKeepsThePropertyOfItsCentre() {
        QVERIFY(rc::check("ends within voxels", [] {
            std::mt19937 random(*rc::gen::arbitrary<std::uint32_t>());
            const glm::ivec3 count = someCount();
            for (const RunAxis from : everyAxis)
                for (const RunAxis to : everyAxis) {
                    RunVolume volume = someRuns(cubeGrid(count, from, 0.5), random, 1);
                    TurnedVolume result = turn(volume, to);
                    RC_ASSERT(toDense(result.volume.snapshot()) == toDense(volume.snapshot()));
                    RC_ASSERT(result.volume.amounts() == result.volume.snapshot().amounts());
                    RC_ASSERT(result.loss.greatestDisplacement <= 0.5);
                    for (std::size_t p = 0; p < 4; ++p)
                        RC_ASSERT(
                            std::abs(result.loss.changed[p] - (static_cast<double>(result.volume.amounts().units[p]) -
                                                               static_cast<double>(volume.amounts().units[p])) *
                                                                  0.125 / 256.0) < 1e-9);
                    if (from == to) RC_ASSERT(sameLines(result.volume, volume));
                }
        }));
    }

    void aPlaneStaysAPlane() {
        QVERIFY(rc::check("planes", [] {
            const auto number = [](int low, int high) { return *rc::gen::inRange(low * 1000, high * 1000) / 1000.0; };
            const double steep = *rc::gen::element(0.05, 0.5, 1.0, 3.0, 7.0);
            const glm::dvec2 slope(number(-1, 1) * steep, number(-1, 1));
            const Grid grid = cubeGrid({30, 20, 60});
            const double offset = 30.0 - glm::dot(slope, glm::dvec2(15.0, 10.0)) + number(-5, 5);
            const TurnedVolume result = turn(belowPlane(grid, offset, slope), RunAxis::x);
            const Grid& along = result.volume.grid();
            const double norm = std::sqrt(1.0 + glm::dot(slope, slope));
            int ends = 0;
            for (LineIndex line; line.v < along.lineCountV(); ++line.v)
                for (line.u = 0; line.u < along.lineCountU(); ++line.u) {
                    const auto segments = result.volume.line(line);
                    for (std::size_t i = 0; i + 1 < segments.size(); ++i, ++ends) {
                        const double x = along.toMillimetres(segments[i].end());
                        const glm::dvec2 centre = along.lineCentre(line); // y, z
                        const double height = offset + slope.x * x + slope.y * centre.x;
                        if (height < 0.6 * steep || height > 60.0 - 0.6 * steep) continue; // the grid cuts the old ends
                        const auto oldEnd = [&](double at) {
                            return grid.toRunPosition(offset + slope.x * at + slope.y * centre.x);
                        };
                        const double face = std::round(x);
                        if (oldEnd(face - 0.5) % unitsPerVoxel == 0 && oldEnd(face + 0.5) % unitsPerVoxel == 0)
                            continue; // whole voxels stay whole
                        RC_ASSERT(std::abs(height - centre.y) / norm < 1.0 / 128.0);
                    }
                }
            if (std::abs(slope.x) > 0.2) RC_ASSERT(ends > 50);
        }));
    }

    void aFloorBetweenVoxelFacesMovesToTheNearestOne() {
        const Grid grid = cubeGrid({12, 14, 16}, RunAxis::z, 0.5);
        RunVolume volume = emptyVolume(grid);
        volume.fillBlock({2, 3}, {8, 9}, 512, 2048 + 90, wax);
        const TurnedVolume result = turn(volume, RunAxis::y);
        QCOMPARE(result.volume.amounts().units[wax], std::uint64_t{6 * 6 * 6 * 256});
        QCOMPARE(result.loss.greatestDisplacement, 90.0 / 256.0);
        QCOMPARE(result.loss.changed[wax], -36 * 90 * 0.125 / 256.0);
        QCOMPARE(result.loss.changed[airProperty], 36 * 90 * 0.125 / 256.0);
        QCOMPARE(result.loss.changed[part], 0.0);
    }

    void aSphereKeepsItsVolume() {
        const double exact = 4.0 / 3.0 * pi * 512.0;
        const TriangleMesh mesh = sphereMesh({10.1, 10.2, 10.3}, 8.0, 150);
        double earlier = 1.0;
        for (const int voxels : {40, 80, 160}) {
            RunVolume volume = emptyVolume(cubeGrid(glm::ivec3(voxels), RunAxis::z, 20.0 / voxels));
            fill(mesh, volume);
            for (const RunAxis axis : {RunAxis::x, RunAxis::y}) {
                const TurnedVolume result = turn(volume, axis);
                const double units = static_cast<double>(result.volume.amounts().units[part]);
                const double error = units * result.volume.grid().unitVolume() / exact - 1.0;
                qInfo("%d voxels: %.1e", voxels, error);
                QVERIFY(std::abs(error) < 0.1 / voxels);
                if (axis == RunAxis::y) earlier = error;
            }
        }
        QVERIFY(std::abs(earlier) < 1e-3);
    }

    void cancellingIsAnError() {
        RunVolume volume = emptyVolume(cubeGrid({16, 16, 16}));
        Progress progress;
        progress.cancel();
        const auto result = turned(volume.snapshot(), RunAxis::x, progress);
        QVERIFY(!result && result.error().code == ErrorCode::cancelled);
    }
};

BURIN_TEST(TestTurn, NoApplication)

} // namespace burin::tst_turn

#include "tst_turn.moc"

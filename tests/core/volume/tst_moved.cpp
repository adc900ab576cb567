// SPDX-FileCopyrightText: 2026 The Burin authors
// SPDX-License-Identifier: Apache-2.0
#include "core/base/units.h"
#include "core/volume/operations/dense.h"
#include "core/volume/operations/moved.h"
#include "tests/core/volume/shapes.h"
#include "tests/core/volume/voxelised.h"
#include "tests/test_program.h"

#include <QtTest>
#include <rapidcheck.h>

#include <cmath>
#include <random>

namespace burin::tst_moved {

using namespace burin::test;

namespace {

MovedVolume move(RunVolume& volume, const Placement& placement) {
    Progress progress;
    return *moved(volume.snapshot(), placement, progress);
}

RunVolume someRuns(const Grid& grid, std::mt19937& random) {
    RunVolume volume = emptyVolume(grid, 4'000'000);
    for (int i = 0; i < 200; ++i) {
        const LineIndex low{static_cast<int>(random() % static_cast<unsigned>(grid.lineCountU())),
                            static_cast<int>(random() % static_cast<unsigned>(grid.lineCountV()))};
        const LineIndex high{low.u + static_cast<int>(random() % 6), low.v + static_cast<int>(random() % 6)};
        const auto place = [&] { return static_cast<RunPosition>(random() % grid.lineEnd()); };
        const RunPosition from = place(), to = place();
        volume.fillBlock(low, high, std::min(from, to), std::max(from, to), static_cast<PropertyIndex>(random() % 4));
    }
    return volume;
}

/// The property of a volume at a point, from its runs alone.
PropertyIndex at(const RunVolume& volume, const glm::dvec3& place) {
    const Grid& grid = volume.grid();
    const glm::dvec3 local = (place - grid.low()) / grid.edge();
    const LineIndex line{static_cast<int>(std::floor(local[grid.axisOfU()])),
                         static_cast<int>(std::floor(local[grid.axisOfV()]))};
    const double along = local[grid.axisOfRuns()] * unitsPerVoxel;
    if (!grid.contains(line) || along < 0.0) return airProperty;
    for (const Segment segment : volume.line(line))
        if (along < static_cast<double>(segment.end())) return segment.property();
    return airProperty;
}

/// A rotation that maps axes to axes, about some point, and a translation.
Placement someTurnAlongAxes() {
    Placement placement;
    for (int i = *rc::gen::inRange(0, 4); i > 0; --i) {
        glm::dvec3 axis(0.0);
        axis[*rc::gen::inRange(0, 3)] = 1.0;
        placement = combined(placement, turnedAbout(axis, 0.5 * pi * *rc::gen::inRange(0, 4), {3.0, 1.0, 2.0}));
    }
    const auto number = [] { return *rc::gen::inRange(-500, 500) / 37.0; };
    return combined(placement, movedBy({number(), number(), number()}));
}

} // namespace

class TestMoved : public QObject {
    Q_OBJECT

private slots:
    /// With run ends within voxels, too: a workpiece that is turned over is the same workpiece.
    void turnsAlongAxesLoseNothingThereAndBack() {
        QVERIFY(rc::check("there and back", [] {
            std::mt19937 random(*rc::gen::arbitrary<std::uint32_t>());
            const auto side = [] { return *rc::gen::inRange(1, 24); };
            const Grid grid = cubeGrid({side(), side(), side()}, *rc::gen::element(RunAxis::x, RunAxis::y, RunAxis::z),
                                       *rc::gen::element(1.0, 0.5, 0.3));
            RunVolume volume = someRuns(grid, random);
            const Placement placement = someTurnAlongAxes();
            MovedVolume there = move(volume, placement);
            RC_ASSERT(there.greatestDisplacement == 0.0);
            RC_ASSERT(there.volume.amounts() == volume.amounts());
            MovedVolume back = move(there.volume, inverse(placement));
            RC_ASSERT(back.volume.grid().count() == grid.count() && back.volume.grid().axis() == grid.axis());
            RC_ASSERT(glm::distance(back.volume.grid().low(), grid.low()) < 1e-9);
            for (LineIndex line; line.v < grid.lineCountV(); ++line.v)
                for (line.u = 0; line.u < grid.lineCountU(); ++line.u)
                    RC_ASSERT(std::ranges::equal(back.volume.line(line), volume.line(line)));
        }));
    }

    /// Point by point: the material of each point is at the point that the placement maps it to.
    void everyPlaceKeepsItsMaterial() {
        QVERIFY(rc::check("places", [] {
            std::mt19937 random(*rc::gen::arbitrary<std::uint32_t>());
            const Grid grid = cubeGrid({17, 9, 12}, *rc::gen::element(RunAxis::x, RunAxis::y, RunAxis::z), 0.5);
            RunVolume volume = someRuns(grid, random);
            const Placement placement = someTurnAlongAxes();
            const MovedVolume result = move(volume, placement);
            std::uniform_real_distribution<double> share(0.0, 1.0);
            for (int i = 0; i < 300; ++i) {
                // Perpendicular to the runs in the middle of columns: their borders may belong to either.
                glm::dvec3 place = grid.low();
                place[grid.axisOfU()] += (std::floor(share(random) * grid.lineCountU()) + 0.5) * grid.edge();
                place[grid.axisOfV()] += (std::floor(share(random) * grid.lineCountV()) + 0.5) * grid.edge();
                place[grid.axisOfRuns()] +=
                    (std::floor(share(random) * grid.lineEnd()) + 0.5) / unitsPerVoxel * grid.edge();
                RC_ASSERT(at(result.volume, placement.point(place)) == at(volume, place));
            }
        }));
    }

    /// For any rotation: on each new scanline the material is that of the old volume there, to a run unit.
    void aTiltedScanlineMeetsTheOldRuns() {
        QVERIFY(rc::check("tilted", [] {
            std::mt19937 random(*rc::gen::arbitrary<std::uint32_t>());
            const Grid grid = cubeGrid({14, 11, 9}, *rc::gen::element(RunAxis::x, RunAxis::y, RunAxis::z));
            RunVolume volume = someRuns(grid, random);
            const auto number = [] { return *rc::gen::inRange(-1000, 1000) / 1000.0; };
            const Placement placement =
                combined(turnedAbout({number(), number(), 1.001}, 3.0 * number(), {5.0, 5.0, 5.0}),
                         movedBy({number(), number(), number()}));
            const MovedVolume result = move(volume, placement);
            const Grid& turned = result.volume.grid();
            const Placement back = inverse(placement);
            std::uniform_real_distribution<double> share(0.0, 1.0);
            int looked = 0, differ = 0;
            for (int i = 0; i < 1000; ++i) {
                glm::dvec3 place = turned.low();
                place[turned.axisOfU()] += (std::floor(share(random) * turned.lineCountU()) + 0.5) * turned.edge();
                place[turned.axisOfV()] += (std::floor(share(random) * turned.lineCountV()) + 0.5) * turned.edge();
                place[turned.axisOfRuns()] += share(random) * turned.voxelsPerLine() * turned.edge();
                ++looked;
                if (at(result.volume, place) != at(volume, back.point(place))) ++differ;
            }
            // A run end is rounded to 1/256 voxel: a point may be within the rounding.
            RC_ASSERT(differ <= looked / 20);
            RC_ASSERT((result.greatestDisplacement > 0.0) == !alongAxes(placement));
        }));
    }

    /// A bar that is rotated by any angle keeps its volume.
    void volumeStaysAsItIsTurned() {
        const Grid grid = cubeGrid({80, 40, 40}, RunAxis::z, 0.25);
        RunVolume bar = emptyVolume(grid);
        QVERIFY(bar.fillBlock({4, 4}, {76, 36}, 5 * unitsPerVoxel, 35 * unitsPerVoxel, wax));
        for (const double angle : {0.1, 0.5, 0.785, 1.2}) {
            const MovedVolume result = move(bar, turnedAbout({0.3, 1.0, 0.2}, angle, grid.box().centre()));
            const double ratio =
                static_cast<double>(result.volume.amounts().units[wax]) / static_cast<double>(bar.amounts().units[wax]);
            QVERIFY2(std::abs(ratio - 1.0) < 2e-3, qPrintable(QString::number(ratio)));
        }
    }

    void whatWouldBeTooLargeIsRefused() {
        RunVolume rod = emptyVolume(cubeGrid({Grid::maximumVoxelsPerAxis, 1, 1}, RunAxis::x, 0.001));
        Progress progress;
        const auto fits = moved(rod.snapshot(), turnedAbout({0.0, 0.0, 1.0}, 0.5 * pi, {}), progress);
        QVERIFY(fits && fits->volume.grid().axis() == RunAxis::y);
        progress.cancel();
        QCOMPARE(moved(rod.snapshot(), Placement{}, progress).error().code, ErrorCode::cancelled);
    }
};

BURIN_TEST(TestMoved, NoApplication)

} // namespace burin::tst_moved

#include "tst_moved.moc"

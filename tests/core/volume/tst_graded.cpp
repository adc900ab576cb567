// SPDX-FileCopyrightText: 2026 The Burin authors
// SPDX-License-Identifier: Apache-2.0
#include "core/volume/operations/graded.h"
#include "core/volume/operations/moments.h"
#include "tests/core/volume/volumes.h"
#include "tests/test_program.h"

#include <QtTest>
#include <rapidcheck.h>

#include <limits>

namespace burin::tst_graded {

using namespace burin::test;

namespace {

const std::string energy(specificCuttingEnergy);

/// Wax with a cutting energy, a part, and room for grades.
PropertyList waxAndPart() {
    PropertyList list;
    Property material;
    material.id = material.name = "wax";
    material.values[energy] = {0.5, "J/mm^3", "a table", false};
    material.values["density"] = {0.9, "g/cm^3", "a table", false};
    (void)list.add(material);
    material.id = material.name = "part";
    material.machinability = Machinability::isProtected;
    (void)list.add(material);
    return list;
}
constexpr PropertyIndex waxEntry = 1, partEntry = 2;

struct Graded {
    RunVolume volume;
    GradedMaterial material;
};

/// A block of wax with a part in it and ragged ends, graded.
Graded graded(const Grid& grid, Grading grading, int entries) {
    PropertyList list = waxAndPart();
    const GradedMaterial material = *addGrades(list, waxEntry, energy, std::move(grading), entries);
    RunVolume volume = *RunVolume::make(grid, list, std::size_t{16} << 20);
    (void)volume.fillBlock({0, 0}, {grid.lineCountU(), grid.lineCountV()}, 100, grid.lineEnd() - 77, waxEntry);
    (void)volume.fillBlock({2, 3}, {6, 7}, 700, 1300, partEntry);
    (void)volume.fillSpan({7, 7}, 900, 950, airProperty);
    return {std::move(volume), material};
}

glm::dvec3 middleOf(const Grid& grid, LineIndex line, RunPosition unit) {
    glm::dvec3 place;
    place[grid.axisOfU()] = grid.lineCentre(line).x;
    place[grid.axisOfV()] = grid.lineCentre(line).y;
    place[grid.axisOfRuns()] = grid.toMillimetres(unit) + 0.5 * grid.edge() / unitsPerVoxel;
    return place;
}

/// Compares every 1/256 voxel with the value there; everything except wax is unchanged.
void checkEveryUnit(const Graded& graded, const VolumeSnapshot& before) {
    const Grid& grid = before.grid();
    const PropertyList& list = graded.volume.properties();
    const double tolerance = 1e-9 * (graded.material.grading.high() - graded.material.grading.low());
    for (LineIndex line; line.v < grid.lineCountV(); ++line.v)
        for (line.u = 0; line.u < grid.lineCountU(); ++line.u) {
            auto was = before.line(line).begin(), is = graded.volume.line(line).begin();
            for (RunPosition unit = 0; unit < grid.lineEnd(); ++unit) {
                while (was->end() <= unit) ++was;
                while (is->end() <= unit) ++is;
                if (was->property() != waxEntry) {
                    RC_ASSERT(is->property() == was->property());
                    continue;
                }
                RC_ASSERT(list.baseOf(is->property()) == waxEntry);
                RC_ASSERT(is->property() != waxEntry);
                const double value = graded.material.grading.value(middleOf(grid, line, unit));
                RC_ASSERT(std::abs(list[is->property()].valueOr(energy, -1.0) - value) <=
                          graded.material.error() + tolerance);
            }
        }
}

std::vector<Grading::Control> someControls() {
    std::vector<Grading::Control> controls;
    const int count = *rc::gen::inRange(2, 6);
    double distance = *rc::gen::inRange(-40, 10) * 0.1;
    for (int i = 0; i < count; ++i) {
        distance += *rc::gen::inRange(1, 30) * 0.1;
        controls.push_back({distance, *rc::gen::inRange(0, 20) * 0.25 + i * 1e-3});
    }
    return controls;
}

} // namespace

class TestGraded : public QObject {
    Q_OBJECT

private slots:
    void entriesAreNamedAndHoldTheMiddleOfTheirBand() {
        PropertyList list = waxAndPart();
        const Grading grading = *Grading::fromPlane({0, 0, 0}, {0, 0, 2}, {{0.0, 1.0}, {10.0, 3.0}});
        const GradedMaterial material = *addGrades(list, waxEntry, energy, grading, 8);
        QCOMPARE(list.size(), 3 + 8);
        QCOMPARE(material.error(), 0.125);
        const Property& third = list[static_cast<PropertyIndex>(material.first + 2)];
        QCOMPARE(third.name, std::string("wax (graded 3/8)"));
        QCOMPARE(third.base, std::string("wax"));
        QCOMPARE(third.valueOr(energy, 0.0), 1.0 + 2.5 * 0.25);
        QCOMPARE(third.valueOr("density", 0.0), 0.9); // the others stay
        QCOMPARE(third.values.at(energy).unit, std::string("J/mm^3"));
        QVERIFY(addGrades(list, waxEntry, energy, grading, 8).error().code == ErrorCode::argumentInvalid); // again
        QCOMPARE(addGrades(list, waxEntry, "hardness", grading, 8).error().place, std::string("hardness"));
        QVERIFY(!addGrades(list, 99, energy, grading, 8));
        QVERIFY(!addGrades(list, waxEntry, energy, grading, 0));
    }

    void gradingsThatSayNothingAreRefused() {
        const glm::dvec3 x(1, 0, 0);
        QVERIFY(!Grading::fromPlane({}, x, {{0.0, 1.0}}));
        QVERIFY(!Grading::fromPlane({}, x, {{0.0, 1.0}, {1.0, 1.0}}));
        QVERIFY(!Grading::fromPlane({}, x, {{1.0, 1.0}, {1.0, 2.0}}));
        QVERIFY(!Grading::fromPlane({}, {}, {{0.0, 1.0}, {1.0, 2.0}}));
        QVERIFY(!Grading::fromPoint({std::numeric_limits<double>::quiet_NaN(), 0, 0}, {{0.0, 1.0}, {1.0, 2.0}}));
        QVERIFY(!Grading::fromAxis({}, x, {{0.0, 1.0}, {1.0, std::numeric_limits<double>::infinity()}}));
        QVERIFY(!Grading::of({}, 0.0, 1.0));
        QVERIFY(!Grading::of([](const glm::dvec3&) { return 0.0; }, 1.0, 1.0));
    }

    void valuesFollowTheControls() {
        const Grading skin = *Grading::fromAxis({1, 2, 0}, {0, 0, 5}, {{1.0, 4.0}, {2.0, 2.0}, {4.0, 3.0}});
        QCOMPARE(skin.value({1, 2, 77}), 4.0);
        QCOMPARE(skin.value({2.5, 2, -3}), 3.0);
        QCOMPARE(skin.value({1, 5, 0}), 2.5);
        QCOMPARE(skin.value({1, 50, 0}), 3.0);
        QCOMPARE(skin.low(), 2.0);
        QCOMPARE(skin.high(), 4.0);
    }

    void bordersLieWhereThePlaneDoes() {
        // 1/256 voxel along the runs: 0 to 8 mm in four bands of 2 mm on runs of 1 mm voxels.
        const Grading grading = *Grading::fromPlane({0, 0, 0}, {0, 0, 1}, {{0.0, 0.0}, {8.0, 4.0}});
        Graded block = graded(cubeGrid({9, 9, 8}), grading, 4);
        QVERIFY(gradeRuns(block.volume, block.material));
        const auto first = block.material.first;
        const std::vector<Segment> expected{{100, airProperty},
                                            {512, first},
                                            {1024, static_cast<PropertyIndex>(first + 1)},
                                            {1536, static_cast<PropertyIndex>(first + 2)},
                                            {2048 - 77, static_cast<PropertyIndex>(first + 3)},
                                            {2048, airProperty}};
        QVERIFY(std::ranges::equal(block.volume.line({0, 0}), expected));
        // Volumes and the total are the same as before.
        const VolumeMoments found = moments(block.volume.snapshot());
        QCOMPARE(found.byProperty[waxEntry].volume, 0.0);
    }

    void everyUnitIsWithinHalfABand() {
        QVERIFY(rc::check("distances: each 1/256 voxel within half a band", [] {
            const auto axis = static_cast<RunAxis>(*rc::gen::inRange(0, 3));
            const Grid grid = *Grid::make({-4.0, -3.0, 2.0}, 0.75, {9, 9, 9}, axis);
            const auto coordinate = [] { return *rc::gen::inRange(-30, 60) * 0.1; };
            const glm::dvec3 point(coordinate(), coordinate(), coordinate());
            const glm::dvec3 direction(*rc::gen::inRange(-2, 3), *rc::gen::inRange(-2, 3), *rc::gen::inRange(1, 3));
            const int shape = *rc::gen::inRange(0, 3);
            const Grading grading = *(shape == 0   ? Grading::fromPlane(point, direction, someControls())
                                      : shape == 1 ? Grading::fromPoint(point, someControls())
                                                   : Grading::fromAxis(point, direction, someControls()));
            Graded block = graded(grid, grading, *rc::gen::inRange(1, 24));
            const VolumeSnapshot before = block.volume.snapshot();
            RC_ASSERT(gradeRuns(block.volume, block.material));
            checkEveryUnit(block, before);
        }));
    }

    void functionsAreFollowedToo() {
        QVERIFY(rc::check("a wave: each 1/256 voxel within half a band", [] {
            const Grid grid = cubeGrid({9, 8, 12}, static_cast<RunAxis>(*rc::gen::inRange(0, 3)));
            const double length = *rc::gen::inRange(5, 20);
            // Even within a voxel it only rises or falls, except for its crests; those are far flatter than a band.
            const auto wave = [length](const glm::dvec3& place) {
                return std::floor(place.x) + 10.0 * std::sin((place.y + place.z) / length);
            };
            Graded block = graded(grid, *Grading::of(wave, -5.0, 15.0), *rc::gen::inRange(1, 6));
            const VolumeSnapshot before = block.volume.snapshot();
            RC_ASSERT(gradeRuns(block.volume, block.material));
            const VolumeSnapshot now = block.volume.snapshot();
            RC_ASSERT(gradeRuns(block.volume, block.material)); // no wax is left: nothing to do
            RC_ASSERT(now.amounts() == block.volume.amounts());
            RC_ASSERT(before.amounts().units[partEntry] == now.amounts().units[partEntry]);
            RC_ASSERT(now.amounts().units[waxEntry] == std::uint64_t{0});
            // Within half a band, plus the change of the wave within one voxel next to its crest.
            const PropertyList& list = block.volume.properties();
            const double slack = 10.0 / (length * length) / 8.0;
            for (LineIndex line; line.v < grid.lineCountV(); ++line.v)
                for (line.u = 0; line.u < grid.lineCountU(); ++line.u) {
                    RunPosition unit = 0;
                    for (const Segment segment : now.line(line))
                        for (; unit < segment.end(); ++unit) {
                            if (list.baseOf(segment.property()) != waxEntry || unit % 16 != 0) continue;
                            const double value = block.material.grading.value(middleOf(grid, line, unit));
                            RC_ASSERT(std::abs(list[segment.property()].valueOr(energy, -99.0) - value) <=
                                      block.material.error() + slack);
                        }
                }
        }));
    }

    void aFunctionsFaultsAreItsLowestValue() {
        const Grid grid = cubeGrid({9, 9, 9});
        const auto nothing = [](const glm::dvec3&) { return std::numeric_limits<double>::quiet_NaN(); };
        Graded block = graded(grid, *Grading::of(nothing, 1.0, 2.0), 4);
        QVERIFY(gradeRuns(block.volume, block.material));
        QVERIFY(block.volume.line({0, 0})[1].property() == block.material.first);
    }

    void onlyItsOwnGradesAreTaken() {
        const Grading grading = *Grading::fromPlane({0, 0, 0}, {0, 0, 1}, {{0.0, 0.0}, {8.0, 4.0}});
        Graded block = graded(cubeGrid({9, 9, 8}), grading, 4);
        RunVolume other = *RunVolume::make(cubeGrid({9, 9, 8}), waxAndPart());
        QVERIFY(gradeRuns(other, block.material).error().code == ErrorCode::argumentInvalid);
        GradedMaterial wrong = block.material;
        wrong.first = partEntry;
        QVERIFY(gradeRuns(block.volume, wrong).error().code == ErrorCode::argumentInvalid);
    }
};

BURIN_TEST(TestGraded, NoApplication)

} // namespace burin::tst_graded

#include "tst_graded.moc"

// SPDX-FileCopyrightText: 2026 The Burin authors
// SPDX-License-Identifier: Apache-2.0
#include "core/volume/operations/ray_cast.h"
#include "core/volume/operations/section.h"
#include "tests/core/volume/surfaces.h"
#include "tests/core/volume/volumes.h"
#include "tests/oracles/dense_grid.h"
#include "tests/test_program.h"

#include <QtTest>
#include <rapidcheck.h>

namespace burin::tst_ray_cast {

using namespace burin::test;

namespace {

constexpr double step = 0.002; // of the marching oracle, mm; the voxels are 1 mm

/// Some balls of different materials in a small grid, also written to a dense one.
struct Pile {
    Grid grid;
    RunVolume volume;
    oracles::DenseGrid dense;

    explicit Pile(RunAxis axis)
        : grid(*Grid::make({-2.0, 3.0, 1.0}, 1.0, {12, 11, 10}, axis)), volume(emptyVolume(grid)), dense(grid) {}

    void addBall(const glm::dvec3& centre, double radius, PropertyIndex property) {
        fillSphere(volume, property, centre, radius);
        for (LineIndex line; line.v < grid.lineCountV(); ++line.v)
            for (line.u = 0; line.u < grid.lineCountU(); ++line.u) {
                RunPosition begin = 0;
                for (const Segment segment : volume.line(line)) {
                    dense.fillSpan(line, begin, segment.end(), segment.property());
                    begin = segment.end();
                }
            }
    }
    PropertyIndex at(const glm::dvec3& place) const {
        const glm::dvec3 local = (place - grid.low()) / grid.edge();
        const glm::dvec3 inOrder(local[grid.axisOfU()], local[grid.axisOfV()], local[grid.axisOfRuns()]);
        if (glm::any(glm::lessThan(inOrder, glm::dvec3(0.0)))) return airProperty;
        const LineIndex line{static_cast<int>(inOrder.x), static_cast<int>(inOrder.y)};
        const auto unit = static_cast<RunPosition>(inOrder.z * unitsPerVoxel);
        return grid.contains(line) && unit < grid.lineEnd() ? dense.at(line, unit) : airProperty;
    }
    std::optional<RayHit> march(const glm::dvec3& origin, const glm::dvec3& way, RayTarget target) const {
        for (double distance = 0.0; distance < 60.0; distance += step) {
            const glm::dvec3 place = origin + way * distance;
            const PropertyIndex property = at(place);
            if (property != airProperty && (target == RayTarget::anything || property == part))
                return RayHit{place, distance, property};
        }
        return std::nullopt;
    }
};

glm::dvec3 anyPlace(int from, int to) {
    return {*rc::gen::inRange(from, to), *rc::gen::inRange(from, to), *rc::gen::inRange(from, to)};
}

Pile anyPile() {
    Pile pile(static_cast<RunAxis>(*rc::gen::inRange(0, 3)));
    for (int i = *rc::gen::inRange(1, 6); i > 0; --i)
        pile.addBall(pile.grid.low() + anyPlace(0, 1000) / 100.0, *rc::gen::inRange(5, 40) / 10.0,
                     *rc::gen::inRange<PropertyIndex>(0, 4));
    return pile;
}

} // namespace

class RayCastTest : public QObject {
    Q_OBJECT
private slots:
    void meetsWhatMarchingMeets();
    void passesTheMaterialThatMarchingPasses();
    void meetsRunEndsExactly();
    void startsInsideAtOnce();
    void missesAnEmptyGrid();
    void whatIsNoRayMeetsNothing_data();
    void whatIsNoRayMeetsNothing();
    void aRayFromFarAwayArrives();
    void nothingIsHighestAroundNoPlace();
    void findsThePartBehindStock();
    void highestIsWhatADenseGridShows();
    void aSectionIsWhatThePlaneMeets();
};

void RayCastTest::meetsWhatMarchingMeets() {
    QVERIFY(rc::check("a ray meets what small steps along it meet", [] {
        Pile pile = anyPile();
        const glm::dvec3 origin = pile.grid.box().centre() + anyPlace(-1500, 1500) / 100.0;
        // Offset from the centre by irregular amounts: marching skips corners thinner than its step.
        const glm::dvec3 aim = pile.grid.box().low + anyPlace(0, 1000) / 100.0 + glm::dvec3(0.00371, 0.00513, 0.00297);
        RC_PRE(glm::length(aim - origin) > 0.1);
        const glm::dvec3 way = glm::normalize(aim - origin);
        const RayTarget target = *rc::gen::element(RayTarget::anything, RayTarget::protectedOnly);
        const auto found = castRay(pile.volume.snapshot(), origin, way * 3.7, target);
        const auto expected = pile.march(origin, way, target);
        if (!found) {
            RC_ASSERT(!expected);
            return;
        }
        // The hit material is there, and nothing was hit before.
        RC_ASSERT(pile.at(found->place + way * 1e-9) == found->property);
        RC_ASSERT(glm::length(found->place - (origin + way * found->distance)) < 1e-9);
        if (!expected)
            RC_ASSERT(pile.at(found->place + way * step) != found->property); // thinner than a step
        else
            RC_ASSERT(found->distance <= expected->distance + 1e-9);
        for (double before = 0.0; before < found->distance - 1e-9; before += step) {
            const PropertyIndex property = pile.at(origin + way * before);
            RC_ASSERT(property == airProperty || (target == RayTarget::protectedOnly && property != part));
        }
    }));
}

void RayCastTest::passesTheMaterialThatMarchingPasses() {
    QVERIFY(rc::check("small steps along a ray are in material within its intervals, and nowhere else", [] {
        Pile pile = anyPile();
        const glm::dvec3 origin = pile.grid.box().centre() + anyPlace(-1500, 1500) / 100.0;
        const glm::dvec3 aim = pile.grid.box().low + anyPlace(0, 1000) / 100.0 + glm::dvec3(0.00371, 0.00513, 0.00297);
        RC_PRE(glm::length(aim - origin) > 0.1);
        const glm::dvec3 way = glm::normalize(aim - origin);
        constexpr double reach = 25.0;
        const std::vector<RayInterval> intervals = materialAlong(pile.volume.snapshot(), origin, way * 0.3, reach);
        for (std::size_t i = 0; i < intervals.size(); ++i) {
            RC_ASSERT(intervals[i].from <= intervals[i].to && intervals[i].to <= reach);
            RC_ASSERT(i == 0 || intervals[i - 1].to < intervals[i].from);
        }
        for (double at = 0.5 * step; at < reach; at += 5.0 * step) {
            const auto near = std::ranges::find_if(
                intervals, [&](const RayInterval& each) { return at > each.from - 1e-3 && at < each.to + 1e-3; });
            const bool atEnd =
                near != intervals.end() && (std::abs(at - near->from) < 1e-3 || std::abs(at - near->to) < 1e-3);
            if (!atEnd) RC_ASSERT((pile.at(origin + way * at) != airProperty) == (near != intervals.end()));
        }
    }));
}

void RayCastTest::meetsRunEndsExactly() {
    const Grid grid = cubeGrid({10, 10, 10});
    RunVolume volume = emptyVolume(grid);
    (void)volume.fillBlock({0, 0}, {10, 10}, 0, 5 * unitsPerVoxel + 77, wax);
    const VolumeSnapshot workpiece = volume.snapshot();
    const double top = 5.0 + 77.0 / 256.0;
    const auto down = castRay(workpiece, {4.3, 2.2, 20.0}, {0.0, 0.0, -2.0});
    QVERIFY(down);
    QCOMPARE(down->distance, 20.0 - top);
    QCOMPARE(down->property, wax);
    const auto side = castRay(workpiece, {-7.0, 2.2, 3.0}, {1.0, 0.0, 0.0});
    QVERIFY(side);
    QCOMPARE(side->distance, 7.0);
    const auto slanting = castRay(workpiece, {5.0, 5.0, top + 2.0}, {1.0, 0.0, -1.0});
    QVERIFY(slanting);
    QVERIFY(glm::length(slanting->place - glm::dvec3(7.0, 5.0, top)) < 1e-12);
}

void RayCastTest::startsInsideAtOnce() {
    RunVolume volume = emptyVolume(cubeGrid({10, 10, 10}));
    (void)volume.fillBlock({0, 0}, {10, 10}, 0, 5 * unitsPerVoxel, aluminium);
    const auto hit = castRay(volume.snapshot(), {5.0, 5.0, 2.0}, {0.3, 0.2, 1.0});
    QVERIFY(hit);
    QCOMPARE(hit->distance, 0.0);
    QCOMPARE(hit->property, aluminium);
}

void RayCastTest::missesAnEmptyGrid() {
    RunVolume volume = emptyVolume(cubeGrid({10, 10, 10}));
    const VolumeSnapshot workpiece = volume.snapshot();
    QVERIFY(!castRay(workpiece, {5.0, 5.0, 20.0}, {0.0, 0.0, -1.0}));
    QVERIFY(!castRay(workpiece, {5.0, 5.0, 20.0}, {0.0, 0.0, 1.0}));
    QCOMPARE(highestWithin(workpiece, {5.0, 5.0}, 3.0), 0.0);
}

void RayCastTest::whatIsNoRayMeetsNothing_data() {
    constexpr double nan = std::numeric_limits<double>::quiet_NaN(), inf = std::numeric_limits<double>::infinity();
    QTest::addColumn<glm::dvec3>("origin");
    QTest::addColumn<glm::dvec3>("direction");
    QTest::newRow("origin is no number") << glm::dvec3(nan) << glm::dvec3(1.0, 0.5, -1.0);
    QTest::newRow("one coordinate is no number") << glm::dvec3(nan, 5.0, 20.0) << glm::dvec3(0.2, 0.1, -1.0);
    QTest::newRow("origin at infinity") << glm::dvec3(5.0, 5.0, inf) << glm::dvec3(0.0, 0.0, -1.0);
    QTest::newRow("direction is no number") << glm::dvec3(5.0, 5.0, 20.0) << glm::dvec3(0.0, nan, -1.0);
    QTest::newRow("direction is infinite") << glm::dvec3(5.0, 5.0, 20.0) << glm::dvec3(0.0, 0.0, -inf);
    QTest::newRow("direction without length") << glm::dvec3(5.0, 5.0, 2.0) << glm::dvec3(0.0);
}

void RayCastTest::whatIsNoRayMeetsNothing() {
    QFETCH(glm::dvec3, origin);
    QFETCH(glm::dvec3, direction);
    for (const RunAxis axis : {RunAxis::x, RunAxis::y, RunAxis::z}) {
        RunVolume volume = emptyVolume(*Grid::make({0.0, 0.0, 0.0}, 1.0, {10, 10, 10}, axis));
        (void)volume.fillBlock({0, 0}, {10, 10}, 0, 5 * unitsPerVoxel, wax);
        QVERIFY(!castRay(volume.snapshot(), origin, direction));
        QVERIFY(!castRay(volume.snapshot(), origin, direction, RayTarget::protectedOnly));
        QVERIFY(materialAlong(volume.snapshot(), origin, direction).empty());
    }
}

/// However few significant digits are left when it arrives at the grid.
void RayCastTest::aRayFromFarAwayArrives() {
    RunVolume volume = emptyVolume(cubeGrid({10, 10, 10}));
    (void)volume.fillBlock({0, 0}, {10, 10}, 0, 10 * unitsPerVoxel, wax);
    for (const double far : {1e9, 1e18, 1e200}) {
        const auto hit = castRay(volume.snapshot(), {far, 5.0, 5.0}, {-1.0, 0.0, 0.0});
        QVERIFY(hit);
        QCOMPARE(hit->property, wax);
    }
}

void RayCastTest::nothingIsHighestAroundNoPlace() {
    RunVolume volume = emptyVolume(cubeGrid({10, 10, 10}));
    (void)volume.fillBlock({0, 0}, {10, 10}, 0, 5 * unitsPerVoxel, wax);
    const VolumeSnapshot workpiece = volume.snapshot();
    QCOMPARE(highestWithin(workpiece, {5.0, 5.0}, 1e12), 5.0); // all of it
    QCOMPARE(highestWithin(workpiece, {5.0, std::nan("")}, 3.0), 0.0);
}

void RayCastTest::findsThePartBehindStock() {
    RunVolume volume = emptyVolume(cubeGrid({10, 10, 10}));
    (void)volume.fillBlock({0, 0}, {10, 10}, 0, 4 * unitsPerVoxel, part);
    (void)volume.fillBlock({0, 0}, {10, 10}, 4 * unitsPerVoxel, 8 * unitsPerVoxel, wax);
    const VolumeSnapshot workpiece = volume.snapshot();
    const glm::dvec3 origin(5.0, 5.0, 30.0), down(0.0, 0.0, -1.0);
    QCOMPARE(castRay(workpiece, origin, down)->distance, 22.0);
    const auto hit = castRay(workpiece, origin, down, RayTarget::protectedOnly);
    QCOMPARE(hit->distance, 26.0);
    QCOMPARE(hit->property, part);
}

void RayCastTest::highestIsWhatADenseGridShows() {
    QVERIFY(rc::check("the highest run end near a place", [] {
        Pile pile = anyPile();
        const Grid& grid = pile.grid;
        const glm::dvec2 low(grid.low()[grid.axisOfU()], grid.low()[grid.axisOfV()]);
        const glm::dvec2 place = low + glm::dvec2(*rc::gen::inRange(-300, 1500), *rc::gen::inRange(-300, 1500)) / 100.0;
        const double radius = *rc::gen::inRange(0, 500) / 100.0;
        // A column counts if any part of it is within the radius; where it just touches, rounding decides.
        constexpr double touching = 1e-9; // mm
        RunPosition least = 0, most = 0;
        for (LineIndex line; line.v < grid.lineCountV(); ++line.v)
            for (line.u = 0; line.u < grid.lineCountU(); ++line.u) {
                const glm::dvec2 off = glm::abs(grid.lineCentre(line) - place) - 0.5 * grid.edge();
                const double beyond = glm::length(glm::max(off, 0.0)) - radius;
                if (beyond > touching) continue;
                RunPosition end = 0;
                for (RunPosition unit = 0; unit < grid.lineEnd(); ++unit)
                    if (pile.dense.at(line, unit) != airProperty) end = unit + 1;
                most = std::max(most, end);
                if (beyond < -touching) least = std::max(least, end);
            }
        const double highest = highestWithin(pile.volume.snapshot(), place, radius);
        RC_ASSERT(highest >= grid.toMillimetres(least));
        RC_ASSERT(highest <= grid.toMillimetres(most));
    }));
}

/// Each point of the plane is in one patch of its property, or in none where there is air.
void RayCastTest::aSectionIsWhatThePlaneMeets() {
    QVERIFY(rc::check("a section shows what the dense grid holds", [] {
        Pile pile = anyPile();
        const Box box = pile.grid.box();
        const int axis = *rc::gen::inRange(0, 3);
        const double position = box.low[axis] + *rc::gen::inRange(1, 900) / 100.0 + 0.00137;
        const std::vector<SectionPatch> patches = sectionOf(pile.volume.snapshot(), axis, position);
        for (int i = 0; i < 40; ++i) {
            glm::dvec3 place = box.low + anyPlace(0, 1000) / 100.0 + glm::dvec3(0.00371, 0.00513, 0.00297);
            place[axis] = position;
            const glm::dvec2 across(place[(axis + 1) % 3], place[(axis + 2) % 3]);
            PropertyIndex seen = airProperty;
            int found = 0;
            for (const SectionPatch& patch : patches) {
                if (glm::any(glm::lessThan(across, patch.low)) || glm::any(glm::greaterThan(across, patch.high)))
                    continue;
                seen = patch.property;
                ++found;
            }
            RC_ASSERT(found <= 1);
            RC_ASSERT(seen == pile.at(place));
        }
        RC_ASSERT(sectionOf(pile.volume.snapshot(), axis, box.high[axis] + 0.1).empty());
        RC_ASSERT(sectionOf(pile.volume.snapshot(), axis, box.low[axis] - 0.1).empty());
    }));
}

BURIN_TEST(RayCastTest, NoApplication)

} // namespace burin::tst_ray_cast

#include "tst_ray_cast.moc"

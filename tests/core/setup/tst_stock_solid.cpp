// SPDX-FileCopyrightText: 2026 The Burin authors
// SPDX-License-Identifier: Apache-2.0
// Fixtures against the real form of the stock.
#include "core/base/units.h"
#include "core/setup/fixture_fit.h"
#include "core/setup/fixture_library.h"
#include "core/setup/fixture_placement.h"
#include "core/setup/fixture_solid.h"
#include "core/setup/stock_shape.h"
#include "tests/core/setup/stock_bodies.h"
#include "tests/core/volume/volumes.h"
#include "tests/test_program.h"

#include <QtTest>

#include <cmath>
#include <random>

namespace burin::tst_stock_solid {

namespace {

constexpr double radius = 20.0;

bool near(double one, double other, double within = 1e-6) {
    return std::abs(one - other) <= within;
}

StockSolid solidOf(const Model& model, const Setup& setup) {
    Progress progress;
    return *StockSolid::of(model, setup, progress);
}

StockSolid barOf(const CylinderShape& cylinder) {
    Setup setup;
    setup.form = StockForm::cylinder;
    setup.cylinder = cylinder;
    setup.stock = boxAround(cylinder);
    return solidOf({}, setup);
}

/// Standing, 30 mm high, about the Z axis.
StockSolid standingBar() {
    return barOf({glm::dvec3(0.0), {0.0, 0.0, 1.0}, radius, 30.0});
}

/// A foot 20 mm wide and 15 mm high below a plate 60 mm wide, along X; 40 mm long along Y.
const Box foot{{-10.0, -20.0, 0.0}, {10.0, 20.0, 15.0}}, plate{{-30.0, -20.0, 15.0}, {30.0, 20.0, 25.0}};
const Box aroundBoth{{-30.0, -20.0, 0.0}, {30.0, 20.0, 25.0}};

StockSolid footedSolids() {
    Model model = test::modelOf({test::bodyOf("foot", test::boxMesh(foot.low, foot.high)),
                                 test::bodyOf("part", test::boxMesh({-1, -1, 1}, {1, 1, 2})),
                                 test::bodyOf("plate", test::boxMesh(plate.low, plate.high))});
    Setup setup;
    setup.form = StockForm::solids;
    setup.roles = {BodyRole::stock, BodyRole::part, BodyRole::stock};
    setup.stock = aroundBoth;
    return solidOf(model, setup);
}

StockSolid footedVolume(double voxel) {
    const glm::ivec3 count = glm::ivec3(glm::round(aroundBoth.size() / voxel));
    PropertyList list;
    const PropertyIndex wax = *list.add(test::materialOf("wax", 0.1, 0.9));
    RunVolume volume = *RunVolume::make(*Grid::make(aroundBoth.low, voxel, count), list);
    for (const Box& box : {foot, plate}) BoxStock(box).fill(volume, wax);
    Progress progress;
    Setup setup;
    setup.form = StockForm::file;
    setup.voxel = voxel;
    setup.volume = *StockVolume::of(volume.snapshot(), "footed.vol", progress);
    setup.stock = aroundBoth;
    return solidOf({}, setup);
}

FixtureDesign placedOn(FixtureKind kind, const StockSolid& stock, const glm::dvec3& click) {
    return placedAt(standardFixture(kind), {}, siteOf(stock, {}), click);
}

/// A base plate of 40 x 40 x 20 mm with the middle of its top at a point.
FixtureDesign blockAt(const glm::dvec3& place) {
    FixtureDesign block = standardFixture(FixtureKind::plate);
    setValue(block, "length", 40.0);
    setValue(block, "width", 40.0);
    block.place = place;
    return block;
}

} // namespace

class TestStockSolid : public QObject {
    Q_OBJECT
private slots:
    /// A vise closes on the diameter of a standing bar, and touches it.
    void aViseClosesOnABar() {
        const StockSolid bar = standingBar();
        for (const glm::dvec3& click : {glm::dvec3(19, 0, 10), {-19, 1, 10}, {0, 19, 10}, {1, -19, 10}}) {
            const FixtureDesign vise = placedOn(FixtureKind::vise, bar, click);
            QVERIFY(near(valueOf(vise, "opening"), 2.0 * radius));
            QCOMPARE(depthIn(vise, bar), 0.0);
            QCOMPARE(gapTo(vise, bar), std::optional(0.0));
            FixtureDesign wider = vise, closer = vise;
            setValue(wider, "opening", 2.0 * radius + 3.0);
            QVERIFY(near(*gapTo(wider, bar), 3.0));
            setValue(closer, "opening", 2.0 * radius - 3.0);
            QVERIFY(near(depthIn(closer, bar), 1.5, 2.0 * stockChord));
        }
    }

    /// Jaws that end below the axis of a lying bar close on the chord at their top.
    void aViseClosesOnAChordOfALyingBar() {
        const StockSolid bar = barOf({{-40.0, 0.0, 0.0}, {1.0, 0.0, 0.0}, radius, 80.0});
        const FixtureDesign vise = placedOn(FixtureKind::vise, bar, {0.0, 19.0, 0.0});
        QVERIFY(near(vise.place.z, -radius));
        const double grip = valueOf(vise, "grip"); // 8 mm
        QVERIFY(near(valueOf(vise, "opening"), 2.0 * std::sqrt(radius * radius - (radius - grip) * (radius - grip)),
                     4.0 * stockChord));
        QCOMPARE(depthIn(vise, bar), 0.0);
        FixtureDesign deep = standardFixture(FixtureKind::vise);
        setValue(deep, "grip", 25.0);
        deep = placedAt(deep, {"grip"}, siteOf(bar, {}), {0.0, 19.0, 0.0});
        QVERIFY(near(valueOf(deep, "opening"), 2.0 * radius));
    }

    /// Beside the middle, the nose goes further in: to the circle within its width.
    void aToeClampTouchesTheCircle() {
        const StockSolid bar = standingBar();
        for (const double beside : {0.0, 6.0, 15.0}) {
            const FixtureDesign toe = placedOn(FixtureKind::toeClamp, bar, {19.5, beside, 10.0});
            const double nose = 0.5 * valueOf(toe, "nose-width"), least = std::max(0.0, beside - nose);
            QVERIFY2(near(toe.place.x, std::sqrt(radius * radius - least * least), 4.0 * stockChord),
                     qPrintable(QString::number(toe.place.x, 'g', 12)));
            QCOMPARE(depthIn(toe, bar), 0.0);
            QCOMPARE(gapTo(toe, bar), std::optional(0.0));
            FixtureDesign away = toe;
            away.place.x += 1.25;
            QVERIFY(near(*gapTo(away, bar), 1.25));
        }
    }

    void aStepClampStandsOnWhatIsThere() {
        const StockSolid lying = barOf({{-40.0, 0.0, 0.0}, {1.0, 0.0, 0.0}, radius, 80.0});
        const FixtureDesign clamp = placedOn(FixtureKind::stepClamp, lying, {35.0, 0.0, 20.0});
        QVERIFY(near(clamp.place.z, radius) && near(valueOf(clamp, "height"), 2.0 * radius));
        FixtureDesign raised = clamp;
        raised.place.z += 2.0;
        QVERIFY(near(*gapTo(raised, lying), 2.0));
        // In a corner of the box around a standing bar there is nothing.
        FixtureDesign corner = standardFixture(FixtureKind::stepClamp);
        setValue(corner, "width", 5.0);
        setValue(corner, "slot", 3.0);
        setValue(corner, "stud", 2.0);
        corner.place = {18.5, 18.5, 30.0};
        setValue(corner, "contact", 2.0);
        QVERIFY(std::isinf(*gapTo(corner, standingBar())));
        QVERIFY(!gapTo(standardFixture(FixtureKind::hexScrew), standingBar()));
        // A screw beside the bar, but within the box around it, stands on the table.
        const FixtureDesign screw = placedOn(FixtureKind::socketScrew, standingBar(), {19.0, 19.0, 30.0});
        QCOMPARE(screw.place, glm::dvec3(19.0, 19.0, 0.0));
        QVERIFY(near(placedOn(FixtureKind::socketScrew, standingBar(), {3.0, 4.0, 30.0}).place.z, 30.0));
    }

    /// The corners of the box around a bar are free; what enters the bar is told.
    void depthsInABarAreThoseOfCircles() {
        const StockSolid bar = standingBar();
        const double corner = radius / std::sqrt(2.0); // of the box that fits beside the bar
        FixtureDesign block = blockAt({corner + 20.0, corner + 20.0, 25.0});
        QVERIFY(depthIn(block, Box(bar.box())) > 5.0);
        QCOMPARE(depthIn(block, bar), 0.0);
        block.place = {radius + 20.0 - 1.5, 0.0, 25.0};
        QVERIFY(near(depthIn(block, bar), 1.5, 2.0 * stockChord));
        FixtureDesign screw = standardFixture(FixtureKind::socketScrew); // washer of 8 mm radius
        screw.place = {21.0, 14.0, 10.0}; // the washer is too thin to be entered deeper than its head of 6.5 mm radius
        QVERIFY(near(depthIn(screw, bar), radius + 6.5 - std::hypot(21.0, 14.0), 2.0 * stockChord));
        screw.place = {24.0, 14.0, 10.0};
        QVERIFY(near(depthIn(screw, bar), radius + 8.0 - std::hypot(24.0, 14.0), 2.0 * stockChord));
        // A solid in the middle of the bar, which its surface doesn't enter.
        FixtureDesign inside = standardFixture(FixtureKind::plate);
        setValue(inside, "length", 4.0);
        setValue(inside, "width", 4.0);
        setValue(inside, "thickness", 4.0);
        inside.place = {0.0, 0.0, 17.0};
        QVERIFY(near(depthIn(inside, bar), 2.0));
    }

    /// Against a dense grid of the bar's points.
    void depthsInABarAreThoseOfItsPoints() {
        const StockSolid bar = standingBar();
        constexpr double step = 0.5;
        std::mt19937 random(34);
        std::uniform_real_distribution<double> place(14.0, 45.0), height(-5.0, 45.0), turn(-pi, pi), side(-pi, pi);
        int entered = 0;
        for (int i = 0; i < 30; ++i) {
            const double direction = side(random), away = place(random);
            FixtureDesign block = blockAt({away * std::cos(direction), away * std::sin(direction), height(random)});
            block.turn = turn(random);
            const Placement back = inverse(placementOf(block));
            const Box solid = solidsOf(block).boxes.front();
            double deepest = 0.0;
            for (double x = -radius; x <= radius; x += step)
                for (double y = -radius; y <= radius; y += step) {
                    if (x * x + y * y > radius * radius) continue;
                    for (double z = 0.0; z <= 30.0; z += step) {
                        const glm::dvec3 own = back.point({x, y, z}), in = glm::min(own - solid.low, solid.high - own);
                        deepest = std::max(deepest, std::min({in.x, in.y, in.z}));
                    }
                }
            const double told = depthIn(block, bar);
            entered += deepest > 0.0 ? 1 : 0;
            QVERIFY2(told >= deepest - 2.0 * stockChord && told <= std::max(deepest, 0.0) + step * std::sqrt(3.0),
                     qPrintable(QString("%1 of %2").arg(told).arg(deepest)));
        }
        QVERIFY(entered > 8 && entered < 30);
    }

    /// The jaws close on the foot, not on the plate above it, of solids and of a stock from a file.
    void aViseClosesOnTheFoot() {
        for (const StockSolid& stock : {footedSolids(), footedVolume(1.0), footedVolume(0.5)}) {
            QVERIFY(!stock.isBox());
            FixtureDesign vise = placedOn(FixtureKind::vise, stock, {29.0, 0.0, 20.0});
            QVERIFY2(near(valueOf(vise, "opening"), 20.0), qPrintable(QString::number(valueOf(vise, "opening"))));
            QCOMPARE(depthIn(vise, stock), 0.0);
            QCOMPARE(gapTo(vise, stock), std::optional(0.0));
            QVERIFY(depthIn(vise, aroundBoth) > 0.0); // the box would refuse it
            setValue(vise, "grip", 15.0);
            QCOMPARE(depthIn(vise, stock), 0.0); // the jaws touch the plate
            setValue(vise, "grip", 17.0);
            QVERIFY(near(depthIn(vise, stock), 2.0));
            FixtureDesign high = standardFixture(FixtureKind::vise);
            setValue(high, "grip", 20.0);
            high = placedAt(high, {"grip"}, siteOf(stock, {}), {29.0, 0.0, 20.0});
            QVERIFY(near(valueOf(high, "opening"), 60.0));
        }
        const FixtureDesign boxed = placedOn(FixtureKind::vise, aroundBoth, {29.0, 0.0, 20.0});
        QCOMPARE(valueOf(boxed, "opening"), 60.0);
    }

    /// A box 3 mm in the foot, a cylinder of 2 mm in the plate's side by 1.5 mm; a vise that is open too far. What is
    /// switched off, a keep-out volume and what touches are not told.
    void whatDoesNotFitIsTold() {
        const Model model = test::modelOf({test::bodyOf("foot", test::boxMesh(foot.low, foot.high)),
                                           test::bodyOf("plate", test::boxMesh(plate.low, plate.high))});
        Setup setup;
        setup.form = StockForm::solids;
        setup.roles = {BodyRole::stock, BodyRole::stock};
        setup.stock = aroundBoth;
        const StockSolid stock = footedSolids();
        const Box inFoot{{7.0, -5.0, 1.0}, {17.0, 5.0, 9.0}}, beside{{10.0, -5.0, 0.0}, {20.0, 5.0, 15.0}};
        const CylinderShape pin{{31.5 - 1.0, 0.0, 30.0}, {0.0, 0.0, -1.0}, 2.0, 12.0};
        FixtureDesign vise = placedOn(FixtureKind::vise, stock, {29.0, 0.0, 20.0});
        setValue(vise, "opening", 22.5);
        const std::vector<Obstacle> around{
            {"in the foot", inFoot},
            {"touches", beside},
            {"pin", pin},
            {"off", inFoot, 0.0, false},
            {"keep-out", inFoot, 0.0, true, ObstacleKind::keepOut},
            {"vise", meshOf(vise), 0.0, true, ObstacleKind::fixture, vise},
            {"from a file", test::boxMesh(inFoot.low, inFoot.high)},
        };
        Progress progress;
        const Result<std::vector<BadFit>> bad = badFits(model, setup, around, progress);
        QVERIFY(bad);
        QCOMPARE(bad->size(), std::size_t{3});
        QCOMPARE((*bad)[0].name, std::string("in the foot"));
        QVERIFY(near((*bad)[0].fit.depth, 3.0) && (*bad)[0].fit.gap == 0.0);
        QCOMPARE((*bad)[1].name, std::string("pin"));
        QVERIFY(near((*bad)[1].fit.depth, 1.5));
        QCOMPARE((*bad)[2].name, std::string("vise"));
        QVERIFY(near((*bad)[2].fit.gap, 2.5) && (*bad)[2].fit.depth == 0.0);
        progress.cancel();
        QCOMPARE(badFits(model, setup, around, progress).error().code, ErrorCode::cancelled);
    }

    void aRayMeetsTheStockItself() {
        const StockSolid bar = standingBar();
        const auto side = bar.hit({100.0, 12.0, 5.0}, {-2.0, 0.0, 0.0});
        QVERIFY(side && near(side->x, 16.0, 2.0 * stockChord) && near(side->y, 12.0) && near(side->z, 5.0));
        QVERIFY(!bar.hit({19.0, 19.0, 100.0}, {0.0, 0.0, -1.0})); // in the corner of its box
        const auto top = StockSolid(bar.box()).hit({19.0, 19.0, 100.0}, {0.0, 0.0, -1.0});
        QVERIFY(top && near(top->z, 30.0));
        const auto below = footedVolume(1.0).hit({25.0, 3.0, -50.0}, {0.0, 0.0, 1.0});
        QVERIFY(below && near(below->z, 15.0));
        QVERIFY(!StockSolid().hit({0.0, 0.0, 100.0}, {0.0, 0.0, -1.0}));
    }
};

BURIN_TEST(TestStockSolid, NoApplication)

} // namespace burin::tst_stock_solid

#include "tst_stock_solid.moc"

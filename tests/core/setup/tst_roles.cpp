// SPDX-FileCopyrightText: 2026 The Burin authors
// SPDX-License-Identifier: Apache-2.0
#include "core/base/units.h"
#include "core/setup/cylinder_stock.h"
#include "core/setup/setup.h"
#include "tests/core/setup/stock_bodies.h"
#include "tests/test_program.h"

#include <QCoreApplication>
#include <QtTest>

#include <random>

namespace burin::tst_roles {

using namespace burin::test;

namespace {

constexpr double blockSide = 20.0;

/// A block in the middle, and four bodies in it or next to it.
Model workholding() {
    return modelOf(
        {bodyOf("Block", boxMesh({0, 0, 0}, {20, 20, 10})), bodyOf("Bush", boxMesh({24, 8, 0}, {28, 12, 10})),
         bodyOf("Thread", boxMesh({-6, 8, 0}, {-2, 12, 10})), bodyOf("Jaw", boxMesh({-40, 0, 0}, {-30, 20, 10})),
         bodyOf("Sketch", boxMesh({60, 60, 60}, {70, 70, 70}))});
}

Setup workheld() {
    Setup setup = setupOf(0.5, 10.0);
    setup.roles = {BodyRole::part, BodyRole::insert, BodyRole::protectedInsert, BodyRole::fixture, BodyRole::ignored};
    setup.bodyMaterials = {"", "brass", "brass", "", ""};
    return setup;
}

/// Whether a point is in a cylinder, by definition; empty if it is so near to its surface that rounding decides.
std::optional<bool> liesIn(const CylinderShape& cylinder, const glm::dvec3& point, double skin) {
    const glm::dvec3 way = point - cylinder.base;
    const double along = glm::dot(way, cylinder.axis);
    const double across = glm::length(way - along * cylinder.axis);
    const double deepest = std::min({along, cylinder.height - along, cylinder.radius - across});
    if (std::abs(deepest) < skin) return std::nullopt;
    return deepest > 0.0;
}

} // namespace

class TestRoles : public QObject {
    Q_OBJECT

private slots:
    void rolesHaveStableNames() {
        for (const BodyRole role : bodyRoles) QCOMPARE(bodyRoleFromId(idOf(role)), std::optional(role));
        QVERIFY(!bodyRoleFromId("Part"));
        for (const StockForm form : stockForms) QCOMPARE(stockFormFromId(idOf(form)), std::optional(form));
        QVERIFY(!stockFormFromId("sphere"));
    }

    /// The stock encloses part and inserts; fixtures are not embedded.
    void eachRoleIsWhatItSays() {
        const Model model = workholding();
        const Result<Setup> setup = placeStock(model, workheld());
        QVERIFY(setup);
        QVERIFY(setup->stock.low == glm::dvec3(-16, -10, -10));
        QVERIFY(setup->stock.high == glm::dvec3(38, 30, 20));
        const auto made = embedded(model, workheld());
        QVERIFY(made);
        const RunVolume& workpiece = made->workpiece;
        QCOMPARE(materialAt(workpiece, {10, 10, 5}), std::string("metal (Block)"));
        QCOMPARE(materialAt(workpiece, {26, 10, 5}), std::string("brass"));
        QCOMPARE(materialAt(workpiece, {-4, 10, 5}), std::string("brass (Thread)"));
        QCOMPARE(materialAt(workpiece, {15, 10, 15}), std::string("metal"));
        const PropertyList& list = workpiece.properties();
        QVERIFY(list.isProtected(made->bodyProperties[0]));
        QVERIFY(!list.isProtected(made->bodyProperties[1]));
        QVERIFY(list.isProtected(made->bodyProperties[2]));
        QCOMPARE(made->bodyProperties[3], airProperty);
        QCOMPARE(made->bodyProperties[4], airProperty);
        QCOMPARE(volumeOf(workpiece, "brass"), 4.0 * 4.0 * 10.0);
        QCOMPARE(made->partVolume, 20.0 * 20.0 * 10.0 + 4.0 * 4.0 * 10.0);
        QCOMPARE(made->stockVolume, 54.0 * 40.0 * 30.0 - made->partVolume);
    }

    void thePartIsWhatNothingMayCut() {
        const auto model = std::make_shared<const Model>(workholding());
        const auto part = protectedPart(model, workheld());
        QCOMPARE(part->bodies.size(), std::size_t{2});
        QCOMPARE(part->bodies[1].name, std::string("Thread"));
        QVERIFY((part->brepSolids == std::vector<std::uint32_t>{0, 2}));
        const auto fixtures = bodyFixtures(*model, workheld());
        QVERIFY(fixtures && fixtures->size() == 1);
        QCOMPARE(fixtures->front().name, std::string("Jaw"));
        QVERIFY(boundsOf(fixtures->front()).low == glm::dvec3(-40, 0, 0));
        QVERIFY(protectedPart(model, setupOf(0.5, 1.0)) == model);
    }

    void rolesThatLeaveNoPartAreRefused() {
        Setup setup = workheld();
        setup.roles[0] = setup.roles[2] = BodyRole::insert;
        const auto refused = placeStock(workholding(), setup);
        QVERIFY(!refused);
        QCOMPARE(refused.error().code, ErrorCode::stockInvalid);
        QCOMPARE(refused.error().subject, std::string("part"));
        setup.freeCarving = true;
        QVERIFY(placeStock(workholding(), setup));
    }

    /// Figure 13b of the paper: a block, a tool and no part that limits it.
    void freeCarvingNeedsNoModel() {
        Setup setup = setupOf(0.5, 5.0);
        setup.freeCarving = true;
        const auto nowhere = placeStock(Model{}, setup);
        QVERIFY(!nowhere && nowhere.error().subject == "form");
        setup.stated = true;
        setup.stock = {glm::dvec3(0.0), {30, 20, 10}};
        const auto made = embedded(Model{}, setup);
        QVERIFY(made);
        QCOMPARE(made->partVolume, 0.0);
        QCOMPARE(made->stockVolume, 30.0 * 20.0 * 10.0);
        setup.stock.high.z = 0.0;
        const auto flat = placeStock(Model{}, setup);
        QVERIFY(!flat && flat.error().code == ErrorCode::stockInvalid);
    }

    void insertsThatOverlapAreRefused() {
        Model model = workholding();
        model.bodies.push_back(bodyOf("Second bush", boxMesh({27, 8, 0}, {31, 12, 10})));
        Setup setup = workheld();
        setup.roles.push_back(BodyRole::insert);
        setup.bodyMaterials.push_back("beech");
        const auto refused = embedded(model, setup);
        QVERIFY(!refused);
        QCOMPARE(refused.error().code, ErrorCode::argumentInvalid);
        QCOMPARE(refused.error().place, std::string("Bush, Second bush"));
        QVERIFY(refused.error().detail.find("40.00 mm^3") != std::string::npos);
        model.bodies.back() = bodyOf("Second bush", boxMesh({28, 8, 0}, {32, 12, 10})); // it touches
        QVERIFY(embedded(model, setup));
    }

    void whatIsMilledNeedsAForce() {
        Setup setup = workheld();
        setup.bodyMaterials[1] = "unmeasured";
        const auto refused = embedded(workholding(), setup);
        QVERIFY(!refused && refused.error().code == ErrorCode::resourceInvalid);
        QCOMPARE(refused.error().subject, std::string("unmeasured"));
        setup.bodyMaterials = {"unmeasured", "brass", "unmeasured", "", ""}; // protected materials are never felt
        QVERIFY(embedded(workholding(), setup));
    }

    void anInsertThatNoScanlineMeetsIsRefused() {
        Model model = workholding();
        model.bodies[1] = bodyOf("Hair", boxMesh({24.05, 8.05, 0}, {24.15, 8.15, 10}));
        const auto refused = embedded(model, workheld());
        QVERIFY(!refused && refused.error().code == ErrorCode::argumentInvalid);
        QCOMPARE(refused.error().subject, std::string("Hair"));
    }

    void cylindersAreFilledExactly_data() {
        QTest::addColumn<glm::dvec3>("axis");
        QTest::addColumn<int>("runs");
        for (const int runs : {0, 2}) {
            QTest::addRow("x, runs along %d", runs) << glm::dvec3(1, 0, 0) << runs;
            QTest::addRow("y, runs along %d", runs) << glm::dvec3(0, 1, 0) << runs;
            QTest::addRow("z, runs along %d", runs) << glm::dvec3(0, 0, 1) << runs;
            QTest::addRow("down, runs along %d", runs) << glm::dvec3(0, 0, -1) << runs;
            QTest::addRow("aslant, runs along %d", runs) << glm::normalize(glm::dvec3(1, -2, 3)) << runs;
        }
    }
    void cylindersAreFilledExactly() {
        QFETCH(glm::dvec3, axis);
        QFETCH(int, runs);
        const CylinderShape cylinder{{1.0, 2.0, 3.0}, axis, 9.0, 25.0};
        const Box box = boxAround(cylinder);
        const Grid grid =
            *Grid::make(box.low - 1.0, 0.25, glm::ivec3(glm::ceil(box.size() / 0.25)) + 8, static_cast<RunAxis>(runs));
        PropertyList list;
        const PropertyIndex metal = *list.add(materialOf("metal", 1.0, 1.0));
        RunVolume volume = *RunVolume::make(grid, list);
        QVERIFY(fillCylinder(volume, cylinder, metal));
        const double exact = pi * 81.0 * 25.0;
        // 36 scanlines per radius: whole lines along the axis limit the accuracy of the circle to that.
        QVERIFY2(std::abs(volumeOf(volume, "metal") - exact) < 0.004 * exact,
                 qPrintable(QString::number(volumeOf(volume, "metal") / exact)));
        std::mt19937 random(7);
        std::uniform_real_distribution<double> share(0.0, 1.0);
        int judged = 0;
        for (int i = 0; i < 20'000; ++i) {
            // On a scanline's centre, where the runs' ends are exact.
            glm::dvec3 place = grid.low() + glm::dvec3(share(random), share(random), share(random)) * box.size();
            for (const int across : {grid.axisOfU(), grid.axisOfV()})
                place[across] =
                    grid.low()[across] + (std::floor((place[across] - grid.low()[across]) / 0.25) + 0.5) * 0.25;
            const auto inside = liesIn(cylinder, place, 0.01);
            if (!inside) continue;
            QCOMPARE(!materialAt(volume, place).empty(), *inside);
            ++judged;
        }
        QVERIFY(judged > 18'000);
    }

    /// A round bar around a square part extends to its corners and no farther.
    void aCylinderIsLaidAroundThePart() {
        const Model model = modelOf({bodyOf("Block", boxMesh({0, 0, 0}, {blockSide, blockSide, 10}))});
        Setup setup = setupOf(0.5, 2.0);
        setup.form = StockForm::cylinder;
        const Result<Setup> placed = placeStock(model, setup);
        QVERIFY(placed);
        QVERIFY(std::abs(placed->cylinder.radius - (std::sqrt(0.5) * blockSide + 2.0)) < 1e-9);
        QVERIFY(glm::distance(placed->cylinder.base, glm::dvec3(10, 10, -2)) < 1e-9);
        QCOMPARE(placed->cylinder.height, 14.0);
        const auto made = embedded(model, setup);
        QVERIFY(made);
        const double bar = pi * placed->cylinder.radius * placed->cylinder.radius * 14.0;
        QVERIFY(std::abs(made->stockVolume + made->partVolume - bar) < 0.002 * bar);
    }

    void aPartOutsideARoundStockIsRefused() {
        const Model model = modelOf({bodyOf("Block", boxMesh({0, 0, 0}, {blockSide, blockSide, 10}))});
        Setup setup = setupOf(0.5, 2.0);
        setup.form = StockForm::cylinder;
        setup.stated = true;
        setup.cylinder = {{10, 10, -1}, {0, 0, 1}, 13.0, 12.0}; // its box contains the part, but the corners do not fit
        const auto refused = embedded(model, setup);
        QVERIFY(!refused);
        QCOMPARE(refused.error().code, ErrorCode::partOutsideStock);
        QCOMPARE(refused.error().subject, std::string("Block"));
    }

    void stockMayBeSolids() {
        const Model model = modelOf(
            {bodyOf("Block", boxMesh({5, 5, 5}, {15, 15, 10})), bodyOf("Casting", sphereMesh({10, 10, 7}, 14.0, 120))});
        Setup setup = setupOf(0.25, 2.0);
        setup.form = StockForm::solids;
        const auto without = placeStock(model, setup);
        QVERIFY(!without && without.error().subject == "form");
        setup.roles = {BodyRole::part, BodyRole::stock};
        const auto made = embedded(model, setup);
        QVERIFY(made);
        const double ball = 4.0 / 3.0 * pi * 14.0 * 14.0 * 14.0;
        QCOMPARE(made->partVolume, 500.0);
        QVERIFY(std::abs(made->stockVolume + 500.0 - ball) < 0.003 * ball);
        QVERIFY(materialAt(made->workpiece, {10, 10, 20}) == "metal");
        QVERIFY(materialAt(made->workpiece, {0, 0, 0}).empty());
    }
};

BURIN_TEST(TestRoles, QCoreApplication)

} // namespace burin::tst_roles

#include "tst_roles.moc"

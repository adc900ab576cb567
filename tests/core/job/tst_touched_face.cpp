// SPDX-FileCopyrightText: 2026 The Burin authors
// SPDX-License-Identifier: Apache-2.0
#include "core/job/touched_stock.h"

#include "core/haptics/boundary/proxy.h"
#include "core/setup/obstacle.h"
#include "core/tool/tool_library.h"
#include "core/volume/voxelisation/voxelisation.h"
#include "tests/core/setup/stock_bodies.h"
#include "tests/test_program.h"

#include <QtTest>

namespace burin::tst_touched_face {

namespace {

/// A hand that presses a tool by 1 mm against an obstacle, in a direction.
Sample pressed(const glm::dvec3& tip, const glm::dvec3& towards) {
    Sample sample;
    sample.proxy.tip = tip;
    sample.proxy.axis = {0.0, 0.0, 1.0};
    sample.stylusTip = tip + glm::normalize(towards);
    return sample;
}

TouchableStock stockOf(const Setup& setup, const Model& model = {}) {
    Progress progress;
    return *TouchableStock::of(model, setup, progress);
}

/// A stock of one body.
struct StockBody {
    Model model;
    Setup setup;
};
StockBody stockBody(const TriangleMesh& mesh, double chord) {
    StockBody stock{test::modelOf({test::bodyOf("casting", mesh)}), {}};
    stock.model.meshChord = chord;
    stock.setup.form = StockForm::solids;
    stock.setup.roles = {BodyRole::stock};
    stock.setup.stock = boundingBox(mesh);
    return stock;
}

/// The voxels whose centre lines are in a shape.
Setup voxelsOf(const TriangleMesh& mesh, double voxel) {
    const Box box = boundingBox(mesh);
    PropertyList list;
    const PropertyIndex wax = *list.add(test::materialOf("wax", 0.1, 0.9));
    RunVolume volume = *RunVolume::make(
        *Grid::make(glm::floor(box.low), voxel, glm::ivec3(glm::ceil((box.size() + 2.0) / voxel))), list);
    Progress progress;
    const std::vector<BodyMesh> bodies{{&mesh, wax}};
    (void)voxelise(bodies, volume, progress);
    Setup setup;
    setup.form = StockForm::file;
    setup.voxel = voxel;
    setup.volume = *StockVolume::of(volume.snapshot(), "casting.vol", progress);
    setup.stock = volume.grid().box();
    return setup;
}

} // namespace

/// As with an edge finder: the face is one radius from the tool's axis, or at its tip.
class TestTouchedFace : public QObject {
    Q_OBJECT
private slots:
    void aSideIsARadiusAway() {
        const Tool tool = loadTool("ball-6").value(); // 6 mm in diameter
        const glm::dvec3 tip(10.0, 20.0, 30.0);
        const TouchedFace right = touchedFace(pressed(tip, {1.0, 0.0, 0.0}), tool, 0.0);
        QCOMPARE(right.outcome, TouchedFace::Outcome::found);
        QCOMPARE(right.axis, 0);
        QCOMPARE(right.place, glm::dvec3(13.0, 20.0, 33.0)); // beside the middle of the ball
        QVERIFY(!right.high);
        const TouchedFace front = touchedFace(pressed(tip, {0.0, -1.0, 0.0}), tool, 0.5); // with an allowance
        QCOMPARE(front.axis, 1);
        QCOMPARE(front.place, glm::dvec3(10.0, 16.5, 33.0));
        QVERIFY(front.high);
    }

    void theTipTouchesBelow() {
        const Tool tool = loadTool("ball-6").value();
        const TouchedFace floor = touchedFace(pressed({1.0, 2.0, 3.0}, {0.0, 0.0, -1.0}), tool, 0.25);
        QCOMPARE(floor.outcome, TouchedFace::Outcome::found);
        QCOMPARE(floor.axis, 2);
        QCOMPARE(floor.place, glm::dvec3(1.0, 2.0, 2.75));
    }

    void whatTellsNothingIsNoFace() {
        const Tool tool = loadTool("ball-6").value();
        const glm::dvec3 tip(1.0, 2.0, 3.0);
        Sample free = pressed(tip, {1.0, 0.0, 0.0});
        free.stylusTip = tip + glm::dvec3(0.001, 0.0, 0.0);
        QCOMPARE(touchedFace(free, tool, 0.0).outcome, TouchedFace::Outcome::nothing);
        QCOMPARE(touchedFace(pressed(tip, {1.0, 0.3, 0.0}), tool, 0.0).outcome, TouchedFace::Outcome::aslant);
        QCOMPARE(touchedFace(pressed(tip, {0.0, 0.0, 1.0}), tool, 0.0).outcome, TouchedFace::Outcome::aslant);
        Sample leaning = pressed(tip, {1.0, 0.0, 0.0});
        leaning.proxy.axis = glm::normalize(glm::dvec3(0.2, 0.0, 1.0));
        QCOMPARE(touchedFace(leaning, tool, 0.0).outcome, TouchedFace::Outcome::aslant);
    }

    /// A block touched on five sides with a ball, a flat and a bull-nosed cutter: each side is found within the contact
    /// gap of the proxy, the corner exactly.
    void theSidesOfABlockAreFound_data() {
        QTest::addColumn<QString>("tool");
        for (const char* tool : {"ball-6", "flat-8", "bull-10-r2"}) QTest::newRow(tool) << QString(tool);
    }
    void theSidesOfABlockAreFound() {
        QFETCH(QString, tool);
        const Tool cutter = loadTool(tool.toStdString()).value();
        Setup setup;
        setup.stock = {{-20.3, -10.0, 0.0}, {20.0, 10.7, 30.1}};
        const TouchableStock stock = stockOf(setup);
        const glm::dvec3 x(1.0, 0.0, 0.0), y(0.0, 1.0, 0.0), z(0.0, 0.0, 1.0);
        const struct {
            glm::dvec3 tip, towards;
            int axis;
            double side;
        } touches[] = {{{-50.0, 1.0, 20.0}, x, 0, -20.3},
                       {{45.0, 1.0, 20.0}, -x, 0, 20.0},
                       {{2.0, -300.0, 20.0}, y, 1, -10.0},
                       {{2.0, 60.0, 20.0}, -y, 1, 10.7},
                       {{2.0, 3.0, 90.0}, -z, 2, 30.1}};
        for (const auto& touch : touches) {
            const Result<TouchedFace> face = touchStock(stock, cutter, touch.tip, touch.towards);
            QVERIFY(face);
            QCOMPARE(face->outcome, TouchedFace::Outcome::found);
            QCOMPARE(face->axis, touch.axis);
            QVERIFY(std::abs(face->place[touch.axis] - touch.side) <= Proxy::contactGap);
            const std::optional<TouchedSide> side = stock.sideTouched(*face, cutter);
            QVERIFY(side && side->coordinate == touch.side && side->error == 0.0);
        }
    }

    /// A round bar is touched on its outermost line; beside that line no side is found. A ball whose middle is above
    /// the upper edge touches that edge aslant.
    void onlyAFaceThatLiesSquareIsASide() {
        const Tool ball = loadTool("ball-6").value();
        Setup bar;
        bar.form = StockForm::cylinder;
        bar.cylinder = {{5.0, 0.0, 0.0}, {0.0, 0.0, 1.0}, 20.0, 40.0};
        bar.stock = boxAround(bar.cylinder);
        const glm::dvec3 x(1.0, 0.0, 0.0);
        const TouchableStock round = stockOf(bar);
        const Result<TouchedFace> outermost = touchStock(round, ball, {-60.0, 0.0, 10.0}, x);
        QVERIFY(outermost && outermost->outcome == TouchedFace::Outcome::found);
        QVERIFY(std::abs(outermost->place.x + 15.0) <= Proxy::contactGap + cylinderChord);
        QCOMPARE(round.sideTouched(*outermost, ball)->coordinate, -15.0);
        QCOMPARE(touchStock(round, ball, {-60.0, 8.0, 10.0}, x)->outcome, TouchedFace::Outcome::aslant);
        Setup block;
        block.stock = {{0.0, 0.0, 0.0}, {40.0, 30.0, 20.0}};
        QCOMPARE(touchStock(stockOf(block), ball, {-30.0, 10.0, 18.5}, x)->outcome, TouchedFace::Outcome::aslant);
    }

    /// A tool that stands on the stock and is pushed against a fixture beside it has not touched the stock's side.
    void aFixtureIsNoSideOfTheStock() {
        Setup block;
        block.stock = {{0.0, 0.0, 0.0}, {40.0, 30.0, 20.0}};
        TouchedFace fixture;
        fixture.outcome = TouchedFace::Outcome::found;
        fixture.high = true;
        fixture.place = {12.0, 10.0, 20.0};
        const Tool ball = loadTool("ball-6").value();
        QVERIFY(!stockOf(block).sideTouched(fixture, ball));
        fixture.place.x = 40.001;
        QCOMPARE(stockOf(block).sideTouched(fixture, ball)->coordinate, 40.0);
        const StockBody body = stockBody(test::boxMesh({0.0, 0.0, 0.0}, {40.0, 30.0, 20.0}), 0.0);
        fixture.place.x = 12.0;
        fixture.tip = {9.0, 10.0, 20.0}; // it stands on the top
        QVERIFY(!stockOf(body.setup, body.model).sideTouched(fixture, ball));
    }

    /// Each refusal names its reason.
    void whatCannotBeTouchedIsRefused() {
        const Tool ball = loadTool("ball-6").value();
        Setup block;
        block.stock = {{0.0, 0.0, 0.0}, {40.0, 30.0, 20.0}};
        const glm::dvec3 x(1.0, 0.0, 0.0);
        QCOMPARE(touchStock(stockOf(block), ball, {10.0, 10.0, 10.0}, x).error().detail,
                 std::string("a tip from which the tool is clear of the stock"));
        QCOMPARE(touchStock(stockOf(block), ball, {-20.0, 10.0, 10.0}, -x).error().detail,
                 std::string("a tip from which the tool meets the stock in this direction"));
        block.form = StockForm::solids; // none of its bodies is the stock
        Progress progress;
        QCOMPARE(TouchableStock::of({}, block, progress).error().code, ErrorCode::notSupported);
    }

    /// A casting: its plane sides are found exactly, wherever they are, whichever way its triangles face; the outermost
    /// line of a bar within the chord of its mesh.
    void theSidesOfSolidsAreFound() {
        const glm::dvec3 low(-20.31, -10.07, 0.043), high(20.011, 10.7, 30.19), x(1.0, 0.0, 0.0), z(0.0, 0.0, 1.0);
        TriangleMesh inward = test::boxMesh(low, high);
        for (auto& triangle : inward.triangles) std::swap(triangle[0], triangle[1]);
        for (const char* name : {"ball-6", "flat-8", "bull-10-r2"})
            for (const TriangleMesh& mesh : {test::boxMesh(low, high), inward}) {
                const Tool tool = loadTool(name).value();
                const StockBody body = stockBody(mesh, 0.005);
                const TouchableStock stock = stockOf(body.setup, body.model);
                const auto touched = [&](const glm::dvec3& tip, const glm::dvec3& towards) {
                    const Result<TouchedFace> face = touchStock(stock, tool, tip, towards);
                    return face ? stock.sideTouched(*face, tool) : std::nullopt;
                };
                const auto side = touched({-60.0, 1.0, 20.0}, x), top = touched({3.0, 2.0, 70.0}, -z);
                QVERIFY(side && top && side->error == 0.0 && top->error == 0.0);
                QVERIFY(std::abs(side->coordinate - low.x) < 1e-9 && std::abs(top->coordinate - high.z) < 1e-9);
            }
        constexpr double radius = 20.0, chord = 0.005;
        const Tool ball = loadTool("ball-6").value();
        const Obstacle bar{"bar", CylinderShape{{5.0, 0.0, 0.0}, z, radius, 40.0}};
        const StockBody body = stockBody(meshOf(bar), chord);
        const TouchableStock stock = stockOf(body.setup, body.model);
        const Result<TouchedFace> face = touchStock(stock, ball, {-60.0, 0.0, 10.0}, x);
        const std::optional<TouchedSide> side = face ? stock.sideTouched(*face, ball) : std::nullopt;
        QVERIFY(side);
        QCOMPARE(side->error, chord);
        QVERIFY(std::abs(side->coordinate + 15.0) <= chord);
    }

    /// Of a stock that is known by its voxels, the true side is within the stated half of a voxel, wherever it lies in
    /// the grid and whatever the tool.
    void theSidesOfVoxelsAreFoundWithinTheirError() {
        const glm::dvec3 x(1.0, 0.0, 0.0), y(0.0, 1.0, 0.0), z(0.0, 0.0, 1.0);
        for (const double voxel : {0.5, 1.0})
            for (const double beyond : {0.0, 0.13, 0.49, 0.77}) {
                const glm::dvec3 low(-10.0 - beyond, -8.0 + beyond, 0.0), high(12.0 + beyond, 9.0, 14.0 + beyond);
                const TouchableStock stock = stockOf(voxelsOf(test::boxMesh(low, high), voxel));
                for (const char* name : {"ball-6", "flat-8"}) {
                    const Tool tool = loadTool(name).value();
                    const struct {
                        glm::dvec3 tip, towards;
                        int axis;
                        double side;
                    } touches[] = {{{-40.0, 1.2, 7.0}, x, 0, low.x},
                                   {{40.0, 1.2, 7.0}, -x, 0, high.x},
                                   {{2.3, -40.0, 7.0}, y, 1, low.y},
                                   {{2.3, 1.1, 40.0}, -z, 2, high.z}};
                    for (const auto& touch : touches) {
                        const Result<TouchedFace> face = touchStock(stock, tool, touch.tip, touch.towards);
                        QVERIFY(face);
                        const std::optional<TouchedSide> side = stock.sideTouched(*face, tool);
                        QVERIFY2(side && face->axis == touch.axis, name);
                        QCOMPARE(side->error, 0.5 * voxel);
                        QVERIFY2(std::abs(side->coordinate - touch.side) <= side->error + 1e-9,
                                 qPrintable(QString("%1: %2").arg(touch.side).arg(side->coordinate)));
                    }
                }
            }
    }
};

BURIN_TEST(TestTouchedFace, NoApplication)

} // namespace burin::tst_touched_face

#include "tst_touched_face.moc"

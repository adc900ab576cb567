// SPDX-FileCopyrightText: 2026 The Burin authors
// SPDX-License-Identifier: Apache-2.0
#include "core/job/touched_stock.h"

#include "core/haptics/boundary/proxy.h"
#include "core/tool/tool_library.h"
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
            const Result<TouchedFace> face = touchStock(setup, cutter, touch.tip, touch.towards);
            QVERIFY(face);
            QCOMPARE(face->outcome, TouchedFace::Outcome::found);
            QCOMPARE(face->axis, touch.axis);
            QVERIFY(std::abs(face->place[touch.axis] - touch.side) <= Proxy::contactGap);
            QCOMPARE(sideTouched(setup, *face), std::optional(touch.side));
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
        const Result<TouchedFace> outermost = touchStock(bar, ball, {-60.0, 0.0, 10.0}, x);
        QVERIFY(outermost && outermost->outcome == TouchedFace::Outcome::found);
        QVERIFY(std::abs(outermost->place.x + 15.0) <= Proxy::contactGap + cylinderChord);
        QCOMPARE(sideTouched(bar, *outermost), std::optional(-15.0));
        QCOMPARE(touchStock(bar, ball, {-60.0, 8.0, 10.0}, x)->outcome, TouchedFace::Outcome::aslant);
        Setup block;
        block.stock = {{0.0, 0.0, 0.0}, {40.0, 30.0, 20.0}};
        QCOMPARE(touchStock(block, ball, {-30.0, 10.0, 18.5}, x)->outcome, TouchedFace::Outcome::aslant);
    }

    /// A tool that stands on the stock and is pushed against a fixture beside it has not touched the stock's side.
    void aFixtureIsNoSideOfTheStock() {
        Setup block;
        block.stock = {{0.0, 0.0, 0.0}, {40.0, 30.0, 20.0}};
        TouchedFace fixture;
        fixture.outcome = TouchedFace::Outcome::found;
        fixture.high = true;
        fixture.place = {12.0, 10.0, 20.0};
        QVERIFY(!sideTouched(block, fixture));
        fixture.place.x = 40.001;
        QCOMPARE(sideTouched(block, fixture), std::optional(40.0));
    }

    /// Each refusal names its reason.
    void whatCannotBeTouchedIsRefused() {
        const Tool ball = loadTool("ball-6").value();
        Setup block;
        block.stock = {{0.0, 0.0, 0.0}, {40.0, 30.0, 20.0}};
        const glm::dvec3 x(1.0, 0.0, 0.0);
        QCOMPARE(touchStock(block, ball, {10.0, 10.0, 10.0}, x).error().detail,
                 std::string("a tip from which the tool is clear of the stock"));
        QCOMPARE(touchStock(block, ball, {-20.0, 10.0, 10.0}, -x).error().detail,
                 std::string("a tip from which the tool meets the stock in this direction"));
        block.form = StockForm::file;
        QCOMPARE(touchStock(block, ball, {-20.0, 10.0, 10.0}, x).error().code, ErrorCode::notSupported);
    }
};

BURIN_TEST(TestTouchedFace, NoApplication)

} // namespace burin::tst_touched_face

#include "tst_touched_face.moc"

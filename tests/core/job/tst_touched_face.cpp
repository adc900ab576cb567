// SPDX-FileCopyrightText: 2026 The Burin authors
// SPDX-License-Identifier: Apache-2.0
#include "core/job/touched_face.h"

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
        QCOMPARE(right.place, glm::dvec3(13.0, 20.0, 30.0));
        const TouchedFace front = touchedFace(pressed(tip, {0.0, -1.0, 0.0}), tool, 0.5); // with an allowance
        QCOMPARE(front.axis, 1);
        QCOMPARE(front.place, glm::dvec3(10.0, 16.5, 30.0));
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
};

BURIN_TEST(TestTouchedFace, NoApplication)

} // namespace burin::tst_touched_face

#include "tst_touched_face.moc"

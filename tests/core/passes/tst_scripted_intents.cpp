// SPDX-FileCopyrightText: 2026 The Burin authors
// SPDX-License-Identifier: Apache-2.0
#include "core/base/units.h"
#include "core/haptics/operator/operator_hand.h"
#include "core/passes/scripted_intents.h"
#include "tests/core/haptics/analytic_fields.h"
#include "tests/core/haptics/haptic_rig.h"
#include "tests/test_program.h"

#include <QtTest>

#include <map>

namespace burin::tst_scripted_intents {

using namespace burin::test;

namespace {

constexpr double radius = 3.0;

ContourRequest around(double bottom, double top) {
    ContourRequest request;
    request.stock = {{-25, -25, bottom}, {25, 25, top}};
    request.bottom = bottom;
    request.levelDepth = 2.0;
    request.press = 0.7;
    return request;
}

bool sameWay(const std::vector<IntentPoint>& a, const std::vector<IntentPoint>& b) {
    return std::equal(a.begin(), a.end(), b.begin(), b.end(), [](const IntentPoint& one, const IntentPoint& other) {
        return one.tip == other.tip && one.speed == other.speed;
    });
}

} // namespace

class TestOperatorIntents : public QObject {
    Q_OBJECT
private slots:
    void aContourGoesRoundTheGrownPartAtEachLevel() {
        const BallField<SphereSolid> field(SphereSolid{15.0}, radius);
        const ContourRequest request = around(-2.0, 6.0);
        const auto points = planContours(field, ballTool(), request);
        QVERIFY(points);
        std::map<double, std::vector<glm::dvec2>> levels;
        for (const IntentPoint& point : *points) {
            QVERIFY(point.speed > 0.0 && isFinite(point.tip));
            if (point.speed == request.speeds.cutting) levels[point.tip.z].emplace_back(point.tip);
        }
        QCOMPARE(levels.size(), std::size_t{4}); // 4, 2, 0, -2
        for (const auto& [height, way] : levels) {
            // The ball's centre stays on the sphere grown by its radius; the hand aims inside by the press depth.
            const double ring = std::sqrt(18.0 * 18.0 - (height + radius) * (height + radius)) - request.press;
            double turned = 0.0;
            for (std::size_t i = 0; i + 1 < way.size(); ++i) { // the last point leads away
                QVERIFY(std::abs(glm::length(way[i]) - ring) < 0.02);
                if (i == 0) continue;
                turned += std::atan2(way[i - 1].x * way[i].y - way[i - 1].y * way[i].x, glm::dot(way[i - 1], way[i]));
                QVERIFY(glm::length(way[i] - way[i - 1]) < 1.1);
            }
            QVERIFY(std::abs(turned - 2.0 * pi) < 1e-6); // one turn, with the part to the left
        }
    }

    void theCornersOfABoxAreFollowed() {
        const BallField<BoxSolid> field(BoxSolid{{8, 6, 10}}, radius);
        const auto points = planContours(field, ballTool(), around(-4.0, 0.0));
        QVERIFY(points);
        QVERIFY(points->size() > 50);
        double widest = 0.0;
        for (const IntentPoint& point : *points)
            if (point.tip.z < 0.0) widest = std::max(widest, point.tip.y);
        QVERIFY(std::abs(widest - (6.0 + radius - 0.7)) < 0.02);
    }

    void noDeeperThanTheFlutesAndNothingWithoutAPart() {
        const BallField<SphereSolid> field(SphereSolid{15.0}, radius);
        ContourRequest request = around(-40.0, 6.0);
        const auto points = planContours(field, ballTool(5.0), request);
        QVERIFY(points);
        for (const IntentPoint& point : *points) QVERIFY(point.tip.z >= 1.0 - 1e-9);
        const BallField<SphereSolid> far(SphereSolid{0.001}, radius);
        request.stock = {{100, 100, 20}, {120, 120, 30}};
        request.bottom = 20;
        QVERIFY(planContours(far, ballTool(), request)->empty());
        request.press = -1.0;
        QCOMPARE(planContours(field, ballTool(), request).error().code, ErrorCode::argumentInvalid);
    }

    void aScribbleIsTheSameForTheSameSeedAndStaysWhereItShall() {
        ScribbleRequest request{.region = {{-20, -10, -5}, {20, 10, 2}}, .seconds = 30.0, .seed = 4};
        const auto first = planScribble(request), again = planScribble(request);
        QVERIFY(first && again);
        QVERIFY(sameWay(*first, *again));
        request.seed = 5;
        QVERIFY(!sameWay(*first, *planScribble(request)));
        Box seen;
        double length = 0.0;
        for (std::size_t i = 1; i + 1 < first->size(); ++i) {
            QVERIFY(request.region.grown(1e-9).contains((*first)[i].tip));
            seen.include((*first)[i].tip);
            if (i > 1) length += glm::length((*first)[i].tip - (*first)[i - 1].tip);
        }
        QVERIFY(seen.size().x > 20.0 && seen.size().y > 10.0 && seen.size().z > 3.0); // most of it
        QVERIFY(length / 30.0 > 0.2 * request.speed && length / 30.0 < 2.0 * request.speed);
        request.seconds = 0.0;
        QCOMPARE(planScribble(request).error().code, ErrorCode::argumentInvalid);
    }

    void finerStepsMeasureTheSameHand() {
        // Against the closed formula: a mass on spring and damper, pushed by a constant force from rest.
        const HandImpedance hand = lightHand;
        const HandleInertia handle;
        const double mass = hand.mass + handle.mass, damping = hand.damping + handle.damping;
        const double decay = 0.5 * damping / mass, natural = std::sqrt(hand.stiffness / mass);
        const double swing = std::sqrt(natural * natural - decay * decay), force = 0.7, time = 0.037;
        const double rest = force / hand.stiffness * 1000.0; // mm
        const double exact =
            rest * (1.0 - std::exp(-decay * time) * (std::cos(swing * time) + decay / swing * std::sin(swing * time)));
        for (const double step : {50e-6, 20e-6, 10e-6}) {
            HandArm arm(hand, handle, HandReaction{.share = 0.0}, step);
            for (int i = 0; i < 37; ++i) arm.advance({force, 0, 0}, 0.001);
            QVERIFY(std::abs(arm.deviation().x - exact) < 1e-8);
        }
    }
};

BURIN_TEST(TestOperatorIntents, NoApplication)

} // namespace burin::tst_scripted_intents

#include "tst_scripted_intents.moc"

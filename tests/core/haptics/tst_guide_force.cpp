// SPDX-FileCopyrightText: 2026 The Burin authors
// SPDX-License-Identifier: Apache-2.0
#include "core/haptics/operator/operator_hand.h"
#include "tests/core/haptics/guide_rig.h"
#include "tests/oracles/allocation_count.h"
#include "tests/test_program.h"

#include <QtTest>
#include <rapidcheck.h>

#include <new>
#include <random>

namespace burin::tst_guide_force {

using namespace burin::test;

namespace {

constexpr int seconds = 1000;        // ticks
constexpr double guideHeight = 20.0; // mm, far above the stock

/// A step with a part but no stock.
Rig bareMilling(HapticSettings settings = Rig::settings()) {
    return Rig(settings, ballTool(), stockOnPart(0, false));
}

GuideSettings guidesOf(std::initializer_list<Guide> wanted) {
    GuideSettings settings;
    std::copy(wanted.begin(), wanted.end(), settings.guides.begin());
    return settings;
}

/// Measurements for a hand that moves into guides and out of them again.
struct Cycles {
    double worstGain = -1e300;  ///< J, largest energy that the hand gained between two releases, after which it is as
                                ///< free as before
    double largestChange = 0.0; ///< N, of the force between two ticks
    double largestForce = 0.0;  ///< N
    int releases = 0;
};

/// A hand-arm that swings over guides, `amplitude` mm to each side of a height, with its position read in encoder
/// steps.
Cycles swing(const HandImpedance& impedance, const GuideSettings& guides, double centre, double amplitude,
             double stiffness, double encoder, double cycleSeconds = 1.0) {
    HapticSettings settings = Rig::settings();
    settings.stylus.maximumStiffness.value = stiffness / settings.guideShare;
    Rig rig = bareMilling(settings);
    rig.step.setGuides(guides);
    HandArm arm(impedance, HandleInertia{}, HandReaction{.share = 0.0});
    const auto request = [&](double time) { return up(centre + amplitude * std::cos(2.0 * pi * time / cycleSeconds)); };
    Cycles cycles;
    glm::dvec3 place = request(0.0), force(0.0);
    double gained = 0.0;
    bool held = false;
    for (int tick = 0; tick < 8 * seconds; ++tick) {
        const Sample sample = rig.feed(glm::round(place / encoder) * encoder);
        const glm::dvec3 before = force, from = place;
        force = rig.step.deviceWrench().force;
        cycles.largestChange = std::max(cycles.largestChange, glm::length(force - before));
        cycles.largestForce = std::max(cycles.largestForce, glm::length(force));
        const bool now = (sample.flags & sampleOnGuide) != 0;
        if (held && !now) {
            cycles.worstGain = std::max(cycles.worstGain, gained);
            gained = 0.0;
            ++cycles.releases;
        }
        held = now;
        arm.advance(force, period);
        place = request((tick + 1) * period) + arm.deviation();
        gained += glm::dot(force, place - from) / millimetresPerMetre;
    }
    return cycles;
}

} // namespace

class TestGuideForce : public QObject {
    Q_OBJECT
private slots:
    void goingIntoAGuideAndOutGivesNoEnergyAndNoKick_data() {
        QTest::addColumn<double>("stiffness");
        QTest::addColumn<double>("encoder");
        for (const double stiffness : {240.0, 400.0, 800.0, 1500.0})
            for (const double encoder : {0.02, 0.055})
                QTest::addRow("%.0f N/m, %.3f mm", stiffness, encoder) << stiffness << encoder;
    }
    void goingIntoAGuideAndOutGivesNoEnergyAndNoKick() {
        QFETCH(double, stiffness);
        QFETCH(double, encoder);
        Guide levels = guideOf(GuideKind::levels, 2.0);
        levels.point = up(guideHeight);
        const double strongest = std::min(0.6 * 3.0e-3 * stiffness, 1.2); // N, largest pull: half of any force sent
        for (const HandImpedance& hand : {lightHand, middleHand, firmHand})
            for (const GuideSettings& guides : {guidesOf({planeGuide(up(guideHeight), up(1))}), guidesOf({levels})}) {
                const double enough = 5.0 + 1.25e3 * strongest / hand.stiffness; // mm, enough to pull free
                const Cycles cycles = swing(hand, guides, guideHeight, enough, stiffness, encoder);
                QVERIFY2(cycles.worstGain <= 0.02e-3, qPrintable(QString::number(cycles.worstGain)));
                QVERIFY(cycles.releases >= 8);
                QVERIFY(cycles.largestForce > 0.1);
                // The spring over an encoder step and 0.1 mm of the hand's own motion; 0.1 N of the controller's
                // damper.
                const double most = 1.5e-3 * stiffness * (encoder + 0.1) + 0.1;
                QVERIFY2(cycles.largestChange <= most, qPrintable(QString::number(cycles.largestChange)));
            }
    }

    void aHandThatTurnsBackAtTheEdgeOfAGuideGainsNothingEither() {
        for (const double amplitude : {0.4, 0.8, 1.2}) // about the heights at which it is engaged and released
            for (const double cycleSeconds : {0.1, 0.25, 0.7}) {
                const Cycles cycles = swing(lightHand, guidesOf({planeGuide(up(guideHeight), up(1))}),
                                            guideHeight + 2.5, amplitude, 240.0, 0.02, cycleSeconds);
                QVERIFY2(cycles.worstGain <= 0.02e-3, qPrintable(QString::number(cycles.worstGain)));
            }
    }

    void theForceIsTheSprings() {
        Rig rig = bareMilling();
        rig.step.setGuides(guidesOf({planeGuide(up(guideHeight), up(1))}));
        rig.begin(up(guideHeight + 1.0));
        const Sample sample = rig.rest(1 * seconds);
        QVERIFY(sample.flags & sampleOnGuide);
        QCOMPARE(sample.proxy.tip, up(guideHeight));
        QCOMPARE(sample.stylusTip, up(guideHeight + 1.0));
        const double stiffness = 0.6 * 400.0; // N/m: 60 % of the device's limit
        QVERIFY(std::abs(sample.force.z + stiffness * 1e-3) < 0.01 * stiffness * 1e-3);
    }

    void aGuideInsideThePartNeverPressesTheToolIn() {
        Rig rig = bareMilling();
        rig.step.setGuides(guidesOf({planeGuide(up(floorHeight - 1.5), up(1))}));
        double least = 1e300;
        rig.onTick = [&](const Sample& sample) { least = std::min(least, sample.proxy.tip.z); };
        rig.begin(up(floorHeight + 5.0));
        // Within the guide's reach, above the floor: the guide pulls to the floor, and no farther.
        rig.moveTo(up(floorHeight + 0.4), 20.0);
        Sample sample = rig.rest(seconds);
        QVERIFY(sample.flags & sampleOnGuide);
        QVERIFY(std::abs(sample.proxy.tip.z - floorHeight) < 1e-3);
        QVERIFY(sample.force.z < 0.0);
        QVERIFY(sample.force.z > -240.0 * 0.4e-3 - 1e-6);
        // In the floor, before reaching the guide: only the contact force, in full.
        rig.moveTo(up(floorHeight - 1.0), 20.0);
        sample = rig.rest(seconds);
        QVERIFY(std::abs(sample.force.z - 0.32) < 0.01 * 0.32);
        // Beyond the guide both push out, the contact starting from the guide.
        rig.moveTo(up(floorHeight - 2.5), 20.0);
        sample = rig.rest(seconds);
        QVERIFY(std::abs(sample.force.z - (0.32 * 1.5 + 0.24 * 1.0)) < 0.01 * 0.72);
        QVERIFY(least >= floorHeight - 1e-9);
    }

    void acrossAContactTheGuideStillHolds() {
        HapticSettings settings = Rig::settings();
        settings.felt.friction = 0.0; // which would also hold the tool in the direction perpendicular to the guide
        Rig rig = bareMilling(settings);
        rig.step.setGuides(guidesOf({planeGuide({3, 0, 0}, {1, 0, 0})}));
        rig.begin({3, 0, floorHeight + 1.0});
        rig.moveTo({4, 0, floorHeight - 1.0}, 20.0);
        const Sample sample = rig.rest(seconds);
        QVERIFY(std::abs(sample.proxy.tip.x - 3.0) < 1e-3);
        QVERIFY(std::abs(sample.force.x + 0.24) < 0.01 * 0.24);
        QVERIFY(std::abs(sample.force.z - 0.32) < 0.01 * 0.32);
    }

    void theForceIsContinuousInHandAndTool() {
        QVERIFY(rc::check("a small move changes what is felt by little", [] {
            std::mt19937_64 random(*rc::gen::arbitrary<std::uint64_t>());
            std::uniform_real_distribution<double> unit(-1.0, 1.0);
            const auto point = [&](double half) { return half * glm::dvec3(unit(random), unit(random), unit(random)); };
            // A plane guide with normal n, and a flat contact with normal m that keeps the tool at the nearest point.
            const glm::dvec3 n = glm::normalize(point(1.0)), m = glm::normalize(point(1.0));
            const double guideAt = unit(random), contactAt = unit(random);
            const auto feltAt = [&](const glm::dvec3& hand) {
                GuidedHand guided;
                guided.pull = n * (guideAt - glm::dot(n, hand));
                guided.goal.tip = hand + guided.pull;
                const double inside = contactAt - glm::dot(m, guided.goal.tip);
                const glm::dvec3 tool = guided.goal.tip + m * std::max(0.0, inside);
                const FeltGuides felt = burin::felt(guided, hand, tool);
                return 320.0 * (tool - felt.from) + 240.0 * felt.pull; // mN
            };
            const glm::dvec3 hand = point(2.0);
            for (int i = 0; i < 100; ++i) {
                const glm::dvec3 next = hand + point(1e-5);
                RC_ASSERT(glm::length(feltAt(next) - feltAt(hand)) <= 4.0 * 560.0 * glm::length(next - hand) + 1e-9);
            }
        }));
    }

    void theRecordSaysWhereAGuideHeld() {
        Rig rig = bareMilling();
        rig.begin(up(guideHeight + 1.0));
        QVERIFY((rig.rest(200).flags & sampleOnGuide) == 0);
        rig.step.setGuides(guidesOf({planeGuide(up(guideHeight), up(1))}));
        QVERIFY((rig.rest(200).flags & sampleOnGuide) != 0);
        rig.step.setGuides({});
        const Sample sample = rig.rest(200);
        QVERIFY((sample.flags & sampleOnGuide) == 0);
        QVERIFY(glm::length(sample.force) < 0.01);
    }

    void aFaultLetsTheHandGo() {
        Rig rig = bareMilling();
        rig.step.setGuides(guidesOf({planeGuide(up(guideHeight), up(1))}));
        rig.begin(up(guideHeight + 1.0));
        rig.rest(200);
        rig.step.advance(StylusState{}, period);
        const Sample sample = rig.rest(1);
        QVERIFY(std::abs(sample.proxy.tip.z - guideHeight) > 0.99); // engaged again, starting without force
    }

    void switchingGuidesUnderForceNeverKicks() {
        Rig rig = bareMilling();
        std::mt19937_64 random(7);
        std::uniform_real_distribution<double> unit(-1.0, 1.0);
        rig.begin(up(guideHeight));
        glm::dvec3 before(0.0);
        double largest = 0.0;
        rig.onTick = [&](const Sample& sample) {
            largest = std::max(largest, glm::length(sample.force - before));
            before = sample.force;
        };
        for (int round = 0; round < 200; ++round) {
            Guide levels = guideOf(GuideKind::levels, 1.0 + 3.0 * std::abs(unit(random)));
            levels.direction = glm::normalize(glm::dvec3(unit(random), unit(random), 1.0));
            rig.step.setGuides(guidesOf({planeGuide({0, unit(random), 0}, {unit(random), 1.0, 0}), levels}));
            if (round % 5 == 0) rig.step.stepGuides(round % 2 == 0 ? 1 : -1);
            rig.moveTo(up(guideHeight) + 3.0 * glm::dvec3(unit(random), unit(random), unit(random)), 40.0);
        }
        QVERIFY2(largest <= 0.16 + 1e-9, qPrintable(QString::number(largest))); // the slew limit
    }

    void guidesAllocateNothing() {
        Rig rig = bareMilling();
        std::vector<glm::dvec3> points, tangents;
        for (int i = 0; i < 500; ++i) {
            points.emplace_back(0.1 * i - 20.0, std::sin(0.1 * i), guideHeight);
            tangents.emplace_back(1.0, std::cos(0.1 * i), 0.0);
        }
        const GuideCurve curve = *GuideCurve::make(points, tangents);
        Guide edge = guideOf(GuideKind::curve), axis = guideOf(GuideKind::axis);
        edge.curve = &curve;
        const GuideSettings guides = guidesOf({edge, guideOf(GuideKind::surface, 1.0), guideOf(GuideKind::levels, 1.0),
                                               guideOf(GuideKind::stepOver, 1.0), axis});
        rig.begin(up(guideHeight));
        const std::size_t before = allocationCount.load();
        rig.step.setGuides(guides);
        for (int i = 0; i < 3; ++i) {
            rig.moveTo({8, 3, guideHeight + 1}, 50.0);
            rig.step.stepGuides(-1);
            rig.moveTo({-8, 2, floorHeight}, 50.0);
        }
        QCOMPARE(allocationCount.load(), before);
        const auto more = std::make_unique<int>(1);
        QVERIFY(allocationCount.load() > before);
    }
};

BURIN_TEST(TestGuideForce, NoApplication)

} // namespace burin::tst_guide_force

#include "tst_guide_force.moc"

// SPDX-FileCopyrightText: 2026 The Burin authors
// SPDX-License-Identifier: Apache-2.0
#include "tests/core/haptics/hostile_rig.h"
#include "tests/test_program.h"

#include <QtTest>

#include <map>

namespace burin::tst_hostile_stylus {

using namespace burin::test;

namespace {

bool same(const HostileStylus::Tick& a, const HostileStylus::Tick& b) {
    const auto bits = [](double x) {
        std::uint64_t word = 0;
        std::memcpy(&word, &x, sizeof word);
        return word;
    };
    return bits(a.period) == bits(b.period) && a.event == b.event && a.state.buttons == b.state.buttons &&
           bits(a.state.pose.position.x) == bits(b.state.pose.position.x) &&
           bits(a.state.pose.position.z) == bits(b.state.pose.position.z);
}

} // namespace

class TestHostileStylus : public QObject {
    Q_OBJECT
private slots:
    void theSameSeedGivesTheSameTicks() {
        HostileStylus first(strayingInTheStock(5)), second(strayingInTheStock(5)), other(strayingInTheStock(6));
        int different = 0;
        for (int i = 0; i < 20'000; ++i) {
            Wrench wrench;
            wrench.force = {0.0, 0.001 * (i % 700), 0.5};
            for (HostileStylus* hand : {&first, &second, &other}) hand->write(wrench);
            const HostileStylus::Tick tick = first.next();
            QVERIFY(same(tick, second.next()));
            different += same(tick, other.next()) ? 0 : 1;
        }
        QVERIFY(different > 10'000);
    }

    void everythingHappens() {
        HostileStylus hostile(strayingInTheStock(1));
        std::map<HostileEvent, int> events;
        double fastest = 0.0;
        int still = 0, pressed = 0;
        glm::dvec3 before(0.0);
        bool known = false;
        for (int i = 0; i < 200'000; ++i) {
            const HostileStylus::Tick tick = hostile.next();
            ++events[tick.event];
            pressed += tick.state.buttons != 0 ? 1 : 0;
            if (tick.event == HostileEvent::none && known) {
                const double speed = glm::length(tick.state.pose.position - before) / tick.period;
                fastest = std::max(fastest, speed);
                still += speed == 0.0 ? 1 : 0;
            }
            known = tick.event == HostileEvent::none;
            before = tick.state.pose.position;
        }
        for (int event = 1; event <= static_cast<int>(HostileEvent::badPeriod); ++event)
            QVERIFY(events[static_cast<HostileEvent>(event)] > 100);
        QVERIFY(fastest > 500.0);
        QVERIFY(still > 1000);
        QVERIFY(pressed > 1000);
    }

    void theStepStaysWithinItsLimitsWithGuidesUnderIt() {
        HapticSettings settings = Rig::settings();
        settings.rampSeconds = 0.05;
        settings.felt.gain = 100.0;
        Rig rig(settings, ballTool(5.0, 12.0));
        HostileStylus hostile(strayingInTheStock(3));
        SeededRandom random(9);
        const double largest = settings.forceShare * settings.stylus.maximumForce.value;
        const double slope = 1.5 * period / settings.rampSeconds * largest;
        const double rise = 0.16 + slope;
        glm::dvec3 before(0.0);
        int events = 0, pushed = 0, guided = 0;
        for (int i = 0; i < 200'000; ++i) {
            if (i % 500 == 0) {
                GuideSettings guides;
                for (Guide& guide : guides.guides) {
                    guide.kind = std::array{GuideKind::plane,   GuideKind::levels,   GuideKind::line,
                                            GuideKind::surface, GuideKind::stepOver, GuideKind::axis}[random.below(6)];
                    guide.on = random.share() < 0.4;
                    guide.point = random.within({-8, -8, -14}, {8, 8, 5});
                    guide.direction = random.direction();
                    guide.distance = random.between(0.1, 4.0);
                }
                guides.stepButton = 4;
                rig.step.setGuides(guides);
            }
            const HostileStylus::Tick tick = hostile.next();
            const Sample sample = rig.step.advance(tick.state, tick.period);
            const glm::dvec3 force = rig.step.deviceWrench().force;
            hostile.write(rig.step.deviceWrench());
            QVERIFY(isFinite(force) && isFinite(sample.proxy.tip) && isFinite(sample.proxy.axis));
            QVERIFY(glm::length(force) <= largest + 1e-12);
            QVERIFY(rig.field.clearance(sample.proxy.tip) >= -1e-9 || !rig.step.started());
            if (HostileStylus::mustBeStill(tick.event)) {
                QCOMPARE(force, glm::dvec3(0.0));
                ++events;
            } else if (glm::length(force) > 0.0) {
                QVERIFY(glm::length(force) - glm::length(before) <= rise + 1e-12);
                QVERIFY(glm::length(force - before) <= 3.0 * rise + 1e-12);
                ++pushed;
            }
            guided += (sample.flags & sampleOnGuide) != 0 ? 1 : 0;
            before = force;
        }
        QVERIFY(events > 1000);
        QVERIFY(pushed > 20'000);
        QVERIFY(guided > 20'000);
    }
};

BURIN_TEST(TestHostileStylus, NoApplication)

} // namespace burin::tst_hostile_stylus

#include "tst_hostile_stylus.moc"

// SPDX-FileCopyrightText: 2026 The Burin authors
// SPDX-License-Identifier: Apache-2.0
#include "core/base/units.h"
#include "core/haptics/operator/virtual_operator.h"
#include "core/haptics/trace/trace_stylus.h"
#include "core/recording/trace_file.h"
#include "tests/test_program.h"

#include <QTemporaryDir>
#include <QtTest>

#include <cstring>
#include <functional>

namespace burin::tst_operator {

namespace {

using Force = std::function<glm::dvec3(const glm::dvec3&)>;
const Force noForce = [](const glm::dvec3&) { return glm::dvec3(0.0); };

/// A thousand ticks a second until the stylus is finished (at most 100 s).
std::vector<StylusState> play(Stylus& stylus, const Force& force = noForce) {
    std::vector<StylusState> states;
    for (int tick = 0; tick < 100000 && !stylus.finished(); ++tick) {
        states.push_back(stylus.read(tick * 0.001));
        stylus.write({force(states.back().pose.position)});
    }
    return states;
}

bool sameBits(const std::vector<StylusState>& a, const std::vector<StylusState>& b) {
    if (a.size() != b.size()) return false;
    for (std::size_t i = 0; i < a.size(); ++i)
        if (std::memcmp(&a[i].time, &b[i].time, sizeof a[i].time) != 0 ||
            std::memcmp(&a[i].pose, &b[i].pose, sizeof a[i].pose) != 0 || a[i].buttons != b[i].buttons ||
            a[i].valid != b[i].valid)
            return false;
    return true;
}

/// Around a square of 40 mm, up and back.
std::vector<IntentPoint> square() {
    return {{{0, 0, 0}, 0}, {{40, 0, 0}, 60}, {{40, 40, 0}, 60}, {{0, 40, 10}, 120}, {{0, 0, 0}, 60}};
}

OperatorSettings calm() {
    OperatorSettings settings;
    settings.tremor = 0.0;
    settings.encoderStep = 0.0;
    return settings;
}

double distanceToWay(const glm::dvec3& place, const std::vector<IntentPoint>& way) {
    double least = 1e9;
    for (std::size_t i = 1; i < way.size(); ++i) {
        const glm::dvec3 edge = way[i].tip - way[i - 1].tip;
        const double share = std::clamp(glm::dot(place - way[i - 1].tip, edge) / glm::dot(edge, edge), 0.0, 1.0);
        least = std::min(least, glm::distance(place, way[i - 1].tip + share * edge));
    }
    return least;
}

} // namespace

class OperatorTest final : public QObject {
    Q_OBJECT
private slots:
    void handAnswersAStepOfForceAsTheFormulaSays_data();
    void handAnswersAStepOfForceAsTheFormulaSays();
    void motionOnALineTakesTheTimeOfTheFormula();
    void motionKeepsToTheWayAndItsLimits();
    void motionSensesWrongPoints();
    void handFollowsTheIntentInTheAir();
    void handPressesIntoAWall_data();
    void handPressesIntoAWall();
    void tremorIsAsStrongAndAsFastAsStated();
    void theSameSeedGivesTheSameMotion();
    void readingsLieOnTheStepsOfTheEncoder();
    void forcesBeyondTheDeviceOrNotFiniteDoNoHarm();
    void handStaysInTheWorkspace();
    void mappingLaysTheRegionIntoTheWorkspace();
    void openSensesAnIntentOutOfReach();
    void recordedTraceIsReplayedBitByBit();
    void traceBetweenReadingsIsInterpolated();
};

void OperatorTest::handAnswersAStepOfForceAsTheFormulaSays_data() {
    QTest::addColumn<double>("mass");
    QTest::addColumn<double>("damping");
    QTest::addColumn<double>("stiffness");
    for (const auto& [name, hand] : {std::pair{"light", lightHand}, {"middle", middleHand}, {"firm", firmHand}})
        QTest::newRow(name) << hand.mass << hand.damping << hand.stiffness;
    QTest::newRow("overdamped") << 0.05 << 40.0 << 100.0;
}

void OperatorTest::handAnswersAStepOfForceAsTheFormulaSays() {
    QFETCH(double, mass);
    QFETCH(double, damping);
    QFETCH(double, stiffness);
    const HandleInertia handle;
    HandArm arm({mass, damping, stiffness}, handle, {.share = 0.0, .seconds = 0.1});
    const double m = mass + handle.mass, b = damping + handle.damping;
    const double decay = 0.5 * b / m, square = stiffness / m - decay * decay; // of the angular frequency
    const double end = 1000.0 * 2.0 / stiffness;                              // mm for 2 N
    for (int tick = 1; tick <= 1000; ++tick) {
        arm.advance({0.0, 2.0, 0.0}, 0.001);
        const double t = tick * 0.001, w = std::sqrt(std::abs(square));
        const double shape = square > 0.0 ? std::cos(w * t) + decay / w * std::sin(w * t)
                                          : std::cosh(w * t) + decay / w * std::sinh(w * t);
        QVERIFY(std::abs(arm.deviation().y - end * (1.0 - std::exp(-decay * t) * shape)) < 1e-7 * end);
        QVERIFY(arm.deviation().x == 0.0 && arm.deviation().z == 0.0);
    }
}

void OperatorTest::motionOnALineTakesTheTimeOfTheFormula() {
    const std::vector<IntentPoint> line = {{{0, 0, 0}, 0}, {{30, 40, 0}, 80}};
    const auto motion = IntentMotion::make(line, {.acceleration = 2000.0, .cornerSeconds = 0.03});
    QVERIFY(motion);
    QVERIFY(std::abs(motion->duration() - (50.0 / 80.0 + 80.0 / 2000.0 + 0.03)) < 1e-9);
    QVERIFY(std::abs(glm::length(motion->at(0.4).velocity) - 80.0) < 1e-9);
    QVERIFY(glm::length(motion->at(0.5 * motion->duration()).position - glm::dvec3(15, 20, 0)) < 1e-9);
    const auto rest = IntentMotion::make(std::span(line).first(1), {});
    QVERIFY(rest && rest->at(5.0).position == line[0].tip);
}

void OperatorTest::motionKeepsToTheWayAndItsLimits() {
    const MotionLimits limits{.acceleration = 3000.0, .cornerSeconds = 0.025};
    std::vector<IntentPoint> way = square();
    for (int i = 0; i < 400; ++i) { // and a tight spiral in short pieces
        const double angle = 0.1 * i;
        way.push_back({{5.0 * std::sin(angle), 5.0 - 5.0 * std::cos(angle), 0.01 * i}, 150});
    }
    const auto motion = IntentMotion::make(way, limits);
    QVERIFY(motion);
    QVERIFY(motion->at(-1.0).position == way.front().tip);
    QVERIFY(motion->at(1e6).position == way.back().tip);
    const double step = 1e-4;
    MotionState before = motion->at(0.0);
    double fastest = 0.0, hardest = 0.0, farthest = 0.0;
    for (double t = step; t < motion->duration() + 0.1; t += step) {
        const MotionState now = motion->at(t);
        fastest = std::max(fastest, glm::length(now.velocity));
        hardest = std::max(hardest, glm::length(now.acceleration));
        farthest = std::max(farthest, distanceToWay(now.position, way));
        // Velocity is the derivative of position, acceleration that of velocity, without a jump.
        QVERIFY(glm::length((now.position - before.position) / step - 0.5 * (now.velocity + before.velocity)) < 0.1);
        QVERIFY(glm::length(now.velocity - before.velocity) < 2.0 * limits.acceleration * step);
        before = now;
    }
    QVERIFY2(fastest < 150.0 + 1e-6 && fastest > 100.0, qPrintable(QString::number(fastest)));
    QVERIFY2(hardest < 2.0 * limits.acceleration, qPrintable(QString::number(hardest)));
    QVERIFY2(farthest < 0.3, qPrintable(QString::number(farthest))); // only at corners
}

void OperatorTest::motionSensesWrongPoints() {
    const auto fails = [](std::vector<IntentPoint> way, MotionLimits limits = {}) {
        const auto motion = IntentMotion::make(way, limits);
        return !motion && motion.error().code == ErrorCode::argumentInvalid;
    };
    QVERIFY(fails({}));
    QVERIFY(fails({{{0, 0, 0}, 0}, {{1, 0, 0}, 0}}));
    QVERIFY(fails({{{0, 0, 0}, 0}, {{1, std::nan(""), 0}, 10}}));
    QVERIFY(fails({{{0, 0, 0}, 0}}, {.acceleration = 0.0}));
    QVERIFY(!fails({{{1, 1, 1}, 0}, {{1, 1, 1}, 10}, {{1, 1, 1}, 10}})); // repeating the same point takes no time
}

void OperatorTest::handFollowsTheIntentInTheAir() {
    OperatorSettings settings; // with tremor and encoder
    WorkspaceMapping mapping;
    mapping.origin = {20.0, 20.0, 0.0};
    mapping.rotation = glm::angleAxis(0.5 * pi, glm::dvec3(0.0, 0.0, 1.0));
    mapping.scale = 1.5;
    VirtualOperator hand(square(), mapping, settings);
    QVERIFY(hand.open());
    const std::vector<StylusState> states = play(hand);
    QVERIFY(hand.finished());
    QVERIFY(states.size() > 2000);
    double farthest = 0.0;
    for (const StylusState& state : states) {
        QVERIFY(state.valid);
        farthest = std::max(farthest, distanceToWay(mapping.toSetup(state.pose.position), square()));
        QVERIFY(glm::length(mapping.rotation * toolPose(state.pose).axis - glm::dvec3(0, 0, 1)) < 1e-12);
    }
    // Rounded corners 0.25 mm; tremor of 0.05 mm rms per axis and half a step of the encoder, scaled.
    QVERIFY2(farthest < 0.7, qPrintable(QString::number(farthest)));
    VirtualOperator steady(square(), mapping, calm());
    QVERIFY(steady.open());
    const StylusState last = play(steady).back();
    QVERIFY(glm::length(mapping.toSetup(last.pose.position) - square().back().tip) < 1e-9);
}

void OperatorTest::handPressesIntoAWall_data() {
    QTest::addColumn<double>("stiffness");
    QTest::addColumn<double>("leaning");
    QTest::newRow("firm hand leans against the wall") << 600.0 << 0.8;
    QTest::newRow("firm hand, no leaning") << 600.0 << 0.0;
    QTest::newRow("light hand leans") << 100.0 << 0.8;
}

void OperatorTest::handPressesIntoAWall() {
    QFETCH(double, stiffness);
    QFETCH(double, leaning);
    OperatorSettings settings = calm();
    settings.hand = stiffness < 200.0 ? lightHand : firmHand;
    settings.reaction.share = leaning;
    // Along a wall at z = 0, aiming 2 mm below; the coupling spring of a Touch, 320 N/m.
    const std::vector<IntentPoint> way = {{{-30, 0, 5}, 0}, {{-30, 0, -2}, 20}, {{30, 0, -2}, 40}};
    VirtualOperator hand(way, {}, settings);
    QVERIFY(hand.open());
    double deepest = 0.0;
    const std::vector<StylusState> states = play(hand, [&](const glm::dvec3& place) {
        deepest = std::min(deepest, place.z);
        return glm::dvec3(0.0, 0.0, place.z < 0.0 ? -0.320 * place.z : 0.0);
    });
    // Equilibrium of springs: k (z + 2) = -K z (1 - share).
    const double expected = -2.0 * stiffness / (stiffness + 320.0 * (1.0 - leaning));
    QVERIFY2(std::abs(states.back().pose.position.z - expected) < 0.01,
             qPrintable(QString::number(states.back().pose.position.z)));
    QVERIFY2(deepest > -2.3, qPrintable(QString::number(deepest)));
    for (std::size_t i = 800; i < states.size(); ++i) QVERIFY(states[i].pose.position.z < -0.2); // never bounces off
}

void OperatorTest::tremorIsAsStrongAndAsFastAsStated() {
    const Tremor tremor(0.05, 7);
    const double seconds = 20.0, step = 0.001;
    const int count = static_cast<int>(seconds / step);
    for (int axis = 0; axis < 3; ++axis) {
        double square = 0.0;
        for (int i = 0; i < count; ++i) square += std::pow(tremor.at(i * step)[axis], 2);
        const double rms = std::sqrt(square / count);
        QVERIFY2(std::abs(rms - 0.05) < 0.005, qPrintable(QString::number(rms)));
        double inBand = 0.0; // power by a plain Fourier sum
        for (double frequency = 7.5; frequency <= 12.5; frequency += 1.0 / seconds) {
            double c = 0.0, s = 0.0;
            for (int i = 0; i < count; i += 5) {
                c += tremor.at(i * step)[axis] * std::cos(2.0 * pi * frequency * i * step);
                s += tremor.at(i * step)[axis] * std::sin(2.0 * pi * frequency * i * step);
            }
            inBand += 2.0 * (c * c + s * s) / std::pow(count / 5.0, 2);
        }
        QVERIFY2(inBand > 0.9 * square / count, qPrintable(QString::number(inBand / (square / count))));
    }
    QVERIFY(Tremor(0.0, 7).at(3.0) == glm::dvec3(0.0));
}

void OperatorTest::theSameSeedGivesTheSameMotion() {
    const auto run = [](std::uint64_t seed) {
        OperatorSettings settings;
        settings.seed = seed;
        VirtualOperator hand(square(), {}, settings);
        if (!hand.open()) return std::vector<StylusState>{};
        return play(hand, [](const glm::dvec3& place) { return -0.05 * place; });
    };
    QVERIFY(!run(1).empty());
    QVERIFY(sameBits(run(1), run(1)));
    QVERIFY(!sameBits(run(1), run(2)));
    VirtualOperator again(square(), {}, {});
    QVERIFY(again.open());
    const auto first = play(again);
    QVERIFY(again.open());
    QVERIFY(sameBits(first, play(again)));
}

void OperatorTest::readingsLieOnTheStepsOfTheEncoder() {
    OperatorSettings settings;
    settings.encoderStep = 0.055;
    VirtualOperator hand(square(), {}, settings);
    QVERIFY(hand.open());
    for (const StylusState& state : play(hand))
        for (int axis = 0; axis < 3; ++axis) {
            const double steps = state.pose.position[axis] / 0.055;
            QVERIFY(std::abs(steps - std::round(steps)) < 1e-9);
        }
}

void OperatorTest::forcesBeyondTheDeviceOrNotFiniteDoNoHarm() {
    OperatorSettings settings = calm();
    settings.reaction.share = 0.0;
    VirtualOperator hand({{{0, 0, 0}, 0}}, {}, settings);
    QVERIFY(hand.open());
    for (int tick = 0; tick < 2000; ++tick) {
        const StylusState state = hand.read(tick * 0.001);
        QVERIFY(isFinite(state.pose.position));
        hand.write({tick < 1000 ? glm::dvec3(1e9, 0, 0) : glm::dvec3(std::nan(""), 0, 0)});
        if (tick == 999) QVERIFY(std::abs(state.pose.position.x - 1000.0 * 3.3 / 600.0) < 1e-3); // limited to 3.3 N
        if (tick == 1999) QVERIFY(std::abs(state.pose.position.x) < 1e-3);
    }
    QVERIFY(!hand.read(std::nan("")).valid);
}

void OperatorTest::handStaysInTheWorkspace() {
    OperatorSettings settings = calm();
    settings.hand = lightHand;
    VirtualOperator hand({{{74, 0, 0}, 0}, {{73, 0, 0}, 1}}, {}, settings);
    QVERIFY(hand.open());
    double farthest = 0.0;
    for (const StylusState& state : play(hand, [](const glm::dvec3&) { return glm::dvec3(3.0, 1.0, 0.0); }))
        farthest = std::max(farthest, glm::length(state.pose.position));
    QVERIFY2(farthest <= 75.0 + 1e-9 && farthest > 74.9, qPrintable(QString::number(farthest)));
}

void OperatorTest::mappingLaysTheRegionIntoTheWorkspace() {
    const StylusDescription stylus = touchLikeStylus();
    const Box region{{-10, 20, -5}, {120, 90, 48}};
    const WorkspaceMapping mapping = mappingFor(region, stylus);
    for (int corner = 0; corner < 8; ++corner) {
        const glm::dvec3 place((corner & 1) ? region.high.x : region.low.x, (corner & 2) ? region.high.y : region.low.y,
                               (corner & 4) ? region.high.z : region.low.z);
        QVERIFY(glm::length(mapping.toDevice(place)) <= 0.9 * stylus.workspaceRadius.value + 1e-9);
        QVERIFY(glm::length(mapping.toSetup(mapping.toDevice(place)) - place) < 1e-9);
    }
    QCOMPARE(mappingFor({{0, 0, 0}, {1, 1, 1}}, stylus).scale, 0.25);
}

void OperatorTest::openSensesAnIntentOutOfReach() {
    VirtualOperator hand({{{0, 0, 0}, 0}, {{80, 0, 0}, 10}}, {}, {});
    const Result<void> opened = hand.open();
    QVERIFY(!opened);
    QCOMPARE(opened.error().code, ErrorCode::argumentInvalid);
    QCOMPARE(opened.error().subject, std::string("intent point 2"));
    QVERIFY(!hand.read(0.0).valid);
    QVERIFY(!hand.finished());
}

void OperatorTest::recordedTraceIsReplayedBitByBit() {
    OperatorSettings settings;
    settings.encoderStep = 0.0; // all digits of a double
    WorkspaceMapping mapping;
    mapping.rotation = glm::angleAxis(0.3, glm::normalize(glm::dvec3(1.0, 2.0, 3.0)));
    VirtualOperator hand(square(), mapping, settings);
    QVERIFY(hand.open());
    const std::vector<StylusState> states = play(hand, [](const glm::dvec3& p) { return -0.02 * p; });
    const QTemporaryDir folder;
    const std::filesystem::path file = std::filesystem::path(folder.path().toStdString()) / "trace.csv";
    QVERIFY(writeTrace(file, states));
    const auto read = readTrace(file);
    QVERIFY(read);
    TraceStylus replay(read->readings, touchLikeStylus());
    QVERIFY(replay.open());
    QVERIFY(sameBits(play(replay), states));
    QVERIFY(replay.finished());
}

void OperatorTest::traceBetweenReadingsIsInterpolated() {
    StylusState first, second;
    first.valid = second.valid = true;
    first.time = 1.0;
    second.time = 1.01;
    second.pose.position = {1.0, 2.0, 3.0};
    second.buttons = 1;
    TraceStylus replay({first, second}, {});
    QVERIFY(replay.open());
    QVERIFY(replay.read(0.0).pose.position == first.pose.position);
    QVERIFY(!replay.finished());
    QVERIFY(glm::length(replay.read(1.005).pose.position - 0.5 * second.pose.position) < 1e-12);
    QCOMPARE(replay.read(1.005).buttons, 0u);
    QCOMPARE(replay.read(1.01).buttons, 1u);
    QVERIFY(replay.finished());
    QVERIFY(replay.read(9.0).pose.position == second.pose.position);
    TraceStylus backwards({second, first}, {});
    QVERIFY(!backwards.open());
    QVERIFY(!TraceStylus(std::vector<StylusState>(), {}).open());
}

BURIN_TEST(OperatorTest, NoApplication)

} // namespace burin::tst_operator

#include "tst_operator.moc"

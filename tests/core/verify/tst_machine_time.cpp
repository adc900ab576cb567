// SPDX-FileCopyrightText: 2026 The Burin authors
// SPDX-License-Identifier: Apache-2.0
#include "core/base/units.h"
#include "core/verify/machine_time.h"
#include "tests/test_program.h"

#include <QTest>
#include <rapidcheck.h>

#include <cmath>
#include <limits>

namespace burin::tst_machine_time {

namespace {

constexpr double a = 500.0; // mm/s²

MachineProfile mill(JunctionRule rule = JunctionRule::deviation) {
    MachineProfile machine;
    machine.rapidFeed = 6000.0; // 100 mm/s
    machine.maximumFeed = 6000.0;
    machine.acceleration = a;
    machine.junctions = rule;
    machine.junctionTolerance = 0.01;
    return machine;
}

ParsedProgram read(const std::string& moves) {
    return parseProgram("G21 G90 G17 G54\nT1 M6\nS10000 M3\n" + moves + "M2\n", "time.ngc").value();
}

/// Seconds from the start of the motion of a program's line to the end of the program.
double secondsFrom(const ParsedProgram& program, std::uint32_t line, const MachineProfile& machine) {
    const MachiningTime time = machiningTime(program, machine);
    for (std::size_t i = 0; i < program.motions.size(); ++i)
        if (program.motions[i].line == line) return time.seconds - time.motions[i].start;
    return std::numeric_limits<double>::quiet_NaN();
}

/// After the moves that every program here begins with.
constexpr std::uint32_t firstLine = 5;
const std::string begin = "G0 X0 Y0 Z5\n";

bool near(double value, double expected, double relative = 1e-9) {
    return std::abs(value - expected) <= relative * expected;
}

/// Speed along a finely divided path of straight blocks, directly from the definition: no faster than the block's feed,
/// at corners no faster than GRBL's rule, nowhere more than the acceleration. A forward pass, a backward pass, then the
/// time of each piece.
double bruteForce(const std::vector<glm::dvec2>& places, double speed, double acceleration, double deviation) {
    constexpr int pieces = 4000; // of each block
    std::vector<double> squares, lengths;
    for (std::size_t i = 1; i < places.size(); ++i) {
        const double length = glm::distance(places[i - 1], places[i]);
        double corner = 0.0;
        if (i > 1) {
            const glm::dvec2 before = glm::normalize(places[i - 1] - places[i - 2]);
            const glm::dvec2 after = glm::normalize(places[i] - places[i - 1]);
            const double inner = pi - std::acos(std::clamp(glm::dot(before, after), -1.0, 1.0));
            const double sine = std::sin(0.5 * inner);
            corner = sine < 1.0 - 1e-12 ? acceleration * deviation * sine / (1.0 - sine) : 1e300;
        }
        for (int k = 0; k < pieces; ++k) {
            squares.push_back(k == 0 ? std::min(corner, speed * speed) : speed * speed);
            lengths.push_back(length / pieces);
        }
    }
    squares.push_back(0.0);
    for (std::size_t i = lengths.size(); i-- > 0;)
        squares[i] = std::min(squares[i], squares[i + 1] + 2.0 * acceleration * lengths[i]);
    for (std::size_t i = 0; i < lengths.size(); ++i)
        squares[i + 1] = std::min(squares[i + 1], squares[i] + 2.0 * acceleration * lengths[i]);
    double seconds = 0.0;
    for (std::size_t i = 0; i < lengths.size(); ++i)
        seconds += 2.0 * lengths[i] / (std::sqrt(squares[i]) + std::sqrt(squares[i + 1]));
    return seconds;
}

/// Up to 20 straight moves to random points.
std::string anyLines() {
    std::string text = begin + "G1 F3000\n";
    const int count = *rc::gen::inRange(1, 20);
    for (int i = 0; i < count; ++i) {
        const auto place = [] { return std::to_string(*rc::gen::inRange(-3000, 3000) / 100.0); };
        text += "X" + place() + " Y" + place() + " Z" + place() + "\n";
    }
    return text;
}

} // namespace

class MachineTimeTest : public QObject {
    Q_OBJECT
private slots:
    void aMoveIsATrapezoid();
    void aShortMoveNeverGetsToItsFeed();
    void twoMovesInLineAreOne();
    void aSquareCornerIsTakenAsTheMachineSays();
    void aZigZagIsWhatAnIntegrationSays();
    void anAxisThatIsSlowSlowsTheWay();
    void anArcIsNoFasterThanItsCurvatureAllows();
    void rapidsOfIndependentAxesTakeTheLongest();
    void dwellsAndToolChangesCount();
    void movesOfWhichTheWayIsNotKnownAreCounted();
    void nothingIsFasterThanWithoutAcceleration();
    void feedsMayBeTimesOrTurns();
    void theProgramSaysHowCornersAreTaken();
    void jerkRoundsARamp();
    void jerkCostsTimeAndNoneWithoutLimit();
    void aControlCarriesOutSoManyBlocks();
};

void MachineTimeTest::aMoveIsATrapezoid() {
    const ParsedProgram program = read(begin + "G1 X100 F1200\n");
    QVERIFY(near(secondsFrom(program, firstLine, mill()), 100.0 / 20.0 + 20.0 / a));
    const MachiningTime time = machiningTime(program, mill());
    QVERIFY(near(time.motions.back().peakSpeed, 20.0));
    QVERIFY(near(time.withoutAcceleration, 5.0));
}

void MachineTimeTest::aShortMoveNeverGetsToItsFeed() {
    const ParsedProgram program = read(begin + "G1 X0.5 F6000\n");
    QVERIFY(near(secondsFrom(program, firstLine, mill()), 2.0 * std::sqrt(0.5 / a)));
    QVERIFY(near(machiningTime(program, mill()).motions.back().peakSpeed, std::sqrt(0.5 * a)));
}

void MachineTimeTest::twoMovesInLineAreOne() {
    for (const JunctionRule rule : {JunctionRule::deviation, JunctionRule::blend}) {
        const double one = secondsFrom(read(begin + "G1 X100 Y50 F3000\n"), firstLine, mill(rule));
        const double two = secondsFrom(read(begin + "G1 X40 Y20 F3000\nX100 Y50\n"), firstLine, mill(rule));
        QVERIFY(near(two, one));
    }
    const double stops = secondsFrom(read(begin + "G1 X40 F3000\nX100\n"), firstLine, mill(JunctionRule::exactStop));
    QVERIFY(near(stops, 100.0 / 50.0 + 2.0 * 50.0 / a));
}

/// 20 mm, a square corner, 20 mm at 50 mm/s: on each side slowing down for the corner instead of passing at full speed
/// costs (v - vc)²/(2 a v), and the other end costs v/2a.
void MachineTimeTest::aSquareCornerIsTakenAsTheMachineSays() {
    const ParsedProgram program = read(begin + "G1 X20 F3000\nY20\n");
    const double v = 50.0, sine = std::sqrt(0.5);
    // Along the bisector both axes accelerate together: sqrt(2) times a single axis.
    const double along = a * std::sqrt(2.0);
    const auto expected = [&](double corner) {
        const double ramps = v / a + (v - corner) / a;
        const double way = (v * v + v * v - corner * corner) / (2.0 * a);
        return 2.0 * (ramps + (20.0 - way) / v);
    };
    const double deviation = std::sqrt(along * 0.01 * sine / (1.0 - sine));
    QVERIFY(near(secondsFrom(program, firstLine, mill(JunctionRule::deviation)), expected(deviation)));
    const double leg = 2.0 * 0.01 / std::cos(0.25 * pi); // of the parabola that deviates from the corner by 0.01 mm
    const double blend = std::sqrt(along * leg / std::cos(0.25 * pi));
    QVERIFY(near(secondsFrom(program, firstLine, mill(JunctionRule::blend)), expected(blend)));
    QVERIFY(near(secondsFrom(program, firstLine, mill(JunctionRule::exactStop)), expected(0.0)));
}

void MachineTimeTest::aZigZagIsWhatAnIntegrationSays() {
    const bool holds = rc::check("look-ahead equals a fine integration", [] {
        const double tolerance = *rc::gen::inRange(5, 100) / 1000.0;
        std::vector<glm::dvec2> places{{0.0, 0.0}};
        std::string text = begin;
        const int count = *rc::gen::inRange(2, 12);
        for (int i = 0; i < count; ++i) {
            // Diagonals: both axes have the same share of every block, so that its limit is a sqrt(2).
            const double length = *rc::gen::inRange(1, 4000) / 1000.0;
            const double turn = *rc::gen::inRange(0, 3) == 0 ? -1.0 : 1.0;
            places.push_back(places.back() + glm::dvec2(length, turn * length));
            text += (i == 0 ? "G1 F3000 " : "") + std::string("X") + std::to_string(places.back().x) + " Y" +
                    std::to_string(places.back().y) + "\n";
        }
        MachineProfile machine = mill();
        machine.junctionTolerance = tolerance;
        machine.axisAccelerations = {a, a, a};
        // At these corners the direction only changes along Y, where the limit is a, not a sqrt(2).
        const double expected = bruteForce(places, 50.0, a * std::sqrt(2.0), tolerance / std::sqrt(2.0));
        RC_ASSERT(near(secondsFrom(read(text), firstLine, machine), expected, 1e-3));
    });
    QVERIFY(holds);
}

void MachineTimeTest::anAxisThatIsSlowSlowsTheWay() {
    MachineProfile machine = mill();
    machine.axisRates = {6000.0, 6000.0, 600.0}; // Z: 10 mm/s
    machine.axisAccelerations = {500.0, 500.0, 100.0};
    // 3 : 4 : the distance is 5/4 of its Z.
    const ParsedProgram program = read(begin + "G1 X30 Z-35 F6000\n");
    const double v = 10.0 * 1.25, slow = 100.0 * 1.25;
    QVERIFY(near(secondsFrom(program, firstLine, machine), 50.0 / v + v / slow));
    QVERIFY(near(secondsFrom(read(begin + "G0 X30 Z-35\n"), firstLine, machine), 50.0 / v + v / slow));
}

void MachineTimeTest::anArcIsNoFasterThanItsCurvatureAllows() {
    // A full circle of radius 2: no faster than sqrt(500 * 2) = 31.6 mm/s, although 100 are programmed.
    const ParsedProgram program = read(begin + "G2 I2 J0 F6000\n");
    const double v = std::sqrt(a * 2.0), length = 2.0 * pi * 2.0;
    QVERIFY(near(secondsFrom(program, firstLine, mill()), length / v + v / a));
    // A tangent line before it joins without a stop.
    const double line = secondsFrom(read(begin + "G1 Y40 F6000\nG2 X4 I2 J0\n"), firstLine, mill());
    const double entered = 100.0, way = 40.0;
    const double ramps = entered / a + (entered - v) / a;
    const double used = (2.0 * entered * entered - v * v) / (2.0 * a);
    const double half = pi * 2.0;
    QVERIFY(near(line, ramps + (way - used) / entered + (half - v * v / (2.0 * a)) / v + v / a));
}

void MachineTimeTest::rapidsOfIndependentAxesTakeTheLongest() {
    MachineProfile machine = mill();
    machine.rapids = RapidMode::independent;
    machine.axisRates = {6000.0, 3000.0, 6000.0};
    const ParsedProgram program = read(begin + "G0 X60 Y50\n");
    QVERIFY(near(secondsFrom(program, firstLine, machine), 50.0 / 50.0 + 50.0 / a)); // Y, although X moves farther
}

void MachineTimeTest::dwellsAndToolChangesCount() {
    MachineProfile machine = mill();
    machine.toolChangeSeconds = 7.0;
    const ParsedProgram program = read(begin + "G1 X10 F600\nG4 P1.5\nG1 X20\nT2 M6\nS1000 M3\nG0 X0 Y0 Z5\nG1 X10\n");
    const MachiningTime time = machiningTime(program, machine);
    QCOMPARE(time.toolChanges, 2);
    const double move = 10.0 / 10.0 + 10.0 / a;
    QVERIFY(near(time.seconds, 2.0 * 7.0 + 1.5 + 3.0 * move));
    for (std::size_t i = 1; i < time.motions.size(); ++i)
        QVERIFY(time.motions[i].start >= time.motions[i - 1].start + time.motions[i - 1].duration - 1e-12);
}

/// The first move has no known start; the move home ends at the machine's own zero.
void MachineTimeTest::movesOfWhichTheWayIsNotKnownAreCounted() {
    const MachiningTime away = machiningTime(read(begin + "G1 X10 F600\n"), mill());
    QCOMPARE(away.untimedMoves, 1);
    const MachiningTime home = machiningTime(read(begin + "G1 X10 F600\nG53 G0 Z0\nG53 G0 X0 Y0\n"), mill());
    QCOMPARE(home.untimedMoves, 3);
    QCOMPARE(home.seconds, away.seconds);
}

void MachineTimeTest::nothingIsFasterThanWithoutAcceleration() {
    const bool holds = rc::check("acceleration and corners only cost time, more of them less", [] {
        const ParsedProgram program = read(anyLines());
        double last = std::numeric_limits<double>::infinity();
        for (const double tolerance : {0.001, 0.01, 0.1}) {
            MachineProfile machine = mill(JunctionRule::blend);
            machine.junctionTolerance = tolerance;
            const MachiningTime time = machiningTime(program, machine);
            RC_ASSERT(time.seconds >= time.withoutAcceleration - 1e-9);
            RC_ASSERT(time.seconds <= last + 1e-9);
            last = time.seconds;
        }
        RC_ASSERT(machiningTime(program, mill(JunctionRule::exactStop)).seconds >= last - 1e-9);
    });
    QVERIFY(holds);
}

void MachineTimeTest::feedsMayBeTimesOrTurns() {
    MachineProfile machine = mill();
    machine.acceleration = 0.0;                                                                 // without limit
    QVERIFY(near(secondsFrom(read(begin + "G93\nG1 X30 F10\n"), firstLine + 1, machine), 6.0)); // a tenth of a minute
    QVERIFY(near(secondsFrom(read(begin + "G95\nG1 X30 F0.003\n"), firstLine + 1, machine), 60.0)); // 10,000 turns
}

/// For LinuxCNC the program's own words take precedence over the machine's settings.
void MachineTimeTest::theProgramSaysHowCornersAreTaken() {
    const std::string corner = begin + "G1 X20 F3000\nY20\n", bend = begin + "G1 X20 F3000\nX40\nY20\n";
    const auto seconds = [](const std::string& text, const MachineProfile& machine) {
        return secondsFrom(read(text), firstLine + 1, machine);
    };
    MachineProfile fine = mill(JunctionRule::blend), coarse = fine;
    coarse.junctionTolerance = 0.2;
    for (const JunctionRule rule : {JunctionRule::blend, JunctionRule::deviation, JunctionRule::exactStop}) {
        QVERIFY(near(seconds("G64 P0.2\n" + corner, mill(rule)), seconds("F1\n" + corner, coarse)));
        QVERIFY(near(seconds("G64 P0.01\n" + corner, mill(rule)), seconds("F1\n" + corner, fine)));
        QVERIFY(near(seconds("G61.1\n" + bend, mill(rule)), seconds("F1\n" + bend, mill(JunctionRule::exactStop))));
    }
    QVERIFY(near(secondsFrom(read("G20 G64 P0.01\nG21\n" + corner), firstLine + 2, fine),
                 secondsFrom(read("G21\nG64 P0.254\n" + corner), firstLine + 2, fine)));
    // G61 stops where the path bends and continues where it does not.
    const double v = 50.0, twenty = 20.0 / v + v / a, forty = 40.0 / v + v / a;
    QVERIFY(near(seconds("G61\n" + corner, fine), 2.0 * twenty));
    QVERIFY(near(seconds("G61\n" + bend, fine), forty + twenty));
    const std::vector<StatedPathMode> stated =
        statedPathModes(read("G64 P0.2\n" + begin + "G1 X5 F300\nG61.1\nX6\nG64\nX7\nX8\n"));
    QCOMPARE(stated.size(), std::size_t{3});
    QVERIFY(stated[0].mode == PathMode::blend && stated[0].tolerance == 0.2 && stated[0].line == 5);
    QVERIFY(stated[1].mode == PathMode::exactStop && stated[1].line == 8);
    QVERIFY(stated[2].mode == PathMode::blend && stated[2].tolerance == 0.0 && stated[2].line == 10);
    QVERIFY(statedPathModes(read(corner)).empty());
    // Without P the deviation may be up to half of a block: as with a tolerance of many millimetres.
    coarse.junctionTolerance = 100.0;
    QVERIFY(near(seconds("G64\n" + corner, fine), seconds("F1\n" + corner, coarse)));
}

/// One move from rest to rest: L / v + v / a + a / j where both limits are reached, otherwise by the formulas of the
/// ramps.
void MachineTimeTest::jerkRoundsARamp() {
    const double j = 10000.0;
    MachineProfile machine = mill();
    machine.axisJerks = glm::dvec3(j);
    const auto seconds = [&](const std::string& move) { return secondsFrom(read(begin + move), firstLine, machine); };
    // a²/j = 25 mm/s: at 50 mm/s the acceleration is reached, at 20 it is not.
    QVERIFY(near(seconds("G1 X100 F3000\n"), 100.0 / 50.0 + 50.0 / a + a / j));
    QVERIFY(near(seconds("G1 X100 F1200\n"), 100.0 / 20.0 + 2.0 * std::sqrt(20.0 / j)));
    // Too short for its feed and for its acceleration: four equal intervals of jerk, L = 2 j (t / 4)³.
    QVERIFY(near(seconds("G1 X0.5 F6000\n"), 4.0 * std::cbrt(0.5 / (2.0 * j))));
    // Divided into collinear blocks it is the same move.
    std::string blocks = "G1 F3000\n";
    for (int i = 1; i <= 400; ++i) blocks += "X" + std::to_string(0.25 * i) + "\n";
    QVERIFY(near(secondsFrom(read(begin + blocks), firstLine + 1, machine), 100.0 / 50.0 + 50.0 / a + a / j));
    // Rapids of independent axes are S-curves of their own; 3 : 4 : 5 has 5/4 of the jerk of its longer axis.
    machine.rapids = RapidMode::independent;
    QVERIFY(near(seconds("G0 X100 Y20\n"), 100.0 / 100.0 + 100.0 / a + a / j));
    machine.axisJerks = {4.0 * j, j, j};
    QVERIFY(near(seconds("G1 X60 Y80 F3000\n"), 100.0 / 50.0 + 50.0 / (1.25 * a) + a / j));
}

void MachineTimeTest::jerkCostsTimeAndNoneWithoutLimit() {
    const bool holds = rc::check("the less jerk, the more time", [] {
        const ParsedProgram program = read(anyLines());
        const double without = machiningTime(program, mill()).seconds;
        double last = without;
        for (const double jerk : {1e12, 1e6, 1e5, 1e4}) {
            MachineProfile machine = mill();
            machine.axisJerks = glm::dvec3(jerk);
            const MachiningTime time = machiningTime(program, machine);
            RC_ASSERT(time.seconds >= last - 1e-9);
            if (jerk == 1e12) RC_ASSERT(time.seconds <= without + 1e-3);
            last = time.seconds;
            for (std::size_t i = 1; i < time.motions.size(); ++i)
                RC_ASSERT(time.motions[i].start >= time.motions[i - 1].start + time.motions[i - 1].duration - 1e-9);
        }
    });
    QVERIFY(holds);
}

void MachineTimeTest::aControlCarriesOutSoManyBlocks() {
    MachineProfile machine = mill();
    machine.acceleration = 0.0; // without limit
    machine.blocksPerSecond = 500.0;
    std::string blocks = "G1 F6000\n"; // 100 mm/s would be 2000 blocks a second
    for (int i = 1; i <= 1000; ++i) blocks += "X" + std::to_string(0.05 * i) + "\n";
    QVERIFY(near(secondsFrom(read(begin + blocks), firstLine + 1, machine), 1000.0 / 500.0));
    QVERIFY(near(secondsFrom(read(begin + "G1 X50 F6000\n"), firstLine, machine), 0.5)); // one block, long enough
}

BURIN_TEST(MachineTimeTest, NoApplication)

} // namespace burin::tst_machine_time

#include "tst_machine_time.moc"

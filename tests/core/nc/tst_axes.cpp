// SPDX-FileCopyrightText: 2026 The Burin authors
// SPDX-License-Identifier: Apache-2.0
// Programs with named axes: rules for X hold for any other axis, except that degrees are not converted from inches.
#include "core/nc/data_post.h"
#include "core/nc/frames.h"
#include "core/nc/line_reader.h"
#include "core/nc/parser.h"
#include "core/nc/post.h"
#include "tests/test_program.h"

#include <rapidcheck.h>

#include <QtTest>

namespace burin::tst_axes {

namespace {

double anyNumber() {
    return *rc::gen::inRange(-1'000'000, 1'000'001) / 1000.0;
}

/// LinuxCNC's control with all nine axes, which none of our controls has.
Control nineAxes() {
    Control control = defaultControl();
    control.letters = "ABCDFHIJKLPQRSTUVWXYZ";
    control.axes = allAxes;
    return control;
}

NcMotion last(const std::string& text, const MachineState& start = {}) {
    const Result<ParsedProgram> program = parseProgram(text, "job", nineAxes(), start);
    if (!program) qFatal("%s", program.error().detail.c_str());
    return program->motions.back();
}

PartialPlace only(Axis axis, std::optional<double> value) {
    PartialPlace place;
    place[axis] = value;
    return place;
}

} // namespace

class TestNcAxes : public QObject {
    Q_OBJECT
private slots:
    void aBlockIsAskedByAxis() {
        const Control control = nineAxes();
        Parameters parameters(false, [](int) { return std::nullopt; });
        Block block;
        BlockFault fault;
        QVERIFY(readLine("G1 F100 C-45.5 X2 W3", control, parameters, block, fault));
        QCOMPARE(block.word(Axis::c).value, -45.5);
        QCOMPARE(block.word(Axis::x).value, 2.0);
        QCOMPARE(block.word(Axis::w).value, 3.0);
        QVERIFY(!block.word(Axis::y).given() && !block.word(Axis::a).given());
        QVERIFY(block.hasAxis());
        QCOMPARE(block.firstAxis(), 9u);
        QVERIFY(readLine("G4 P1", control, parameters, block, fault) && !block.hasAxis());
    }

    /// The six axes after Z do not move on the controls that we read.
    void ourControlsMoveThreeAxes() {
        for (const Control& control : controls()) {
            QVERIFY(control.axes == linearAxes);
            for (const char letter : {'A', 'B', 'C', 'U', 'V', 'W'})
                QVERIFY(!parseProgram(std::string("G21 G0 ") + letter + "1\n", "job", control));
        }
    }

    void rotaryAxesCountDegreesAndOthersTheUnit() {
        const NcMotion move = last("G20\nG0 X1 A90 U2\n");
        QCOMPARE(move.to[Axis::x], 25.4);
        QCOMPARE(move.to[Axis::a], 90.0);
        QCOMPARE(move.to[Axis::u], 50.8);
        QVERIFY(move.toKnown == AxisSet(Axis::x, Axis::a, Axis::u));
        QVERIFY(!move.endKnown(linearAxes) && move.endKnown(AxisSet(Axis::x, Axis::a)));
        QVERIFY(move.takes(Axis::a) && !move.takes(Axis::b));
    }
    void furtherAxesStayWhereTheyAreAndGoByIncrements() {
        const NcMotion move = last("G0 X0 Y0 Z5 A10 C20\nG91 G1 X5 A2.5 F100\n");
        QCOMPARE(move.from[Axis::a], 10.0);
        QCOMPARE(move.to[Axis::a], 12.5);
        QCOMPARE(move.to[Axis::c], 20.0);
        QVERIFY(move.takes(Axis::a) && !move.takes(Axis::c));
        // and evenly along an arc, as its chords show
        const Result<ParsedProgram> arc = parseProgram("G0 X10 Y0 Z0 A0\nG3 X-10 I-10 A30 F100\n", "job", nineAxes());
        QVERIFY(arc);
        for (const NcMotion& chord : straightMoves(*arc, 0.01)) {
            if (chord.rapid()) continue;
            const double angle = std::atan2(chord.to[Axis::y], chord.to[Axis::x]) * 180.0 / pi; // of 180 in all
            QVERIFY(std::abs(chord.to[Axis::a] - std::abs(angle) / 6.0) < 1e-9);
        }
    }
    void aHoleIsDrilledWhereTheFurtherAxesStand() {
        const NcMotion move = last("G0 X0 Y0 Z5 A10\nG81 X3 A40 Z-2 R1 F100\n");
        QCOMPARE(move.to[Axis::a], 40.0);
        QCOMPARE(move.to[Axis::x], 3.0);
    }

    /// The same words for X and C in one machine: those for X are checked against LinuxCNC in tst_rs274.
    void offsetsAndShiftsHoldForAnyAxisAsForX() {
        QVERIFY(rc::check("C as X", [] {
            MachineState start;
            start.unit = 25.4;
            for (const int offset : {54, 55})
                start.workOffsets[offset][Axis::x] = start.workOffsets[offset][Axis::c] = 0.0;
            if (*rc::gen::arbitrary<bool>()) start.place[Axis::x] = start.place[Axis::c] = anyNumber();
            Frames frames(start, linearAxes | AxisSet(Axis::c));
            const auto both = [](double value) {
                PartialPlace place = only(Axis::x, value);
                place[Axis::c] = value;
                return place;
            };
            for (int i = *rc::gen::inRange(1, 12); i > 0; --i) {
                const double value = anyNumber();
                const int offset = *rc::gen::element(54, 55, 56);
                switch (*rc::gen::inRange(0, 9)) {
                case 0:
                    frames.setWorkOffset(offset);
                    break;
                case 1:
                    frames.writeWorkOffset(offset, both(value));
                    break;
                case 2:
                    frames.writeWorkOffsetHere(offset, both(value));
                    break;
                case 3:
                    frames.shiftSoThatHereIs(both(value));
                    break;
                case 4:
                    frames.setShift(both(value));
                    break;
                case 5:
                    frames.dropShift(*rc::gen::arbitrary<bool>());
                    break;
                case 6:
                    frames.restoreShift();
                    break;
                case 7:
                    frames.forgetPlace();
                    break;
                default:
                    AxisValues place;
                    place.set(Axis::x, value);
                    place.set(Axis::c, value);
                    frames.moveTo(place, AxisSet(Axis::x, Axis::c));
                    break;
                }
                frames.storeHome(0);
                RC_ASSERT(frames.known().has(Axis::c) == frames.known().has(Axis::x));
                RC_ASSERT(frames.place()[Axis::c] == frames.place()[Axis::x]);
                RC_ASSERT(frames.shift()[Axis::c] == frames.shift()[Axis::x]);
                RC_ASSERT(frames.inMachine(Axis::c) == frames.inMachine(Axis::x));
                for (const int row : {5161, 5211, 5221, 5241, 5261, 5420}) {
                    const std::optional<double> x = frames.parameter(row, 25.4, 0),
                                                c = frames.parameter(row + 5, 25.4, 0);
                    RC_ASSERT(x.has_value() == c.has_value());
                    if (x) RC_ASSERT(*x == *c / 25.4);              // degrees, not inches
                    RC_ASSERT(!frames.parameter(row + 3, 25.4, 0)); // A, which no program moves
                }
            }
        }));
    }

    /// Only Z includes the tool length.
    void theLengthOfAToolMovesZAlone() {
        MachineState start;
        start.lengthOffset = 0.0;
        for (const Axis axis : allAxes) start.place[axis] = start.workOffsets[54][axis] = 0.0;
        Frames frames(start, allAxes);
        frames.setLengthOffset(3, 40.0);
        for (const Axis axis : allAxes) QCOMPARE(frames.place()[axis], axis == Axis::z ? -40.0 : 0.0);
    }

    void aDialectOfThreeAxesRefusesMore() {
        NcProgram program;
        program.name = "tilted";
        NcSection& section = program.sections.emplace_back();
        section.moves.resize(2);
        section.moves[0].kind = NcMoveKind::rapid;
        section.moves[1].feed = 100.0;
        section.moves[1].target = AxisValues(1.0, 0.0, 0.0);
        DialectData dialect;
        dialect.coolant[0] = "M9";
        MachineProfile machine;
        Progress progress;
        QVERIFY(writeProgram(program, machine, DataPost(dialect), progress));
        section.moves[1].target.set(Axis::b, 15.0);
        const Result<std::string> refused = writeProgram(program, machine, DataPost(dialect), progress);
        QVERIFY(!refused);
        QCOMPARE(refused.error().code, ErrorCode::notSupported);
        QCOMPARE(refused.error().subject, std::string("axes other than X, Y and Z"));
    }
};

BURIN_TEST(TestNcAxes, NoApplication)

} // namespace burin::tst_axes

#include "tst_axes.moc"

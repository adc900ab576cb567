// SPDX-FileCopyrightText: 2026 The Burin authors
// SPDX-License-Identifier: Apache-2.0
#include "core/nc/post.h"
#include "tests/test_program.h"

#include <QCoreApplication>
#include <QTest>

namespace burin::tst_post {

namespace {

MachineProfile machine() {
    MachineProfile profile;
    profile.travel = {300, 200, 100};
    profile.maximumFeed = 2000;
    profile.minimumSpindleSpeed = 1000;
    profile.maximumSpindleSpeed = 24000;
    profile.maximumLineLength = 20;
    return profile;
}

Path path() {
    Path made;
    made.name = "p";
    made.toolId = "ball-6";
    made.spindleSpeed = 10000;
    made.points = {{{{10, 20, 40}}, MoveKind::rapid, 0, 0, -1},
                   {{{10, 20, 30}}, MoveKind::plunge, 300, 0, -1},
                   {{{15, 20, 30}}, MoveKind::cut, 900, 7, 123},
                   {{{15, 20, 31}}, MoveKind::retract, 900, 0, -1},
                   {{{15, 20, 40}}, MoveKind::rapid, 0, 0, -1}};
    return made;
}

PostRequest request() {
    PostRequest made;
    made.programName = "job";
    made.workOffset = {10, 20, 30};
    made.safeHeight = 10;
    return made;
}

class Repeater final : public PostProcessor {
public:
    explicit Repeater(std::string text) : text_(std::move(text)) {}
    Result<void> write(const NcProgram&, const MachineProfile&, LineSink& sink, Progress&) const override {
        return sink.line(text_);
    }

private:
    std::string text_;
};

} // namespace

class TestPost : public QObject {
    Q_OBJECT

private slots:
    /// A machine with three axes cannot tilt the tool; a tilted pose is not posted as if it were upright.
    void aTiltedPoseIsRefusedByThreeAxes() {
        Path tilted = path();
        tilted.points[2].pose.axis = {0.0, 0.6, 0.8}; // atan(0.6 / 0.8) = 36.869898°
        const auto program = toProgram({tilted}, request(), machine());
        QVERIFY(!program);
        QCOMPARE(program.error().code, ErrorCode::programLimit);
        QVERIFY2(program.error().place.starts_with("36.869898"), program.error().place.c_str());
        QCOMPARE(program.error().detail, std::string("point 2"));
    }

    void movesArriveInTheFrameOfTheWorkOffset() {
        const auto program = toProgram({path()}, request(), machine());
        QVERIFY(program);
        QCOMPARE(program->sections.front().moves.size(), std::size_t{5});
        QVERIFY(program->sections.front().moves[0].kind == NcMoveKind::rapid &&
                program->sections.front().moves[0].target == AxisValues(0, 0, 10));
        QVERIFY(program->sections.front().moves[2].kind == NcMoveKind::line &&
                program->sections.front().moves[2].target == AxisValues(5, 0, 0));
        QCOMPARE(program->sections.front().moves[2].feed, 900.0);
        QCOMPARE(program->sections.front().moves[2].source, 7);
        QCOMPARE(program->sections.front().moves[2].sample, 123);
        QCOMPARE(QString::fromStdString(program->sections.front().moves[2].comment), "take 7, sample 123");
        QCOMPARE(program->sections.front().spindleSpeed, 10000.0);
    }

    void whatTheMachineCannotDoIsRefused_data() {
        QTest::addColumn<int>("fault");
        QTest::addColumn<ErrorCode>("code");
        QTest::addColumn<QString>("subject");
        QTest::newRow("feed too high") << 0 << ErrorCode::programLimit << "feed";
        QTest::newRow("feed missing") << 1 << ErrorCode::programLimit << "feed";
        QTest::newRow("X too far") << 2 << ErrorCode::programLimit << "X travel";
        QTest::newRow("tool change height too far") << 3 << ErrorCode::programLimit << "Z travel";
        QTest::newRow("spindle too fast") << 4 << ErrorCode::programLimit << "spindle speed";
        QTest::newRow("spindle too slow") << 5 << ErrorCode::programLimit << "spindle speed";
        QTest::newRow("no points") << 6 << ErrorCode::pathEmpty << "p";
        QTest::newRow("begins in the unknown") << 7 << ErrorCode::argumentInvalid << "path";
        QTest::newRow("not a place") << 8 << ErrorCode::argumentInvalid << "path";
    }
    void whatTheMachineCannotDoIsRefused() {
        QFETCH(int, fault);
        QFETCH(ErrorCode, code);
        QFETCH(QString, subject);
        Path faulty = path();
        MachineProfile limits = machine();
        switch (fault) {
        case 0:
            faulty.points[2].feed = 2000.5;
            break;
        case 1:
            faulty.points[3].feed = 0;
            break;
        case 2:
            faulty.points[2].pose.tip.x = 310.5;
            break;
        case 3:
            limits.toolChangeHeight = 100.5;
            break;
        case 4:
            faulty.spindleSpeed = 24001;
            break;
        case 5:
            faulty.spindleSpeed = 999;
            break;
        case 6:
            faulty.points.clear();
            break;
        case 7:
            faulty.points.erase(faulty.points.begin());
            break;
        default:
            faulty.points[2].pose.tip.y = std::nan("");
            break;
        }
        const auto program = toProgram({faulty}, request(), limits);
        QVERIFY(!program);
        QCOMPARE(program.error().code, code);
        QCOMPARE(QString::fromStdString(program.error().subject), subject);
    }

    void eachToolIsASection() {
        Path other = path();
        other.toolId = "flat-6";
        other.coolant = Coolant::flood;
        const auto refused = toProgram({path(), other}, request(), machine());
        QVERIFY(!refused); // the request names a single tool
        QCOMPARE(refused.error().code, ErrorCode::argumentInvalid);
        PostRequest both = request();
        both.tools["ball-6"] = {1, "Ball", SpindleDirection::clockwise};
        both.tools["flat-6"] = {2, "Flat", SpindleDirection::clockwise};
        const auto program = toProgram({path(), path(), other}, both, machine());
        QVERIFY(program);
        QCOMPARE(program->sections.size(), std::size_t{2});
        QCOMPARE(program->sections[0].moves.size(), std::size_t{10});
        QCOMPARE(program->sections[1].toolNumber, 2);
        QVERIFY(program->sections[1].coolant == Coolant::flood);
    }

    void anotherSpeedOfTheSameToolIsASection() {
        Path faster = path();
        faster.spindleSpeed = 12000;
        const auto program = toProgram({path(), faster}, request(), machine());
        QVERIFY(program);
        QCOMPARE(program->sections.size(), std::size_t{2});
        QCOMPARE(program->sections[1].spindleSpeed, 12000.0);
    }

    /// In a cut before the move that requires it; between cuts before the first rapid, where the tool touches nothing.
    void aSpeedChangesWithinASection() {
        Path changing = path();
        changing.points.insert(changing.points.begin() + 3, {{{18, 20, 30}}, MoveKind::cut, 500, 7, 130});
        changing.points[3].spindleSpeed = 6000;
        changing.points[4].spindleSpeed = 6000; // the retract
        const auto program = toProgram({changing, path()}, request(), machine());
        QVERIFY(program);
        QCOMPARE(program->sections.size(), std::size_t{2}); // its first speed differs from the last one before
        const std::vector<NcMove>& moves = program->sections[0].moves;
        QCOMPARE(program->sections[0].spindleSpeed, 10000.0);
        for (std::size_t i = 0; i < moves.size(); ++i) QCOMPARE(moves[i].spindleSpeed, i == 3 ? 6000.0 : 0.0);
        for (PathPoint& point : changing.points) point.spindleSpeed = 6000;
        const auto slower = toProgram({changing}, request(), machine());
        QVERIFY(slower);
        QCOMPARE(slower->sections[0].spindleSpeed, 6000.0);
        changing.points[3].spindleSpeed = 30000;
        const auto refused = toProgram({changing}, request(), machine());
        QVERIFY(!refused);
        QCOMPARE(refused.error().code, ErrorCode::programLimit);
    }

    /// As the speed does: within a cut before the move that requires it, between cuts before the first rapid.
    void theCoolantChangesWithinASection() {
        Path changing = path();
        changing.coolant = Coolant::flood;
        changing.points.insert(changing.points.begin() + 3, {{{18, 20, 30}}, MoveKind::cut, 500, 7, 130});
        changing.points[3].coolant = Coolant::mist;
        const auto changesOf = [](const NcSection& section) {
            std::vector<std::pair<std::size_t, Coolant>> changes;
            for (std::size_t i = 0; i < section.moves.size(); ++i)
                if (section.moves[i].coolant) changes.emplace_back(i, *section.moves[i].coolant);
            return changes;
        };
        using Changes = std::vector<std::pair<std::size_t, Coolant>>;
        const auto program = toProgram({changing, changing}, request(), machine());
        QVERIFY(program);
        QCOMPARE(program->sections.size(), std::size_t{1}); // it ends in the state in which the second begins
        const std::size_t count = changing.points.size();
        QVERIFY(program->sections[0].coolant == Coolant::flood);
        QVERIFY((
            changesOf(program->sections[0]) ==
            Changes{{3, Coolant::mist}, {4, Coolant::flood}, {count + 3, Coolant::mist}, {count + 4, Coolant::flood}}));
        for (PathPoint& point : changing.points) point.coolant = Coolant::off;
        const auto dry = toProgram({changing}, request(), machine());
        QVERIFY(dry && dry->sections[0].coolant == Coolant::off && changesOf(dry->sections[0]).empty());
    }

    void arcsArriveWhole() {
        Path turning = path();
        turning.points[2].arc = PathArc{{12.5, 20, 0}, 2, true};
        const auto program = toProgram({turning}, request(), machine());
        QVERIFY(program);
        const NcMove& move = program->sections.front().moves[2];
        QVERIFY(move.kind == NcMoveKind::arc && move.target == AxisValues(5, 0, 0));
        QVERIFY(move.arc.centre.x == 2.5 && move.arc.centre.y == 0.0 && move.arc.axis == 2 && move.arc.clockwise);
    }

    void anArcsWayCountsForTheTravel() {
        Path turning = path();
        turning.points[2].arc = PathArc{{12.5, 20, 0}, 2, true}; // half a circle, 2.5 mm to the side
        MachineProfile small = machine();
        small.travel.y = 2.4;
        const auto program = toProgram({turning}, request(), small);
        QVERIFY(!program);
        QCOMPARE(QString::fromStdString(program.error().subject), "Y travel");
    }

    void aLineTheControlCannotReadIsRefused() {
        Progress progress;
        const auto fits = writeProgram({}, machine(), Repeater(std::string(20, 'x')), progress);
        QVERIFY(fits);
        QCOMPARE(fits->size(), std::size_t{21});
        const auto tooLong = writeProgram({}, machine(), Repeater(std::string(21, 'x')), progress);
        QVERIFY(!tooLong);
        QCOMPARE(tooLong.error().code, ErrorCode::programLimit);
        QCOMPARE(QString::fromStdString(tooLong.error().subject), "length of line 1");
    }
};

BURIN_TEST(TestPost, QCoreApplication)

} // namespace burin::tst_post

#include "tst_post.moc"

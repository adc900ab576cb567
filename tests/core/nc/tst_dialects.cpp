// SPDX-FileCopyrightText: 2026 The Burin authors
// SPDX-License-Identifier: Apache-2.0
// Every dialect defined by data: exact text, the controls' rules, and that its own control reads the intended moves.
#include "core/base/file.h"
#include "core/nc/lint.h"
#include "core/nc/parser.h"
#include "tests/core/nc/dialect_jobs.h"
#include "tests/oracles/canonical_program.h"
#include "tests/oracles/grbl_rules.h"
#include "tests/places.h"
#include "tests/test_program.h"

#include <rapidcheck.h>

#include <QCoreApplication>
#include <QRegularExpression>
#include <QTest>

#include <random>

#include <cmath>

namespace burin::tst_dialects {

namespace {

const std::vector<std::string> ids{"fanuc", "grbl", "grblhal", "haas", "linuxcnc", "mach"};

NcProgram jobFor(const std::string& dialect, NcUnits units = NcUnits::millimetre) {
    return referenceJob(units, dialect == "grbl" ? 1 : 2);
}

void addDialects() {
    QTest::addColumn<QString>("dialect");
    QTest::addColumn<bool>("inch");
    for (const std::string& id : ids)
        for (const bool inch : {false, true})
            QTest::newRow((id + (inch ? ", inch" : ", mm")).c_str()) << QString::fromStdString(id) << inch;
}

NcUnits unitsOf(bool inch) {
    return inch ? NcUnits::inch : NcUnits::millimetre;
}

/// Lines, arcs and rapids around a point, as a path fitter makes them.
NcProgram randomJob(NcUnits units) {
    NcProgram program = referenceJob(units, 1);
    std::vector<NcMove>& moves = program.sections.front().moves;
    const auto coordinate = [] { return *rc::gen::inRange(-200000, 200000) / 1700.0; };
    moves = {rapidTo(coordinate(), coordinate(), 10)};
    const int count = *rc::gen::inRange(1, 40);
    for (int i = 0; i < count; ++i) {
        const glm::dvec3 from = moves.back().target.linear();
        const double feed = *rc::gen::inRange(10, 90000) / 10.0;
        switch (*rc::gen::inRange(0, 6)) {
        case 0:
            moves.push_back(rapidTo(coordinate(), coordinate(), coordinate()));
            break;
        case 1:
            moves.push_back(lineTo(coordinate(), coordinate(), coordinate(), feed));
            break;
        default: {
            const int axis = *rc::gen::inRange(0, 3);
            const double radius = std::pow(10.0, *rc::gen::inRange(-1500, 2900) / 1000.0);
            const double angle = *rc::gen::inRange(0, 6283) / 1000.0;
            const int thousandths = *rc::gen::inRange(1, 7000); // sometimes a full turn
            const double sweep =
                std::min(thousandths / 1000.0, 2.0 * std::acos(-1.0)) * (*rc::gen::inRange(0, 2) == 0 ? 1.0 : -1.0);
            const int u = (axis + 1) % 3, v = (axis + 2) % 3;
            glm::dvec3 centre = from, to = from;
            centre[u] -= radius * std::cos(angle);
            centre[v] -= radius * std::sin(angle);
            if (thousandths < 6284) { // otherwise it ends where it begins
                to[u] = centre[u] + radius * std::cos(angle + sweep);
                to[v] = centre[v] + radius * std::sin(angle + sweep);
            }
            if (*rc::gen::inRange(0, 2) == 0) to[axis] += *rc::gen::inRange(-5000, 5000) / 1000.0;
            moves.push_back(arcTo(to, centre, axis, sweep < 0.0, feed));
            break;
        }
        }
    }
    return program;
}

/// The end points of a posted text's blocks, mm, read without our parser: X, Y and Z are modal, comments are ignored.
std::vector<glm::dvec3> placesIn(const std::string& text, bool inch) {
    const QRegularExpression comment(R"(\([^)]*\)|;.*)"), word(R"(([XYZ])(-?[0-9]*\.?[0-9]*))");
    std::vector<glm::dvec3> places;
    glm::dvec3 at(0.0);
    for (const QString& line : QString::fromStdString(text).split('\n')) {
        glm::dvec3 to = at;
        auto words = word.globalMatch(QString(line).remove(comment));
        while (words.hasNext()) {
            const auto one = words.next();
            to[one.captured(1)[0].unicode() - 'X'] = one.captured(2).toDouble() * (inch ? 25.4 : 1.0);
        }
        if (to != at) places.push_back(to);
        at = to;
    }
    return places;
}

double turnAt(const glm::dvec3& from, const glm::dvec3& at, const glm::dvec3& to) {
    const glm::dvec3 in = glm::normalize(at - from), out = glm::normalize(to - at);
    return std::acos(glm::clamp(glm::dot(in, out), -1.0, 1.0)) * 180.0 / std::acos(-1.0);
}

/// Turns of more than 155 degrees with a leg of less than 0.1 mm.
std::size_t backStepsAmong(const std::vector<glm::dvec3>& places) {
    std::size_t count = 0;
    for (std::size_t i = 1; i + 1 < places.size(); ++i)
        if (turnAt(places[i - 1], places[i], places[i + 1]) > 155.0 &&
            std::min(glm::distance(places[i - 1], places[i]), glm::distance(places[i], places[i + 1])) < 0.1)
            ++count;
    return count;
}

double distanceToLine(const glm::dvec3& place, const std::vector<glm::dvec3>& line) {
    double least = 1e9;
    for (std::size_t i = 1; i < line.size(); ++i) {
        const glm::dvec3 along = line[i] - line[i - 1];
        const double share = glm::clamp(glm::dot(place - line[i - 1], along) / glm::dot(along, along), 0.0, 1.0);
        least = std::min(least, glm::distance(place, line[i - 1] + share * along));
    }
    return least;
}

/// The distance of `place` from an arc.
double distanceToArc(const glm::dvec3& place, const Arc& arc) {
    const ArcTurn turn = turnOf(arc);
    const int u = (arc.axis + 1) % 3, v = (arc.axis + 2) % 3;
    const double radial = std::hypot(place[u] - arc.centre[u], place[v] - arc.centre[v]) - turn.startRadius;
    return std::abs(radial);
}

} // namespace

class TestDialects : public QObject {
    Q_OBJECT

private slots:
    void theReferenceJobReadsAsAMachinistExpects_data() { addDialects(); }
    void theReferenceJobReadsAsAMachinistExpects() {
        QFETCH(QString, dialect);
        QFETCH(bool, inch);
        const auto text = posted(dialect.toStdString(), jobFor(dialect.toStdString(), unitsOf(inch)));
        QVERIFY2(text, text ? "" : (text.error().subject + text.error().place + text.error().detail).c_str());
        const QString file = QString(BURIN_FIXTURES "/programs/%1-%2.txt").arg(dialect, inch ? "inch" : "mm");
        const auto expected = readFile(file.toStdString());
        QVERIFY2(expected, qPrintable(file));
        const QStringList ours = QString::fromStdString(*text).split('\n');
        const QStringList theirs = QString::fromStdString(*expected).split('\n');
        for (qsizetype i = 0; i < std::min(ours.size(), theirs.size()); ++i) QCOMPARE(ours[i], theirs[i]);
        QCOMPARE(ours.size(), theirs.size());
    }

    void itsOwnControlReadsIt_data() { addDialects(); }
    void itsOwnControlReadsIt() {
        QFETCH(QString, dialect);
        QFETCH(bool, inch);
        const auto text = posted(dialect.toStdString(), jobFor(dialect.toStdString(), unitsOf(inch)));
        QVERIFY(text);
        const Control* control = findControl(dialect.toStdString());
        QVERIFY(control != nullptr);
        const auto program = parseProgram(*text, "job", *control);
        QVERIFY2(program, program ? "" : (program.error().place + ": " + program.error().detail).c_str());
        QVERIFY(program->ended);
        const MachineProfile machine = roomyMachine();
        for (const LintMark& mark : lint(*text, {control, &machine}))
            QFAIL((std::to_string(mark.line) + ": " + mark.text).c_str());
    }

    void speedsChangeInTheCut_data() { addDialects(); }
    /// The dialect's own control reads the intended speed for each move; a change in the air waits for the spindle.
    void speedsChangeInTheCut() {
        QFETCH(QString, dialect);
        QFETCH(bool, inch);
        NcProgram job = referenceJob(unitsOf(inch), 1);
        NcSection& section = job.sections.front();
        section.moves = {rapidTo(0, 0, 10),  lineTo(0, 0, -1, 300),  lineTo(10, 0, -1, 900), lineTo(20, 0, -1, 500),
                         rapidTo(20, 0, 10), lineTo(20, 0, -2, 300), rapidTo(20, 0, 10)};
        section.moves[3].spindleSpeed = 6000;
        section.moves[4].spindleSpeed = 9000;
        const auto text = posted(dialect.toStdString(), job);
        QVERIFY(text);
        const Control* control = findControl(dialect.toStdString());
        const auto program = parseProgram(*text, "job", *control);
        QVERIFY2(program, program ? "" : (program.error().place + ": " + program.error().detail).c_str());
        std::vector<double> speeds;
        double waited = 0.0;
        for (const NcMotion& motion : program->motions) {
            if (motion.kind == NcMotionKind::dwell && motion.spindleSpeed == 9000.0) waited += motion.seconds;
            if (motion.kind == NcMotionKind::line) speeds.push_back(motion.spindleSpeed);
        }
        QVERIFY((speeds == std::vector<double>{12000, 12000, 6000, 9000}));
        QCOMPARE(waited, 3.0);
        const MachineProfile machine = roomyMachine();
        for (const LintMark& mark : lint(*text, {control, &machine}))
            QFAIL((std::to_string(mark.line) + ": " + mark.text).c_str());
    }

    /// A point that equals the previous one after rounding is omitted, but its speed and coolant are not.
    void aSpeedOutlivesThePointThatRoundingLeavesOut() {
        for (const std::string& id : ids) {
            NcProgram job = referenceJob(NcUnits::millimetre, 1);
            job.sections.front().moves = {rapidTo(0, 0, 10),           lineTo(0, 0, -1, 300),  lineTo(10, 0, -1, 900),
                                          lineTo(10.0001, 0, -1, 500), lineTo(20, 0, -1, 500), rapidTo(20, 0, 10)};
            job.sections.front().moves[3].spindleSpeed = 6000;
            job.sections.front().moves[3].coolant = Coolant::off;
            const auto text = posted(id, job);
            QVERIFY(text);
            const auto program = parseProgram(*text, "job", *findControl(id));
            QVERIFY(program);
            NcMotion last;
            for (const NcMotion& motion : program->motions)
                if (motion.kind == NcMotionKind::line) last = motion;
            QCOMPARE(last.spindleSpeed, 6000.0);
            QVERIFY(!last.flood);
        }
    }

    void theSpindleParksWhereItsMachineSays_data() { addDialects(); }
    /// Two blocks in the machine's frame after each tool, Z first; all other blocks are unchanged.
    void theSpindleParksWhereItsMachineSays() {
        QFETCH(QString, dialect);
        QFETCH(bool, inch);
        const std::string id = dialect.toStdString();
        const NcProgram job = jobFor(id, unitsOf(inch));
        MachineProfile machine = roomyMachine();
        machine.home = glm::dvec3(-254.0, 12.7, -2.54);
        const auto without = posted(id, job), with = posted(id, job, machine);
        QVERIFY(without && with);
        const double unit = inch ? 25.4 : 1.0;
        const QRegularExpression height("^(N\\d+ )?G53 G00? Z([-.\\d]+)$"),
            across("^(N\\d+ )?G53 G00? X([-.\\d]+) Y([-.\\d]+)$");
        QStringList rest;
        std::size_t parked = 0;
        const QStringList lines = QString::fromStdString(*with).split('\n');
        for (int i = 0; i < lines.size(); ++i) {
            const auto up = height.match(lines[i]), aside = across.match(lines.value(i + 1));
            if (!aside.hasMatch()) {
                rest << lines[i];
                continue;
            }
            QVERIFY2(up.hasMatch(), qPrintable(lines[i]));
            QCOMPARE(up.captured(2).toDouble() * unit, -2.54);
            QCOMPARE(aside.captured(2).toDouble() * unit, -254.0);
            QCOMPARE(aside.captured(3).toDouble() * unit, 12.7);
            ++parked;
            ++i;
        }
        QCOMPARE(rest.join('\n').toStdString(), *without);
        QCOMPARE(parked, job.sections.size());
        const Control& control = *findControl(id);
        QVERIFY(lint(*with, {&control, &machine}).empty());
        MachineState known; // of a control that knows the position of the work
        known.workOffsets[54] = {100.0, 200.0, -300.0};
        for (const int number : {0, 3, 12}) known.lengthOffsets[number] = 0.0;
        const auto read = parseProgram(*with, "job", control, known);
        QVERIFY(read && read->ended);
        QVERIFY(glm::distance(read->motions.back().to.linear(), glm::dvec3(-354.0, -187.3, 297.46)) < 1e-6);
    }

    void roundingTurnsNothingBack_data() { addDialects(); }
    /// A line of short moves with turns of up to 154 degrees has no turns above 155 degrees once it is written.
    void roundingTurnsNothingBack() {
        QFETCH(QString, dialect);
        QFETCH(bool, inch);
        const double digit = inch ? 25.4e-4 : 1e-3; // mm
        NcProgram program = referenceJob(unitsOf(inch), 1);
        std::vector<NcMove>& moves = program.sections.front().moves;
        const glm::dvec2 far(inch ? 5.08 : 3.0, 0.0); // the issue's own example, in steps of the last digit
        moves = {rapidTo(0, 0, 10),
                 lineTo(0, 0, -1, 300),
                 lineTo(far.x, 0, -1, 300),
                 lineTo(far.x + 0.6 * digit, -0.6 * digit, -1, 300),
                 lineTo(far.x + 0.4 * digit, 0.4 * digit, -1, 300),
                 lineTo(far.x + 2.0, 1.0, -1, 300)};
        const auto example = posted(dialect.toStdString(), program);
        QVERIFY(example);
        QCOMPARE(backStepsAmong(placesIn(*example, inch)), std::size_t{0});
        QVERIFY(rc::check("no turn back, and no point left by more than two and a half steps", [&] {
            moves = {rapidTo(0, 0, 10), lineTo(0, 0, -1, 300)};
            double heading = 0.0;
            glm::dvec3 at(0.0, 0.0, -1.0);
            const int count = *rc::gen::inRange(3, 150);
            for (int i = 0; i < count; ++i) {
                const double length = 0.012 * std::pow(12.0, *rc::gen::inRange(0, 1000) / 1000.0);
                heading += *rc::gen::inRange(-154000, 154000) / 1000.0 * std::acos(-1.0) / 180.0;
                at += length * glm::dvec3(std::cos(heading), std::sin(heading), 0.0);
                moves.push_back(lineTo(at.x, at.y, at.z, 300));
            }
            const auto text = posted(dialect.toStdString(), program);
            RC_ASSERT(static_cast<bool>(text));
            const std::vector<glm::dvec3> places = placesIn(*text, inch);
            RC_ASSERT(backStepsAmong(places) == 0U);
            for (const NcMove& move : moves)
                if (move.kind == NcMoveKind::line)
                    RC_ASSERT(distanceToLine(move.target.linear(), places) < 2.5 * digit);
        }));
    }

    void flatArcsStayArcs_data() { addDialects(); }
    /// The rounded ends rotate a short chord, which moves the centre of a large radius far along it, with hardly any
    /// effect on the path. Ends and centres are multiples of a control's resolution in millimetres, as for fitted arcs.
    void flatArcsStayArcs() {
        QFETCH(QString, dialect);
        QFETCH(bool, inch);
        NcProgram program = referenceJob(unitsOf(inch), 1);
        std::vector<NcMove>& moves = program.sections.front().moves;
        moves = {rapidTo(0, 0, 10), lineTo(0, 0, -1, 300)};
        std::mt19937 random(7);
        std::uniform_real_distribution<double> share(0.0, 1.0);
        const auto figure = [](double value) { return std::round(value * 1000.0) / 1000.0; };
        constexpr int count = 200;
        glm::dvec3 at(0.0, 0.0, -1.0);
        for (int i = 0; i < count; ++i) {
            const double radius = 3.0 * std::pow(30.0, share(random)), chord = 0.4 + 2.0 * share(random);
            const double heading = 6.28 * share(random), sweep = 2.0 * std::asin(0.5 * chord / radius);
            const glm::dvec3 centre = at - radius * glm::dvec3(std::cos(heading), std::sin(heading), 0.0);
            const double end = heading + sweep;
            NcMove move =
                lineTo(figure(centre.x + radius * std::cos(end)), figure(centre.y + radius * std::sin(end)), -1, 300);
            move.kind = NcMoveKind::arc;
            move.arc = {{figure(centre.x), figure(centre.y), -1.0}, 2, false};
            at = move.target.linear();
            moves.push_back(move);
        }
        const auto text = posted(dialect.toStdString(), program);
        QVERIFY(text);
        const auto parsed = parseProgram(*text, "job", *findControl(dialect.toStdString()));
        QVERIFY(parsed);
        const auto arcs =
            std::ranges::count_if(parsed->motions, [](const NcMotion& one) { return one.kind == NcMotionKind::arc; });
        qInfo() << arcs << "of" << count;
        QVERIFY(arcs >= count * 95 / 100 && arcs <= count * 105 / 100);
    }

    void whatIsReadBackIsWhatWasMeant_data() { addDialects(); }
    void whatIsReadBackIsWhatWasMeant() {
        QFETCH(QString, dialect);
        QFETCH(bool, inch);
        const Control& control = *findControl(dialect.toStdString());
        QVERIFY(rc::check("every move within half the last digit, every arc on its circle", [&] {
            const NcProgram program = randomJob(unitsOf(inch));
            const auto text = posted(dialect.toStdString(), program);
            RC_ASSERT(static_cast<bool>(text));
            const auto parsed = parseProgram(*text, "job", control);
            if (!parsed) RC_LOG() << *text << parsed.error().place << parsed.error().detail;
            RC_ASSERT(static_cast<bool>(parsed));
            const double half = (inch ? 25.4e-4 : 1e-3) * 0.5 + 1e-9;
            const auto& moves = program.sections.front().moves;
            const auto& motions = parsed->motions;
            std::size_t at = 0;
            while (at < motions.size() &&
                   (motions[at].kind == NcMotionKind::dwell || !motions[at].toKnown.has(Axis::x) ||
                    !motions[at].toKnown.has(Axis::z) || std::abs(motions[at].to[Axis::z] - 60.0) > half))
                ++at; // up and across
            RC_ASSERT(at < motions.size());
            glm::dvec3 from = moves.front().target.linear();
            for (const NcMove& move : moves) {
                const auto reached = [&](const glm::dvec3& place) {
                    return glm::all(glm::lessThanEqual(glm::abs(place - move.target.linear()), glm::dvec3(half)));
                };
                const Arc arc{from, move.target.linear(), move.arc.centre, move.arc.axis, move.arc.clockwise};
                NcMotion wanted;
                wanted.kind = NcMotionKind::arc;
                wanted.from = AxisValues(arc.from);
                wanted.to = AxisValues(arc.to);
                wanted.centre = arc.centre;
                wanted.arcAxis = static_cast<std::uint8_t>(arc.axis);
                wanted.clockwise = arc.clockwise;
                const double trueWay = move.kind == NcMoveKind::arc ? lengthOf(wanted) : 0.0;
                const bool full = trueWay > 8.0 * half;
                // A move that is rounded to zero length has no block; an arc has at least one.
                bool arrived = reached(motions[at].to.linear()) && !full;
                double way = 0.0;
                while (!arrived) {
                    RC_ASSERT(++at < motions.size());
                    const NcMotion& motion = motions[at];
                    RC_ASSERT(motion.rapid() == (move.kind == NcMoveKind::rapid));
                    if (!motion.rapid()) {
                        const double step = inch ? 25.4 * 0.01 : 0.1;
                        RC_ASSERT(std::abs(motion.feed - move.feed) <= 0.5 * step + 1e-9);
                    }
                    if (move.kind == NcMoveKind::arc) {
                        RC_ASSERT(distanceToArc(motion.to.linear(), arc) <= 2.0 * half + lineDoubt);
                        if (motion.kind == NcMotionKind::arc) {
                            const ArcTurn turn = motion.turn();
                            RC_ASSERT(std::abs(turn.startRadius - turn.endRadius) <= 0.002);
                            RC_ASSERT(motion.clockwise == move.arc.clockwise && motion.arcAxis == move.arc.axis);
                            const glm::dvec3 middle = placeOn(motion.arc(), turn, 0.5);
                            RC_ASSERT(distanceToArc(middle, arc) <= (inch ? 0.008 : 0.005));
                        }
                    }
                    way += lengthOf(motion);
                    arrived = reached(motion.to.linear()) && (!full || way >= 0.5 * trueWay);
                }
                // No turn is lost or added; each end and each centre is rounded.
                if (full) RC_ASSERT(std::abs(way - trueWay) <= 0.02 * trueWay + 16.0 * half);
                from = move.target.linear();
            }
        }));
    }

    void grblTakesWhatIsPostedForIt() {
        QVERIFY(rc::check("no line of a random job is refused", [] {
            const auto text =
                posted("grbl", randomJob(*rc::gen::inRange(0, 2) == 0 ? NcUnits::inch : NcUnits::millimetre));
            RC_ASSERT(static_cast<bool>(text));
            const GrblVerdict verdict = grblVerdict(*text);
            RC_LOG() << *text << "error " << verdict.error << " in line " << verdict.line;
            RC_ASSERT(verdict.error == 0);
        }));
    }

    void linuxCncTakesWhatIsPostedForIt() {
        if (!CanonicalProgram::available()) QSKIP("rs274 (package linuxcnc-uspace) is not installed");
        for (const NcUnits units : {NcUnits::millimetre, NcUnits::inch}) {
            NcProgram program = referenceJob(units);
            program.sections[1].toolNumber = 5; // in rs274's table
            const auto text = posted("linuxcnc", program);
            QVERIFY(text);
            const CanonicalProgram truth = CanonicalProgram::ofText(*text);
            QVERIFY2(truth.exitCode == 0, qPrintable(truth.complaint));
        }
    }

    void strangersProgramsGetGrblsVerdict_data() {
        QTest::addColumn<QString>("file");
        QTest::addColumn<int>("error");
        // Results of GRBL 1.1h's own parser.
        QTest::newRow("tball") << "tball.gcode" << 0;
        QTest::newRow("tball-engrave") << "tball-engrave.gcode" << 0;
        QTest::newRow("jsdc") << "jsdc.gcode" << 0;
        QTest::newRow("circle-inch") << "circle-inch.gcode" << 0;
        QTest::newRow("arc-zx-plane") << "arc-zx-plane.nc" << 0;
        QTest::newRow("full circles") << "full-circle-without-xyz.gcode" << 26;
        QTest::newRow("thread") << "helical-thread-milling.gcode" << 20;
        QTest::newRow("circle-diamond-square") << "circle-diamond-square.gcode" << 33;
        QTest::newRow("g92offset") << "g92offset.nc" << 26;
        QTest::newRow("special fields") << "special-fields.gcode" << 1;
        QTest::newRow("expressions") << "nist-expressions.ngc" << 2;
        QTest::newRow("cycles") << "nist-cycles.ngc" << 20;
    }
    void strangersProgramsGetGrblsVerdict() {
        QFETCH(QString, file);
        QFETCH(int, error);
        const auto text = readFile((QString(BURIN_FIXTURES "/gcode/") + file).toStdString());
        QVERIFY(text);
        const GrblVerdict verdict = grblVerdict(*text);
        QCOMPARE(verdict.error, error);
        MachineState atZero;
        atZero.place = {0.0, 0.0, 0.0};
        atZero.workOffsets[54] = {0.0, 0.0, 0.0};
        atZero.lengthOffset = 0.0;
        const auto program = parseProgram(*text, "job", *findControl("grbl"), atZero);
        QCOMPARE(static_cast<bool>(program), error == 0);
        if (!program)
            QVERIFY2(program.error().place.starts_with("line " + std::to_string(verdict.line) + ","),
                     program.error().place.c_str());
    }

    void grblHasNoToolChange() {
        const auto text = posted("grbl", referenceJob(NcUnits::millimetre, 2));
        QVERIFY(!text);
        QCOMPARE(text.error().code, ErrorCode::notSupported);
        NcProgram sameTool = referenceJob(NcUnits::millimetre, 2);
        sameTool.sections[1].toolNumber = sameTool.sections[0].toolNumber;
        QVERIFY(posted("grbl", sameTool));
    }

    /// A control's requirements for every program, as a pattern that its text must or must not contain.
    void theTextKeepsItsControlsRules_data() {
        QTest::addColumn<QString>("dialect");
        QTest::addColumn<QString>("pattern");
        QTest::addColumn<bool>("there");
        const auto row = [](const char* name, const char* dialect, const char* pattern, bool there) {
            QTest::newRow((std::string(dialect) + ": " + name).c_str()) << dialect << pattern << there;
        };
        for (const std::string& id : ids) {
            const char* dialect = id.c_str();
            row("an end", dialect, "^M(2|30)$", true);
            row("no radius words", dialect, "^[^(]*R[0-9.]", false);
            row("both offsets of an XY arc", dialect, "^(G0?[23] )?X[^ ]+ Y[^ ]+( Z[^ ]+)? I[^ ]+ J[^ ]+( F[^ ]+)?$",
                true);
            row("no third offset", dialect, "I.*J.*K", false);
            row("plane words stand before their arcs", dialect, "^G18\nG0?2 X", true);
            row("plain ASCII", dialect, "[^\\x20-\\x7E\\n]", false);
        }
        for (const char* dialect : {"linuxcnc", "grbl", "grblhal", "mach"}) {
            row("incremental centres are stated", dialect, "G91\\.1", true);
            row("no tape mark", dialect, "%", false);
            row("dwell in seconds", dialect, "^G4 P0\\.5$", true);
            row("three decimals", dialect, "^X-4\\.000 F1234\\.6$", true);
        }
        for (const char* dialect : {"linuxcnc", "grblhal", "fanuc", "haas", "mach"})
            row("the spindle stops before the tool is changed", dialect, "^M0?5\n(?:(?!M0?[34]$)(?s:.))*^T12 M0?6$",
                true);
        for (const char* dialect : {"fanuc", "haas"}) {
            row("tape marks", dialect, "\\A%\nO0", true);
            row("ends by a tape mark", dialect, "M30\n%\n\\z", true);
            row("dwell in milliseconds", dialect, "^G04 P500$", true);
            row("a point on every length and feed", dialect, "[XYZIJKF]-?[0-9]+( |$)", false);
            row("upper case", dialect, "[a-z]", false);
            row("leading zeros", dialect, "^G01 ", true);
            row("X Y before Z behind a tool change", dialect, "^G00 X[^ ]+ Y[^ ]+\nG43 Z60\\. H", true);
            row("work offset with each tool", dialect, "^G54$", true);
        }
        row("four digits of the program", "fanuc", "^O[0-9]{4}$", true);
        row("home by G28", "fanuc", "^G28 G91 Z0\\.\nG90$", true);
        row("AI contour control before G43, off behind G49", "fanuc", "^G05\\.1 Q1\n(?s:.)*G43(?s:.)*G49\nG05\\.1 Q0$",
            true);
        row("five digits of the program", "haas", "^O[0-9]{5}$", true);
        row("home by G53", "haas", "^G53 G00 Z0\\.$", true);
        row("smoothing and back", "haas", "^G187 P3 E0\\.01\n(?s:.)*^G187$", true);
        row("blending", "linuxcnc", "^G64 P0\\.01 Q0\\.01$", true);
        row("length offset of the tool", "linuxcnc", "^T3 M6\nG43 H3$", true);
        row("no G43", "grbl", "G43", false);
        row("no G64", "grbl", "G64", false);
        row("no tool change", "grbl", "M6", false);
        row("no G64", "grblhal", "G64", false);
        row("constant velocity, without a tolerance", "mach", "^G64$", true);
    }
    void theTextKeepsItsControlsRules() {
        QFETCH(QString, dialect);
        QFETCH(QString, pattern);
        QFETCH(bool, there);
        const auto text = posted(dialect.toStdString(), jobFor(dialect.toStdString()));
        QVERIFY(text);
        QString blocks;
        for (const QString& line : QString::fromStdString(*text).split('\n', Qt::SkipEmptyParts))
            if (!line.startsWith('(')) blocks += line + '\n';
        const QRegularExpression rule(pattern, QRegularExpression::MultilineOption);
        QVERIFY2(rule.isValid(), qPrintable(rule.errorString()));
        QCOMPARE(rule.match(blocks).hasMatch(), there);
    }

    void workOffsetsAreWordedOrRefused_data() {
        QTest::addColumn<QString>("dialect");
        QTest::addColumn<int>("offset");
        QTest::addColumn<QString>("words"); // empty: refused
        for (const std::string& id : ids)
            QTest::newRow((id + " G59").c_str()) << QString::fromStdString(id) << 59 << "G59";
        QTest::newRow("linuxcnc G59.3") << "linuxcnc" << 593 << "G59.3";
        QTest::newRow("grblhal G59.1") << "grblhal" << 591 << "G59.1";
        QTest::newRow("grbl G59.1") << "grbl" << 591 << "";
        QTest::newRow("fanuc G54.1 P7") << "fanuc" << 1007 << "G54.1 P7";
        QTest::newRow("fanuc beyond") << "fanuc" << 1049 << "";
        QTest::newRow("haas G154 P20") << "haas" << 1020 << "G154 P20";
        QTest::newRow("mach G54.1") << "mach" << 1001 << "";
    }
    void workOffsetsAreWordedOrRefused() {
        QFETCH(QString, dialect);
        QFETCH(int, offset);
        QFETCH(QString, words);
        NcProgram program = referenceJob(NcUnits::millimetre, 1);
        program.workOffset = offset;
        const auto text = posted(dialect.toStdString(), program);
        QCOMPARE(static_cast<bool>(text), !words.isEmpty());
        if (!text) {
            QCOMPARE(text.error().code, ErrorCode::notSupported);
            return;
        }
        QVERIFY(QString::fromStdString(*text).contains(words));
        const auto parsed = parseProgram(*text, "job", *findControl(dialect.toStdString()));
        QVERIFY(parsed);
        QCOMPARE(parsed->workOffset, offset);
    }

    void longSweepsAreSplit() {
        for (const std::string& id : ids) {
            const auto text = posted(id, jobFor(id));
            QVERIFY(text);
            const auto parsed = parseProgram(*text, "job", *findControl(id));
            QVERIFY(parsed);
            const double largest = id == "fanuc" || id == "mach" ? 180.0 : id == "haas" ? 355.0 : 360.0;
            for (const NcMotion& motion : parsed->motions)
                if (motion.kind == NcMotionKind::arc)
                    QVERIFY(std::abs(motion.turn().sweep) <= largest * 3.14159265358979 / 180.0 + 1e-3);
        }
    }

private:
    static constexpr double lineDoubt = 0.001; // mm, of lines that replace an arc
};

BURIN_TEST(TestDialects, QCoreApplication)

} // namespace burin::tst_dialects

#include "tst_dialects.moc"

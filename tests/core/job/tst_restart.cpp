// SPDX-FileCopyrightText: 2026 The Burin authors
// SPDX-License-Identifier: Apache-2.0
#include "core/geometry/arc.h"
#include "core/job/job_paths.h"
#include "core/job/restart_job.h"
#include "tests/core/geometry/shapes.h"
#include "tests/core/job/session_milling.h"
#include "tests/core/path/path_fixture.h"
#include "tests/long_run.h"
#include "tests/oracles/canonical_program.h"
#include "tests/oracles/grbl_rules.h"
#include "tests/test_program.h"

#include <QRegularExpression>
#include <QtTest>

#include <algorithm>
#include <cmath>
#include <map>
#include <random>
#include <sstream>

namespace burin::tst_restart {

using namespace burin::test;

namespace {

constexpr double radius = 2.0, tolerance = 0.005; // mm: of both cutters; of the workpiece
constexpr double halfSide = 20.0, height = 10.0;  // mm: of the block; program zero is the centre of its top

/// Lines, arcs in three planes, a full circle, a helix, plunges, links, canned cycles, a dwell, a second tool.
constexpr const char* program = R"((interrupted)
G17 G21 G40 G49
G54 G80 G90 G91.1 G94
G64 P0.005 Q0.005
(first tool)
T1 M6
G43 H1
S8000 M3
G4 P1
M8
G0 Z30
X-14 Y-14
Z2
G1 Z-1 F150
X14 F400
G3 X14 Y-6 I0 J4
G1 X-6
G2 X-6 Y-6 I0 J3
G3 X-10 Y-2 Z-2 I0 J4 F300
G1 X-14 Z-2.5
G18 G2 X-12 Z-2.5 I1 K0
G17 G1 Y2

(a link)
G0 Z1
X-12 Y8
G1 Z-1.5 F150
Y14 F500
G4 P0.2
X-4 Y15
G0 Z30
G0 X2 Y6
G98 G81 X2 Y6 Z-3 R1 F120
X8
X14 Y9
G80
G0 Z30
M5
M9
(second tool)
T2 M6
G43 H2
S6000 M3
G4 P1
G0 Z30
X3 Y2
Z2
G91
G1 Z-3 F100
X2 F350
X1 Y0.5
X3 Y-1
G3 X2 Y2 I0 J2
G90
G1 X14 Y2
X3 Y-3
G0 Z30
M5
M9
M2
)";

Tool flat(int number) {
    Tool tool = sessionTool();
    tool.id = "flat-" + std::to_string(number);
    tool.number = number;
    tool.cutter.type = CutterType::flat;
    tool.cutter.cornerRadius = 0.0;
    return tool;
}

/// A block with a part low in it, which the tool never comes near.
MillingContext milling(const Tool& tool) {
    Body body;
    body.name = "plate";
    body.box = {{5.0, 5.0, 1.0}, {35.0, 35.0, 3.0}};
    body.mesh = shapes::box(body.box.low, body.box.high);
    Model model;
    model.bodies = {body};
    Setup setup = blockSetup();
    setup.stock = {glm::dvec3(0.0), {2.0 * halfSide, 2.0 * halfSide, height}};
    setup.workOffset = {halfSide, halfSide, height};
    Progress progress;
    Result<MillingContext> made =
        makeMillingContext({std::make_shared<const Model>(model), setup, tool, "linuxcnc-mill", {}, {}}, progress);
    if (!made) std::abort(); // the test's own set-up
    return std::move(*made);
}

ProgramRequest request(std::vector<Tool> tools) {
    ProgramRequest wanted;
    wanted.name = "again.ngc";
    wanted.tools = std::move(tools);
    return wanted;
}

std::vector<std::string> linesOfText(const std::string& text) {
    std::vector<std::string> lines;
    std::istringstream stream(text);
    for (std::string line; std::getline(stream, line);) lines.push_back(line);
    return lines;
}

/// The lines before the given one, as a program of their own.
std::string textBefore(const std::string& text, std::uint32_t line) {
    std::string before;
    const std::vector<std::string> lines = linesOfText(text);
    for (std::uint32_t i = 1; i < line && i <= lines.size(); ++i) before += lines[i - 1] + "\n";
    return before + "M2\n";
}

/// Height map of the block's top over a grid of points, cut by the moves that LinuxCNC's interpreter computes from
/// programs, with flat cutters.
class HeightMap {
public:
    explicit HeightMap(double cutterRadius) : radius_(cutterRadius), tops_(cells * cells, 0.0) {}

    /// @return mm, largest depth removed by a rapid
    double cut(const CanonicalProgram& from) {
        double torn = 0.0;
        glm::dvec3 at{0.0, 0.0, 100.0};
        bool known = false; // the start of the first move is unknown
        for (const CanonicalMove& move : from.moves) {
            if (move.kind == CanonicalKind::dwell) continue;
            const glm::dvec3 to = move.to * move.unit;
            std::vector<glm::dvec3> way;
            if (move.kind == CanonicalKind::arc) {
                way = along(at, to, move);
            } else {
                const int steps = known ? std::max(1, static_cast<int>(glm::distance(at, to) / step)) : 1;
                for (int i = 1; i <= steps; ++i) way.push_back(glm::mix(at, to, double(i) / steps));
            }
            for (const glm::dvec3& tip : way) {
                const double taken = cutAt(tip);
                if (move.kind == CanonicalKind::rapid) torn = std::max(torn, taken);
            }
            known = true;
            at = to;
        }
        return torn;
    }

    /// The greatest amount by which this one is below the other.
    double below(const HeightMap& other) const {
        double most = 0.0;
        for (std::size_t i = 0; i < tops_.size(); ++i) most = std::max(most, other.tops_[i] - tops_[i]);
        return most;
    }

private:
    static constexpr double cell = 0.2, step = 0.05; // mm
    static constexpr std::size_t cells = 200;

    std::vector<glm::dvec3> along(const glm::dvec3& from, const glm::dvec3& to, const CanonicalMove& move) const {
        const Arc arc{from, to, move.centre * move.unit, move.axis, move.turns < 0};
        std::vector<glm::dvec3> places;
        flatten(arc, 1e-4, places);
        return places;
    }
    double cutAt(const glm::dvec3& tip) {
        double most = 0.0;
        const auto first = [&](double centre) {
            return static_cast<std::size_t>(std::clamp((centre - radius_ + halfSide) / cell - 1.0, 0.0, double(cells)));
        };
        const auto last = [&](double centre) {
            return static_cast<std::size_t>(std::clamp((centre + radius_ + halfSide) / cell + 1.0, 0.0, double(cells)));
        };
        for (std::size_t j = first(tip.y); j < last(tip.y); ++j)
            for (std::size_t i = first(tip.x); i < last(tip.x); ++i) {
                const glm::dvec2 place(-halfSide + cell * (double(i) + 0.5), -halfSide + cell * (double(j) + 0.5));
                double& top = tops_[j * cells + i];
                if (glm::distance(place, glm::dvec2(tip)) > radius_ || top <= tip.z) continue;
                most = std::max(most, top - tip.z);
                top = tip.z;
            }
        return most;
    }

    double radius_;
    std::vector<double> tops_;
};

HeightMap milled(double cutterRadius, std::initializer_list<const CanonicalProgram*> programs) {
    HeightMap map(cutterRadius);
    for (const CanonicalProgram* one : programs) map.cut(*one);
    return map;
}

/// The fault of the rest of a program from a line on: it does not pass the check, LinuxCNC's interpreter refuses it, or
/// the interpreter's moves for the lines before and for the rest produce another workpiece. Empty: no fault.
std::string faultOfRestart(const Result<RestartedProgram>& rest, const std::string& text, std::uint32_t line,
                           const HeightMap& whole) {
    const std::string told = "line " + std::to_string(line) + ": ";
    if (!rest) return told + rest.error().place + " " + rest.error().detail;
    const std::string shown = "\n" + rest->program.text;
    if (!rest->program.passed()) return told + "not passed" + shown;
    const CanonicalProgram before = CanonicalProgram::ofText(textBefore(text, line));
    const CanonicalProgram after = CanonicalProgram::ofText(rest->program.text);
    if (after.exitCode != 0) return told + after.complaint.toStdString() + shown;
    if (milled(radius - tolerance, {&before, &after}).below(whole) > tolerance) return told + "cuts more" + shown;
    if (whole.below(milled(radius + tolerance, {&before, &after})) > tolerance) return told + "cuts less" + shown;
    HeightMap narrow = milled(radius - tolerance, {&before});
    return narrow.cut(after) > 0.0 ? told + "a rapid cuts" + shown : std::string();
}

/// A hand's strokes with one tool, with the links and feeds of a path.
PathMatter matterOfHand(std::int64_t id, const Tool& tool, const std::vector<glm::dvec3>& corners, bool arcs) {
    PathMatter matter;
    matter.path.id = id;
    matter.path.sources = {{id}};
    matter.path.edits = {{Simplify{}}};
    if (arcs) matter.path.edits.push_back({FitArcs{}});
    matter.path.edits.push_back({Link{}});
    matter.path.edits.push_back({SetFeed{.cooling = id == 1 ? SetFeed::Cooling::flood : SetFeed::Cooling::off}});
    matter.tool = tool;
    Take take = takeOf(along(corners, 50.0));
    take.info.id = id;
    take.info.toolId = tool.id;
    matter.sources = {*recordedStrokes(take)};
    return matter;
}

/// Rows of an unsteady hand.
std::vector<glm::dvec3> rows() {
    std::vector<glm::dvec3> corners;
    for (int row = 0; row < 7; ++row)
        for (int i = 0; i <= 20; ++i) {
            const double along = row % 2 == 0 ? i : 20.0 - i;
            corners.emplace_back(4.0 + 1.5 * along, 8.0 + 3.5 * row + 0.4 * std::sin(1.7 * along + row),
                                 8.2 - 0.15 * row + 0.1 * std::cos(2.3 * along));
        }
    return corners;
}

/// A third of a recorded take, at a lower speed and without coolant.
SpindleAndCoolant aPart(const PathMatter& matter) {
    const std::int64_t last = matter.sources[0].strokes.back().points.back().sample;
    SpindleAndCoolant edit;
    edit.interval = {matter.path.id, last / 3, 2 * last / 3};
    edit.speed = 5000.0;
    edit.cooling = SpindleAndCoolant::Cooling::off;
    return edit;
}

/// Three levels, each of rings about one centre, from the inner one to the outer one.
std::vector<glm::dvec3> levels() {
    std::vector<glm::dvec3> corners;
    for (int level = 1; level <= 3; ++level)
        for (const double ring : {2.0, 4.5, 7.0})
            for (int i = 0; i <= 120; ++i) {
                const double angle = 2.0 * pi * i / 120.0;
                corners.emplace_back(20.0 + ring * std::cos(angle), 18.0 + ring * std::sin(angle),
                                     height - 0.8 * level);
            }
    return corners;
}

/// The last word of each kind in a text up to a line, by letter, found by text search alone: the spindle, coolant,
/// tool, offsets and unit in force there.
std::map<QString, QString> modalWords(const std::string& text, std::uint32_t line) {
    static const QRegularExpression comment(R"(\([^)]*\)|;.*)"),
        word(R"((S\d+|T\d+|H\d+|M0?[345]|M0?[789]|G5[4-9]|G2[01])(?![.\d]))");
    std::map<QString, QString> words;
    const std::vector<std::string> lines = linesOfText(text);
    for (std::uint32_t i = 0; i < line && i < lines.size(); ++i) {
        auto found = word.globalMatch(QString::fromStdString(lines[i]).remove(comment));
        while (found.hasNext()) {
            const QString one = found.next().captured(1);
            const bool coolant = one[0] == 'M' && one.back() >= '7';
            words[coolant ? QString("coolant") : one.startsWith("G5") ? QString("offset") : one.left(1)] = one;
        }
    }
    const auto coolant = words.find("coolant");
    if (coolant != words.end() && coolant->second.endsWith('9')) words.erase(coolant); // off, as if not stated
    return words;
}

/// Line of the first cut, found by text search.
std::uint32_t firstCutIn(const std::string& text) {
    static const QRegularExpression cut("(^|\\s)G0?[123](?![.\\d])");
    const std::vector<std::string> lines = linesOfText(text);
    for (std::uint32_t i = 0; i < lines.size(); ++i)
        if (cut.match(QString::fromStdString(lines[i])).hasMatch()) return i + 1;
    return 0;
}

/// Returns the line of the comment after which the remainder continues with a line of the interrupted program.
std::uint32_t goesOnIn(const std::string& text, std::uint32_t line) {
    const std::string comment = "(Line " + std::to_string(line) + " of the interrupted program)";
    const std::vector<std::string> lines = linesOfText(text);
    return static_cast<std::uint32_t>(std::ranges::find(lines, comment) - lines.begin()) + 1;
}

} // namespace

/// A program that continues after a broken tool makes the part that the first one would have made.
class TestRestart : public QObject {
    Q_OBJECT
private slots:
    void theRestMakesTheSameWorkpiece_data() {
        QTest::addColumn<bool>("inch");
        QTest::newRow("mm") << false;
        QTest::newRow("inch") << true;
    }
    /// From every line, in inches from every fourth: the rest is accepted by LinuxCNC's interpreter, and its moves
    /// produce the same workpiece; no rapid cuts.
    void theRestMakesTheSameWorkpiece() {
        if (!CanonicalProgram::available()) QSKIP("rs274 (package linuxcnc-uspace) is not installed");
        QFETCH(bool, inch);
        const MillingContext block = milling(flat(1));
        ProgramRequest wanted = request({flat(1), flat(2)});
        if (inch) wanted.units = NcUnits::inch;
        const CanonicalProgram whole = CanonicalProgram::ofText(program);
        QCOMPARE(whole.exitCode, 0);
        const HeightMap wholeMap = milled(radius, {&whole});
        std::uint32_t restarted = 0;
        const auto lines = static_cast<std::uint32_t>(linesOfText(program).size());
        for (std::uint32_t line = 1; line <= lines; ++line) {
            const bool behindLastCut = line > 56;
            if (inch && !behindLastCut && line % testing::inLongRun(1U, 4U) != 0) continue;
            if (behindLastCut) {
                Progress progress;
                const Result<RestartedProgram> rest = makeRestart(block, program, line, wanted, progress);
                QVERIFY(!rest && rest.error().code == ErrorCode::argumentInvalid);
                QCOMPARE(rest.error().detail, std::string("1 to 56, the line of the last cut"));
                continue;
            }
            Progress progress;
            const std::string fault =
                faultOfRestart(makeRestart(block, program, line, wanted, progress), program, line, wholeMap);
            QVERIFY2(fault.empty(), fault.c_str());
            ++restarted;
        }
        QCOMPARE(restarted, inch ? testing::inLongRun(56U, 14U) : 56U);
    }

    void aPostedProgramGoesOnFromAnyLine_data() {
        QTest::addColumn<QString>("dialect");
        QTest::addColumn<bool>("inch");
        QTest::addColumn<bool>("inLevels"); // with arcs
        QTest::addColumn<int>("tools");
        QTest::addColumn<bool>("section"); // a part with its own speed and coolant
        QTest::newRow("rows") << "linuxcnc" << false << false << 1 << false;
        QTest::newRow("levels with a part at another speed") << "linuxcnc" << false << true << 1 << true;
        QTest::newRow("levels of arcs and rows, two tools, inch") << "linuxcnc" << true << true << 2 << false;
        QTest::newRow("levels of arcs, GRBL") << "grbl" << false << true << 1 << false;
    }
    /// Programs that Burin posts from a hand's paths, restarted at random lines: spindle, coolant, tool, offset and
    /// unit are those of the line, the tool comes from above, and the workpiece is the same.
    void aPostedProgramGoesOnFromAnyLine() {
        if (!CanonicalProgram::available()) QSKIP("rs274 (package linuxcnc-uspace) is not installed");
        QFETCH(QString, dialect);
        QFETCH(bool, inch);
        QFETCH(bool, inLevels);
        QFETCH(int, tools);
        const MillingContext block = milling(flat(1));
        std::vector<PathMatter> matters{matterOfHand(1, flat(1), inLevels ? levels() : rows(), inLevels)};
        QFETCH(bool, section);
        if (section) matters[0].path.edits.push_back({aPart(matters[0])});
        if (tools == 2) matters.push_back(matterOfHand(2, flat(2), rows(), false));
        Progress progress;
        const Result<EvaluatedPaths> paths = evaluateInOrder(block, matters, progress);
        QVERIFY(paths);
        ProgramRequest wanted = request(paths->program.tools);
        wanted.dialect = dialect.toStdString();
        if (inch) wanted.units = NcUnits::inch;
        const Result<CheckedProgram> posted = makeProgram(block, paths->program, wanted, progress);
        QVERIFY2(posted && posted->passed(), posted ? posted->text.c_str() : posted.error().detail.c_str());
        const auto isArc = [](const NcMotion& one) { return one.kind == NcMotionKind::arc; };
        QCOMPARE(std::ranges::any_of(posted->parsed.motions, isArc), inLevels);
        const CanonicalProgram whole = CanonicalProgram::ofText(posted->text);
        QCOMPARE(whole.exitCode, 0);
        const HeightMap wholeMap = milled(radius, {&whole});
        const auto last = std::find_if(posted->parsed.motions.rbegin(), posted->parsed.motions.rend(),
                                       [](const NcMotion& one) { return !one.rapid(); });
        QVERIFY(last->line > 30);
        std::mt19937 random(7);
        for (int i = 0; i < testing::inLongRun(20, 6); ++i) {
            const std::uint32_t line = 1 + static_cast<std::uint32_t>(random() % last->line);
            const Result<RestartedProgram> rest = makeRestart(block, posted->text, line, wanted, progress);
            const std::string fault = faultOfRestart(rest, posted->text, line, wholeMap);
            QVERIFY2(fault.empty(), fault.c_str());
            const std::string& again = rest->program.text; // its lead-in may have the speed before the part
            const std::uint32_t first = section ? goesOnIn(again, rest->line) : firstCutIn(again);
            QCOMPARE(modalWords(again, first), modalWords(posted->text, rest->line));
            if (dialect == "grbl") QCOMPARE(grblVerdict(rest->program.text).error, 0);
        }
    }

    /// The tool reaches the path before the line, with the spindle, coolant and offsets that the program had there.
    void theCutIsLedInto() {
        const MillingContext block = milling(flat(1));
        Progress progress;
        const Result<RestartedProgram> rest =
            makeRestart(block, program, 17, request({flat(1), flat(2)}), progress); // G1 X-6
        QVERIFY(rest);
        QCOMPARE(rest->line, 17U);
        QCOMPARE(rest->lead, 5.0);
        const std::vector<NcMotion>& motions = rest->program.parsed.motions;
        const auto cut = std::find_if(motions.begin(), motions.end(),
                                      [](const NcMotion& one) { return one.kind == NcMotionKind::arc; });
        QVERIFY(cut != motions.end());
        // 5 mm of the half circle about (14, -10) lie before (14, -6).
        const double angle = 0.5 * pi - 5.0 / 4.0;
        QVERIFY(glm::distance(cut->from.linear(),
                              glm::dvec3(14.0 + 4.0 * std::cos(angle), -10.0 + 4.0 * std::sin(angle), -1.0)) < 0.002);
        QVERIFY(cut->to == AxisValues(14.0, -6.0, -1.0));
        QVERIFY(cut->spindle == SpindleState::clockwise && cut->flood);
        QCOMPARE(cut->spindleSpeed, 8000.0);
        QCOMPARE(cut->tool, 1);
        QCOMPARE(cut->workOffset, 54);
        QCOMPARE(cut->lengthOffset, 1);
        QCOMPARE((cut - 1)->feed, 120.0); // the lowest plunge feed of this tool anywhere in the program
        QVERIFY((cut - 2)->rapid() && (cut - 2)->to[Axis::z] == 2.0);
    }

    /// Where the spindle speed changes during a cut the tool stays in it, and every move has its original speed.
    void aSpeedThatChangesInTheCutDoesSoAgain() {
        const MillingContext block = milling(flat(1));
        std::string changing = program;
        changing.insert(changing.find("G1 X-6\n"), "S6000 M3\n");
        const auto cutsFrom = [](const ParsedProgram& parsed, std::uint32_t line) {
            std::vector<std::pair<AxisValues, double>> cuts;
            for (const NcMotion& one : parsed.motions)
                if (one.line >= line && !one.rapid() && one.kind != NcMotionKind::dwell)
                    cuts.emplace_back(one.to, one.spindleSpeed);
            return cuts;
        };
        const auto whole = parseProgram(changing, "whole", *findControl("linuxcnc"));
        QVERIFY(whole);
        for (const std::uint32_t line : {14U, 18U, 20U}) {
            Progress progress;
            const Result<RestartedProgram> rest =
                makeRestart(block, changing, line, request({flat(1), flat(2)}), progress);
            QVERIFY(rest);
            const auto wanted = cutsFrom(*whole, line), made = cutsFrom(rest->program.parsed, 0);
            QVERIFY(made.size() >= wanted.size());
            QVERIFY(std::equal(wanted.rbegin(), wanted.rend(), made.rbegin(), [](const auto& one, const auto& other) {
                return one.second == other.second && glm::distance(one.first.linear(), other.first.linear()) < 0.002;
            }));
            const std::string& text = rest->program.text;
            QCOMPARE(QString::fromStdString(text).count("T1 M6"), 1);
        }
    }

    /// So does coolant; if the program stops the spindle to change it, the remainder begins a new section.
    void coolantThatChangesInTheCutDoesSoAgain() {
        const MillingContext block = milling(flat(1));
        std::string changing = program;
        changing.insert(changing.find("G1 X-6\n"), "M9\nM7\n");
        const auto coolantsFrom = [](const ParsedProgram& parsed, std::uint32_t line) {
            std::string coolants;
            for (const NcMotion& one : parsed.motions)
                if (one.line >= line && !one.rapid() && one.kind != NcMotionKind::dwell)
                    coolants += one.flood ? 'F' : one.mist ? 'M' : '-';
            return coolants;
        };
        const auto whole = parseProgram(changing, "whole", *findControl("linuxcnc"));
        QVERIFY(whole);
        QVERIFY(coolantsFrom(*whole, 0).starts_with("FFFMMM"));
        for (const std::uint32_t line : {14U, 18U, 21U}) {
            Progress progress;
            const Result<RestartedProgram> rest =
                makeRestart(block, changing, line, request({flat(1), flat(2)}), progress);
            QVERIFY(rest);
            QVERIFY(coolantsFrom(rest->program.parsed, 0).ends_with(coolantsFrom(*whole, line)));
            QCOMPARE(QString::fromStdString(rest->program.text).count("T1 M6"), 1);
        }
        changing.insert(changing.find("(a link)\n"), "M5\nM9\nM8\nS8000 M3\n");
        Progress progress;
        const Result<RestartedProgram> stopped =
            makeRestart(block, changing, 14, request({flat(1), flat(2)}), progress);
        QVERIFY(stopped);
        QCOMPARE(QString::fromStdString(stopped->program.text).count("T1 M6"), 2);
    }

    /// Only the rest is cut: on a fresh workpiece the same text would cut through full stock.
    void itIsJudgedOnTheStockThatIsLeft() {
        const MillingContext block = milling(flat(1));
        Progress progress;
        const Result<RestartedProgram> rest =
            makeRestart(block, program, 41, request({flat(1), flat(2)}), progress); // only the second tool
        QVERIFY(rest && rest->program.passed());
        const Result<CheckedProgram> whole =
            checkProgram(block, program, "whole", request({flat(1), flat(2)}), progress);
        QVERIFY(whole && whole->passed());
        QVERIFY(rest->program.report.removed < 0.5 * whole->report.removed);
        QVERIFY(linesOf(rest->program.machined) == linesOf(whole->machined));
    }

    /// A cutter that is wider than its shank, below an edge: from above it would cut the edge off, so it enters as the
    /// program did.
    void aWideCutterGoesInFromTheSide() {
        Tool wide = flat(1);
        wide.cutter.type = CutterType::lollipop;
        wide.cutter.diameter = 6.0;
        wide.cutter.cornerRadius = 3.0;
        wide.cutter.fluteLength = 5.0;
        wide.cutter.shankDiameter = 3.0;
        wide.maximumDepthOfCut = 5.0; // mm
        QVERIFY(validate(wide));
        const std::string text =
            "G17 G21 G90 G94 G54\nT1 M6\nG43 H1\nS8000 M3\nG0 Z30\nX-30 Y-21.7\nZ-7\nG1 X-18 F300\n"
            "X-10\nX0\nX5\nX30\nG0 Z30\nM5\nM2\n";
        const MillingContext block = milling(wide);
        Progress progress;
        const Result<CheckedProgram> whole = checkProgram(block, text, "whole", request({wide}), progress);
        QVERIFY(whole && whole->passed());
        const Result<RestartedProgram> rest = makeRestart(block, text, 11, request({wide}), progress);
        QVERIFY(rest);
        QVERIFY2(rest->program.passed(), rest->program.text.c_str());
        QCOMPARE(rest->lead, 30.0); // from X-30 to X0
        QVERIFY(linesOf(rest->program.machined) == linesOf(whole->machined));
    }

    void whatCantBeRestartedIsRefused_data() {
        QTest::addColumn<QString>("text");
        QTest::addColumn<int>("line");
        QTest::addColumn<QString>("told");
        const QString start = "G17 G21 G90 G94 G54\nT1 M6\nG43 H1\nS8000 M3\nG0 Z30\nX0 Y0\nZ2\n";
        QTest::newRow("line 0") << start + "G1 Z-1 F100\nM2\n" << 0 << "1 to 9";
        QTest::newRow("a line that is not there") << start + "G1 Z-1 F100\nM2\n" << 10 << "1 to 9";
        QTest::newRow("a program that cuts nothing") << start + "M2\n" << 2 << "none";
        QTest::newRow("another work offset") << start + "G1 Z-1 F100\nG0 Z30\nG55\nG0 X0 Y0 Z30\nG1 Z29\nM2\n"
                                             << 8 << "work offset";
        QTest::newRow("corners taken otherwise") << start + "G1 Z-1 F100\nX1\nG61\nX2\nM2\n" << 8 << "path mode";
        QTest::newRow("a zero of its own") << start + "G10 L2 P1 X5\nG0 X0 Y0\nG1 Z-1 F100\nX1\nM2\n" << 10 << "zero";
        QTest::newRow("a spindle that stands") << start + "G1 Z-1 F100\nM5\nX1\nM2\n" << 8 << "spindle";
    }
    void whatCantBeRestartedIsRefused() {
        QFETCH(QString, text);
        QFETCH(int, line);
        QFETCH(QString, told);
        Progress progress;
        const Result<RestartedProgram> rest = makeRestart(
            milling(flat(1)), text.toStdString(), static_cast<std::uint32_t>(line), request({flat(1)}), progress);
        QVERIFY(!rest);
        const QString all = QString::fromStdString(rest.error().subject + rest.error().place + rest.error().detail);
        QVERIFY2(all.contains(told), qPrintable(all));
    }
};

BURIN_TEST(TestRestart, NoApplication)

} // namespace burin::tst_restart

#include "tst_restart.moc"

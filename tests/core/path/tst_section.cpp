// SPDX-FileCopyrightText: 2026 The Burin authors
// SPDX-License-Identifier: Apache-2.0
#include "core/geometry/arc.h"
#include "tests/core/path/path_fixture.h"
#include "tests/test_program.h"

#include <QTest>

#include <cmath>

namespace burin::tst_section {

using namespace burin::test;
using Cooling = SpindleAndCoolant::Cooling;

namespace {

constexpr double spindle = 6000.0; // 1/min, from the tables
constexpr SourceInterval second{1, 600, 1100}, middle{1, 725, 975};

PathContext shop() {
    static const MeshDistance nothing{TriangleMesh{}};
    PathContext context = contextOf(nothing, ballTool(), {{-100, -100, -50}, {100, 100, 0}});
    context.conditions.spindleSpeed = spindle;
    context.machine.name = "Mill";
    context.machine.minimumSpindleSpeed = 1000.0;
    context.machine.maximumSpindleSpeed = 10000.0;
    context.machine.coolants = std::vector{Coolant::flood};
    context.tool.maximumSpindleSpeed = 0.0;
    return context;
}

/// Three strokes of one take, 0.02 mm per tick: ticks 0 … 500, 600 … 1100, 1200 … 1700, each 10 mm along X.
Take strokesInRows() {
    std::vector<Tick> ticks;
    for (int row = 0; row < 3; ++row) {
        for (int i = 0; i <= 500; ++i) ticks.push_back({{0.02 * i, 4.0 * row, -1.0}});
        for (int i = 1; i < 100 && row < 2; ++i) ticks.push_back({{10.0, 4.0 * row, 0.0}, false, sampleSpindleOff});
    }
    return takeOf(ticks);
}

Result<EvaluatedPath> edited(const std::vector<Edit>& further, const PathContext& context = shop(),
                             const Take& take = strokesInRows()) {
    std::vector<Edit> edits{{Simplify{}}, {FitArcs{}}, {Link{}}, {SetFeed{.cooling = SetFeed::Cooling::off}}};
    edits.insert(edits.end(), further.begin(), further.end());
    return run({take}, edits, context);
}

SpindleAndCoolant edit(const SourceInterval& interval, double speed, Cooling cooling = Cooling::kept) {
    return {interval, speed, 1.0, cooling};
}

/// A move to a point, with spindle speed and coolant.
struct Way {
    MoveKind kind;
    glm::dvec2 to; ///< mm
    double speed;  ///< 1/min
    bool flood;

    friend bool operator==(const Way& a, const Way& b) {
        return a.kind == b.kind && glm::distance(a.to, b.to) < 1e-9 && a.speed == b.speed && a.flood == b.flood;
    }
};

/// Returns all moves except rapids.
std::vector<Way> waysOf(const Path& path) {
    std::vector<Way> ways;
    for (const PathPoint& point : path.points)
        if (point.kind != MoveKind::rapid)
            ways.push_back({point.kind, glm::dvec2(point.pose.tip),
                            point.spindleSpeed > 0.0 ? point.spindleSpeed : path.spindleSpeed,
                            point.coolant.value_or(path.coolant) == Coolant::flood});
    return ways;
}

QByteArray told(const std::vector<Way>& ways) {
    QByteArray text;
    for (const Way& way : ways)
        text += QStringLiteral("%1: %2 %3, %4 %5\n")
                    .arg(static_cast<int>(way.kind))
                    .arg(way.to.x)
                    .arg(way.to.y)
                    .arg(way.speed)
                    .arg(way.flood)
                    .toUtf8();
    return text;
}

constexpr MoveKind plunge = MoveKind::plunge, cut = MoveKind::cut, retract = MoveKind::retract;

} // namespace

/// Spindle speed and coolant of strokes and of parts of them.
class TestSection : public QObject {
    Q_OBJECT
private slots:
    /// A stroke gets them including its plunge and retract; the rapids between stay unchanged.
    void aStrokeGetsThemWithItsLinks() {
        const auto path = edited({{edit(second, 8000.0, Cooling::flood)}});
        QVERIFY(path);
        const std::vector<Way> expected{
            {plunge, {0, 0}, spindle, false}, {cut, {10, 0}, spindle, false}, {retract, {10, 0}, spindle, false},
            {plunge, {0, 4}, 8000.0, true},   {cut, {10, 4}, 8000.0, true},   {retract, {10, 4}, 8000.0, true},
            {plunge, {0, 8}, spindle, false}, {cut, {10, 8}, spindle, false}, {retract, {10, 8}, spindle, false}};
        QVERIFY2(waysOf(path->path) == expected, told(waysOf(path->path)));
        QCOMPARE(path->path.spindleSpeed, spindle);
    }

    /// A move is divided exactly where the part begins and ends, and keeps its feed.
    void aPartOfAStrokeGetsThem() {
        const auto path = edited({{edit(middle, 8000.0, Cooling::flood)}}), plain = edited({});
        QVERIFY(path && plain);
        const std::vector<Way> expected{
            {plunge, {0, 0}, spindle, false}, {cut, {10, 0}, spindle, false},     {retract, {10, 0}, spindle, false},
            {plunge, {0, 4}, spindle, false}, {cut, {2.5, 4}, spindle, false},    {cut, {7.5, 4}, 8000.0, true},
            {cut, {10, 4}, spindle, false},   {retract, {10, 4}, spindle, false}, {plunge, {0, 8}, spindle, false},
            {cut, {10, 8}, spindle, false},   {retract, {10, 8}, spindle, false}};
        QVERIFY2(waysOf(path->path) == expected, told(waysOf(path->path)));
        for (const PathPoint& point : path->path.points)
            if (point.kind == cut) QCOMPARE(point.feed, 900.0);
        QCOMPARE(path->path.points.size(), plain->path.points.size() + 2);
        // An interval of another source changes nothing, nor does an edit that keeps both values.
        for (const auto& nothing : {edit({7, 725, 975}, 8000.0, Cooling::flood), edit(middle, 0.0)}) {
            const auto same = edited({{nothing}});
            QVERIFY(same);
            QVERIFY(waysOf(same->path) == waysOf(plain->path));
        }
    }

    /// A divided arc stays on its circle: both parts lie on the circle of the undivided arc.
    void anArcIsDividedOnItself() {
        std::vector<Tick> ticks;
        for (int i = 0; i <= 900; ++i) {
            const double angle = pi * i / 900.0;
            ticks.push_back({{20.0 * std::cos(angle), 20.0 * std::sin(angle), -1.0}});
        }
        const auto path = edited({{edit({1, 300, 600}, 8000.0)}}, shop(), takeOf(ticks));
        QVERIFY(path);
        double from = 0.0; // rad, at the start of a move
        int arcs = 0;
        std::vector<double> borders;
        for (std::size_t i = 1; i < path->path.points.size(); ++i) {
            const PathPoint& point = path->path.points[i];
            if (point.kind != cut) continue;
            QVERIFY(point.arc);
            ++arcs;
            const double to = std::atan2(point.pose.tip.y, point.pose.tip.x);
            QVERIFY(std::abs(glm::length(glm::dvec2(point.pose.tip)) - 20.0) < 0.012); // deviation of the fit
            const double half = 0.5 * (from + to);
            QCOMPARE(point.spindleSpeed, half > pi / 3.0 && half < 2.0 * pi / 3.0 ? 8000.0 : 0.0);
            if (!borders.empty() || point.spindleSpeed > 0.0) borders.push_back(from);
            from = to;
        }
        QVERIFY(arcs >= 3 && borders.size() >= 2);
        QVERIFY(std::abs(borders.front() - pi / 3.0) < 2e-3);
    }

    /// A share applies to the present speed of each move; a later edit overrides an earlier one; other edits keep both.
    void editsFollowEachOther() {
        AreaFeed area;
        area.outline = {{5, -50, 0}, {50, -50, 0}, {50, 50, 0}, {5, 50, 0}};
        const auto path = edited({{edit(second, 4000.0, Cooling::flood)},
                                  {SpindleAndCoolant{{}, 0.0, 0.5, Cooling::kept}},
                                  {area},
                                  {ScaleFeed{second, 2.0}}});
        QVERIFY(path);
        const std::vector<Way> expected{
            {plunge, {0, 0}, 3000.0, false},   {cut, {5, 0}, 3000.0, false},     {cut, {10, 0}, 3000.0, false},
            {retract, {10, 0}, 3000.0, false}, {plunge, {0, 4}, 2000.0, true},   {cut, {5, 4}, 2000.0, true},
            {cut, {10, 4}, 2000.0, true},      {retract, {10, 4}, 2000.0, true}, {plunge, {0, 8}, 3000.0, false},
            {cut, {5, 8}, 3000.0, false},      {cut, {10, 8}, 3000.0, false},    {retract, {10, 8}, 3000.0, false}};
        QVERIFY2(waysOf(path->path) == expected, told(waysOf(path->path)));
    }

    void whatMachineAndToolCantDoIsRefused_data() {
        QTest::addColumn<double>("speed");
        QTest::addColumn<int>("cooling");
        QTest::addColumn<int>("code");
        QTest::addColumn<QString>("place");
        const auto row = [](const char* what, double speed, Cooling cooling, ErrorCode code, const char* place) {
            QTest::newRow(what) << speed << static_cast<int>(cooling) << static_cast<int>(code) << place;
        };
        row("too slow", 500.0, Cooling::kept, ErrorCode::programLimit, "500.000 1/min, limit 1000");
        row("too fast", 12000.0, Cooling::kept, ErrorCode::programLimit, "12000.000 1/min, limit 10000");
        row("too fast for the tool", 9500.0, Cooling::kept, ErrorCode::argumentInvalid, "9500 1/min");
        row("no mist", 0.0, Cooling::mist, ErrorCode::notSupported, "");
    }
    void whatMachineAndToolCantDoIsRefused() {
        QFETCH(double, speed);
        QFETCH(int, cooling);
        QFETCH(int, code);
        PathContext context = shop();
        context.tool.maximumSpindleSpeed = 9000.0;
        const auto path = edited({{edit(middle, speed, static_cast<Cooling>(cooling))}}, context);
        QVERIFY(!path);
        QCOMPARE(static_cast<int>(path.error().code), code);
        QTEST(QString::fromStdString(path.error().place), "place");
        QCOMPARE(
            path.error().subject,
            std::string(code == static_cast<int>(ErrorCode::notSupported) ? "mist coolant for Mill" : "spindle speed"));
    }

    /// A single moment selects the stroke that passes it, whether it has a vertex there or not.
    void aPointMeansItsStroke() {
        const auto whole = edited({{edit(second, 8000.0, Cooling::flood)}});
        QVERIFY(whole);
        for (const std::int64_t tick : {600, 725, 1100}) {
            const auto path = edited({{edit({1, tick, tick}, 8000.0, Cooling::flood)}});
            QVERIFY(path);
            QVERIFY2(waysOf(path->path) == waysOf(whole->path), told(waysOf(path->path)));
        }
    }

    void aPathWithoutSpeedsIsRefused() {
        const auto early = run({strokesInRows()}, {{Simplify{}}, {Link{}}, {edit(middle, 8000.0)}}, shop());
        QVERIFY(!early && early.error().code == ErrorCode::argumentInvalid);
        QCOMPARE(early.error().detail, std::string("set-feed, then section"));
    }
};

BURIN_TEST(TestSection, NoApplication)

} // namespace burin::tst_section

#include "tst_section.moc"

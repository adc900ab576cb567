// SPDX-FileCopyrightText: 2026 The Burin authors
// SPDX-License-Identifier: Apache-2.0
#include "block_fixture.h"
#include "tests/test_program.h"

#include <rapidcheck.h>

#include <QTest>

#include <optional>

namespace burin::tst_entries {

using namespace burin::test;

namespace {

/// Greatest depth to which the tool enters material more steeply than a slope, mm in one go, by the height map of the
/// remaining stock.
double deepestPlunge(const std::vector<PathPoint>& points, const Cutter& cutter, double slope) {
    Heights left;
    double deepest = 0.0, now = 0.0;
    std::optional<glm::dvec3> last;
    walk(points, 0.02, [&](const PathPoint& end, const glm::dvec3& tip) {
        if (last && end.kind != MoveKind::rapid) {
            const double down = last->z - tip.z, across = std::hypot(tip.x - last->x, tip.y - last->y);
            const double looked = cutter.type == CutterType::ball ? 0.3 * cutter.radius() : 0.8 * cutter.radius();
            const bool inside = left.highestWithin(tip, looked) > tip.z + 0.5 * down;
            if (down > slope * across + 1e-9 && inside)
                now += down - slope * across;
            else if (down < -1e-9 || across > 1e-9)
                now = 0.0;
            deepest = std::max(deepest, now);
        }
        if (end.kind != MoveKind::rapid) left.cut(cutter, tip);
        last = tip;
    });
    return deepest;
}

/// The standard entry into material.
Link rampingLink() {
    Link link;
    link.entry = Link::Entry::ramp;
    link.rampAngle = 0.06;
    return link;
}

/// A hand that begins with some tiny moves, like hands that search for the start, and continues with long ones. It
/// never turns back by itself.
std::vector<glm::dvec3> hesitantCorners() {
    const auto part = [](int most) { return 0.01 * *rc::gen::inRange(-most, most + 1); };
    std::vector<glm::dvec3> corners{{5.0 * part(100), 5.0 * part(100), -1.0 - *rc::gen::inRange(0, 4)}};
    const int tiny = *rc::gen::inRange(0, 4), wide = *rc::gen::inRange(1, 4);
    double heading = pi * part(100);
    const auto go = [&](double length, double rise) {
        heading += part(120);
        corners.push_back(corners.back() + glm::dvec3(length * std::cos(heading), length * std::sin(heading), rise));
    };
    for (int i = 0; i < tiny; ++i) go(0.01 * *rc::gen::inRange(2, 25), 0.1 * part(10));
    for (int i = 0; i < wide; ++i) go(*rc::gen::inRange(1, 5), part(20));
    return corners;
}

constexpr double plungeBlur = 0.45; // mm: permitted contact straight from above: a voxel and a sampling step

/// Straight sides of a square hole in a plate.
TriangleMesh holeMesh(double half) {
    return meshOf({{{-10, -10, -16}, {10, -half, 0}},
                   {{-10, half, -16}, {10, 10, 0}},
                   {{-10, -half, -16}, {-half, half, 0}},
                   {{half, -half, -16}, {10, half, 0}}});
}

} // namespace

class TestEntries : public QObject {
    Q_OBJECT

private slots:
    void aStrokeThatBeginsInMaterialIsRampedInto_data() {
        QTest::addColumn<std::vector<glm::dvec3>>("corners");
        QTest::addColumn<int>("form");
        const auto row = [](const char* name, const std::vector<glm::dvec3>& corners, EntryForm form) {
            QTest::newRow(name) << corners << static_cast<int>(form);
        };
        row("a slot", {{-8, 0, -4}, {8, 0, -4}}, EntryForm::ramp);
        row("round a corner", {{-5, -2, -4}, {-2, -2, -4}, {-2, 6, -4}}, EntryForm::ramp);
        row("a hand that plunges", {{-8, 0, 1}, {-8, 0, -4}, {8, 0, -4}}, EntryForm::ramp);
        row("a short one", {{0, 0, -4}, {0.8, 0, -4}}, EntryForm::helix);
    }
    void aStrokeThatBeginsInMaterialIsRampedInto() {
        QFETCH(std::vector<glm::dvec3>, corners);
        QFETCH(int, form);
        for (const CutterType type : {CutterType::flat, CutterType::ball}) {
            const Tool tool = stubbyTool(type);
            const std::vector<Tick> ticks = along(corners, 40.0);
            const auto path = run({takeOf(ticks)}, {{Simplify{}}, {rampingLink()}, {SetFeed{}}}, blockContext(tool));
            QVERIFY2(path, path ? "" : path.error().detail.c_str());
            const EditReport& link = reportOf(*path, "link");
            QCOMPARE(link.entries.size(), std::size_t{1});
            const StrokeEntry& entry = link.entries.front();
            QCOMPARE(static_cast<int>(entry.form), form);
            QVERIFY2(std::abs(entry.depth - 4.0) < blur, qPrintable(QString::number(entry.depth)));
            QVERIFY(link.omissions.empty());
            const std::vector<PathPoint>& points = path->path.points;
            const double slope = std::tan(0.06);
            QVERIFY2(deepestPlunge(points, tool.cutter, 1.05 * slope) < plungeBlur,
                     qPrintable(QString::number(deepestPlunge(points, tool.cutter, 1.05 * slope))));
            // The same with a straight plunge, which the check detects.
            const auto plunged = run({takeOf(ticks)}, {{Simplify{}}, {Link{}}}, blockContext(tool));
            QVERIFY(plunged && deepestPlunge(plunged->path.points, tool.cutter, 1.05 * slope) > 2.5);
            // Ramps have half of the feed, 900 mm/min; down to the material the tool plunges.
            std::size_t ramps = 0;
            for (std::size_t i = 1; i < points.size(); ++i) {
                if (points[i].kind != MoveKind::plunge) continue;
                const bool down =
                    glm::distance(glm::dvec2(points[i].pose.tip), glm::dvec2(points[i - 1].pose.tip)) < 1e-9 &&
                    !points[i].arc;
                QCOMPARE(points[i].feed, down ? 300.0 : 450.0);
                ramps += down ? 0 : 1;
            }
            QVERIFY(ramps >= 2);
            // Once down it stays there: the hand's own descent is not repeated.
            for (const PathPoint& point : points)
                if (point.kind == MoveKind::cut) QVERIFY(std::abs(point.pose.tip.z + 4.0) < 1e-6);
            // It removes nothing beyond the stroke's own removal.
            if (entry.form == EntryForm::helix) continue;
            for (const PathPoint& point : points) {
                if (point.kind != MoveKind::plunge || point.pose.tip.z >= 0.0) continue;
                double nearest = 1e9;
                for (std::size_t i = 1; i < corners.size(); ++i)
                    nearest = std::min(nearest, distanceToPolyline({point.pose.tip.x, point.pose.tip.y, 0.0},
                                                                   {{corners[i - 1].x, corners[i - 1].y, 0.0},
                                                                    {corners[i].x, corners[i].y, 0.0}}));
                QVERIFY2(nearest < 1e-6, qPrintable(QString::number(nearest)));
                QVERIFY(point.pose.tip.z > -4.0 - 1e-9);
            }
        }
    }

    void whereTheMaterialIsGoneNothingIsRamped() {
        std::vector<Tick> ticks = along({{-8, 0, -4}, {8, 0, -4}}, 40.0);
        append(ticks, along({{8, 0, 8}, {-8, 0, 8}}, 400.0, false));
        append(ticks, along({{-8, 0, -4}, {8, 0, -4}}, 40.0));
        const auto path = run({takeOf(ticks)}, {{DropAirCuts{}}, {Simplify{}}, {rampingLink()}},
                              blockContext(stubbyTool(CutterType::flat)));
        QVERIFY(path);
        QCOMPARE(reportOf(*path, "link").entries.size(), std::size_t{1});
    }

    /// Next to earlier milling: a sliver at the tool's rim does not require an entry.
    void aSkimmedWallIsNoPlunge() {
        for (const auto& [aside, enters] : {std::pair{0.12, false}, std::pair{1.0, true}}) {
            std::vector<Tick> ticks = along({{-8, 0, -4}, {8, 0, -4}}, 40.0);
            append(ticks, along({{8, 0, 8}, {0, aside, 8}}, 400.0, false));
            append(ticks, along({{-0.05, aside, -4}, {0.05, aside, -4}}, 40.0)); // too short for a ramp
            const Tool tool = stubbyTool(CutterType::flat);
            const std::vector<Edit> edits{{DropAirCuts{}}, {Simplify{}}, {rampingLink()}};
            const auto path = run({takeOf(ticks)}, edits, blockContext(tool));
            QVERIFY(path);
            const EditReport& link = reportOf(*path, "link");
            QCOMPARE(link.entries.size(), enters ? std::size_t{2} : std::size_t{1}); // the first is the slot's own
            if (!enters) QVERIFY(deepestPlunge(path->path.points, tool.cutter, 1.05 * std::tan(0.06)) < plungeBlur);
        }
    }

    /// In a hole hardly wider than the tool there is room for neither ramp nor helix.
    void aToolThatMayPlungesWhereNothingElseFits() {
        const MeshDistance part(holeMesh(2.1));
        Tool tool = stubbyTool(CutterType::flat);
        tool.cutter.shankDiameter = 3.8;
        const std::vector<Edit> edits{{Simplify{}}, {rampingLink()}};
        const std::vector<Tick> ticks = along({{-0.05, 0, -5}, {0.05, 0, -5}}, 40.0);
        PathContext context = contextOf(part, tool, block);
        context.lendStock = lendBlock;
        const auto path = run({takeOf(ticks)}, edits, context);
        QVERIFY2(path, path ? "" : path.error().detail.c_str());
        const EditReport& link = reportOf(*path, "link");
        QCOMPARE(link.entries.size(), std::size_t{1});
        QVERIFY(link.entries.front().form == EntryForm::plunge);
        QVERIFY(glm::distance(link.entries.front().tip, glm::dvec3(-0.05, 0, -5)) < 1e-9);
        context.tool.centreCutting = false;
        const auto refused = run({takeOf(ticks)}, edits, context);
        QVERIFY(!refused && refused.error().code == ErrorCode::pathGouges);
        QCOMPARE(refused.error().detail, std::string(remedyOf(OmissionReason::plunge).text));
    }

    /// A control that is sent a tenth of a millimetre back and forth stutters and leaves a mark.
    void noEntryStepsBack() {
        double ramps = 0.0;
        QVERIFY(rc::check("a ramp turns where its moves are long", [&] {
            const Tool tool = stubbyTool(*rc::gen::element(CutterType::ball, CutterType::flat));
            std::vector<glm::dvec3> corners = hesitantCorners();
            if (*rc::gen::inRange(0, 3) == 0) { // a hand that descends in steps
                const glm::dvec3 start = corners.front();
                corners.insert(corners.begin(), {{start.x, start.y, 1.0}, {start.x + 0.5, start.y, 0.4 * start.z}});
            }
            std::vector<Edit> edits{{DropAirCuts{}}, {DropDwells{}}};
            const int smoothing = *rc::gen::inRange(0, 3);
            if (smoothing == 0) edits.push_back({Simplify{}});
            if (smoothing == 1) edits.insert(edits.end(), {{SmoothShape{}}, {HoldOut{}}});
            if (*rc::gen::inRange(0, 2) == 0) edits.push_back({FitArcs{}});
            Link link = rampingLink();
            link.travel = *rc::gen::element(Link::Travel::safe, Link::Travel::lowest, Link::Travel::around);
            link.rounding = *rc::gen::element(0.0, 0.7);
            edits.push_back({link});
            std::vector<Tick> ticks = along(corners, 40.0);
            if (*rc::gen::inRange(0, 2) == 0) { // set down again near by
                const glm::dvec3 up(0.0, 0.0, 8.0), near = 0.01 * glm::dvec3(*rc::gen::inRange(0, 20), 0, 0);
                append(ticks, along({corners.back(), corners.back() + up, corners.back() + up + near}, 400.0, false));
                std::vector<glm::dvec3> again = hesitantCorners();
                const glm::dvec3 shift = corners.back() + near - again.front();
                for (glm::dvec3& corner : again) corner += shift;
                append(ticks, along(again, 40.0));
            }
            const auto path = run({takeOf(ticks)}, edits, blockContext(tool));
            RC_PRE(!isEmpty(path));
            RC_ASSERT(static_cast<bool>(path));
            const EditReport& report = reportOf(*path, "link");
            ramps += static_cast<double>(countOf(report.entries, EntryForm::ramp));
            RC_ASSERT(backStepsIn(path->path.points, false) == 0U);
        }));
        QVERIFY(ramps > 30.0); // the test was not empty
    }

    /// A ramp next to the stroke, whose descent alone makes a back-step at the transition into the stroke.
    void aRampBesideAStrokeDoesNotStepBack() {
        const std::vector<glm::dvec3> corners{
            {-5.0, -5.0, 1.0}, {-4.5, -5.0, -0.4}, {-5.0, -5.0, -1.0}, {-5.9165, -4.5999, -1.2}};
        const auto path = run({takeOf(along(corners, 40.0))}, {{DropAirCuts{}}, {DropDwells{}}, {rampingLink()}},
                              blockContext(stubbyTool(CutterType::ball)));
        QVERIFY2(path, path ? "" : path.error().detail.c_str());
        QVERIFY(backStepsIn(path->path.points, false) == 0U);
    }

    /// A stroke that begins at a wall with a tiny move along it leaves no room to turn beyond its start.
    void atAWallNothingStepsBackEither() {
        const MeshDistance part(meshOf({{{-10, -10, -16}, {-8, 10, -1}}, {{-10, -10, -16}, {10, -8, -1}}}));
        for (const glm::dvec3& tiny : {glm::dvec3(0.06, 0.02, 0), glm::dvec3(0.03, 0.03, 0), glm::dvec3(0.09, 0, 0)}) {
            const glm::dvec3 start(-6.0, -6.0, -4.0);
            const std::vector<glm::dvec3> corners{start, start + tiny, {4, -5.5, -4}, {4, 4, -4}};
            PathContext context = contextOf(part, stubbyTool(CutterType::flat), block);
            context.lendStock = lendBlock;
            const auto path =
                run({takeOf(along(corners, 40.0))}, {{Simplify{.tolerance = 0.001}}, {rampingLink()}}, context);
            QVERIFY2(path, path ? "" : path.error().detail.c_str());
            const EditReport& link = reportOf(*path, "link");
            QCOMPARE(link.entries.size(), std::size_t{1});
            QVERIFY(link.entries.front().form == EntryForm::ramp);
            QVERIFY(backStepsIn(path->path.points, false) == 0U);
            // The hand's start is kept, and the tool stays clear of the walls.
            double nearest = 1e9;
            for (const PathPoint& point : path->path.points) {
                nearest = std::min(nearest, glm::distance(point.pose.tip, start));
                if (point.pose.tip.z < -1.0) QVERIFY(point.pose.tip.x > -6.0 - 1e-6 && point.pose.tip.y > -6.0 - 1e-6);
            }
            QVERIFY(nearest < 1e-9);
            QVERIFY(path->errorBudget < 0.07);
        }
    }

    /// Where nothing else fits, a stroke is entered where an earlier one has cleared the stock, and followed back from
    /// there.
    void aStrokeIsEnteredWhereNothingStands() {
        const MeshDistance part(meshOf({{{-10, 2.1, -16}, {0, 10, -1}}, {{-10, -10, -16}, {0, -2.1, -1}}}));
        Tool tool = stubbyTool(CutterType::flat);
        tool.cutter.shankDiameter = 3.8;
        std::vector<Tick> ticks = along({{4, -8, -5}, {4, 8, -5}}, 40.0);
        append(ticks, along({{4, 8, 8}, {-8, 0, 8}}, 400.0, false));
        append(ticks, along({{-8, 0, -5}, {4, 0, -5}, {8, 1, -5}}, 40.0));
        Link link = rampingLink();
        link.rampAngle = 0.001; // ramps would be far too long
        PathContext context = contextOf(part, tool, block);
        context.lendStock = lendBlock;
        const auto path = run({takeOf(ticks)}, {{DropAirCuts{}}, {Simplify{}}, {link}}, context);
        QVERIFY2(path, path ? "" : path.error().detail.c_str());
        const auto& entries = reportOf(*path, "link").entries;
        QCOMPARE(entries.size(), std::size_t{1}); // of the first stroke
        QVERIFY2(std::abs(entries.front().tip.x - 4.0) < 0.5,
                 qPrintable(QString("%1 at %2").arg(idOf(entries.front().form)).arg(entries.front().tip.x)));
        double farthest = 1e9;
        int descents = 0;
        for (std::size_t i = 1; i < path->path.points.size(); ++i) {
            const PathPoint &from = path->path.points[i - 1], &to = path->path.points[i];
            farthest = std::min(farthest, to.pose.tip.x);
            if (std::abs(to.pose.tip.y) > 1.0 || to.pose.tip.z > from.pose.tip.z - 1e-9 || to.pose.tip.z >= 0.0)
                continue;
            QVERIFY2(std::abs(to.pose.tip.x - 4.0) < 0.5,
                     qPrintable(QString::number(to.pose.tip.x))); // down into the cleared slot
            ++descents;
        }
        QVERIFY(descents > 0);
        QVERIFY2(std::abs(farthest + 8.0) < 0.01, qPrintable(QString::number(farthest))); // the entire stroke
    }

    /// Remaining stock at a wall, approached from above as a hand does: there is no level line for a ramp, nor room for
    /// a helix.
    void alongAWallAStrokeIsRampedInto() {
        const MeshDistance part(meshOf({{{-10, -10, -16}, {-8, 10, -1}}, {{-3.5, -10, -16}, {10, 10, -1}}}));
        Tool tool = stubbyTool(CutterType::flat);
        tool.cutter.shankDiameter = 3.8;
        PathContext context = contextOf(part, tool, block);
        context.lendStock = lendBlock;
        const std::vector<Tick> ticks = along({{-6, 0, 1}, {-5.6, 0, -3}}, 40.0);
        const auto path = run({takeOf(ticks)}, {{Simplify{}}, {rampingLink()}}, context);
        QVERIFY2(path, path ? "" : path.error().detail.c_str());
        const EditReport& link = reportOf(*path, "link");
        QCOMPARE(link.entries.size(), std::size_t{1});
        QVERIFY(link.entries.front().form == EntryForm::ramp);
        const double plunge = deepestPlunge(path->path.points, tool.cutter, 1.05 * std::tan(0.06));
        QVERIFY2(plunge < plungeBlur, qPrintable(QString::number(plunge)));
        for (const PathPoint& point : path->path.points)
            if (point.pose.tip.z < -1.0) QVERIFY(point.pose.tip.x > -6.0 - 1e-6 && point.pose.tip.x < -5.5 + 1e-6);
    }

    void noStrokeIsPlungedIntoUnsaid() {
        double forms[3] = {};
        QVERIFY(rc::check("where no plunge is reported no move goes down steeply into material", [&] {
            const Tool tool = stubbyTool(*rc::gen::element(CutterType::ball, CutterType::flat));
            std::vector<Tick> ticks;
            for (int i = 0; i < 3; ++i) {
                glm::dvec3 at(*rc::gen::inRange(-8, 9), *rc::gen::inRange(-8, 9), -*rc::gen::inRange(1, 6));
                std::vector<glm::dvec3> corners{at};
                for (int k = 0; k < 2; ++k)
                    corners.push_back({*rc::gen::inRange(-8, 9), *rc::gen::inRange(-8, 9), at.z});
                append(ticks, along(corners, 400.0));
                append(ticks, along({corners.back(), {corners.back().x, corners.back().y, 8}}, 400.0, false));
            }
            Link link = rampingLink();
            link.travel = *rc::gen::element(Link::Travel::safe, Link::Travel::lowest, Link::Travel::around);
            link.rounding = *rc::gen::element(0.0, 0.7);
            const auto path = run({takeOf(ticks)}, {{DropAirCuts{}}, {Simplify{}}, {link}}, blockContext(tool));
            RC_PRE(!isEmpty(path));
            RC_ASSERT(static_cast<bool>(path));
            const EditReport& report = reportOf(*path, "link");
            for (const StrokeEntry& entry : report.entries) forms[static_cast<std::size_t>(entry.form)] += 1.0;
            RC_ASSERT(deepestGuard(path->path.points, tool.cutter) < blur);
            if (countOf(report.entries, EntryForm::plunge) > 0) return;
            RC_ASSERT(deepestPlunge(path->path.points, tool.cutter, 1.05 * std::tan(0.06)) < plungeBlur);
        }));
        QVERIFY(forms[1] > 50.0); // the test was not empty
    }
};

BURIN_TEST(TestEntries, NoApplication)

} // namespace burin::tst_entries

#include "tst_entries.moc"

// SPDX-FileCopyrightText: 2026 The Burin authors
// SPDX-License-Identifier: Apache-2.0
#include "block_fixture.h"
#include "tests/random_cases.h"
#include "tests/test_program.h"

#include <rapidcheck.h>

#include <QTest>

#include <algorithm>
#include <cmath>
#include <vector>

namespace burin::tst_omissions {

using namespace burin::test;

namespace {

double lengthOfCuts(const std::vector<PathPoint>& points) {
    double length = 0.0;
    for (std::size_t i = 1; i < points.size(); ++i)
        if (points[i].kind == MoveKind::cut) length += glm::distance(points[i - 1].pose.tip, points[i].pose.tip);
    return length;
}

/// Five rows at a height, back and forth, over a square about the origin; then up.
void appendRows(std::vector<Tick>& ticks, double half, double z) {
    std::vector<glm::dvec3> corners{{-half, -half, 8}};
    double side = -1.0;
    for (double y = -half; y <= half + 1e-9; y += 0.5 * half) {
        corners.push_back({side * half, y, z});
        corners.push_back({-side * half, y, z});
        side = -side;
    }
    append(ticks, along({corners.front(), corners[1]}, 400.0, false));
    append(ticks, along({corners.begin() + 1, corners.end()}, 400.0));
    append(ticks, along({corners.back(), {corners.back().x, corners.back().y, 8}}, 400.0, false));
}

/// The same work as `linkedEdits`, with all edits that bend ends and corners.
std::vector<Edit> allEdits(Link link) {
    RoundCorners round;
    round.tolerance = 0.05;
    LeadIn in;
    in.form = *rc::gen::element(LeadIn::Form::arc, LeadIn::Form::line, LeadIn::Form::ramp);
    LeadOut out;
    return {{DropAirCuts{}}, {SmoothSpline{}}, {HoldOut{}}, {Simplify{}}, {round}, {FitArcs{}}, {in},
            {out},           {link},           {SetFeed{}}};
}

/// A T-slot cutter: a disc under a neck that passes between the ledges of the slot.
Tool slotTool() {
    Tool tool = flatTool(8.0);
    tool.cutter.fluteLength = 3.0;
    tool.cutter.shankDiameter = 3.0;
    return tool;
}
constexpr double slotRadius = 4.0, slotHeight = 3.0, neckRadius = 1.5;

/// Clearance of disc and neck from a box.
double slotToolDistance(const Box& box, const glm::dvec3& tip) {
    const double aside = glm::length(glm::max(
        glm::max(glm::dvec2(box.low) - glm::dvec2(tip), glm::dvec2(tip) - glm::dvec2(box.high)), glm::dvec2(0.0)));
    const double across = aside - slotRadius;
    const double above = std::max(tip.z - box.high.z, box.low.z - tip.z - slotHeight);
    const double disc = across > 0.0 && above > 0.0 ? std::hypot(across, above) : std::max(across, above);
    return box.high.z > tip.z + slotHeight ? std::min(disc, aside - neckRadius) : disc;
}

} // namespace

class TestOmissions : public QObject {
    Q_OBJECT

private slots:
    /// A pocket 6 mm deep that extends 7 mm, then a deep groove out of it: the shank, 2.5 mm wide on each side, gets as
    /// far as its wall.
    void aGrooveEndsWhereTheShankWouldTouch() {
        const Tool tool = stubbyTool(CutterType::flat);
        std::vector<Tick> ticks;
        appendRows(ticks, 5.0, -5.0);
        append(ticks, along({{-4, 0, 8}, {-4, 0, -8}}, 400.0, false));
        append(ticks, along({{-4, 0, -8}, {9, 0, -8}}, 400.0));
        const auto path = run({takeOf(ticks)}, {{DropAirCuts{}}, {Simplify{}}, {Link{}}}, blockContext(tool));
        QVERIFY2(path, path ? "" : path.error().detail.c_str());
        double farthest = -1e9;
        for (const PathPoint& point : path->path.points)
            if (point.pose.tip.z < -7.9) farthest = std::max(farthest, point.pose.tip.x);
        constexpr double wall = 7.0 - 2.5;
        QVERIFY2(farthest <= wall + 1e-6 && farthest > wall - blur, qPrintable(QString::number(farthest)));
        const EditReport& link = reportOf(*path, "link");
        QCOMPARE(link.omissions.size(), std::size_t{1});
        const Omission& part = link.omissions.front();
        QVERIFY(part.reason == OmissionReason::shank);
        QCOMPARE(part.source, std::int64_t{1});
        QCOMPARE(part.line.front(), glm::dvec3(farthest, 0, -8));
        QCOMPARE(part.line.back(), glm::dvec3(9, 0, -8));
        QVERIFY(std::abs(part.length - (9.0 - farthest)) < 1e-9);
        // The reported part matches the hand's moments: 0.4 mm per tick.
        const double tickAt = static_cast<double>(ticks.size() - 1) - (9.0 - farthest) / 0.4;
        QVERIFY(std::abs(static_cast<double>(part.first) - tickAt) <= 33.0 &&
                part.last == std::int64_t(ticks.size()) - 1);
        QVERIFY(link.lengthBefore >= lengthOfCuts(path->path.points) + part.length - 1e-6);
        QVERIFY(deepestGuard(path->path.points, tool.cutter) < blur);
    }

    void whatFlutesReachIsNeverLeftOut() {
        QVERIFY(testing::holdsInShare("strokes no deeper than the flutes are long are made in whole", [] {
            const Tool tool = stubbyTool(*rc::gen::element(CutterType::ball, CutterType::flat));
            std::vector<Tick> ticks;
            for (int i = 0; i < 3; ++i) {
                const glm::dvec3 from(*rc::gen::inRange(-9, 9), *rc::gen::inRange(-9, 9), -*rc::gen::inRange(1, 6));
                const glm::dvec3 to(*rc::gen::inRange(-9, 9), *rc::gen::inRange(-9, 9), -*rc::gen::inRange(1, 6));
                append(ticks, along({from, to}, 400.0));
                append(ticks, along({to, {to.x, to.y, 8}}, 400.0, false));
            }
            const auto path = run({takeOf(ticks)}, {{DropAirCuts{}}, {Simplify{}}, {Link{}}}, blockContext(tool));
            RC_PRE(!isEmpty(path));
            RC_ASSERT(static_cast<bool>(path));
            for (const EditReport& report : path->reports) RC_ASSERT(report.omissions.empty());
        }));
    }

    /// Spline, rounded corners, arcs, leads, links at each height with rounding: however the path is bent, and wherever
    /// it links, shank and holder stay out of the remaining stock.
    void shankAndHolderStayOutWithAllEditsTogether() {
        double made = 0.0, omitted = 0.0;
        QVERIFY(testing::holdsInShare("no move takes shank or holder into stock", [&] {
            const Tool tool = stubbyTool(*rc::gen::element(CutterType::ball, CutterType::flat));
            std::vector<Tick> ticks;
            appendRows(ticks, 5.0, -5.0);
            for (int i = 0; i < 2; ++i) {
                std::vector<glm::dvec3> corners;
                for (int k = 0; k < 3; ++k)
                    corners.push_back({*rc::gen::inRange(-8, 9), *rc::gen::inRange(-8, 9), -*rc::gen::inRange(5, 13)});
                append(ticks, along(corners, 400.0));
                append(ticks, along({corners.back(), {corners.back().x, corners.back().y, 8}}, 400.0, false));
            }
            Link link;
            link.travel = *rc::gen::element(Link::Travel::safe, Link::Travel::lowest, Link::Travel::around);
            link.rounding = *rc::gen::element(0.0, 0.7, 3.0);
            const auto path = run({takeOf(ticks)}, allEdits(link), blockContext(tool));
            RC_ASSERT(static_cast<bool>(path));
            RC_ASSERT(deepestGuard(path->path.points, tool.cutter) < blur);
            made += lengthOfCuts(path->path.points);
            omitted += lengthOf(reportOf(*path, "link").omissions);
        }));
        QVERIFY(made > 300.0 && omitted > 30.0); // both occurred often enough
    }

    /// Without the stock this cannot be determined, and nothing is left out.
    void withoutStockNothingIsWatched() {
        std::vector<Tick> ticks = along({{-8, 0, -12}, {8, 0, -12}}, 400.0);
        PathContext context = blockContext(stubbyTool(CutterType::flat));
        const std::vector<Edit> edits{{DropAirCuts{}}, {Simplify{}}, {Link{}}};
        const auto watched = run({takeOf(ticks)}, edits, context);
        QVERIFY(!watched);
        QVERIFY(watched.error().code == ErrorCode::pathGouges);
        QCOMPARE(watched.error().place, std::string("-8.000 0.000 -12.000 mm"));
        QCOMPARE(watched.error().detail, std::string(remedyOf(OmissionReason::shank).text));
        context.lendStock = {};
        const auto path = run({takeOf(ticks)}, edits, context);
        QVERIFY(path);
        QVERIFY(reportOf(*path, "link").omissions.empty());
    }

    /// In a T-slot with a wall across it no motion passes the wall: the path ends there, and the rest is left out; the
    /// part outside the slot is made.
    void whatNoMotionLeadsPastIsLeftOut() {
        QVERIFY(testing::holdsInShare("no move enters the part, and all that is missing is reported", [] {
            const double wallAt = 0.5 * *rc::gen::inRange(10, 20), thick = 0.5 * *rc::gen::inRange(1, 8);
            const double y = 0.1 * *rc::gen::inRange(-3, 4), end = wallAt + thick + *rc::gen::inRange(1, 12);
            const std::vector<Box> boxes{{{0, 2, -4}, {40, 20, 0}},
                                         {{0, -20, -4}, {40, -2, 0}},
                                         {{wallAt, -20, -12}, {wallAt + thick, 20, -4.2}}};
            const MeshDistance part(meshOf(boxes));
            std::vector<Tick> ticks = along({{-15, y, -8}, {end, y, -8}}, 40.0);
            append(ticks, along({{end, y, -8}, {end, y, 6}, {-10, 8, 6}, {-10, 8, -8}}, 400.0, false));
            const auto second = static_cast<std::int64_t>(ticks.size());
            append(ticks, along({{-10, 8, -8}, {-10, -8, -8}}, 40.0));
            const std::vector<Edit> edits{{DropAirCuts{}}, {HoldOut{}}, {Simplify{}}, {Link{}}};
            const auto path = run({takeOf(ticks)}, edits, contextOf(part, slotTool(), {{-40, -30, -20}, {50, 30, 0}}));
            RC_ASSERT(static_cast<bool>(path));
            double farthest = -1e9, secondLength = 0.0, nearest = 1e9;
            for (std::size_t i = 1; i < path->path.points.size(); ++i) {
                const PathPoint& point = path->path.points[i];
                if (point.kind != MoveKind::cut) continue;
                farthest = std::max(farthest, point.pose.tip.x);
                if (point.sample >= second)
                    secondLength += glm::distance(path->path.points[i - 1].pose.tip, point.pose.tip);
            }
            walk(path->path.points, 0.1, [&](const PathPoint&, const glm::dvec3& tip) {
                for (const Box& box : boxes) nearest = std::min(nearest, slotToolDistance(box, tip));
            });
            RC_ASSERT(nearest >= -1e-4);
            RC_ASSERT(secondLength > 15.5);
            // The path is made as far as the wall lets the disc go, and the rest is reported completely.
            const double wall = wallAt - slotRadius;
            RC_ASSERT(farthest <= wall + 1e-4);
            RC_ASSERT(farthest >= wall - 0.05);
            double from = 1e9, to = -1e9;
            for (const EditReport& report : path->reports)
                for (const Omission& omitted : report.omissions)
                    for (const glm::dvec3& point : omitted.line) {
                        from = std::min(from, point.x);
                        to = std::max(to, point.x);
                        RC_ASSERT(std::abs(point.y - y) < 0.1);
                    }
            RC_ASSERT(from <= farthest + 0.05);
            RC_ASSERT(std::abs(to - end) < 0.01);
        }));
    }
};

BURIN_TEST(TestOmissions, NoApplication)

} // namespace burin::tst_omissions

#include "tst_omissions.moc"

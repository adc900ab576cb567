// SPDX-FileCopyrightText: 2026 The Burin authors
// SPDX-License-Identifier: Apache-2.0
#include "core/base/units.h"
#include "core/path/milling_side.h"
#include "path_fixture.h"
#include "tests/test_program.h"

#include <QTest>

#include <array>

namespace burin::tst_ends {

using namespace burin::test;

namespace {

const MeshDistance nothing{TriangleMesh{}};

PathContext freeContext() {
    return contextOf(nothing, ballTool(), {{-100, -100, -50}, {100, 100, 0}});
}

/// Corners only: the result of Simplify for straight moves between them.
Result<EvaluatedPath> edited(const std::vector<glm::dvec3>& corners, const std::vector<Edit>& edits,
                             const PathContext& context = freeContext()) {
    std::vector<Edit> all{{Simplify{1e-6}}};
    all.insert(all.end(), edits.begin(), edits.end());
    return run({takeOf(along(corners, 50.0))}, all, context);
}

/// Direction in which a move starts, or ends, by its own points.
glm::dvec3 directionOf(const glm::dvec3& from, const PathPoint& to, bool atEnd) {
    const std::vector<glm::dvec3> places = placesOf(from, to, 1e-4);
    const std::size_t i = atEnd ? places.size() - 1 : 1;
    return glm::normalize(places[i] - places[i - 1]);
}

} // namespace

class TestEnds : public QObject {
    Q_OBJECT

private slots:
    void cornersArePassedByExactlyTheTolerance_data() {
        QTest::addColumn<glm::dvec3>("in");
        QTest::addColumn<glm::dvec3>("out");
        QTest::addColumn<bool>("arc");
        QTest::newRow("square in XY") << glm::dvec3(-20, 0, 0) << glm::dvec3(0, 20, 0) << true;
        QTest::newRow("acute, clockwise") << glm::dvec3(-20, 0, 0) << glm::dvec3(-15, -8, 0) << true;
        QTest::newRow("obtuse in XZ") << glm::dvec3(-20, 0, 0) << glm::dvec3(15, 0, -9) << true;
        QTest::newRow("in YZ") << glm::dvec3(0, 20, 3) << glm::dvec3(0, 4, -20) << true;
        QTest::newRow("in space") << glm::dvec3(-20, 0, 3) << glm::dvec3(4, 18, 9) << false;
    }
    void cornersArePassedByExactlyTheTolerance() {
        QFETCH(glm::dvec3, in);
        QFETCH(glm::dvec3, out);
        QFETCH(bool, arc);
        const glm::dvec3 corner(1.0, 2.0, -20.0);
        const double e = 0.05, inner = std::acos(glm::dot(glm::normalize(in), glm::normalize(out)));
        const auto path = edited({corner + in, corner, corner + out}, {{RoundCorners{e}}});
        QVERIFY(path);
        double nearest = 1e9;
        for (const glm::dvec3& place : placesAlong(path->path.points, 0.001))
            nearest = std::min(nearest, glm::distance(place, corner));
        QVERIFY2(std::abs(nearest - e) <= 0.0025, qPrintable(QString::number(nearest))); // rounded numbers, chords
        const double leg = glm::distance(path->path.points[1].pose.tip, corner);
        const double radius = e / (1.0 / std::sin(0.5 * inner) - 1.0);
        QCOMPARE(leg, arc ? radius / std::tan(0.5 * inner) : 2.0 * e / std::cos(0.5 * inner));
        QCOMPARE(path->path.points[2].arc.has_value(), arc);
        if (arc) QVERIFY(path->path.points.size() == 4);
        QVERIFY(path->errorBudget >= nearest && path->errorBudget < nearest + 0.005);
    }

    void legsDoNotOverlap() {
        std::vector<glm::dvec3> zigzag;
        for (int i = 0; i < 12; ++i) zigzag.push_back({0.1 * i, i % 2 == 0 ? 0.0 : 0.3, -3.0});
        const auto path = edited(zigzag, {{RoundCorners{0.5}}});
        QVERIFY(path);
        const std::vector<PathPoint>& points = path->path.points;
        for (std::size_t i = 1; i < points.size(); ++i) {
            if (points[i].arc) continue;
            const glm::dvec3 way = points[i].pose.tip - points[i - 1].pose.tip;
            QVERIFY(way.x > -1e-9); // never backwards
        }
        QVERIFY(farthestFrom(placesAlong(points, 0.01), zigzag) < 0.3);
    }

    void roundingDoesNotEnterThePart() {
        const Box block{{-30, 3.001, -30}, {-3.001, 30, 10}}; // its edge almost fills the inside of the corner
        const MeshDistance part(boxMesh(block));
        const std::vector<glm::dvec3> corners{{-25, 0, -5}, {0, 0, -5}, {0, 25, -5}};
        const auto beside = [&](const EvaluatedPath& path) {
            double least = 1e9;
            for (const glm::dvec3& place : placesAlong(path.path.points, 0.002)) {
                const double x = std::max(place.x - block.high.x, 0.0), y = std::max(block.low.y - place.y, 0.0);
                least = std::min(least, std::hypot(x, y) - 3.0);
            }
            return least;
        };
        const PathContext held = contextOf(part, flatTool(), {{-40, -40, -20}, {40, 40, 0}});
        const auto path = edited(corners, {{RoundCorners{1.5}}}, held);
        PathContext free = held;
        free.part = &nothing;
        const auto unheld = edited(corners, {{RoundCorners{1.5}}}, free);
        QVERIFY(path && unheld);
        QVERIFY(beside(*unheld) < -0.1); // an arc of 3.6 mm would cut into a corner that a tool of 3 mm goes round
        QVERIFY2(beside(*path) > -1e-4, qPrintable(QString::number(beside(*path))));
    }

    void leadsAreTangent_data() {
        QTest::addColumn<LeadIn::Form>("form");
        QTest::newRow("line") << LeadIn::Form::line;
        QTest::newRow("arc") << LeadIn::Form::arc;
        QTest::newRow("helix") << LeadIn::Form::helix;
        QTest::newRow("ramp") << LeadIn::Form::ramp;
    }
    void leadsAreTangent() {
        QFETCH(LeadIn::Form, form);
        LeadIn in;
        in.form = form;
        in.size = 4.0;
        in.height = 2.5;
        in.angle = 0.05;
        LeadOut out;
        out.size = 2.0;
        const auto path = edited({{0, 0, -3}, {20, 5, -3}}, {{in}, {out}});
        QVERIFY(path);
        const std::vector<PathPoint>& points = path->path.points;
        const glm::dvec3 along = glm::normalize(glm::dvec3(20, 5, 0));
        std::size_t start = 0, end = 0;
        for (std::size_t i = 0; i < points.size(); ++i) {
            if (points[i].pose.tip == glm::dvec3(0, 0, -3)) start = i;
            if (points[i].pose.tip == glm::dvec3(20, 5, -3)) end = i;
        }
        QVERIFY(start > 0 && end == start + 1 && end + 2 == points.size());
        const glm::dvec3 arrives = directionOf(points[start - 1].pose.tip, points[start], true);
        QVERIFY(glm::length(glm::dvec2(arrives) / glm::length(glm::dvec2(arrives)) - glm::dvec2(along)) < 1e-4);
        const glm::dvec3 begin = points.front().pose.tip;
        if (form == LeadIn::Form::line) QVERIFY(glm::distance(begin, -4.0 * along + glm::dvec3(0, 0, -3)) < 1e-9);
        if (form == LeadIn::Form::ramp) QVERIFY(glm::distance(begin, -4.0 * along + glm::dvec3(0, 0, -0.5)) < 1e-9);
        if (form == LeadIn::Form::arc)
            QVERIFY(std::abs(glm::length(begin - glm::dvec3(0, 0, -3)) - 4.0 * std::sqrt(2.0)) < 1e-9);
        if (form == LeadIn::Form::helix) {
            QCOMPARE(begin.z, -0.5);
            for (std::size_t i = 1; i <= start; ++i) {
                QVERIFY(points[i].arc &&
                        points[i - 1].pose.tip.z - points[i].pose.tip.z <= pi * 4.0 * std::tan(0.05) + 1e-9);
                for (const glm::dvec3& place : placesOf(points[i - 1].pose.tip, points[i], 0.1))
                    QVERIFY(std::abs(std::hypot(place.x + 4.0 * along.y, place.y - 4.0 * along.x) - 4.0) < 1e-9);
            }
        }
        const glm::dvec3 leaves = directionOf(points[end].pose.tip, points[end + 1], false);
        QVERIFY(points[end + 1].arc && glm::distance(leaves, along) < 1e-3);
        QVERIFY(std::abs(glm::distance(points.back().pose.tip, points[end].pose.tip) - 2.0 * std::sqrt(2.0)) < 1e-9);
    }

    void aLeadKeepsClearOfThePart() {
        const Box wall{{-30, 3.01, -30}, {30, 10, 10}}; // to the left of the stroke
        const MeshDistance part(boxMesh(wall));
        const auto path = edited({{0, 0, -5}, {20, 0, -5}}, {{LeadIn{}}, {LeadOut{}}},
                                 contextOf(part, ballTool(), {{-60, -60, -20}, {60, 60, 0}}));
        QVERIFY(path);
        QVERIFY(path->path.points.front().pose.tip.y < -2.0 &&
                path->path.points.back().pose.tip.y < -2.0); // to the right
        for (const glm::dvec3& place : placesAlong(path->path.points, 0.01)) QVERIFY(place.y <= 0.0101);
    }

    /// A wall on the left leaves room for a complete lead by a few hundredths of a millimetre, an amount by which
    /// earlier edits move the start of the stroke. With the direction of the first move the lead changes sides; with
    /// that of the recording it stays.
    void leadsKeepTheirSideWhenOtherEditsChange() {
        const MeshDistance part(boxMesh({{-30, 6.03, -30}, {30, 12, 10}}));
        const PathContext context = contextOf(part, flatTool(), {{-60, -60, -20}, {60, 60, 0}});
        std::vector<Tick> ticks = along({{0, 0, -5}, {20, 0, -5}}, 15.0);
        for (std::size_t i = 0; i < ticks.size(); ++i)
            ticks[i].tip.y = 0.05 * std::cos(2.0 * pi * 10.0 * 0.001 * static_cast<double>(i));
        // Number of edit lists for which the lead-in is on the left, and for which the lead-out is.
        const auto leftOnes = [&](LeadDirection direction) {
            std::array<int, 2> left{};
            for (const double wavelength : {0.2, 1.0, 3.0, 6.0, 12.0})
                for (const double tolerance : {0.01, 0.05, 0.1}) {
                    LeadIn in;
                    LeadOut out;
                    in.direction = out.direction = direction;
                    const auto path =
                        run({takeOf(ticks)},
                            {{SmoothShape{wavelength, tolerance}}, {HoldOut{}}, {FitArcs{}}, {in}, {out}}, context);
                    if (!path) return std::array{-1, -1};
                    left[0] += path->path.points.front().pose.tip.y > 1.0 ? 1 : 0;
                    left[1] += path->path.points.back().pose.tip.y > 1.0 ? 1 : 0;
                }
            return left;
        };
        const auto agree = [](int count) { return count == 0 || count == 15; };
        const auto [in, out] = leftOnes(LeadDirection::recording);
        QVERIFY2(agree(in) && agree(out), qPrintable(QString("%1 %2").arg(in).arg(out)));
        const auto [earlierIn, earlierOut] = leftOnes(LeadDirection::firstMove); // shows that the comparison can fail
        QVERIFY2(!agree(earlierIn) || !agree(earlierOut), qPrintable(QString("%1 %2").arg(earlierIn).arg(earlierOut)));
    }

    /// A hand that starts with a step of some hundredths of a millimetre in the opposite direction.
    void aShortFirstMoveDoesNotTurnTheLead() {
        const glm::dvec3 start(0, 0, -5);
        for (const glm::dvec3& step : {glm::dvec3(-0.03, 0, 0), glm::dvec3(0, 0.03, 0), glm::dvec3(-0.02, -0.02, 0)}) {
            LeadIn in;
            in.form = LeadIn::Form::line;
            const auto path = edited({start, start + step, {20, 0, -5}}, {{in}});
            QVERIFY(path);
            const glm::dvec3 lead = path->path.points.front().pose.tip - start;
            QVERIFY2(lead.x <= -0.45 * in.size, qPrintable(QString::number(lead.x))); // from behind, within 60 degrees
            in.direction = LeadDirection::firstMove;
            const auto before = edited({start, start + step, {20, 0, -5}}, {{in}});
            QVERIFY(before && (before->path.points.front().pose.tip - start).x > -0.1 * in.size);
        }
    }

    /// A stroke that was moved, rotated or copied uses the direction of its own motion.
    void leadsOfCopiesAreTangentToo() {
        for (const double angle : {0.5 * pi, pi, -2.0}) {
            const Rotate turn{{}, {0, 0, -3}, angle};
            LeadIn in;
            const auto path = edited({{0, 0, -3}, {20, 0, -3}}, {{in}});
            std::vector<Edit> edits{{turn}, {HoldOut{}}, {in}};
            const auto turned = run({takeOf(along({{0, 0, -3}, {20, 0, -3}}, 50.0))}, edits, freeContext());
            QVERIFY(path && turned);
            const glm::dvec3 before = path->path.points.front().pose.tip, after = turned->path.points.front().pose.tip;
            const glm::dvec3 expected(std::cos(angle) * before.x - std::sin(angle) * before.y,
                                      std::sin(angle) * before.x + std::cos(angle) * before.y, before.z);
            QVERIFY2(glm::distance(after, expected) < 1e-6,
                     qPrintable(QString::number(glm::distance(after, expected))));
        }
    }

    void theLowestWayStaysAboveWhatIsLeft() {
        Take first = takeOf(along({{-20, 0, -3}, {-10, 0, -3}}, 50.0)),
             second = takeOf(along({{10, 0, -3}, {20, 0, -3}}, 50.0));
        second.info.id = 2;
        PathContext context = freeContext();
        Link link;
        link.travel = Link::Travel::lowest;
        const auto heights = [&](const PathContext& in) {
            const auto path = run({first, second}, {{Simplify{}}, {link}}, in);
            double lowest = 1e9, between = -1e9;
            if (!path) return std::pair{lowest, between};
            const std::vector<PathPoint>& points = path->path.points;
            for (std::size_t i = 1; i < points.size(); ++i) {
                const bool across =
                    glm::distance(glm::dvec2(points[i].pose.tip), glm::dvec2(points[i - 1].pose.tip)) > 1.0;
                if (points[i].kind != MoveKind::rapid || !across) continue;
                lowest = std::min({lowest, points[i].pose.tip.z, points[i - 1].pose.tip.z});
                if (points[i - 1].pose.tip.x < 0.0 && points[i].pose.tip.x > 0.0) between = points[i].pose.tip.z;
            }
            return std::pair{lowest, between};
        };
        const auto [lowest, between] = heights(context);
        QCOMPARE(lowest, 1.0); // the approach above the remaining stock in between
        QCOMPARE(between, 1.0);
        const auto pin = std::make_shared<const MeshDistance>(boxMesh({{-1, -1, -5}, {1, 1, 4}}));
        context.obstacles.push_back({pin, 2.0, true});
        QVERIFY(heights(context).second >= 4.0 + 2.0);
        context.obstacles.clear();
        for (Sample& sample : second.samples) sample.proxy.tip.y += 8.0;
        QCOMPARE(heights(context).second, 1.0);
        context.machine.rapids = RapidMode::independent; // not straight, so possibly not over the checked points
        QCOMPARE(heights(context).second, 5.0);
    }

    void climbAndConventionalAreTold_data() {
        QTest::addColumn<bool>("reversed");
        QTest::addColumn<double>("stepOver");
        for (const bool reversed : {false, true})
            for (const double stepOver : {2.0, -2.0, 0.7})
                QTest::addRow("%s, the second row %g mm to the left", reversed ? "reversed" : "as made", stepOver)
                    << reversed << stepOver;
    }
    void climbAndConventionalAreTold() {
        QFETCH(bool, reversed);
        QFETCH(double, stepOver);
        // A slot along X, then an adjacent row: there is stock only on the far side of the row.
        Take slot = takeOf(along({{-30, 0, -2}, {30, 0, -2}}, 100.0)),
             row = takeOf(along({{-20, stepOver, -2}, {20, stepOver, -2}}, 100.0));
        row.info.id = 2;
        std::vector<Edit> edits{{Simplify{}}, {Link{}}};
        if (reversed) edits.insert(edits.begin(), Edit{Reverse{{2, 0, 100000}}});
        PathContext context = contextOf(nothing, flatTool(), {{-60, -60, -20}, {60, 60, 0}});
        const auto path = run({slot, row}, edits, context);
        QVERIFY(path);
        Progress progress;
        const auto sides = millingSides(path->path, context, progress);
        QVERIFY(sides);
        const bool stockOnLeft = (stepOver > 0.0) != reversed;
        std::size_t cuts = 0;
        for (const MillingInterval& interval : sides->intervals) {
            for (std::size_t i = interval.first; i <= interval.last; ++i) {
                const PathPoint& point = path->path.points[i];
                if (point.kind != MoveKind::cut ||
                    glm::distance(point.pose.tip, path->path.points[i - 1].pose.tip) < 10.0)
                    continue;
                ++cuts;
                if (point.source == 1)
                    QVERIFY(interval.side == MillingSide::neither); // a slot: on both sides
                else
                    QVERIFY(interval.side == (stockOnLeft ? MillingSide::conventional : MillingSide::climb));
            }
        }
        QCOMPARE(cuts, std::size_t{2});
    }

    void besideAFinishedWallThePartTells() {
        const MeshDistance part(boxMesh({{-30, 3.005, -30}, {30, 10, 10}})); // on the left, without stock around
        const PathContext context = contextOf(part, flatTool(), {{-60, -60, -20}, {60, 60, -10}});
        for (const bool reversed : {false, true}) {
            std::vector<Edit> edits{{Simplify{}}, {Link{}}};
            if (reversed) edits.insert(edits.begin(), Edit{Reverse{}});
            const auto path = run({takeOf(along({{-20, 0, -5}, {20, 0, -5}}, 100.0))}, edits, context);
            QVERIFY(path);
            Progress progress;
            const auto sides = millingSides(path->path, context, progress);
            QVERIFY(sides);
            const MillingSide wanted = reversed ? MillingSide::climb : MillingSide::conventional;
            QCOMPARE(std::ranges::count(sides->intervals, wanted, &MillingInterval::side), std::ptrdiff_t{1});
        }
    }
};

BURIN_TEST(TestEnds, NoApplication)

} // namespace burin::tst_ends

#include "tst_ends.moc"

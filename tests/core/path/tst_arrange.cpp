// SPDX-FileCopyrightText: 2026 The Burin authors
// SPDX-License-Identifier: Apache-2.0
#include "core/path/drawn_edit.h"
#include "path_fixture.h"
#include "tests/test_program.h"

#include <QTest>

namespace burin::tst_arrange {

using namespace burin::test;

namespace {

const MeshDistance nothing{TriangleMesh{}};

PathContext freeContext() {
    return contextOf(nothing, ballTool(), {{-100, -100, -50}, {100, 100, 0}});
}

/// Three strokes of one take, 0.02 mm per tick: ticks 0 … 500, 600 … 1100, 1200 … 1700, each 10 mm along X.
Take threeStrokes() {
    std::vector<Tick> ticks;
    for (int row = 0; row < 3; ++row) {
        for (int i = 0; i <= 500; ++i) ticks.push_back({{0.02 * i, 4.0 * row, -1.0}});
        for (int i = 1; i < 100 && row < 2; ++i) ticks.push_back({{10.0, 4.0 * row, 0.0}, false, sampleSpindleOff});
    }
    return takeOf(ticks);
}

/// The strokes after some edits, as points; each begins with a rapid move.
std::vector<std::vector<PathPoint>> strokesAfter(const std::vector<Edit>& edits,
                                                 const std::vector<Take>& takes = {threeStrokes()}) {
    const auto path = run(takes, edits, freeContext());
    std::vector<std::vector<PathPoint>> strokes;
    if (!path) return strokes;
    for (const PathPoint& point : path->path.points) {
        if (point.kind == MoveKind::rapid) strokes.emplace_back();
        strokes.back().push_back(point);
    }
    return strokes;
}

bool isAt(const PathPoint& point, const glm::dvec3& place) {
    return glm::distance(point.pose.tip, place) < 1e-9;
}

constexpr SourceInterval second{1, 600, 1100};

} // namespace

class TestArrange : public QObject {
    Q_OBJECT

private slots:
    void anIntervalIsCutOut() {
        const auto strokes = strokesAfter({{CutOut{{1, 700, 799}}}});
        QCOMPARE(strokes.size(), std::size_t{4});
        QVERIFY(isAt(strokes[1].back(), {0.02 * 99, 4, -1}) && isAt(strokes[2].front(), {4.0, 4, -1}));
        QCOMPARE(strokesAfter({{CutOut{second}}}).size(), std::size_t{2});
        QCOMPARE(strokesAfter({{CutOut{{7, 0, 5}}}}).size(), std::size_t{3}); // another take's
    }

    void whatIsMeantStaysItWhateverComesBefore() {
        // If strokes were identified by an index, the second stroke would be another one after each of these.
        for (const Edit& before :
             std::vector<Edit>{{Reorder{{1, 0}, {}}}, {CutOut{{1, 0, 500}}}, {Split{{1, 250}}}, {Reverse{}}}) {
            const auto strokes = strokesAfter({before, {CutOut{second}}});
            QVERIFY(!strokes.empty());
            for (const auto& stroke : strokes)
                for (const PathPoint& point : stroke) QVERIFY(point.pose.tip.y != 4.0);
        }
    }

    void trimmingTakesExactLengths() {
        const auto strokes = strokesAfter({{Trim{second, 1.234, 2.345}}});
        QCOMPARE(strokes.size(), std::size_t{3});
        QVERIFY(isAt(strokes[1].front(), {1.234, 4, -1}) && isAt(strokes[1].back(), {10.0 - 2.345, 4, -1}));
        QVERIFY(isAt(strokes[0].front(), {0, 0, -1}) && isAt(strokes[0].back(), {10, 0, -1}));
        QCOMPARE(strokesAfter({{Trim{second, 6.0, 5.0}}}).size(), std::size_t{2}); // nothing of it is left
    }

    void extendingGoesStraightOn() {
        const auto strokes = strokesAfter({{Extend{second, 1.5, 2.25}}});
        QCOMPARE(strokes.size(), std::size_t{3});
        QVERIFY(isAt(strokes[1].front(), {-1.5, 4, -1}) && isAt(strokes[1].back(), {12.25, 4, -1}));
        for (std::size_t i = 1; i < strokes[1].size(); ++i) {
            const glm::dvec3 step = strokes[1][i].pose.tip - strokes[1][i - 1].pose.tip;
            QVERIFY(step.x > 0.0 && step.x < 0.0201 && step.y == 0.0 && step.z == 0.0); // filters in time see no jump
        }
        QVERIFY(isAt(strokes[0].front(), {0, 0, -1}) && isAt(strokes[2].back(), {10, 8, -1}));
        // Trimming removes the extension.
        const auto back = strokesAfter({{Extend{second, 1.5, 2.25}}, {Trim{second, 1.5, 2.25}}});
        QVERIFY(isAt(back[1].front(), {0, 4, -1}) && isAt(back[1].back(), {10, 4, -1}));
    }

    /// A stroke a little higher passes the same tab: both go over it according to its closed form, and nowhere else.
    void tabsStandInEveryStrokeThatPasses() {
        std::vector<Tick> ticks;
        for (int i = 0; i <= 1000; ++i) ticks.push_back({{0.02 * i, 4.0, -2.0}});
        for (int i = 1; i < 100; ++i) ticks.push_back({{20.0, 4.0, 0.0}, false, sampleSpindleOff});
        for (int i = 0; i <= 1000; ++i) ticks.push_back({{20.0 - 0.02 * i, 4.5, -1.8}});
        for (int i = 1; i < 100; ++i) ticks.push_back({{0.0, 4.5, 0.0}, false, sampleSpindleOff});
        for (int i = 0; i <= 1000; ++i) ticks.push_back({{0.02 * i, 30.0, -2.0}});
        KeepTabs edit;
        edit.places = {{10.0, 4.0, 99.0}};
        edit.width = 2.0;
        edit.height = 1.0;
        const auto strokes = strokesAfter({{edit}}, {takeOf(ticks)});
        QCOMPARE(strokes.size(), std::size_t{3});
        const double half = 0.5 * (2.0 + ballTool().cutter.diameter), flank = std::tan(pi / 6.0);
        for (const auto& stroke : strokes)
            for (const PathPoint& point : stroke) {
                const glm::dvec3& tip = point.pose.tip;
                const double level = tip.y == 4.5 ? -1.8 : -2.0;
                const double beyond = std::max(0.0, std::hypot(tip.x - 10.0, tip.y - 4.0) - half);
                QVERIFY(std::abs(tip.z - std::max(level, -1.0 - flank * beyond)) < 1e-9);
            }
        edit.places.clear();
        for (const auto& stroke : strokesAfter({{edit}}, {takeOf(ticks)}))
            for (const PathPoint& point : stroke) QVERIFY(point.pose.tip.z <= -1.8);
    }

    void feedsOfAStrokeChange() {
        const auto path =
            run({threeStrokes()}, {{Simplify{}}, {Link{}}, {SetFeed{}}, {ScaleFeed{second, 0.5}}}, freeContext());
        QVERIFY(path);
        int slow = 0, usual = 0;
        for (const PathPoint& point : path->path.points) {
            if (point.kind != MoveKind::cut) continue;
            const bool chosen = point.pose.tip.y == 4.0;
            QCOMPARE(point.feed, chosen ? 450.0 : 900.0);
            ++(chosen ? slow : usual);
        }
        QVERIFY(slow > 0 && usual > 0);
    }

    void splitAndJoinUndoEachOther() {
        const auto split = strokesAfter({{Split{{1, 850}}}});
        QCOMPARE(split.size(), std::size_t{4});
        QVERIFY(isAt(split[1].back(), {5, 4, -1}) && isAt(split[2].front(), {5, 4, -1}));
        const auto joined = strokesAfter({{Split{{1, 850}}}, {Join{second, 0.5}}});
        QCOMPARE(joined.size(), std::size_t{3});
    }

    void joiningGoesStraightAcross() {
        const auto strokes = strokesAfter({{Reverse{second}}, {Join{{}, 5.0}}});
        QCOMPARE(strokes.size(), std::size_t{1});
        for (std::size_t i = 1; i < strokes[0].size(); ++i) {
            const glm::dvec3 step = strokes[0][i].pose.tip - strokes[0][i - 1].pose.tip;
            QVERIFY(glm::length(step) < 0.0201); // filters in time see no jump
        }
        QCOMPARE(strokesAfter({{Reverse{second}}, {Join{{}, 3.9}}}).size(), std::size_t{3}); // too far
    }

    void strokesAreReordered() {
        const auto last = strokesAfter({{Reorder{{1, 300}, {}}}});
        QCOMPARE(last.size(), std::size_t{3});
        QCOMPARE(last[2].front().pose.tip.y, 0.0);
        const auto first = strokesAfter({{Reorder{{1, 1300}, {1, 100}}}});
        QVERIFY(first[0].front().pose.tip.y == 8.0 && first[1].front().pose.tip.y == 0.0 &&
                first[2].front().pose.tip.y == 4.0);
    }

    void reversingTurnsTheMotionsRound() {
        std::vector<Tick> ticks = along({{0, 0, -1}, {10, 0, -1}}, 20.0, false);
        append(ticks, along({{10, 0, -1}, {20, 0, -1}}, 20.0, true));
        const auto strokes = strokesAfter({{Reverse{}}, {DropAirCuts{}}}, {takeOf(ticks)});
        QCOMPARE(strokes.size(), std::size_t{1});
        QVERIFY(isAt(strokes[0].front(), {20, 0, -1}));
        QVERIFY(std::abs(strokes[0].back().pose.tip.x - 10.0) < 0.021); // where it cut, without the rest
        QVERIFY(strokes[0].front().sample > strokes[0].back().sample);
    }

    void imagesLieMirrored() {
        const auto moved = strokesAfter({{Mirror{second, Mirror::Across::x, 12.0, false}}});
        QVERIFY(moved.size() == 3 && isAt(moved[1].front(), {24, 4, -1}) && isAt(moved[1].back(), {14, 4, -1}));
        const auto kept = strokesAfter({{Mirror{second, Mirror::Across::y, -1.0, true}}});
        QVERIFY(kept.size() == 4 && isAt(kept[1].front(), {0, 4, -1}) && isAt(kept[3].front(), {0, -6, -1}));
    }

    void strokesAreTurnedAndArrayed() {
        const double quarter = std::acos(0.0);
        const auto turned = strokesAfter({{Rotate{second, {10, 4, 0}, quarter}}});
        QVERIFY(turned.size() == 3 && isAt(turned[1].front(), {10, -6, -1}) && isAt(turned[1].back(), {10, 4, -1}));
        const auto row = strokesAfter({{burin::Array{second, {0, 20, -0.5}, {}, 0.0, 3.0}}});
        QCOMPARE(row.size(), std::size_t{6});
        for (int k = 1; k <= 3; ++k)
            QVERIFY(isAt(row[static_cast<std::size_t>(2 + k)].front(), {0, 4 + 20 * k, -1 - 0.5 * k}));
        const auto ring = strokesAfter({{burin::Array{second, {0, 0, 0}, {10, 4, 0}, quarter, 3.0}}});
        QVERIFY(isAt(ring[3].front(), {10, -6, -1}) && isAt(ring[4].front(), {20, 4, -1}) &&
                isAt(ring[5].front(), {10, 14, -1}));
        QVERIFY(!run({threeStrokes()}, {{burin::Array{{}, {}, {}, 0.0, 1.5}}}, freeContext())); // half a copy
        QVERIFY(!run({threeStrokes()},
                     {{burin::Array{}},
                      {burin::Array{{}, {1, 0, 0}, {}, 0.0, 1000.0}},
                      {burin::Array{{}, {1, 0, 0}, {}, 0.0, 1000.0}}},
                     freeContext()));
    }

    void aPointIsMovedWithItsNeighbours() {
        const auto strokes = strokesAfter({{MovePoints{{1, 850, 850}, {0, 1, 0.5}, 2.0, MovePoints::Along::free}}});
        QCOMPARE(strokes.size(), std::size_t{3});
        for (const PathPoint& point : strokes[1]) {
            const double off = std::abs(point.pose.tip.x - 5.0);
            const double weight = off < 2.0 ? 0.5 * (1.0 + std::cos(std::acos(-1.0) * off / 2.0)) : 0.0;
            QVERIFY(glm::distance(point.pose.tip, {point.pose.tip.x, 4.0 + weight, -1.0 + 0.5 * weight}) < 1e-9);
        }
        for (const PathPoint& point : strokes[0]) QVERIFY(point.pose.tip.y == 0.0 && point.pose.tip.z == -1.0);
    }

    void pointsSlideOnThePart() {
        const TriangleMesh mesh = sphereMesh({0, 0, 0}, 20.0, 200);
        const MeshDistance part(mesh);
        std::vector<Tick> ticks; // a ball of 3 mm lies on a sphere of 20 mm
        for (int i = 0; i <= 1000; ++i) {
            const double angle = 0.0005 * i;
            ticks.push_back({{23.0 * std::sin(angle), 0.0, 23.0 * std::cos(angle) - 3.0}});
        }
        const MovePoints slide{{1, 500, 500}, {0, 4, 0}, 6.0, MovePoints::Along::surface};
        const auto path = run({takeOf(ticks)}, {{slide}}, contextOf(part, ballTool(), {{-30, -30, -30}, {30, 30, 30}}));
        QVERIFY(path);
        const double chord = 20.0 * (1.0 - std::cos(std::acos(-1.0) / 400.0)); // facets are inside by up to twice that
        for (const PathPoint& point : path->path.points)
            QVERIFY(std::abs(glm::length(point.pose.tip + glm::dvec3(0, 0, 3)) - 23.0) < 2.0 * chord + 1e-3);
        QVERIFY(std::abs(path->path.points[500].pose.tip.y - 4.0) < 0.2);
    }

    void anIntervalIsReplacedByWhatWasDrawn() {
        const std::vector<glm::dvec3> drawn{{2, 5, -1}, {5, 7, -2}, {8, 5, -1}};
        const auto strokes = strokesAfter({{ReplaceInterval{{1, 700, 1000}, drawn}}});
        QCOMPARE(strokes.size(), std::size_t{3});
        std::size_t found = 0;
        for (const PathPoint& point : strokes[1]) {
            if (point.sample < 700 || point.sample > 1000) {
                QCOMPARE(point.pose.tip.y, 4.0);
                continue;
            }
            QVERIFY(distanceToPolyline(point.pose.tip, drawn) < 1e-9);
            if (found < drawn.size() && isAt(point, drawn[found])) ++found;
        }
        QCOMPARE(found, drawn.size());                                            // its corners are kept
        QVERIFY(std::abs(static_cast<double>(strokes[1].size()) - 501.0) <= 2.0); // with the hand's timing
        QVERIFY(strokesAfter({{CutOut{second}}, {ReplaceInterval{{1, 700, 1000}, drawn}}}).empty()); // refused
    }

    void anAreaIsRemovedAtItsBorder() {
        RemoveArea edit;
        edit.outline = {{3.003, 3, 0}, {6.005, 3, 0}, {6.005, 9, 0}, {3.003, 9, 0}};
        const auto strokes = strokesAfter({{edit}});
        QCOMPARE(strokes.size(), std::size_t{5});
        QVERIFY(isAt(strokes[1].back(), {3.003, 4, -1}) && isAt(strokes[2].front(), {6.005, 4, -1}));
        edit.low = 0.0; // above the strokes
        QCOMPARE(strokesAfter({{edit}}).size(), std::size_t{3});
        edit = {};
        QCOMPARE(strokesAfter({{edit}}).size(), std::size_t{3}); // no outline: no effect
        edit.outline = {{-1, -1, 0}, {11, -1, 0}, {11, 11, 0}, {-1, 11, 0}};
        QCOMPARE(strokesAfter({{edit}}).size(), std::size_t{0}); // everything: an empty path
    }

    void anAreaIsLiftedAtItsBorder() {
        LiftArea edit;
        edit.outline = {{3.003, 3, 0}, {6.005, 3, 0}, {6.005, 5, 0}, {3.003, 5, 0}};
        edit.lift = 2.0;
        const auto strokes = strokesAfter({{edit}});
        QCOMPARE(strokes.size(), std::size_t{3});
        double highest = -9.0;
        for (std::size_t i = 1; i < strokes[1].size(); ++i) {
            const glm::dvec3 &from = strokes[1][i - 1].pose.tip, &to = strokes[1][i].pose.tip;
            highest = std::max(highest, to.z);
            if (from.z != to.z) QVERIFY(std::abs(from.x - 3.003) < 1e-9 || std::abs(from.x - 6.005) < 1e-9);
            const bool inside = from.x > 3.0031 && to.x < 6.0049;
            if (inside) QVERIFY(from.z == 1.0 && to.z == 1.0);
        }
        QCOMPARE(highest, 1.0);
        for (const PathPoint& point : strokes[0]) QCOMPARE(point.pose.tip.z, -1.0);
    }

    void aLineThatIsDrawnIsAMirrorsPlane() {
        EditParameters edit = Mirror{};
        const auto plane = [&] { return std::get<Mirror>(edit); };
        QVERIFY(isDrawn(edit, "at_mm") && !isDrawn(edit, "across") && !isDrawn(edit, "keep"));
        setDrawn(edit, "at_mm", {{4, -3, 7}, {1, 0, 7}, {5, 9, 7}}); // nearer to Y than to X
        QVERIFY(plane().across == Mirror::Across::x);
        QCOMPARE(plane().at, 4.5);
        setDrawn(edit, "at_mm", {{-8, 2, 0}, {8, 3, 0}});
        QVERIFY(plane().across == Mirror::Across::y);
        QCOMPARE(plane().at, 2.5);
        for (const std::vector<glm::dvec3>& nothingSaid :
             {std::vector<glm::dvec3>{}, {{1, 1, 0}}, {{1, 1, 0}, {1.2, 1.2, 9}}})
            setDrawn(edit, "at_mm", nothingSaid);
        QVERIFY(plane().across == Mirror::Across::y && plane().at == 2.5);
        // The points are the data drawn for other edits.
        EditParameters area = RemoveArea{};
        QVERIFY(isDrawn(area, "outline_mm") && !isDrawn(area, "low_mm"));
        setDrawn(area, "outline_mm", {{0, 0, 0}, {1, 0, 0}, {1, 1, 0}});
        QCOMPARE(std::get<RemoveArea>(area).outline.size(), std::size_t{3});
        const auto last = lastDrawn({{Mirror{}}, {RemoveArea{}}, {AreaFeed{}, false}, {Link{}}});
        QVERIFY(last && *last == (DrawnField{1, "outline_mm"}));
        QVERIFY(!lastDrawn({{Link{}}}));
    }

    void feedsChangeInAnArea() {
        AreaFeed edit;
        edit.outline = {{3, 3, 0}, {6, 3, 0}, {6, 5, 0}, {3, 5, 0}};
        edit.factor = 0.5;
        const auto path = run({threeStrokes()}, {{Simplify{}}, {Link{}}, {SetFeed{}}, {edit}}, freeContext());
        QVERIFY(path);
        bool slow = false;
        for (std::size_t i = 1; i < path->path.points.size(); ++i) {
            const PathPoint& point = path->path.points[i];
            if (point.kind != MoveKind::cut) continue;
            const glm::dvec3 middle = 0.5 * (path->path.points[i - 1].pose.tip + point.pose.tip);
            const bool inside = middle.x > 3 && middle.x < 6 && middle.y > 3 && middle.y < 5;
            QCOMPARE(point.feed, inside ? 450.0 : 900.0);
            slow = slow || inside;
        }
        QVERIFY(slow);
        edit.factor = 5.0;
        const auto fast = run({threeStrokes()}, {{Simplify{}}, {Link{}}, {SetFeed{}}, {edit}}, freeContext());
        QVERIFY(fast);
        for (const PathPoint& point : fast->path.points) QVERIFY(point.feed <= 2000.0); // the machine's limit
    }
};

BURIN_TEST(TestArrange, NoApplication)

} // namespace burin::tst_arrange

#include "tst_arrange.moc"

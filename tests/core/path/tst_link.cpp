// SPDX-FileCopyrightText: 2026 The Burin authors
// SPDX-License-Identifier: Apache-2.0
#include "block_fixture.h"
#include "tests/test_program.h"

#include <rapidcheck.h>

#include <QTest>

#include <vector>

namespace burin::tst_link {

using namespace burin::test;

namespace {

/// Stock as points half a millimetre apart: contact of a move is found by examining each point. Slow and obvious.
class PointStock {
public:
    explicit PointStock(const Box& box) {
        for (double z = box.low.z + 0.25; z < box.high.z; z += 0.5) {
            for (double y = box.low.y + 0.25; y < box.high.y; y += 0.5) {
                for (double x = box.low.x + 0.25; x < box.high.x; x += 0.5) points_.push_back({x, y, z});
            }
        }
    }
    bool meets(const RevolvedPiece& piece, const glm::dvec3& tip) const {
        return std::ranges::any_of(points_, [&](const glm::dvec3& point) { return inside(piece, tip, point); });
    }
    void remove(const RevolvedPiece& piece, const glm::dvec3& tip) {
        std::erase_if(points_, [&](const glm::dvec3& point) { return inside(piece, tip, point); });
    }

private:
    static bool inside(const RevolvedPiece& piece, const glm::dvec3& tip, const glm::dvec3& point) {
        const double height = point.z - tip.z, across = std::hypot(point.x - tip.x, point.y - tip.y);
        if (height < piece.bottom || height > piece.top) return false;
        const double part = (height - piece.bottom) / (piece.top - piece.bottom);
        double radius = piece.bottomRadius + part * (piece.topRadius - piece.bottomRadius);
        const double below = piece.cornerRadius - (height - piece.bottom);
        if (below > 0.0)
            radius += -piece.cornerRadius + std::sqrt(piece.cornerRadius * piece.cornerRadius - below * below);
        return across < radius;
    }
    std::vector<glm::dvec3> points_;
};

/// Strokes in layers of 2.5 mm with air between them, so that shank and holder stay clear in the recording.
std::vector<Tick> layeredStrokes() {
    std::vector<Tick> ticks;
    for (int layer = 1; layer <= 2; ++layer) {
        const double z = -2.0 * layer;
        const int count = *rc::gen::inRange(1, 4);
        for (int i = 0; i < count; ++i) {
            const glm::dvec3 from(*rc::gen::inRange(-7, 8), *rc::gen::inRange(-7, 8), z);
            const glm::dvec3 to(*rc::gen::inRange(-7, 8), *rc::gen::inRange(-7, 8), z);
            append(ticks, along({{from.x, from.y, 8}, from}, 400.0, false));
            append(ticks, along({from, to}, 400.0));
            append(ticks, along({to, {to.x, to.y, 8}}, 400.0, false));
        }
    }
    return ticks;
}

const std::vector<Edit> linkedEdits{{DropAirCuts{}}, {Simplify{}}, {Link{}}, {SetFeed{}}};

} // namespace

class TestLink : public QObject {
    Q_OBJECT

private slots:
    void rapidsNeverMeetStock() {
        const Box stock{{-8, -8, -5}, {8, 8, 0}};
        QVERIFY(rc::check("neither rapids nor shank nor holder touch what is left", [&] {
            const Tool tool = stubbyTool(*rc::gen::element(CutterType::ball, CutterType::flat));
            std::vector<Edit> edits = linkedEdits;
            for (Edit& edit : edits)
                if (Link* link = std::get_if<Link>(&edit.parameters)) {
                    link->travel = *rc::gen::element(Link::Travel::safe, Link::Travel::lowest, Link::Travel::around);
                    link->rounding = *rc::gen::element(0.0, 0.7, 5.0);
                }
            const auto path = run({takeOf(layeredStrokes())}, edits, contextOf(nothing_, tool, stock));
            RC_PRE(!isEmpty(path)); // strokes without length give an empty path
            RC_ASSERT(static_cast<bool>(path));
            PointStock left(stock);
            const std::vector<RevolvedPiece> parts = pieces(tool.cutter);
            bool clean = true;
            walk(path->path.points, 0.5, [&](const PathPoint& end, const glm::dvec3& place) {
                for (std::size_t i = 1; i < parts.size(); ++i) clean = clean && !left.meets(parts[i], place);
                if (end.kind == MoveKind::rapid)
                    clean = clean && !left.meets(parts.front(), place);
                else
                    left.remove(parts.front(), place);
            });
            RC_ASSERT(clean);
            RC_ASSERT(path->path.points.front().pose.tip.z >= 5.0 && path->path.points.back().pose.tip.z >= 5.0);
        }));
    }

    void everyMoveHasItsKindAndFeed() {
        std::vector<Tick> ticks = along({{-10, 0, -2}, {10, 0, -2}}, 40.0);
        append(ticks, along({{10, 0, -2}, {10, 0, 8}, {-10, 15, 8}, {-10, 15, -2}}, 40.0, false));
        append(ticks, along({{-10, 15, -2}, {10, 15, -2}, {12, 15, -5}, {15, 15, -7}}, 40.0));
        const auto path =
            run({takeOf(ticks)}, linkedEdits, contextOf(nothing_, ballTool(), {{-30, -30, -20}, {30, 30, 0}}));
        QVERIFY(path);
        QString kinds;
        for (const PathPoint& point : path->path.points) kinds += "rpcu"[static_cast<int>(point.kind)];
        // Over the stock, down to a millimetre above it, lead-in, along; lead-out, up, over; and the second one with
        // its slopes.
        QCOMPARE(kinds, "rrpcurrrpcccur");
        const std::vector<PathPoint>& p = path->path.points;
        QVERIFY(p[0].pose.tip == glm::dvec3(-10, 0, 5) && p[1].pose.tip == glm::dvec3(-10, 0, 1));
        QVERIFY(p[2].pose.tip == glm::dvec3(-10, 0, -2));
        for (const PathPoint& point : p) {
            if (point.kind == MoveKind::rapid) QCOMPARE(point.feed, 0.0);
            if (point.kind == MoveKind::plunge) QCOMPARE(point.feed, 300.0);
            if (point.kind == MoveKind::retract) QCOMPARE(point.feed, 900.0);
        }
        QCOMPARE(p[9].feed, 900.0);
        QCOMPARE(p[10].feed, 300.0);                  // 3 mm down over 2 mm: steeper than 45°
        QCOMPARE(p[11].feed, 900.0);                  // 2 mm down over 3 mm
        QVERIFY(p[3].source == 1 && p[3].sample > 0); // the moment of the hand's sample
        QVERIFY(p[0].source == 0 && p[0].sample == -1);
    }

    void neighbouringRowsAreJoinedWithoutALift() {
        const auto path =
            run({takeOf(rows())}, linkedEdits, contextOf(nothing_, ballTool(), {{-30, -30, -20}, {30, 30, 0}}));
        QVERIFY(path);
        QCOMPARE(std::ranges::count(path->path.points, MoveKind::plunge, &PathPoint::kind), 1);
    }

    void aShankThatWouldRubForcesALift() {
        const PathContext slender = contextOf(nothing_, ballTool(4.0), {{-30, -30, -20}, {30, 30, 0}});
        const PathContext stubby =
            contextOf(nothing_, stubbyTool(CutterType::ball), slender.stock); // the shank begins 6 mm above the tip
        for (const auto& [context, plunges] : {std::pair{slender, 1}, std::pair{stubby, 2}}) {
            const auto path = run({takeOf(rows(4.0, -8.0))}, linkedEdits, context);
            QVERIFY(path);
            QCOMPARE(std::ranges::count(path->path.points, MoveKind::plunge, &PathPoint::kind), plunges);
        }
    }

    void aWallBetweenRowsForcesALift() {
        const Box wall{{-20, 3.9, -10}, {20, 4.1, 0}};
        const MeshDistance part(boxMesh(wall));
        const auto path =
            run({takeOf(rows(8.0))}, linkedEdits, contextOf(part, ballTool(10.0), {{-30, -30, -20}, {30, 30, 0}}));
        QVERIFY(!path || std::ranges::count(path->path.points, MoveKind::plunge, &PathPoint::kind) == 2);
        const auto narrow =
            run({takeOf(rows(8.0))}, linkedEdits, contextOf(part, ballTool(), {{-30, -30, -20}, {30, 30, 0}}));
        QVERIFY(narrow);
        QCOMPARE(std::ranges::count(narrow->path.points, MoveKind::plunge, &PathPoint::kind), 2);
    }

    void linksGoOverAClampBetweenRows() {
        const Box clamp{{-30, 3.9, -3}, {30, 4.1, 12}};
        Obstacle obstacle;
        obstacle.shape = clamp;
        obstacle.margin = 0.5;
        PathContext context = contextOf(nothing_, ballTool(), {{-30, -30, -20}, {30, 30, 0}});
        const auto linked = [&] { return run({takeOf(rows(8.0))}, linkedEdits, context); };
        const auto before = linked();
        QVERIFY(before);
        for (const bool on : {true, false}) {
            obstacle.on = on;
            context.obstacles = solidsOf(std::vector{obstacle});
            const auto path = linked();
            QVERIFY(path);
            if (!on) {
                QCOMPARE(path->path.points.size(), before->path.points.size());
                continue;
            }
            walk(path->path.points, 0.05, [&](const PathPoint&, const glm::dvec3& place) {
                // Up to the holder, which is higher than the clamp, the tool is no wider than its ball.
                QVERIFY(std::abs(place.y - 4.0) > 0.1 + 3.0 - 1e-6 || place.z > clamp.high.z);
            });
            QVERIFY(path->path.points.front().pose.tip.z >= clamp.high.z + obstacle.margin + 5.0);
        }
    }

    void linksGoRoundAPost() {
        // 40 mm straight across; the post, the tool's radius and the margin leave 5.5 mm on either side of the centre.
        const Box post{{-2, -2, -3}, {2, 2, 40}};
        const auto safe = linkedAround({post}, {{-20, 0}, {20, 0}}, Link::Travel::safe, 0.0);
        const auto around = linkedAround({post}, {{-20, 0}, {20, 0}}, Link::Travel::around, 0.0);
        QVERIFY(safe && around);
        const double level = levelLength(around->path.points);
        QVERIFY2(level > 40.0 && level < 2.0 * std::hypot(14.5, 5.5) + 11.0 + 1.0, qPrintable(QString::number(level)));
        QVERIFY(rapidLength(around->path.points) < rapidLength(safe->path.points) - 60.0);
        // With a wall right across, the only route is over it.
        const Box wall{{-2, -200, -3}, {2, 200, 40}};
        const auto over = linkedAround({wall}, {{-20, 0}, {20, 0}}, Link::Travel::around, 0.0);
        QVERIFY(over);
        const double walled = levelLength(over->path.points);
        QVERIFY(std::abs(walled - 40.0) < 1e-6 || walled > 400.0);
        QVERIFY(leastClearance(over->path.points, {wall}) >= margin - 1e-3);
    }

    void noWayRoundComesTooNear() {
        int shorter = 0;
        QVERIFY(rc::check("links keep the margin, and are no longer than over everything", [&] {
            std::vector<Box> posts;
            const int count = *rc::gen::inRange(1, 5);
            for (int i = 0; i < count; ++i) {
                const glm::dvec3 at(*rc::gen::inRange(-9, 9), *rc::gen::inRange(-24, 24), -3.0);
                posts.push_back(
                    {at, at + glm::dvec3(*rc::gen::inRange(1, 5), *rc::gen::inRange(1, 15), *rc::gen::inRange(2, 45))});
            }
            const auto end = [] { return 1.0 * *rc::gen::inRange(-20, 20); };
            const std::vector<glm::dvec2> ends{{-20, end()}, {20, end()}, {-20, end()}};
            const auto safe = linkedAround(posts, ends, Link::Travel::safe, 0.0);
            const auto around = linkedAround(posts, ends, Link::Travel::around, 0.0);
            const auto smooth = linkedAround(posts, ends, Link::Travel::around, 4.0);
            RC_ASSERT(safe && around && smooth);
            RC_ASSERT(leastClearance(around->path.points, posts) >= margin - 1e-3);
            RC_ASSERT(leastClearance(smooth->path.points, posts) >= margin - 1e-3);
            RC_ASSERT(rapidLength(around->path.points) <= rapidLength(safe->path.points) + 1e-6);
            RC_ASSERT(rapidLength(smooth->path.points) <= rapidLength(around->path.points) + 1e-6);
            shorter += rapidLength(around->path.points) < rapidLength(safe->path.points) - 5.0 ? 1 : 0;
        }));
        QVERIFY2(shorter > 20, qPrintable(QString::number(shorter)));
    }

    void roundedLinksTurnLittleByLittle() {
        const auto sharpest = [](const std::vector<PathPoint>& points) {
            double most = 0.0;
            for (std::size_t i = 2; i < points.size(); ++i) {
                if (points[i].kind != MoveKind::rapid || points[i - 1].kind != MoveKind::rapid) continue;
                const glm::dvec3 before = points[i - 1].pose.tip - points[i - 2].pose.tip,
                                 on = points[i].pose.tip - points[i - 1].pose.tip;
                if (glm::length(before) < 1e-6 || glm::length(on) < 1e-6) continue;
                const double cosine = glm::dot(glm::normalize(before), glm::normalize(on));
                most = std::max(most, std::acos(std::clamp(cosine, -1.0, 1.0)));
            }
            return most;
        };
        const std::vector<glm::dvec2> ends{{-20, 0}, {20, 10}};
        const auto between = [&](double rounding) {
            auto path = linkedAround({}, ends, Link::Travel::safe, rounding);
            auto& points = path->path.points; // the first descent has no start point
            points.erase(points.begin(), std::ranges::find(points, MoveKind::retract, &PathPoint::kind));
            return points;
        };
        QVERIFY(sharpest(between(0.0)) > 1.5);
        QVERIFY(sharpest(between(2.0)) < 0.35);
        // And the feed moves before and after them: the stroke is left, and entered, along its own direction.
        const auto points = linkedAround({}, ends, Link::Travel::safe, 2.0)->path.points;
        int turns = 0;
        for (std::size_t i = 2; i < points.size(); ++i) {
            const bool out = points[i].kind == MoveKind::retract && points[i - 1].kind == MoveKind::cut;
            const bool in = points[i].kind == MoveKind::cut && points[i - 1].kind == MoveKind::plunge;
            if (!out && !in) continue;
            const glm::dvec3 before = glm::normalize(points[i - 1].pose.tip - points[i - 2].pose.tip);
            const glm::dvec3 on = glm::normalize(points[i].pose.tip - points[i - 1].pose.tip);
            QVERIFY2(glm::dot(before, on) > 0.97, qPrintable(QString::number(glm::dot(before, on))));
            ++turns;
        }
        QCOMPARE(turns, 4);
    }

    void aClearedPlaceIsReachedRapidly() {
        // The same slot twice: the second time there is no stock left to plunge into.
        std::vector<Tick> ticks = along({{-10, 0, -4}, {10, 0, -4}}, 40.0);
        append(ticks, along({{10, 0, -4}, {10, 0, 8}, {-10, 0, 8}, {-10, 0, -4}}, 40.0, false));
        append(ticks, along({{-10, 0, -4}, {0, 0, -4}, {0, 6, -4}}, 40.0));
        const auto path =
            run({takeOf(ticks)}, linkedEdits, contextOf(nothing_, flatTool(), {{-30, -30, -20}, {30, 30, 0}}));
        QVERIFY(path);
        double lowest = 1e9;
        for (const PathPoint& point : path->path.points) {
            if (point.kind == MoveKind::rapid) lowest = std::min(lowest, point.pose.tip.z);
        }
        // At the slot's end the round shape of the cutter leaves nothing within the tool's own circle, but the height
        // map of squares is conservative there; so the rapid stops at the stock's top or lower, never below the slot's
        // floor.
        QVERIFY(lowest >= -4.0 && lowest <= 1.0);
    }

    /// At a depth greater than the flute length the neck is in the cut: on their way up the flutes cut the stock left
    /// above them.
    void aDeepPlaceIsNotLeftRapidlyThroughStock() {
        Tool tool = ballTool(4.0);
        tool.cutter.fluteLength = 4.0;
        tool.cutter.shankDiameter = 3.0;
        const Box stock{{-8, -8, -20}, {8, 8, 0}};
        const auto path =
            run({takeOf(along({{-6, 0, -1}, {6, 0, -9}}, 40.0))}, linkedEdits, contextOf(nothing_, tool, stock));
        QVERIFY(path);
        PointStock left(stock);
        const RevolvedPiece flutes = pieces(tool.cutter).front();
        std::size_t rapidsInStock = 0;
        double highestFeed = -20.0;
        walk(path->path.points, 0.25, [&](const PathPoint& end, const glm::dvec3& place) {
            if (end.kind == MoveKind::rapid)
                rapidsInStock += left.meets(flutes, place) ? 1U : 0U;
            else
                left.remove(flutes, place);
            if (end.kind == MoveKind::retract) highestFeed = std::max(highestFeed, place.z);
        });
        QCOMPARE(rapidsInStock, std::size_t{0});
        QCOMPARE(highestFeed, -4.0); // the flutes' upper end has reached the top of the stock
    }

    void anOverhangIsLeftTheWayItWasEntered() {
        // A slotting cutter with a thin neck under a ledge: a move straight up would cross the part.
        Tool tool = flatTool(8.0);
        tool.cutter.fluteLength = 3.0;
        tool.cutter.shankDiameter = 3.0;
        const Box ledge{{0, -20, -4}, {20, 20, 0}};
        const MeshDistance part(boxMesh(ledge));
        const PathContext context = contextOf(part, tool, {{-30, -30, -20}, {30, 30, 0}});
        const auto path = run({takeOf(along({{-10, 0, -8}, {-2, 0, -8}}, 40.0))}, linkedEdits, context);
        QVERIFY2(path, path ? "" : path.error().place.c_str());
        walk(path->path.points, 0.1, [&](const PathPoint&, const glm::dvec3& place) {
            // The flutes' disc must be below or to the side of the ledge, or above it.
            const bool beside = place.x + 4.0 <= 1e-6;
            QVERIFY(beside || place.z + 3.0 <= -4.0 + 1e-6 || place.z >= 0.0);
        });
        const auto enclosed = run({takeOf(along({{-3, 0, -8}, {-2, 0, -8}}, 40.0))}, linkedEdits, context);
        QVERIFY(!enclosed);
        QCOMPARE(enclosed.error().code, ErrorCode::pathGouges);
    }

private:
    /// Two adjacent rows with a lift of the hand between them.
    static std::vector<Tick> rows(double apart = 2.0, double z = -2.0) {
        std::vector<Tick> ticks = along({{-10, 0, z}, {10, 0, z}}, 40.0);
        append(ticks, along({{10, 0, z}, {10, 0, 4}, {10, apart, 4}, {10, apart, z}}, 40.0, false));
        append(ticks, along({{10, apart, z}, {-10, apart, z}}, 40.0));
        return ticks;
    }
    static constexpr double margin = 0.5, radius = 3.0;

    /// Short strokes at some points, one after the other, with posts between them.
    static Result<EvaluatedPath> linkedAround(const std::vector<Box>& posts, const std::vector<glm::dvec2>& ends,
                                              Link::Travel travel, double rounding) {
        static const MeshDistance nothing{TriangleMesh{}};
        std::vector<Obstacle> obstacles;
        for (const Box& post : posts) {
            Obstacle obstacle;
            obstacle.shape = post;
            obstacle.margin = margin;
            obstacles.push_back(obstacle);
        }
        PathContext context = contextOf(nothing, ballTool(2.0 * radius), {{-30, -30, -20}, {30, 30, 0}});
        context.obstacles = solidsOf(obstacles);
        std::vector<Tick> ticks;
        for (const glm::dvec2& end : ends) {
            const glm::dvec3 from(end, -1.0), to = from + glm::dvec3(end.x < 0.0 ? -4.0 : 4.0, 0.0, 0.0);
            append(ticks, along({from, to}, 100.0));
            append(ticks, along({to, from}, 100.0));
            append(ticks, along({from, from + glm::dvec3(0.0, 0.0, 60.0)}, 400.0, false));
        }
        Link link;
        link.travel = travel;
        link.rounding = rounding;
        return run({takeOf(ticks)}, {{DropAirCuts{}}, {Simplify{}}, {link}}, context);
    }
    static double rapidLength(const std::vector<PathPoint>& points) {
        double length = 0.0;
        for (std::size_t i = 1; i < points.size(); ++i)
            if (points[i].kind == MoveKind::rapid) length += glm::distance(points[i - 1].pose.tip, points[i].pose.tip);
        return length;
    }
    /// Horizontal length of the rapids.
    static double levelLength(const std::vector<PathPoint>& points) {
        double length = 0.0;
        for (std::size_t i = 1; i < points.size(); ++i)
            if (points[i].kind == MoveKind::rapid)
                length += glm::distance(glm::dvec2(points[i - 1].pose.tip), glm::dvec2(points[i].pose.tip));
        return length;
    }
    /// Least clearance of all moves: the tool is a ball with a shank as wide, its holder is above everything.
    static double leastClearance(const std::vector<PathPoint>& points, const std::vector<Box>& posts) {
        double least = 1e9;
        walk(points, 0.25, [&](const PathPoint&, const glm::dvec3& tip) {
            for (const Box& post : posts) {
                const glm::dvec3 from(tip.x, tip.y, std::max(tip.z + radius, post.low.z)); // nearest point of the axis
                least = std::min(least, glm::distance(from, glm::clamp(from, post.low, post.high)) - radius);
            }
        });
        return least;
    }
    const MeshDistance nothing_{TriangleMesh{}};
};

BURIN_TEST(TestLink, NoApplication)

} // namespace burin::tst_link

#include "tst_link.moc"

// SPDX-FileCopyrightText: 2026 The Burin authors
// SPDX-License-Identifier: Apache-2.0
#include "core/path/hand_interval.h"
#include "tests/test_program.h"

#include <QTest>

#include <numbers>

namespace burin::tst_hand_interval {

namespace {

constexpr std::int64_t take = 7;

PathPoint point(double x, std::int64_t tick) {
    return {{{x, 0.0, -2.0}}, MoveKind::cut, 0.0, take, tick, {}};
}

PathPoint link(double x) {
    return {{{x, 0.0, 5.0}}, MoveKind::rapid, 0.0, 0, -1, {}};
}

/// Chains as positions along X and the ticks there.
std::vector<std::vector<std::pair<double, std::int64_t>>> along(const Path& path, const SourceInterval& interval) {
    std::vector<std::vector<std::pair<double, std::int64_t>>> chains;
    for (const std::vector<PathPoint>& chain : pointsOf(path, interval)) {
        chains.emplace_back();
        for (const PathPoint& each : chain) chains.back().emplace_back(each.pose.tip.x, each.sample);
    }
    return chains;
}

} // namespace

using Chains = std::vector<std::vector<std::pair<double, std::int64_t>>>;

class TestHandInterval : public QObject {
    Q_OBJECT
private slots:
    void aMomentWhosePointIsLeftOutStaysInItsPlace();
    void endsOfAnIntervalStandBetweenPoints();
    void whatWasTurnedRoundOrCopiedIsMeantAsWell();
    void whatLeftThePathIsNowhere();
    void onAnArcItStaysOnTheArc();
    void aMoveLeadsThroughWhatLiesBehindItsStart();
};

void TestHandInterval::aMomentWhosePointIsLeftOutStaysInItsPlace() {
    Path path;
    path.points = {link(0), point(0, 100), point(10, 200), point(30, 300)};
    QCOMPARE(along(path, {take, 200, 200}), (Chains{{{10.0, 200}}}));
    QCOMPARE(along(path, {take, 250, 250}), (Chains{{{20.0, 250}}}));
    QCOMPARE(along(path, {take, 101, 101}), (Chains{{{0.1, 101}}}));
    QCOMPARE(pointsOf(path, {take, 250, 250})[0][0].pose.tip.z, -2.0);
}

void TestHandInterval::endsOfAnIntervalStandBetweenPoints() {
    Path path;
    path.points = {point(0, 100), point(10, 200), point(30, 300)};
    QCOMPARE(along(path, {take, 150, 250}), (Chains{{{5.0, 150}, {10.0, 200}, {20.0, 250}}}));
    QCOMPARE(along(path, {take, 225, 275}), (Chains{{{15.0, 225}, {25.0, 275}}}));
    QCOMPARE(along(path, {take, 0, 1000}), (Chains{{{0.0, 100}, {10.0, 200}, {30.0, 300}}}));
}

void TestHandInterval::whatWasTurnedRoundOrCopiedIsMeantAsWell() {
    Path path;
    path.points = {point(30, 300), point(10, 200), point(0, 100), link(0), link(50), point(50, 100), point(60, 200)};
    QCOMPARE(along(path, {take, 150, 250}),
             (Chains{{{20.0, 250}, {10.0, 200}, {5.0, 150}}, {{55.0, 150}, {60.0, 200}}}));
    QCOMPARE(along(path, {take, 125, 125}), (Chains{{{2.5, 125}}, {{52.5, 125}}}));
}

void TestHandInterval::whatLeftThePathIsNowhere() {
    Path path;
    path.points = {point(0, 100), point(10, 200), link(10), link(30), point(30, 300), point(40, 400)};
    QVERIFY(pointsOf(path, {take, 250, 250}).empty());
    QVERIFY(pointsOf(path, {take, 20, 80}).empty());
    QVERIFY(pointsOf(path, {take + 1, 150, 150}).empty());
    path.points = {point(0, 100), point(30, 300)};
    path.points.back().kind = MoveKind::rapid; // straight across the part that an edit removed
    QVERIFY(pointsOf(path, {take, 250, 250}).empty());
}

void TestHandInterval::onAnArcItStaysOnTheArc() {
    Path path;
    path.points = {point(10, 0), point(-10, 300)};
    path.points.back().arc = PathArc{{0.0, 0.0, 0.0}, 2, false};
    const auto chains = pointsOf(path, {take, 100, 100});
    QCOMPARE(chains.size(), std::size_t{1});
    const double angle = std::numbers::pi / 3.0; // a third of the half circle
    QVERIFY(glm::distance(chains[0][0].pose.tip, glm::dvec3(10.0 * std::cos(angle), 10.0 * std::sin(angle), -2.0)) <
            1e-9);
}

void TestHandInterval::aMoveLeadsThroughWhatLiesBehindItsStart() {
    const Moment from{take, 100}, to{take, 200};
    QVERIFY(leadsThrough(from, to, {take, 150, 150}));
    QVERIFY(leadsThrough(to, from, {take, 150, 150}));
    QVERIFY(leadsThrough(from, to, {take, 0, 150}));
    QVERIFY(leadsThrough(from, to, {take, 200, 200}));
    QVERIFY(!leadsThrough(from, to, {take, 100, 100}));
    QVERIFY(leadsThrough(to, from, {take, 100, 100}));
    QVERIFY(!leadsThrough(to, from, {take, 200, 200}));
    QVERIFY(!leadsThrough(from, to, {take, 201, 300}));
    QVERIFY(!leadsThrough({take + 1, 100}, to, {take, 150, 150}));
    QVERIFY(!leadsThrough({}, to, {take, 150, 150}));
    QVERIFY(leadsThrough({}, to, {take, 200, 200}));
    QVERIFY(!leadsThrough(from, {}, SourceInterval{})); // all of the hand's motion
    QVERIFY(leadsThrough({}, to, SourceInterval{}));
    PathPoint drawn = point(0, 100);
    drawn.sample = -1;
    QCOMPARE(momentOf(drawn), Moment{});
}

BURIN_TEST(TestHandInterval, NoApplication)

} // namespace burin::tst_hand_interval

#include "tst_hand_interval.moc"

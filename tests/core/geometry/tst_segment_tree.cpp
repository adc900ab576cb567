// SPDX-FileCopyrightText: 2026 The Burin authors
// SPDX-License-Identifier: Apache-2.0
#include "core/geometry/segment_tree.h"
#include "tests/test_program.h"

#include <QtTest>

#include <algorithm>
#include <cmath>
#include <random>

namespace burin::tst_segment_tree {

namespace {

/// By ternary search along each segment, as the distance from a point is convex along it.
double slowDistance(const glm::dvec3& point, const std::vector<StraightSegment>& segments) {
    double least = 1e300;
    for (const StraightSegment& segment : segments) {
        double low = 0.0, high = 1.0;
        const auto at = [&](double share) { return glm::distance(point, glm::mix(segment.from, segment.to, share)); };
        for (int i = 0; i < 100; ++i) {
            const double a = low + (high - low) / 3.0, b = high - (high - low) / 3.0;
            (at(a) < at(b) ? high : low) = at(a) < at(b) ? b : a;
        }
        least = std::min({least, at(low), at(0.0), at(1.0)});
    }
    return least;
}

} // namespace

class TestSegmentTree : public QObject {
    Q_OBJECT
private slots:
    void distancesAreThoseOfTheNearest_data() {
        QTest::addColumn<int>("count");
        QTest::addColumn<double>("length"); // mm, at most
        QTest::newRow("one") << 1 << 10.0;
        QTest::newRow("a full leaf") << 4 << 10.0;
        QTest::newRow("short ones") << 300 << 1.0;
        QTest::newRow("long ones") << 200 << 100.0;
        QTest::newRow("points") << 100 << 0.0;
    }
    void distancesAreThoseOfTheNearest() {
        QFETCH(int, count);
        QFETCH(double, length);
        std::mt19937 random(static_cast<unsigned>(count));
        std::uniform_real_distribution<double> place(-50.0, 50.0), part(-0.5 * length, 0.5 * length);
        std::vector<StraightSegment> segments;
        for (int i = 0; i < count; ++i) {
            const glm::dvec3 from(place(random), place(random), 0.1 * place(random));
            segments.push_back({from, from + glm::dvec3(part(random), part(random), part(random))});
        }
        const SegmentTree tree(segments);
        std::uint32_t near = 0; // of the previous point, which may be far away
        for (int i = 0; i < 200; ++i) {
            const glm::dvec3 point(place(random), place(random), place(random));
            const double found = tree.distance(point, near);
            QVERIFY(near < static_cast<std::uint32_t>(count));
            QVERIFY2(std::abs(found - slowDistance(point, segments)) < 1e-6, qPrintable(QString::number(found)));
            std::uint32_t again = near;
            QCOMPARE(tree.distance(point, again), found);
        }
    }

    void segmentsThatLieOnOneAnotherAreDivided() {
        const SegmentTree tree(std::vector<StraightSegment>(1000, {{0.0, 0.0, 0.0}, {10.0, 0.0, 0.0}}));
        std::uint32_t near = 0;
        QCOMPARE(tree.distance({5.0, 3.0, 4.0}, near), 5.0);
        QCOMPARE(tree.distance({13.0, 0.0, 4.0}, near), 5.0);
        QVERIFY(SegmentTree({}).empty());
    }
};

BURIN_TEST(TestSegmentTree, NoApplication)

} // namespace burin::tst_segment_tree

#include "tst_segment_tree.moc"

// SPDX-FileCopyrightText: 2026 The Burin authors
// SPDX-License-Identifier: Apache-2.0
#include "core/job/stock_left.h"
#include "tests/test_program.h"

#include <QtTest>

#include <cmath>

namespace burin::tst_stock_left {

namespace {

void addBox(TriangleMesh& mesh, const glm::dvec3& low, const glm::dvec3& high) {
    const auto first = static_cast<std::uint32_t>(mesh.vertices.size());
    for (int i = 0; i < 8; ++i)
        mesh.vertices.emplace_back(i & 1 ? high.x : low.x, i & 2 ? high.y : low.y, i & 4 ? high.z : low.z);
    for (const auto& [a, b, c, d] :
         {std::array{0u, 2u, 3u, 1u}, std::array{4u, 5u, 7u, 6u}, std::array{0u, 1u, 5u, 4u},
          std::array{2u, 6u, 7u, 3u}, std::array{0u, 4u, 6u, 2u}, std::array{1u, 3u, 7u, 5u}}) {
        mesh.triangles.push_back({first + a, first + b, first + c});
        mesh.triangles.push_back({first + a, first + c, first + d});
    }
}

Tool ball(double radius) {
    Tool tool;
    tool.cutter.type = CutterType::ball;
    tool.cutter.diameter = tool.cutter.shankDiameter = 2.0 * radius;
    tool.cutter.cornerRadius = radius;
    tool.cutter.fluteLength = 40.0;
    tool.cutter.stickOut = 60.0;
    return tool;
}

PathPoint cutTo(const glm::dvec3& tip) {
    PathPoint point;
    point.pose.tip = tip;
    return point;
}

} // namespace

class StockLeftTest final : public QObject {
    Q_OBJECT

private slots:
    /// Rows of a ball on a level face: between two of them the distance of its points from the nearest one is sqrt(u² +
    /// R²) − R.
    void ridgesBetweenRowsAreMeasured() {
        constexpr double radius = 3.0, apart = 1.0;
        TriangleMesh mesh;
        addBox(mesh, {0.0, 0.0, 0.0}, {30.0, 20.0, 5.0});
        const MeshDistance part(mesh);
        StockLeftMeter meter(part, {{0.0, 0.0, 0.0}, {30.0, 20.0, 8.0}});
        PassRequest request;
        request.kind = PassKind::parallel;
        request.steepest = 0.1;
        Progress progress;
        const StockLeft before = meter.leftBy(request, ball(radius), progress);
        QVERIFY(std::abs(before.reachable - 600.0) < 3.0);
        QCOMPARE(before.most, 3.0); // the height of the stock on it, which is less towards its sides
        std::vector<PathPoint> way{cutTo({-5.0, -0.5, 20.0})};
        for (double y = -0.5; y < 21.0; y += 2.0 * apart) {
            way.push_back(cutTo({-5.0, y, 5.0}));
            way.push_back(cutTo({35.0, y, 5.0}));
            way.push_back(cutTo({35.0, y + apart, 5.0}));
            way.push_back(cutTo({-5.0, y + apart, 5.0}));
        }
        meter.sweep(way, 1, way.size() - 1, ball(radius), progress);
        const StockLeft left = meter.leftBy(request, ball(radius), progress);
        const auto at = [&](double share) { return std::hypot(0.5 * share * apart, radius) - radius; };
        QVERIFY2(std::abs(left.most - at(1.0)) < 0.001, qPrintable(QString::number(left.most)));
        QVERIFY2(std::abs(left.within99 - at(0.99)) < 0.001, qPrintable(QString::number(left.within99)));
        way.back().kind = MoveKind::rapid;
        StockLeftMeter other(part, {{0.0, 0.0, 0.0}, {30.0, 20.0, 8.0}});
        other.sweep(way, way.size() - 1, way.size() - 1, ball(radius), progress);
        QCOMPARE(other.leftBy(request, ball(radius), progress).most, 3.0); // a rapid removes nothing
    }

    /// At the foot of a wall a ball reaches neither floor nor wall nearer than its radius; with an area and a lowest
    /// height only what is inside them counts.
    void onlyWhatCanBeReachedCounts() {
        constexpr double radius = 3.0;
        TriangleMesh mesh;
        addBox(mesh, {0.0, 0.0, 0.0}, {20.0, 20.0, 5.0});
        addBox(mesh, {20.0, 0.0, 0.0}, {30.0, 20.0, 15.0});
        const MeshDistance part(mesh);
        StockLeftMeter meter(part, {{0.0, 0.0, 0.0}, {30.0, 20.0, 15.0}});
        PassRequest floor;
        floor.kind = PassKind::parallel;
        floor.steepest = 0.1;
        floor.bottom = 5.0;
        Progress progress;
        const auto near = [](double value, double expected) { return std::abs(value - expected) < 0.02 * expected; };
        const double level = meter.leftBy(floor, ball(radius), progress).reachable;
        QVERIFY2(near(level, 17.0 * 20.0 + 10.0 * 20.0), qPrintable(QString::number(level)));
        floor.bottom = 10.0;
        QVERIFY(near(meter.leftBy(floor, ball(radius), progress).reachable, 10.0 * 20.0));
        floor.bottom.reset();
        floor.kind = PassKind::face; // only the part's top
        QVERIFY(near(meter.leftBy(floor, ball(radius), progress).reachable, 10.0 * 20.0));
        floor.kind = PassKind::parallel;
        floor.bottom = 5.0;
        floor.area = rectangle({2.0, 2.0}, {12.0, 12.0});
        QVERIFY(near(meter.leftBy(floor, ball(radius), progress).reachable, 10.0 * 10.0));
        PassRequest wall;
        wall.kind = PassKind::waterline;
        wall.flattest = 1.5;
        wall.bottom = 5.0;
        // Walls below whose top the tip does not go: those at the border of the floor, 5 mm high, can't be touched
        // above the tip's lowest height; the inner wall from the radius above the floor upwards, the outer ones of the
        // block from there, too.
        const double upright = meter.leftBy(wall, ball(radius), progress).reachable;
        const double expected = 7.0 * 20.0 + 7.0 * (20.0 + 2.0 * 10.0);
        QVERIFY2(near(upright, expected), qPrintable(QString("%1 of %2").arg(upright).arg(expected)));
    }

    void nothingIsLeftOfNothing() {
        const MeshDistance none{TriangleMesh{}};
        StockLeftMeter meter(none, {{0.0, 0.0, 0.0}, {1.0, 1.0, 1.0}});
        Progress progress;
        QCOMPARE(meter.leftBy({}, ball(1.0), progress).reachable, 0.0);
    }
};

BURIN_TEST(StockLeftTest, NoApplication)

} // namespace burin::tst_stock_left

#include "tst_stock_left.moc"

// SPDX-FileCopyrightText: 2026 The Burin authors
// SPDX-License-Identifier: Apache-2.0
#include "core/base/units.h"
#include "core/geometry/segment.h"
#include "core/passes/drill_pass.h"
#include "core/passes/near_segments.h"
#include "core/passes/plan_pass.h"
#include "core/passes/tip_drop.h"
#include "tests/core/passes/pass_stage.h"
#include "tests/test_program.h"

#include <QCoreApplication>
#include <QtTest>
#include <random>

namespace burin::tst_computed_pass {

using namespace burin::test;

namespace {

/// Lowers a cutter onto every triangle by the closed formulas for vertex and facet; on an edge the height is concave,
/// and its maximum is found by ternary search. Independent of the code under test.
class BruteDrop {
public:
    BruteDrop(const TriangleMesh& mesh, double radius, double corner) : mesh_(mesh), radius_(radius), corner_(corner) {}

    double at(const glm::dvec2& place) const {
        double highest = -1e300;
        for (const auto& triangle : mesh_.triangles) {
            const glm::dvec3 p[3] = {mesh_.vertices[triangle[0]], mesh_.vertices[triangle[1]],
                                     mesh_.vertices[triangle[2]]};
            for (int i = 0; i < 3; ++i) {
                highest = std::max(highest, onVertex(place, p[i]));
                highest = std::max(highest, onEdge(place, p[i], p[(i + 1) % 3]));
            }
            highest = std::max(highest, onFacet(place, p));
        }
        return highest;
    }

private:
    /// mm, height of the cutter's lower surface above its tip; infinite outside the cutter.
    double rise(double distance) const {
        if (distance > radius_ + 1e-9) return 1e300; // tolerance for rounding at the ends of an edge
        const double out = distance - (radius_ - corner_);
        return out <= 0.0 ? 0.0 : corner_ - std::sqrt(std::max(0.0, corner_ * corner_ - out * out));
    }
    double onVertex(const glm::dvec2& place, const glm::dvec3& p) const {
        return p.z - rise(glm::distance(place, glm::dvec2(p)));
    }
    double onEdge(const glm::dvec2& place, const glm::dvec3& a, const glm::dvec3& b) const {
        double low = 0.0, high = 1.0; // the interval of the edge that lies under the cutter
        const glm::dvec2 along = glm::dvec2(b - a), from = glm::dvec2(a) - place;
        const double square = glm::dot(along, along);
        if (square < 1e-12) return -1e300;
        const double middle = -glm::dot(from, along) / square;
        const double half = (radius_ * radius_ - glm::dot(from, from)) / square + middle * middle;
        if (half <= 0.0) return -1e300;
        low = std::max(low, middle - std::sqrt(half));
        high = std::min(high, middle + std::sqrt(half));
        if (low >= high) return -1e300;
        const auto height = [&](double t) { return onVertex(place, glm::mix(a, b, t)); };
        for (int i = 0; i < 100; ++i) {
            const double one = low + (high - low) / 3.0, two = high - (high - low) / 3.0;
            (height(one) < height(two) ? low : high) = height(one) < height(two) ? one : two;
        }
        return height(0.5 * (low + high));
    }
    double onFacet(const glm::dvec2& place, const glm::dvec3 (&p)[3]) const {
        glm::dvec3 normal = glm::cross(p[1] - p[0], p[2] - p[0]);
        if (std::abs(normal.z) < 1e-12) return -1e300;
        normal = glm::normalize(normal.z > 0.0 ? normal : -normal);
        const glm::dvec2 side(normal);
        const double slant = glm::length(side);
        const glm::dvec2 out = slant > 0.0 ? side / slant : glm::dvec2(0.0);
        const glm::dvec2 touch = place - (radius_ - corner_) * out - corner_ * side;
        for (int i = 0; i < 3; ++i) {
            const glm::dvec2 a(p[i]), b(p[(i + 1) % 3]), c(p[(i + 2) % 3]);
            const auto cross = [](const glm::dvec2& u, const glm::dvec2& v) { return u.x * v.y - u.y * v.x; };
            if (cross(b - a, touch - a) * cross(b - a, c - a) < 0.0) return -1e300;
        }
        const double z = p[0].z - glm::dot(side, touch - glm::dvec2(p[0])) / normal.z;
        return z + corner_ * normal.z - corner_;
    }

    const TriangleMesh& mesh_;
    double radius_, corner_;
};

/// A hemisphere 2 mm above the floor, and a ball of 6 mm.
constexpr double domeRadius = 14.0;
Ground domeGround() {
    const auto dome = [](double x, double y) {
        return 2.0 + std::sqrt(std::max(0.0, domeRadius * domeRadius - x * x - y * y));
    };
    return {blockUnder(dome, 16.0, 160), endMill(6.0, 3.0), {{-16.0, -16.0, 0.0}, {16.0, 16.0, 17.0}}, 0.0};
}

/// A plate up to z = 4 with a round boss of radius 8 mm up to z = 12, its wall upright.
TriangleMesh plateWithBoss() {
    TriangleMesh mesh;
    constexpr int count = 720;
    const auto add = [&mesh](const glm::dvec3& place) {
        mesh.vertices.push_back(place);
        return static_cast<std::uint32_t>(mesh.vertices.size() - 1);
    };
    const auto ring = [&](double radius, double z) {
        const auto first = static_cast<std::uint32_t>(mesh.vertices.size());
        for (int i = 0; i < count; ++i) {
            const double angle = 2.0 * pi * i / count;
            add({radius * std::cos(angle), radius * std::sin(angle), z});
        }
        return first;
    };
    const auto band = [&](std::uint32_t inner, std::uint32_t outer) {
        for (std::uint32_t i = 0; i < count; ++i) {
            const std::uint32_t k = (i + 1) % count;
            mesh.triangles.push_back({inner + i, outer + i, outer + k});
            mesh.triangles.push_back({inner + i, outer + k, inner + k});
        }
    };
    const std::uint32_t top = ring(8.0, 12.0), foot = ring(8.0, 4.0), edge = ring(20.0, 4.0), low = ring(20.0, 0.0);
    const std::uint32_t above = add({0.0, 0.0, 12.0}), below = add({0.0, 0.0, 0.0});
    band(top, foot);
    band(foot, edge);
    band(edge, low);
    for (std::uint32_t i = 0; i < count; ++i) {
        const std::uint32_t k = (i + 1) % count;
        mesh.triangles.push_back({above, top + i, top + k});
        mesh.triangles.push_back({below, low + k, low + i});
    }
    return mesh;
}

/// A face with known normals: plane, cylinder along y, hemisphere.
struct KnownFace {
    double x = 0.0, y = 0.0; ///< radius of curvature along each axis; 0: flat
    double height(double u, double v) const { return 2.0 + std::sqrt(domeRadius * domeRadius - x * u * u - y * v * v); }
    glm::dvec3 normal(double u, double v) const { return glm::normalize(glm::dvec3(x * u, y * v, height(u, v) - 2.0)); }
};

/// Height of the material that balls at the tips leave above a point of a face, along its normal, mm.
double leftAbove(const glm::dvec3& place, const glm::dvec3& normal, double radius,
                 const std::vector<glm::dvec3>& tips) {
    double least = 1e9;
    for (const glm::dvec3& tip : tips) {
        const glm::dvec3 to = tip + glm::dvec3(0.0, 0.0, radius) - place;
        if (glm::length(to) > 2.0 * radius) continue;
        const double along = glm::dot(to, normal), square = radius * radius - glm::dot(to, to) + along * along;
        if (square > 0.0) least = std::min(least, along - std::sqrt(square));
    }
    return least;
}

double step(double x, double y) {
    return std::abs(x) < 12.0 && std::abs(y) < 8.0 ? 18.0 : 6.0;
}

} // namespace

class ComputedPassTest final : public QObject {
    Q_OBJECT

private slots:
    /// 10,000 points of three cutters on a rugged mesh.
    void theDropAgreesWithEveryTriangle_data() {
        QTest::addColumn<double>("corner");
        QTest::newRow("ball") << 3.0;
        QTest::newRow("flat") << 0.0;
        QTest::newRow("bull nose") << 1.0;
    }
    void theDropAgreesWithEveryTriangle() {
        QFETCH(double, corner);
        std::mt19937 random(7);
        std::uniform_real_distribution<double> height(4.0, 9.0), place(-19.0, 19.0);
        std::map<std::pair<double, double>, double> heights;
        const TriangleMesh mesh = blockUnder(
            [&](double x, double y) {
                return heights.try_emplace({x, y}, height(random)).first->second;
            },
            20.0, 16);
        const MeshDistance part(mesh);
        const Tool tool = endMill(6.0, corner);
        const std::vector<RevolvedPiece> tooled = pieces(tool.cutter);
        TipDrop drop(part, tooled, 0.0, -5.0);
        const BruteDrop brute(mesh, 3.0, corner);
        double worst = 0.0;
        for (int i = 0; i < 3334; ++i) {
            const glm::dvec2 at(place(random), place(random));
            const std::optional<double> found = drop.at(at);
            QVERIFY(found);
            worst = std::max(worst, std::abs(*found - brute.at(at)));
        }
        QVERIFY2(worst <= 0.001, qPrintable(QString::number(worst)));
    }

    /// The remains of levels, by a height map of the test's own: the allowance up to one step more, and nothing
    /// outside.
    void levelsLeaveTheirAllowance() {
        const Box stock{{-25.0, -25.0, 0.0}, {25.0, 25.0, 20.0}};
        const Ground ground(blockUnder(step, 25.0, 100), endMill(8.0, 0.0), stock, 0.5);
        PassRequest request;
        request.kind = PassKind::levels;
        request.allowance = 0.5;
        request.bottom = 6.0;
        const Result<PlannedPass> pass = ground.plan(request);
        QVERIFY(pass);
        QCOMPARE(pass->leftOut, 0.0);
        constexpr double width = 0.25;
        constexpr int count = 200;
        std::vector<double> heights(count * count, 20.0);
        double nearest = 1e9;
        follow(*pass, [&](const glm::dvec3& tip) {
            nearest =
                std::min(nearest, ground.part.clearance(pieces(ground.tool.cutter), {tip, {0.0, 0.0, 1.0}}).clearance);
            const glm::ivec2 low = glm::max(glm::ivec2((glm::dvec2(tip) + 21.0) / width) - 1, 0),
                             high = glm::min(glm::ivec2((glm::dvec2(tip) + 29.0) / width) + 1, count - 1);
            for (int j = low.y; j <= high.y; ++j)
                for (int i = low.x; i <= high.x; ++i) {
                    const glm::dvec2 at(-25.0 + (i + 0.5) * width, -25.0 + (j + 0.5) * width);
                    if (glm::distance(at, glm::dvec2(tip)) > 4.0) continue;
                    double& standing = heights[static_cast<std::size_t>(j * count + i)];
                    standing = std::min(standing, tip.z);
                }
        });
        QVERIFY2(nearest >= 0.5 - 0.03, qPrintable(QString::number(nearest)));
        for (int j = 0; j < count; ++j)
            for (int i = 0; i < count; ++i) {
                const double x = -25.0 + (i + 0.5) * width, y = -25.0 + (j + 0.5) * width;
                const double beside = std::max(std::abs(x) - 12.0, std::abs(y) - 8.0); // mm from the step's wall
                const double above = heights[static_cast<std::size_t>(j * count + i)];
                // Over one of its cells, half a millimetre, the mesh slopes from the upper face to the lower one.
                if (beside > 0.5 + 0.5 + 0.3)
                    QVERIFY2(above <= 6.0 + 0.5 + 0.1, qPrintable(QString("%1 at %2 %3").arg(above).arg(x).arg(y)));
                if (beside < 0.0)
                    QVERIFY2(above <= 18.0 + 0.5 + 0.1 && above >= 18.5 - 0.03,
                             qPrintable(QString("%1 at %2 %3").arg(above).arg(x).arg(y)));
            }
    }

    /// What levels take at a time, by a height map of the test's own: the cross-section of the cut, over half a radius,
    /// is at most that of a step-over at full depth on 95 % of the way, and nowhere more than 1.5 times that: not where
    /// the tool comes down into a closed pocket, on its first loop, in its corners and on the way from loop to loop.
    void levelsKeepToTheirWidth_data() {
        QTest::addColumn<int>("shape");
        QTest::addColumn<double>("diameter");
        QTest::newRow("closed pocket") << 0 << 8.0;
        QTest::newRow("raised block") << 1 << 8.0;
        QTest::newRow("pocket with an island") << 2 << 6.0;
        QTest::newRow("pocket with room for one loop") << 0 << 16.0;
    }
    void levelsKeepToTheirWidth() {
        QFETCH(int, shape);
        QFETCH(double, diameter);
        const auto top = [shape](double x, double y) {
            const bool pocket = std::abs(x) < 18.0 && std::abs(y) < 14.0, island = std::hypot(x - 5.0, y) < 5.0;
            if (shape == 1) return std::abs(x) < 9.0 && std::abs(y) < 6.0 ? 20.0 : 12.0;
            return pocket && !(shape == 2 && island) ? 12.0 : 20.0;
        };
        const Box stock{{-25.0, -25.0, 0.0}, {25.0, 25.0, 20.0}};
        const Ground ground(blockUnder(top, 25.0, 100), endMill(diameter, 0.0), stock, 0.5);
        PassRequest request;
        request.kind = PassKind::levels;
        request.allowance = 0.3;
        request.stairs = 100.0; // none: they are as wide as they like
        const Result<PlannedPass> pass = ground.plan(request);
        QVERIFY(pass && !pass->strokes.empty());
        constexpr double square = 0.125, depth = 4.0; // mm; that of the levels is the ground's
        constexpr int count = 400;
        const double radius = 0.5 * diameter, bound = 0.4 * diameter * depth;
        std::vector<double> heights(count * count, 20.0);
        const auto cut = [&](const glm::dvec3& tip) {
            double volume = 0.0;
            const glm::ivec2 low = glm::max(glm::ivec2((glm::dvec2(tip) + 25.0 - radius) / square) - 1, 0),
                             high = glm::min(glm::ivec2((glm::dvec2(tip) + 25.0 + radius) / square) + 1, count - 1);
            for (int j = low.y; j <= high.y; ++j)
                for (int i = low.x; i <= high.x; ++i) {
                    const glm::dvec2 at(-25.0 + (i + 0.5) * square, -25.0 + (j + 0.5) * square);
                    if (glm::distance(at, glm::dvec2(tip)) > radius) continue;
                    double& standing = heights[static_cast<std::size_t>(j * count + i)];
                    volume += square * square * std::max(0.0, standing - tip.z);
                    standing = std::min(standing, tip.z);
                }
            return volume;
        };
        double whole = 0.0, within = 0.0, most = 0.0;
        glm::dvec3 mostAt(0.0);
        int plunges = 0;
        for (const TipLine& line : pass->strokes) {
            plunges += cut(line.front()) > 0.25 * pi * radius * radius * depth ? 1 : 0;
            double along = 0.0, volume = 0.0;
            for (std::size_t i = 1; i < line.size(); ++i) {
                const double length = glm::distance(line[i - 1], line[i]);
                const int steps = std::max(1, static_cast<int>(std::ceil(length / 0.3)));
                for (int k = 1; k <= steps; ++k) {
                    volume += cut(glm::mix(line[i - 1], line[i], static_cast<double>(k) / steps));
                    along += length / steps;
                    if (along < 0.5 * radius) continue;
                    if (volume > 0.0) whole += along;
                    if (volume > 0.0 && volume / along <= 1.05 * bound) within += along; // 5 %: its squares
                    if (volume / along > most) {
                        most = volume / along;
                        mostAt = line[i];
                    }
                    along = volume = 0.0;
                }
            }
        }
        const QString measured = QString("%1 % within, most %2 at %3 %4 %5, %6 plunges, %7 mm in %8")
                                     .arg(100.0 * within / whole)
                                     .arg(most / bound)
                                     .arg(mostAt.x)
                                     .arg(mostAt.y)
                                     .arg(mostAt.z)
                                     .arg(plunges)
                                     .arg(lengthOf(*pass))
                                     .arg(pass->strokes.size());
        QVERIFY2(within >= 0.95 * whole, qPrintable(measured));
        QVERIFY2(most <= 1.5 * bound, qPrintable(measured));
        QCOMPARE(plunges, 0);
    }

    /// With the part to the right of the tool the teeth enter the stock from outside: climb milling.
    void levelsClimb() {
        const Box stock{{-25.0, -25.0, 0.0}, {25.0, 25.0, 20.0}};
        const Ground ground(blockUnder(step, 25.0, 100), endMill(8.0, 0.0), stock, 0.5);
        PassRequest request;
        request.kind = PassKind::profile;
        request.bottom = 6.1;
        request.top = 10.0;
        const Result<PlannedPass> pass = ground.plan(request);
        QVERIFY(pass && !pass->strokes.empty());
        double right = 0.0;
        for (const TipLine& line : pass->strokes)
            for (std::size_t i = 1; i < line.size(); ++i) {
                const glm::dvec2 along(line[i] - line[i - 1]), towardsPart = -glm::dvec2(line[i]);
                right += along.y * towardsPart.x - along.x * towardsPart.y;
            }
        QVERIFY(right > 0.0);
    }

    /// Scallops between rows of a ball on a level face, by the height of the intersection of two circles.
    void ridgesAreAsHighAsAsked_data() {
        QTest::addColumn<double>("diameter");
        for (const double diameter : {3.0, 6.0, 12.0}) QTest::addRow("%g mm", diameter) << diameter;
    }
    void ridgesAreAsHighAsAsked() {
        QFETCH(double, diameter);
        const Ground ground(blockUnder([](double, double) { return 5.0; }, 15.0, 4), endMill(diameter, 0.5 * diameter),
                            {{-15.0, -15.0, 0.0}, {15.0, 15.0, 5.2}}, 0.0);
        PassRequest request;
        request.kind = PassKind::parallel;
        request.scallop = 0.01;
        request.direction = 0.3;
        request.area = rectangle({-10.0, -10.0}, {10.0, 10.0});
        const Result<PlannedPass> pass = ground.plan(request);
        QVERIFY(pass && pass->strokes.size() > 0);
        // Perpendicular to the rows: the position of each row, and the height between the circles of two neighbours.
        const glm::dvec2 across(-std::sin(0.3), std::cos(0.3));
        std::vector<double> rows;
        for (const TipLine& line : pass->strokes)
            for (std::size_t i = 1; i < line.size(); ++i) {
                QVERIFY(std::abs(line[i].z - 5.0) < 2e-4);
                const glm::dvec2 along(line[i] - line[i - 1]);
                if (glm::length(along) > 1.0 && std::abs(glm::dot(glm::normalize(along), across)) < 1e-6)
                    rows.push_back(glm::dot(glm::dvec2(line[i]), across));
            }
        std::ranges::sort(rows);
        double highest = 0.0;
        const double radius = 0.5 * diameter;
        for (std::size_t i = 1; i < rows.size(); ++i) {
            const double half = 0.5 * (rows[i] - rows[i - 1]);
            highest = std::max(highest, radius - std::sqrt(radius * radius - half * half));
        }
        QVERIFY2(highest > 0.009 && highest < 0.011, qPrintable(QString::number(highest)));
    }

    /// Rows of every kind touch a hemisphere where a resting ball does by the closed formula.
    void rowsLieOnTheSphere_data() {
        QTest::addColumn<int>("kind");
        for (const PassKind kind : {PassKind::parallel, PassKind::radial, PassKind::spiral, PassKind::flow})
            QTest::addRow("%s", rowOf(kind).id.data()) << static_cast<int>(kind);
    }
    void rowsLieOnTheSphere() {
        QFETCH(int, kind);
        const Ground ground = domeGround();
        PassRequest request;
        request.kind = static_cast<PassKind>(kind);
        request.stepOver = 0.5;
        request.area = rectangle({-7.0, -7.0}, {7.0, 7.0});
        if (request.kind == PassKind::flow) request.lines = {{{-9.0, -6.0, 0.0}, {0.0, -2.0, 0.0}, {9.0, -6.0, 0.0}}};
        const Result<PlannedPass> pass = ground.plan(request);
        QVERIFY(pass);
        // The whole area is covered: rows are nowhere farther apart than requested.
        QVERIFY2(lengthOf(*pass) > 14.0 * 14.0 / 0.5 * 0.9, qPrintable(QString::number(lengthOf(*pass))));
        double worst = 0.0;
        std::vector<glm::dvec2> places;
        follow(*pass, [&](const glm::dvec3& tip) {
            const double reach = domeRadius + 3.0;
            const double resting = 2.0 + std::sqrt(reach * reach - tip.x * tip.x - tip.y * tip.y) - 3.0;
            worst = std::max(worst, std::abs(tip.z - resting));
            places.emplace_back(tip);
        });
        QVERIFY2(worst < 0.004, qPrintable(QString::number(worst))); // facets of 0.2 mm are 0.0004 mm below the sphere
        for (double x = -6.5; x <= 6.5; x += 0.5)
            for (double y = -6.5; y <= 6.5; y += 0.5) {
                double nearest = 1e9;
                for (const glm::dvec2& place : places) nearest = std::min(nearest, glm::distance(place, {x, y}));
                QVERIFY2(nearest < 0.26, qPrintable(QString("%1 mm at %2 %3").arg(nearest).arg(x).arg(y)));
            }
    }

    /// Rows beside a stroke to and fro: each lies on a multiple of the step-over from it, or in the middle between two
    /// of its legs where the rows of both are more than a step-over apart; and none lacks.
    void flowFollowsAZigzag() {
        constexpr double step = 0.7;
        const Ground ground(blockUnder([](double, double) { return 5.0; }, 15.0, 4), endMill(4.0, 2.0),
                            {{-15.0, -15.0, 0.0}, {15.0, 15.0, 6.0}}, 0.0);
        PassRequest request;
        request.kind = PassKind::flow;
        request.stepOver = step;
        request.area = rectangle({-10.0, -10.0}, {10.0, 10.0});
        PassLine zigzag;
        for (int turn = 0; turn <= 4; ++turn)
            for (double x = -12.0; x <= 12.0; x += 0.5)
                zigzag.emplace_back(turn % 2 == 0 ? x : -x, -8.0 + 4.0 * turn + 0.2 * std::sin(x), 9.0);
        request.lines = {zigzag};
        const Result<PlannedPass> pass = ground.plan(request);
        QVERIFY(pass);
        const std::size_t leg = zigzag.size() / 5; // points
        /// mm from the nearest two legs
        const auto fromLegs = [&](const glm::dvec2& place) {
            std::vector<double> all;
            for (std::size_t i = 0; i < zigzag.size(); ++i) {
                const double far =
                    i % leg == 0 ? 1e9 : distanceToSegment(place, glm::dvec2(zigzag[i - 1]), glm::dvec2(zigzag[i]));
                if (i % leg == 0) all.push_back(far);
                all.back() = std::min(all.back(), far);
            }
            std::ranges::sort(all);
            return std::pair(all[0], all[1]);
        };
        double onRows = 0.0, between = 0.0, whole = 0.0; // mm
        std::vector<glm::dvec2> places;
        for (const TipLine& line : pass->strokes)
            for (std::size_t i = 1; i < line.size(); ++i) {
                const double length = glm::distance(line[i - 1], line[i]);
                const auto [near, other] = fromLegs(0.5 * glm::dvec2(line[i - 1] + line[i]));
                const double beyond = near - step * std::floor(near / step);
                whole += length;
                if (std::min(beyond, step - beyond) < 0.01)
                    onRows += length;
                else if (other - near < 0.05 && beyond > 0.5 * step)
                    between += length;
            }
        follow(*pass, [&](const glm::dvec3& tip) { places.emplace_back(tip); });
        const QString lengths = QString("%1 and %2 of %3 mm").arg(onRows).arg(between).arg(whole);
        QVERIFY2(onRows + between > 0.97 * whole, qPrintable(lengths)); // the rest joins rows
        QVERIFY2(between < 0.15 * whole, qPrintable(lengths));
        for (double x = -9.5; x <= 9.5; x += 0.5)
            for (double y = -9.5; y <= 9.5; y += 0.5) {
                double nearest = 1e9;
                for (const glm::dvec2& place : places) nearest = std::min(nearest, glm::distance(place, {x, y}));
                QVERIFY2(nearest < 0.5 * step + 0.05, qPrintable(QString("%1 mm at %2 %3").arg(nearest).arg(x).arg(y)));
            }
    }

    void nearSegmentsAreFound() {
        std::mt19937 random(5);
        std::uniform_real_distribution<double> place(-20.0, 20.0), distance(0.0, 6.0);
        const auto anywhere = [&] { return glm::dvec2(place(random), place(random)); };
        NearSegments near(1.0);
        std::vector<std::pair<glm::dvec2, glm::dvec2>> all;
        for (int i = 0; i < 30; ++i) {
            const glm::dvec2 from = anywhere(), to = i % 3 == 0 ? anywhere() : from + 0.05 * anywhere();
            all.emplace_back(from, to);
            near.add(from, to);
        }
        int found = 0;
        for (int i = 0; i < 2000; ++i) {
            const glm::dvec2 at = anywhere();
            const double within = distance(random);
            const bool any = std::ranges::any_of(
                all, [&](const auto& each) { return distanceToSegment(at, each.first, each.second) < within; });
            QCOMPARE(near.anyWithin(at, within), any);
            const std::optional<glm::dvec2> nearest = near.nearestWithin(at, within);
            QCOMPARE(nearest.has_value(), any);
            double least = 1e9;
            for (const auto& [from, to] : all) least = std::min(least, distanceToSegment(at, from, to));
            if (any) QVERIFY(std::abs(glm::distance(*nearest, at) - least) < 1e-12);
            found += any ? 1 : 0;
        }
        QVERIFY(found > 200 && found < 1800);
    }

    /// Scallops are as high as requested on plane, cylinder and sphere, measured along the normals for balls at the
    /// tips; and the rows are not closer than necessary.
    void scallopsAreEven_data() {
        QTest::addColumn<double>("diameter");
        QTest::addColumn<double>("x");
        QTest::addColumn<double>("y");
        for (const double diameter : {3.0, 6.0, 12.0}) {
            QTest::addRow("plane, %g mm", diameter) << diameter << 0.0 << 0.0;
            QTest::addRow("cylinder, %g mm", diameter) << diameter << 1.0 << 0.0;
            QTest::addRow("sphere, %g mm", diameter) << diameter << 1.0 << 1.0;
        }
    }
    void scallopsAreEven() {
        QFETCH(double, diameter);
        QFETCH(double, x);
        QFETCH(double, y);
        constexpr double asked = 0.02;
        const KnownFace face{x, y};
        const double radius = 0.5 * diameter;
        const Ground ground(blockUnder(
                                [&](double u, double v) {
                                    return 2.0 +
                                           std::sqrt(std::max(1.0, domeRadius * domeRadius - x * u * u - y * v * v));
                                },
                                13.0, 208),
                            endMill(diameter, radius), {{-13.0, -13.0, 0.0}, {13.0, 13.0, 17.0}}, 0.0);
        PassRequest request;
        request.kind = PassKind::scallop;
        request.scallop = asked;
        request.area = rectangle({-8.0, -8.0}, {8.0, 8.0});
        request.areaOnPart = true;
        const Result<PlannedPass> pass = ground.plan(request);
        QVERIFY(pass);
        std::vector<glm::dvec3> tips;
        follow(*pass, [&](const glm::dvec3& tip) { tips.push_back(tip); });
        double highest = 0.0;
        const double stepOver = 2.0 * std::sqrt(asked * (diameter - asked));
        const double inside = 8.0 - 1.5 * stepOver; // at the border of the area there is no next row
        int count = 0;
        for (double u = -inside; u <= inside; u += 0.11)
            for (double v = -inside; v <= inside; v += 0.47) {
                const glm::dvec3 place(u, v, face.height(u, v));
                highest = std::max(highest, leftAbove(place, face.normal(u, v), radius, tips));
                ++count;
            }
        QVERIFY(count > 100);
        QVERIFY2(highest <= 1.1 * asked, qPrintable(QString::number(highest)));
        // The length is that of rows at this spacing, plus a third for connections. On a convex face tips are k times
        // as far apart as contacts: rows are k times as long, and their contacts closer by the square root of k.
        double area = 0.0;
        for (double u = -7.95; u < 8.0; u += 0.1)
            for (double v = -7.95; v < 8.0; v += 0.1) area += 0.01 / face.normal(u, v).z;
        const double curved = x > 0.0 ? std::pow((domeRadius + radius) / domeRadius, 1.5) : 1.0;
        const double least = area / stepOver;
        QVERIFY2(lengthOf(*pass) <= 1.35 * least * curved,
                 qPrintable(QString("%1 of %2").arg(lengthOf(*pass)).arg(least)));
    }

    /// In a groove of two planes a ball touches both, at positions given by the closed formula.
    void pencilFollowsAGroove() {
        const double slope = std::tan(pi / 6.0);
        const Ground ground(blockUnder([&](double x, double) { return 3.0 + slope * std::abs(x); }, 15.0, 60),
                            endMill(6.0, 3.0), {{-15.0, -15.0, 0.0}, {15.0, 15.0, 12.0}}, 0.0);
        PassRequest request;
        request.kind = PassKind::pencil;
        const Result<PlannedPass> pass = ground.plan(request);
        QVERIFY(pass);
        const double resting = 3.0 + 3.0 / std::cos(pi / 6.0) - 3.0;
        double low = 1e9, high = -1e9;
        follow(*pass, [&](const glm::dvec3& tip) {
            if (std::abs(tip.y) > 14.0) return; // beyond the end faces
            QVERIFY2(std::abs(tip.x) < 0.003 && std::abs(tip.z - resting) < 0.003,
                     qPrintable(QString("%1 %2 %3").arg(tip.x).arg(tip.y).arg(tip.z)));
            low = std::min(low, tip.y);
            high = std::max(high, tip.y);
        });
        QVERIFY(low < -13.8 && high > 13.8);
    }

    /// Around the foot of an upright wall: a circle, and nothing on the boss's convex edge.
    void pencilGoesRoundTheFootOfAWall_data() {
        QTest::addColumn<double>("corner");
        QTest::newRow("ball") << 3.0;
        if (!testing::longRun()) return;
        QTest::newRow("bull nose") << 1.0;
        QTest::newRow("flat") << 0.0;
    }
    void pencilGoesRoundTheFootOfAWall() {
        QFETCH(double, corner);
        const Ground ground(plateWithBoss(), endMill(6.0, corner), {{-20.0, -20.0, 0.0}, {20.0, 20.0, 12.0}}, 0.0);
        PassRequest request;
        request.kind = PassKind::pencil;
        const Result<PlannedPass> pass = ground.plan(request);
        QVERIFY(pass);
        QCOMPARE(pass->strokes.size(), std::size_t(1));
        const std::vector<RevolvedPiece> tool = pieces(ground.tool.cutter);
        follow(*pass, [&](const glm::dvec3& tip) {
            const double radius = glm::length(glm::dvec2(tip));
            QVERIFY2(std::abs(radius - 11.0) < 0.004 && std::abs(tip.z - 4.0) < 0.003,
                     qPrintable(QString("%1 %2").arg(radius).arg(tip.z)));
            QVERIFY(ground.part.clearance(tool, {tip, {0.0, 0.0, 1.0}}).clearance > -0.003);
        });
        QVERIFY2(std::abs(lengthOf(*pass) - 2.0 * pi * 11.0) < 0.1, qPrintable(QString::number(lengthOf(*pass))));
    }

    /// A fillet of 10 mm is no corner for a ball of 3 mm: rows reach all of it.
    void aWideFilletIsNoEdge() {
        const Ground ground(
            blockUnder([](double x, double) { return 13.0 - std::sqrt(100.0 - std::min(81.0, x * x)); }, 12.0, 120),
            endMill(6.0, 3.0), {{-12.0, -12.0, 0.0}, {12.0, 12.0, 10.0}}, 0.0);
        PassRequest request;
        request.kind = PassKind::pencil;
        request.area = rectangle({-5.0, -8.0}, {5.0, 8.0});
        const Result<PlannedPass> pass = ground.plan(request);
        QVERIFY(pass);
        QCOMPARE(pass->strokes.size(), std::size_t(0));
    }

    /// An area painted on a slope refers to where the ball touches it, not to where its tip is.
    void anAreaOnThePartIsWhatTheToolTouches_data() {
        QTest::addColumn<int>("kind");
        for (const PassKind kind : {PassKind::parallel, PassKind::waterline, PassKind::scallop})
            QTest::addRow("%s", rowOf(kind).id.data()) << static_cast<int>(kind);
    }
    void anAreaOnThePartIsWhatTheToolTouches() {
        QFETCH(int, kind);
        const Ground ground = domeGround();
        PassRequest request;
        request.kind = static_cast<PassKind>(kind);
        request.stepOver = 0.4;
        const glm::dvec2 middle(9.0, 1.0);
        request.area = brushed({middle}, 2.0);
        request.areaOnPart = true;
        const Result<PlannedPass> pass = ground.plan(request);
        QVERIFY(pass && !pass->strokes.empty());
        std::vector<glm::dvec2> touched;
        follow(*pass, [&](const glm::dvec3& tip) {
            const glm::dvec3 centre(0.0, 0.0, 2.0), ball = tip + glm::dvec3(0.0, 0.0, 3.0);
            touched.emplace_back(centre + domeRadius * glm::normalize(ball - centre));
            // Facets of 0.2 mm are touched at their corners.
            QVERIFY2(glm::distance(touched.back(), middle) < 2.25, qPrintable(QString::number(touched.back().x)));
        });
        for (double angle = 0.0; angle < 6.2; angle += 0.3)
            for (const double out : {0.0, 0.8, 1.5}) {
                const glm::dvec2 place = middle + out * glm::dvec2(std::cos(angle), std::sin(angle));
                double nearest = 1e9;
                for (const glm::dvec2& one : touched) nearest = std::min(nearest, glm::distance(one, place));
                QVERIFY2(nearest < 0.5, qPrintable(QString("%1 at %2 %3").arg(nearest).arg(place.x).arg(place.y)));
            }
    }

    /// Stock that a larger cutter left on one half is milled only there, on flat and steep faces.
    void restGoesOnlyWhereStockIsLeft() {
        Ground ground = domeGround();
        StandingStock& standing = ground.ground.standing;
        standing = {{-16.0, -16.0}, 0.25, 128, 128, {}, {}};
        for (int row = 0; row < standing.rows; ++row)
            for (int column = 0; column < standing.columns; ++column) {
                const double x = -16.0 + 0.25 * (column + 0.5), y = -16.0 + 0.25 * (row + 0.5);
                const double part = 2.0 + std::sqrt(std::max(0.0, domeRadius * domeRadius - x * x - y * y));
                // Elsewhere the part has only the remains from voxels and step-overs: next to nothing.
                standing.thickness.push_back(x > 3.0 ? 0.7 : 0.05);
                standing.heights.push_back(std::min(17.0, part + standing.thickness.back()));
            }
        PassRequest request;
        request.kind = PassKind::rest;
        request.stepOver = 0.5;
        request.bottom = 4.0;
        const Result<PlannedPass> pass = ground.plan(request);
        QVERIFY(pass);
        bool flat = false, steep = false;
        follow(*pass, [&](const glm::dvec3& tip) {
            QVERIFY2(tip.x > 0.0, qPrintable(QString::number(tip.x))); // a ball of 3 mm reaches stock from there
            flat = flat || tip.z > 14.0;
            steep = steep || tip.z < 7.0;
        });
        QVERIFY(flat && steep);
    }

    void waterlinesLieOnTheSphere() {
        const Ground ground = domeGround();
        PassRequest request;
        request.kind = PassKind::waterline;
        request.stepOver = 1.0;
        request.bottom = 6.0;
        const Result<PlannedPass> pass = ground.plan(request);
        QVERIFY(pass);
        std::set<long> heights;
        for (const TipLine& line : pass->strokes)
            for (const glm::dvec3& tip : line) {
                heights.insert(std::lround(tip.z * 1000.0));
                const double up = tip.z + 3.0 - 2.0;
                QVERIFY(std::abs(std::sqrt(tip.x * tip.x + tip.y * tip.y + up * up) - 17.0) < 0.003);
            }
        QCOMPARE(heights.size(), std::size_t(10)); // 15 mm to 6 mm: the dome's top is at 16 mm
    }

    /// For any area, direction, kind and allowance: no tip, and no point between two tips, is in the part.
    void nothingGouges() {
        std::mt19937 random(11);
        std::uniform_real_distribution<double> share(0.0, 1.0);
        const auto bumps = [](double x, double y) { return 8.0 + 3.0 * std::sin(0.4 * x) * std::cos(0.3 * y); };
        const Ground ground(blockUnder(bumps, 20.0, 80), endMill(6.0, 3.0), {{-20.0, -20.0, 0.0}, {20.0, 20.0, 12.0}},
                            1.0);
        const int kinds = static_cast<int>(passKinds.size()) - 2; // the last two work in holes
        for (int round = 0; round < testing::inLongRun(2 * kinds, kinds); ++round) {
            PassRequest request;
            request.kind = passKinds[static_cast<std::size_t>(round % kinds)].kind;
            request.allowance = share(random) < 0.5 ? 0.0 : share(random);
            request.stepOver = 0.5 + 2.0 * share(random);
            request.direction = 6.0 * share(random);
            request.depth = request.kind == PassKind::engrave ? 0.5 + 9.0 * share(random) : 0.0;
            PlanRing ring;
            for (int i = 0; i < 7; ++i)
                ring.emplace_back(glm::dvec2(std::cos(0.9 * i), std::sin(0.9 * i)) * (6.0 + 12.0 * share(random)));
            request.area.rings = {ring};
            request.lines = {
                {{-20.0, 20.0 * share(random), 0.0}, {20.0 * share(random), 0.0, 0.0}, {20.0, -20.0, 0.0}}};
            const Result<PlannedPass> pass = ground.plan(request);
            QVERIFY2(pass, rowOf(request.kind).id.data());
            const std::vector<RevolvedPiece> tool = pieces(ground.tool.cutter);
            double deepest = 0.0;
            follow(*pass, [&](const glm::dvec3& tip) {
                const double clearance = ground.part.clearance(tool, {tip, {0.0, 0.0, 1.0}}, 2.0).clearance;
                deepest = std::max(deepest, request.allowance - clearance);
            });
            // Chords deviate from the surface by 0.002 mm; roughing moves use the field, which states its error.
            const bool rough = request.kind <= PassKind::face;
            QVERIFY2(deepest <= (rough ? 0.03 : 0.005),
                     qPrintable(QString("%1: %2 mm").arg(rowOf(request.kind).id.data()).arg(deepest)));
        }
    }

    /// At any position and depth: a drill stops at the part, with all of the drill above it.
    void drillingNeverGouges() {
        std::mt19937 random(5);
        std::uniform_real_distribution<double> share(0.0, 1.0);
        const auto bumps = [](double x, double y) { return 8.0 + 3.0 * std::sin(0.4 * x) * std::cos(0.3 * y); };
        Tool drill = endMill(3.0, 0.0);
        drill.cutter.type = CutterType::drill;
        drill.cutter.taperAngle = glm::radians(70.0);
        const Ground ground(blockUnder(bumps, 20.0, 80), drill, {{-20.0, -20.0, 0.0}, {20.0, 20.0, 12.0}}, 1.0);
        PassRequest request;
        request.kind = PassKind::drill;
        request.depth = 9.0;
        for (int i = 0; i < 50; ++i)
            request.places.emplace_back(40.0 * share(random) - 20.0, 40.0 * share(random) - 20.0);
        const Result<PlannedPass> pass = ground.plan(request);
        QVERIFY(pass && pass->strokes.size() > 30);
        const std::vector<RevolvedPiece> tool = pieces(ground.tool.cutter);
        for (const TipLine& stroke : pass->strokes) {
            const double clearance = ground.part.clearance(tool, {stroke.back(), {0.0, 0.0, 1.0}}, 2.0).clearance;
            QVERIFY2(clearance > -drillFit, qPrintable(QString::number(clearance)));
            QVERIFY(clearance < drillFit + 1e-4 || std::abs(stroke.back().z - 3.0) < 1e-9); // on the part, or 9 mm deep
        }
    }

    /// A frame cut out of a plate: at each of four tabs the bridge that the cutter leaves has the requested width and
    /// height, by a plain raster of the outline; without tabs nothing is left.
    void tabsHoldWhatIsCutOut() {
        const double radius = 2.0;
        const Ground ground({}, endMill(2.0 * radius, 0.0), {{-30.0, -25.0, 0.0}, {30.0, 25.0, 6.0}}, 0.0);
        PassRequest request;
        request.kind = PassKind::profile;
        request.area.rings = {{{-20.0, -15.0}, {20.0, -15.0}, {20.0, 15.0}, {-20.0, 15.0}}};
        request.bottom = 0.0;
        request.levelDepth = 2.0;
        request.tabs = 4;
        request.tabWidth = 5.0;
        request.tabHeight = 1.5;
        const Result<PlannedPass> pass = ground.plan(request);
        QVERIFY(pass);
        // Height of the material along the middle of the groove, at points 0.05 mm apart.
        std::vector<std::pair<glm::dvec2, double>> groove;
        for (double way = -20.0; way < 20.0; way += 0.05) {
            groove.push_back({{way, -15.0 - radius}, 6.0});
            groove.push_back({{-way, 15.0 + radius}, 6.0});
        }
        for (double way = -15.0; way < 15.0; way += 0.05) {
            groove.push_back({{20.0 + radius, way}, 6.0});
            groove.push_back({{-20.0 - radius, -way}, 6.0});
        }
        follow(*pass, [&](const glm::dvec3& tip) {
            for (auto& [place, height] : groove)
                if (glm::distance(place, glm::dvec2(tip)) < radius) height = std::min(height, tip.z);
        });
        std::vector<glm::dvec2> held;
        for (const auto& [place, height] : groove)
            if (height >= 1.5 - 1e-9) held.push_back(place);
        std::vector<std::pair<glm::dvec2, glm::dvec2>> bridges; // no corner lies within a bridge
        for (const glm::dvec2& place : held) {
            const auto same = std::ranges::find_if(bridges, [&](const auto& one) {
                return glm::distance(one.second, place) < 0.2 || glm::distance(one.first, place) < 0.2;
            });
            if (same == bridges.end())
                bridges.push_back({place, place});
            else if (glm::distance(same->first, place) > glm::distance(same->first, same->second))
                same->second = place;
        }
        QCOMPARE(bridges.size(), std::size_t(4));
        for (const auto& [from, to] : bridges) {
            const double width = glm::distance(from, to);
            QVERIFY2(width >= 4.9 && width < 7.5, qPrintable(QString::number(width)));
        }
        request.tabs = 0;
        const Result<PlannedPass> plain = ground.plan(request);
        QVERIFY(plain);
        double highest = 0.0;
        follow(*plain, [&](const glm::dvec3& tip) { highest = std::max(highest, tip.z); });
        QVERIFY(std::abs(highest - 4.0) < 1e-9); // levels at 4, 2, 0
        request.tabs = 3;
        request.tabWidth = 0.0;
        QVERIFY(!ground.plan(request));
    }

    /// The cutter's edge reaches each square corner of a pocket: a body with square corners fits in.
    void dogbonesReachTheCorners() {
        const double radius = 3.0;
        const Ground ground({}, endMill(2.0 * radius, 0.0), {{-30.0, -25.0, 0.0}, {30.0, 25.0, 6.0}}, 0.0);
        PassRequest request;
        request.kind = PassKind::pocket;
        request.area.rings = {{{-20.0, -15.0}, {20.0, -15.0}, {20.0, 15.0}, {-20.0, 15.0}}};
        request.bottom = 3.0;
        const auto farthestCorner = [&] {
            const Result<PlannedPass> pass = ground.plan(request);
            double farthest = 0.0;
            for (const glm::dvec2& corner : request.area.rings.front()) {
                double nearest = 1e9;
                if (pass)
                    follow(*pass, [&](const glm::dvec3& tip) {
                        nearest = std::min(nearest, glm::distance(glm::dvec2(tip), corner));
                    });
                farthest = std::max(farthest, nearest);
            }
            return farthest;
        };
        QVERIFY(std::abs(farthestCorner() - radius * std::sqrt(2.0)) < 0.02);
        request.dogbones = true;
        QVERIFY2(std::abs(farthestCorner() - radius) < 0.02, qPrintable(QString::number(farthestCorner())));
        request.kind = PassKind::profile;
        request.inside = true;
        QVERIFY2(std::abs(farthestCorner() - radius) < 0.02, qPrintable(QString::number(farthestCorner())));
    }

    /// In an acute corner a dogbone would cut into its sides: the corner stays round.
    void acuteCornersStayRound() {
        const Ground ground({}, endMill(6.0, 0.0), {{-30.0, -25.0, 0.0}, {30.0, 25.0, 6.0}}, 0.0);
        PassRequest request;
        request.kind = PassKind::pocket;
        request.area.rings = {{{-25.0, -8.0}, {25.0, 0.0}, {-25.0, 8.0}}};
        request.bottom = 3.0;
        const Result<PlannedPass> round = ground.plan(request);
        request.dogbones = true;
        const Result<PlannedPass> bones = ground.plan(request);
        QVERIFY(round && bones);
        const auto farthest = [](const PlannedPass& pass) {
            double x = -1e9;
            follow(pass, [&](const glm::dvec3& tip) { x = std::max(x, tip.x); });
            return x;
        };
        QCOMPARE(farthest(*bones), farthest(*round));       // of 18 degrees
        QVERIFY(lengthOf(*bones) > lengthOf(*round) + 1.0); // the others have dogbones
    }

    /// Of two grooves the one next to the stroke is selected.
    void pencilIsLedByAStroke() {
        const auto grooves = [](double x, double) { return 3.0 + 0.6 * std::abs(std::abs(x) - 8.0); };
        const Ground ground(blockUnder(grooves, 15.0, 60), endMill(6.0, 3.0), {{-15.0, -15.0, 0.0}, {15.0, 15.0, 12.0}},
                            0.0);
        PassRequest request;
        request.kind = PassKind::pencil;
        const Result<PlannedPass> both = ground.plan(request);
        request.lines = {{{6.0, -10.0, 9.0}, {7.0, 10.0, 9.0}}};
        const Result<PlannedPass> one = ground.plan(request);
        QVERIFY(both && one);
        QVERIFY(lengthOf(*both) > 1.9 * 28.0);
        follow(*one, [](const glm::dvec3& tip) { QVERIFY(std::abs(tip.x - 8.0) < 0.003); });
        QVERIFY2(lengthOf(*one) > 20.0 && lengthOf(*one) < 0.6 * lengthOf(*both),
                 qPrintable(QString::number(lengthOf(*one))));
    }

    /// A clamp on the stock: the cutter, a cylinder, keeps its margin from the box, and everything else is milled as
    /// before.
    void fixturesAreKeptClearOf() {
        const Box clamp{{-26.0, -3.0, 10.0}, {-14.0, 3.0, 30.0}};
        constexpr double margin = 1.0, radius = 4.0;
        Ground ground(blockUnder(step, 25.0, 100), endMill(2.0 * radius, 0.0),
                      {{-25.0, -25.0, 0.0}, {25.0, 25.0, 20.0}}, 0.5);
        PassRequest request;
        request.kind = PassKind::levels;
        request.allowance = 0.5;
        request.bottom = 7.0;
        const Result<PlannedPass> free = ground.plan(request);
        QVERIFY(free);
        QCOMPARE(free->inTheWay, 0.0);
        Obstacle obstacle;
        obstacle.name = "clamp";
        obstacle.shape = clamp;
        obstacle.margin = margin;
        std::vector<ObstacleSolid> solids = solidsOf(std::span(&obstacle, 1));
        ground.ground.obstacles = solids;
        const Result<PlannedPass> kept = ground.plan(request);
        QVERIFY(kept);
        double nearest = 1e9;
        follow(*kept, [&](const glm::dvec3& tip) { // the tool extends far above the clamp: only plan counts
            const glm::dvec2 beside =
                glm::max(glm::abs(glm::dvec2(tip) - glm::dvec2(clamp.centre())) - 0.5 * glm::dvec2(clamp.size()),
                         glm::dvec2(0.0));
            if (tip.z < clamp.high.z + margin) nearest = std::min(nearest, glm::length(beside) - radius);
        });
        QVERIFY2(nearest >= margin - 1e-6, qPrintable(QString::number(nearest)));
        QVERIFY(kept->inTheWay > 10.0);
        QVERIFY2(std::abs(lengthOf(*kept) + kept->inTheWay - lengthOf(*free)) < 1e-6 * lengthOf(*free),
                 qPrintable(QString("%1 + %2, not %3").arg(lengthOf(*kept)).arg(kept->inTheWay).arg(lengthOf(*free))));
        solids.front().on = false;
        const Result<PlannedPass> off = ground.plan(request);
        QVERIFY(off && lengthOf(*off) == lengthOf(*free));
    }

    void aRequestComesBackFromItsText() {
        PassRequest request;
        request.kind = PassKind::flow;
        request.allowance = 1.0 / 3.0;
        request.scallop = 0.01;
        request.top = 7.5;
        request.bottom = -1e-9;
        request.oneWay = request.restOnly = true;
        request.steepest = 0.7;
        request.area = {{{{0.1, 0.2}, {1.0 / 3.0, 4.0}, {-5.0, 6.0}}}};
        request.lines = {{{0.0, 0.1, 0.2}, {1.0 / 7.0, 2.0, 3.0}}};
        const auto comesBack = [](const PassRequest& sent) {
            const Result<PassRequest> back = passRequestFromJson(toJson(sent), "text");
            return back && *back == sent;
        };
        QVERIFY(comesBack(request));
        request.kind = PassKind::profile;
        request.tabs = 3;
        request.tabWidth = 4.2;
        request.tabHeight = 0.7;
        request.dogbones = true;
        QVERIFY(comesBack(request));
        PassRequest holes;
        holes.kind = PassKind::drill;
        holes.places = {{1.0 / 3.0, -2.0}, {0.1, 5.0}};
        QVERIFY(comesBack(holes));
        holes.kind = PassKind::thread;
        holes.pitch = 25.4 / 20.0;
        holes.majorDiameter = 6.35;
        holes.radialPasses = 3;
        holes.external = holes.leftHand = holes.conventional = holes.springPass = true;
        QVERIFY(comesBack(holes));
    }

    void wrongRequestsAreRefused() {
        const auto refused = [](const char* text) { return !passRequestFromJson(text, "text"); };
        QVERIFY(refused(R"({"pass": "fly"})"));
        QVERIFY(refused(R"({"pass": "levels", "step_over_mm": -1})"));
        QVERIFY(refused(R"({"pass": "levels", "step": 1})"));
        QVERIFY(refused(R"({"pass": "pocket"})"));
        QVERIFY(refused(R"({"pass": "flow"})"));
        QVERIFY(refused(R"({"pass": "engrave", "lines": [{"places_mm": [0, 0, 0, 1, 0, 0]}]})"));
        QVERIFY(refused(R"({"pass": "levels", "top_mm": 1, "bottom_mm": 2})"));
        QVERIFY(refused(R"({"pass": "levels", "area": [{"corners_mm": [0, 0, 1]}]})"));
        QVERIFY(refused(R"({"pass": "profile", "tabs": 2})"));
        QVERIFY(refused(R"({"pass": "profile", "tabs": 1e9, "tab_width_mm": 1, "tab_height_mm": 1})"));
        QVERIFY(refused(R"({"pass": "pocket", "tabs": 2, "tab_width_mm": 1, "tab_height_mm": 1})"));
        QVERIFY(refused(R"({"pass": "levels", "dogbones": true})"));
        QVERIFY(refused(R"({"pass": "levels", "places_mm": [1, 1]})"));
        QVERIFY(refused(R"({"pass": "drill", "places_mm": [1]})"));
        QVERIFY(refused(R"({"pass": "drill", "places_mm": [1, 1e300]})"));
        QVERIFY(refused(R"({"pass": "thread", "major_diameter_mm": 8})"));
        QVERIFY(refused(R"({"pass": "thread", "pitch_mm": 1.25})"));
        QVERIFY(refused(R"({"pass": "thread", "pitch_mm": 4, "major_diameter_mm": 8})"));
        QVERIFY(refused(R"({"pass": "thread", "pitch_mm": 1.25, "major_diameter_mm": 8, "radial_passes": 0})"));
        QVERIFY(refused(R"({"pass": "thread", "pitch_mm": 1.25, "major_diameter_mm": 8, "allowance_mm": 0.1})"));
        QVERIFY(refused(R"({"pass": "drill", "pitch_mm": 1.25})"));
        QVERIFY(!refused(R"({"pass": "thread", "pitch_mm": 1.25, "major_diameter_mm": 8})"));
        PassRequest levels;
        levels.leftHand = true;
        QCOMPARE(validate(levels).error().subject, std::string("left_hand"));
        QVERIFY(!refused(R"({"pass": "levels"})"));
    }

    void cancelledPlansSaySo() {
        const Ground ground(blockUnder(step, 25.0, 100), endMill(8.0, 4.0), {{-25.0, -25.0, 0.0}, {25.0, 25.0, 20.0}},
                            0.5);
        for (const PassKind kind : {PassKind::levels, PassKind::parallel, PassKind::waterline}) {
            PassRequest request;
            request.kind = kind;
            Progress progress;
            progress.cancel();
            const Result<PlannedPass> pass = planPass(request, ground.ground, progress);
            QVERIFY(!pass && pass.error().code == ErrorCode::cancelled);
        }
    }
};

BURIN_TEST(ComputedPassTest, QCoreApplication)

} // namespace burin::tst_computed_pass

#include "tst_computed_pass.moc"

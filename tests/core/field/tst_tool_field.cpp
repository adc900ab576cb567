// SPDX-FileCopyrightText: 2026 The Burin authors
// SPDX-License-Identifier: Apache-2.0
#include "core/base/available_memory.h"
#include "core/field/tool_field.h"
#include "tests/oracles/allocation_count.h"

#include "tests/core/geometry/shapes.h"
#include "tests/test_program.h"

#include <QtTest>

#include <atomic>
#include <cstdlib>
#include <functional>
#include <new>
#include <random>
#include <thread>

namespace burin::tst_tool_field {

namespace {

constexpr double voxel = 0.5;

std::vector<RevolvedPiece> tool(double radius, double corner) {
    return {{0.0, 20.0, radius, radius, corner}, {20.0, 40.0, radius, radius, 0.0}, {40.0, 60.0, 10.0, 16.0, 0.0}};
}

ToolField built(const MeshDistance& part, const std::vector<RevolvedPiece>& pieces, const Box& tips,
                double edge = voxel) {
    Progress progress;
    Result<ToolField> field = ToolField::build(part, {pieces, tips, edge, 1.0}, progress);
    if (!field) qFatal("no field");
    return std::move(*field);
}

class Points {
public:
    glm::dvec3 in(const Box& box) {
        std::uniform_real_distribution<double> part(0.0, 1.0);
        const double x = part(engine_), y = part(engine_), z = part(engine_);
        return box.low + glm::dvec3(x, y, z) * box.size();
    }

private:
    std::mt19937_64 engine_{20260102};
};

/// The deviation of a field above and below a formula, where it is fine according to itself and `counts`; and above it
/// elsewhere. The excess over the stated error at the points, and the mean of the latter.
struct Deviation {
    double above = -1e9, below = 1e9, coarseAbove = -1e9;
    double overBound = -1e9, meanBound = 0.0;
    int fine = 0, coarse = 0;
};

Deviation deviation(const ToolField& field, const Box& tips, const std::function<double(const glm::dvec3&)>& formula,
                    const std::function<bool(const glm::dvec3&, double)>& counts, int samples = 60000) {
    Points points;
    Deviation found;
    for (int i = 0; i < samples; ++i) {
        const glm::dvec3 tip = points.in(tips);
        const double wanted = formula(tip);
        if (!counts(tip, wanted)) continue;
        const FieldSample sample = field.at(tip);
        const double error = sample.clearance - wanted, stated = field.errorBoundAt(tip);
        found.overBound = std::max(found.overBound, error - stated);
        if (sample.fine) {
            ++found.fine;
            found.above = std::max(found.above, error);
            found.below = std::min(found.below, error);
            found.meanBound += stated;
        } else {
            ++found.coarse;
            found.coarseAbove = std::max(found.coarseAbove, error);
        }
    }
    found.meanBound /= std::max(found.fine, 1);
    qInfo("above %.4f below %.4f voxel in %d fine, above %.4f mm in %d coarse; spacing %.3f mm; over the bound %.4f, "
          "that is %.4f in the mean",
          found.above / voxel, found.below / voxel, found.fine, found.coarseAbove, found.coarse, field.spacing(),
          found.overBound / voxel, found.meanBound / voxel);
    return found;
}

bool always(const glm::dvec3&, double) {
    return true;
}

} // namespace

class ToolFieldTest : public QObject {
    Q_OBJECT

private slots:
    void planeIsExactForEveryTool();
    void ballOverTorus();
    void ballOverBlock();
    void flatOverBlock();
    void sharpEdgesKeepTheBoundOfTheirPlace_data();
    void sharpEdgesKeepTheBoundOfTheirPlace();
    void flatInPocket();
    void bullOverTorus();
    void flatOverTorus();
    void shankAndHolderAreInIt();
    void swallowedToolsAreDeep();
    void farTipsAreNeverToldTooMuch();
    void aToolGoesFreeWhereItIsClear_data();
    void aToolGoesFreeWhereItIsClear();
    void insideLeadsOut();
    void outsideTheBoxIsItsNearestPoint();
    void zeroIsOutsideThePart();
    void emptyPartIsFree();
    void askingDoesNotAllocate();
    void canBeCancelled();
    void refusesWhatMakesNoField();
};

void ToolFieldTest::planeIsExactForEveryTool() {
    const MeshDistance part(shapes::box({-30, -30, -12}, {30, 30, 0}));
    const Box tips{{-8, -8, -1.5}, {8, 8, 12}};
    for (const double corner : {3.0, 0.0, 1.0}) {
        const ToolField field = built(part, tool(3.0, corner), tips);
        QVERIFY(field.errorBound() <= 0.05 * voxel);
        const Deviation d = deviation(
            field, tips, [](const glm::dvec3& p) { return p.z; }, always);
        QVERIFY(d.above <= 1e-6 && d.below >= -field.errorBound() && d.coarseAbove <= 0.0);
        QVERIFY(d.fine > 10000);
        const FieldSample sample = field.at({0.3, 0.4, 0.6});
        QVERIFY(sample.fine && glm::length(sample.gradient - glm::dvec3(0, 0, 1)) < 1e-2);
    }
}

void ToolFieldTest::ballOverTorus() {
    const double major = 12.0, minor = 4.0, radius = 3.0;
    const MeshDistance part(shapes::torus(major, minor, 1200, 400));
    const Box tips{{-20, 0, -2}, {20, 20, 9}};
    const ToolField field = built(part, {tool(radius, radius)[0]}, tips);
    const auto formula = [&](const glm::dvec3& tip) {
        const glm::dvec3 centre = tip + glm::dvec3(0, 0, radius);
        return std::hypot(std::hypot(centre.x, centre.y) - major, centre.z) - minor - radius;
    };
    // Above the ring's equator the flutes above the ball are never nearer than the ball.
    const auto smooth = [&](const glm::dvec3& tip, double clearance) {
        return tip.z + radius > 0.0 && clearance > -voxel && std::hypot(tip.x, tip.y) > 5.0;
    };
    const Deviation d = deviation(field, tips, formula, smooth);
    const double chord = 0.0005;
    QVERIFY(d.above <= 0.02 * voxel + chord);
    QVERIFY(d.below >= -field.errorBound() - chord);
    QVERIFY(d.coarseAbove <= chord);
    QVERIFY(d.fine > 10000 && d.coarse > 1000);
}

void ToolFieldTest::ballOverBlock() {
    const glm::dvec3 low{-10, -10, -10}, high{10, 10, 0};
    const MeshDistance part(shapes::box(low, high));
    const Box tips{{-16, -16, -6}, {0, 0, 8}};
    const ToolField field = built(part, {tool(3.0, 3.0)[0]}, tips);
    const auto formula = [&](const glm::dvec3& tip) { // the flutes extend above the block: lift it to them
        const glm::dvec3 centre = tip + glm::dvec3(0, 0, 3.0);
        return shapes::boxDistance(low, high, {centre.x, centre.y, std::max(centre.z, -5.0)}) - 3.0;
    };
    const Deviation d = deviation(field, tips, formula, [](const glm::dvec3&, double c) { return c > -voxel; });
    QVERIFY(d.above <= 0.05 * voxel); // even at edges and corners, which a ball rounds
    QVERIFY(d.below >= -0.5 * voxel);
    QVERIFY(d.coarseAbove <= 0.0);
}

void ToolFieldTest::flatOverBlock() {
    const glm::dvec3 low{-10, -10, -10}, high{10, 10, 0};
    const MeshDistance part(shapes::box(low, high));
    const Box tips{{-16, -16, -6}, {0, 0, 8}};
    const ToolField field = built(part, {tool(3.0, 0.0)[0]}, tips);
    const auto formula = [&](const glm::dvec3& tip) { // a cylinder and a box, perpendicular to the axis and along it
        const glm::dvec2 q = glm::abs(glm::dvec2(tip)) - 10.0;
        const double across = glm::length(glm::max(q, 0.0)) + std::min(std::max(q.x, q.y), 0.0) - 3.0;
        const double along = tip.z;
        return across > 0.0 && along > 0.0 ? std::hypot(across, along) : std::max(across, along);
    };
    const auto faces = [&](const glm::dvec3& tip, double c) {
        const glm::dvec2 q = glm::abs(glm::dvec2(tip)) - 10.0;
        const double across = glm::length(glm::max(q, 0.0)) + std::min(std::max(q.x, q.y), 0.0) - 3.0;
        return c > -voxel && (tip.z > across + 2.0 || across > tip.z + 2.0) && std::min(q.x, q.y) < -1.0;
    };
    const Deviation smooth = deviation(field, tips, formula, faces);
    QVERIFY(smooth.above <= 1e-3 * voxel && smooth.below >= -field.errorBound());
    const Deviation edges = deviation(field, tips, formula, [](const glm::dvec3&, double c) { return c > -voxel; });
    QVERIFY(edges.above <= 0.5 * voxel && edges.below >= -0.5 * voxel);
    QVERIFY(edges.overBound <= 1e-6);
    QVERIFY(edges.coarseAbove <= 0.0);
}

void ToolFieldTest::sharpEdgesKeepTheBoundOfTheirPlace_data() {
    QTest::addColumn<double>("corner"); // mm, of the flutes
    QTest::addColumn<glm::dvec3>("turn");
    QTest::newRow("flat end, block along the axes") << 0.0 << glm::dvec3(0.0);
    QTest::newRow("flat end, block turned about the tool") << 0.0 << glm::dvec3(0.0, 0.0, 0.4);
    QTest::newRow("flat end, block tilted") << 0.0 << glm::dvec3(0.5, 0.3, 0.2);
    QTest::newRow("flat end, block tilted a little") << 0.0 << glm::dvec3(0.06, 0.03, 0.1);
    QTest::newRow("bull nose, block tilted") << 0.5 << glm::dvec3(0.3, -0.5, 0.7);
    QTest::newRow("ball end, block tilted") << 3.0 << glm::dvec3(0.3, -0.5, 0.7);
}

/// A flat end over a sharp edge: the clearance has an edge there, too, and an interpolated value is above it.
void ToolFieldTest::sharpEdgesKeepTheBoundOfTheirPlace() {
    QFETCH(const double, corner);
    QFETCH(const glm::dvec3, turn);
    TriangleMesh block = shapes::box({-10, -10, -10}, {10, 10, 0});
    const glm::dmat3 turned = glm::mat3_cast(glm::dquat(turn));
    for (glm::dvec3& vertex : block.vertices) vertex = turned * vertex;
    const MeshDistance part(block);
    const Box tips{{-16, -16, -6}, {2, 2, 8}};
    const std::vector<RevolvedPiece> pieces{tool(3.0, corner)[0]};
    const ToolField field = built(part, pieces, tips);
    const auto exact = [&](const glm::dvec3& tip) { return part.clearance(pieces, {tip, {0, 0, 1}}).clearance; };
    const Deviation d = deviation(
        field, tips, exact, [](const glm::dvec3&, double c) { return c > -voxel; }, 30000);
    QVERIFY(d.fine > 5000 && d.coarse > 1000);
    QVERIFY(d.overBound <= 1e-6);
    QVERIFY(d.meanBound <= 0.2 * voxel); // and the bound is not trivial
}

void ToolFieldTest::flatInPocket() {
    const double inner = 8.0, depth = 6.0, radius = 3.0;
    const MeshDistance part(shapes::pocket(20.0, 15.0, inner, depth));
    const Box tips{{-6, -6, -7}, {6, 6, 3}};
    const ToolField field = built(part, tool(radius, 0.0), tips);
    const auto formula = [&](const glm::dvec3& tip) {
        return std::min({inner - radius - std::abs(tip.x), inner - radius - std::abs(tip.y), tip.z + depth});
    };
    const auto below = [&](const glm::dvec3& tip, double c) { return tip.z < -2.5 && c > -2.0 * voxel; };
    const Deviation d = deviation(field, tips, formula, below);
    QVERIFY(d.above <= 1e-3 * voxel); // walls and their corners: never too large
    QVERIFY(d.below >= -0.5 * voxel);
    const auto flank = [&](const glm::dvec3& tip, double c) {
        const double a = inner - radius - std::abs(tip.x), b = inner - radius - std::abs(tip.y), f = tip.z + depth;
        const double second = std::max(std::min(a, b), std::min(std::max(a, b), f));
        return below(tip, c) && second > c + 1.0;
    };
    QVERIFY(deviation(field, tips, formula, flank).below >= -field.errorBound());
}

void ToolFieldTest::bullOverTorus() {
    const MeshDistance part(shapes::torus(14.0, 5.0, 300, 120));
    const Box tips{{-22, -6, -3}, {-4, 6, 9}};
    const std::vector<RevolvedPiece> bull = tool(3.0, 1.0);
    const ToolField field = built(part, bull, tips);
    const auto exact = [&](const glm::dvec3& tip) { return part.clearance(bull, {tip, {0, 0, 1}}).clearance; };
    const Deviation d = deviation(
        field, tips, exact, [](const glm::dvec3&, double c) { return c > 0.0; }, 8000);
    QVERIFY(d.above <= 0.05 * voxel);
    QVERIFY(d.overBound <= 1e-6);
    QVERIFY(d.below >= -0.5 * voxel); // the ring closes over itself in the middle of the part
    QVERIFY(d.coarseAbove <= 0.0);
}

void ToolFieldTest::flatOverTorus() {
    // A rim over a smooth surface: the clearance has a kink at 0, and grows more slowly inside.
    const MeshDistance part(shapes::torus(14.0, 5.0, 600, 240));
    const Box tips{{-24, -6, -6}, {-4, 6, 9}};
    const std::vector<RevolvedPiece> flat{{0.0, 20.0, 4.0, 4.0, 0.0}};
    const ToolField field = built(part, flat, tips);
    const auto exact = [&](const glm::dvec3& tip) { return part.clearance(flat, {tip, {0, 0, 1}}).clearance; };
    const auto outside = [](const glm::dvec3& tip, double c) { return tip.x < -16.0 && tip.z > 0.0 && c > 0.0; };
    const Deviation apart = deviation(field, tips, exact, outside, 20000);
    QVERIFY(apart.above <= 0.03 * voxel && apart.below >= -0.06 * voxel && apart.coarseAbove <= 0.0);
    QVERIFY(apart.fine > 1000);
    const Deviation inside = deviation(
        field, tips, exact, [](const glm::dvec3&, double c) { return c > -voxel && c <= 0.0; }, 20000);
    QVERIFY(inside.above <= 0.03 * voxel && inside.below >= -0.06 * voxel);
    QVERIFY(apart.overBound <= 1e-6 && inside.overBound <= 1e-6);
    QVERIFY(inside.fine > 500);
}

void ToolFieldTest::swallowedToolsAreDeep() {
    // Completely inside, the deepest point of the axis counts: no thin sheet of shallow tips where the tool just fits
    // in.
    const glm::dvec3 half(40.0, 40.0, 36.0);
    const MeshDistance part(shapes::box(-half, half));
    const std::vector<RevolvedPiece> pieces = tool(3.0, 3.0); // 60 long
    const Box tips{{-12, -12, -34}, {12, 12, -20}};
    const ToolField field = built(part, pieces, tips);
    const auto axisDepth = [&](const glm::dvec3& tip) {
        double least = 1e9;
        for (const double height : {0.0, 3.0, 20.0, 40.0, 60.0})
            least = std::min(least, shapes::boxDistance(-half, half, tip + glm::dvec3(0.0, 0.0, height)));
        return least;
    };
    const Deviation d = deviation(field, tips, axisDepth, always, 20000);
    QCOMPARE(d.fine, 0);
    QVERIFY(d.coarseAbove <= 0.0);
    const FieldSample sample = field.at({0.0, 0.0, -30.0});
    QVERIFY(sample.clearance < -20.0 && isFinite(sample.gradient));
}

void ToolFieldTest::shankAndHolderAreInIt() {
    const MeshDistance part(shapes::box({0, -90, -90}, {90, 90, 90})); // a wall at x = 0
    const Box tips{{-20, -4, -4}, {-4, 4, 4}};
    const ToolField field = built(part, tool(3.0, 3.0), tips);
    // The clearance from the wall is that of the holder's upper rim; the depth of a sharp rim inside is another matter.
    const Deviation d = deviation(
        field, tips, [](const glm::dvec3& p) { return -p.x - 16.0; },
        [](const glm::dvec3&, double c) { return c > voxel; }, 20000);
    QVERIFY(d.above <= 1e-3 * voxel && d.below >= -field.errorBound() && d.coarseAbove <= 0.0);
}

void ToolFieldTest::farTipsAreNeverToldTooMuch() {
    const MeshDistance part(shapes::pocket(10.0, 10.0, 5.0, 6.0));
    const Box tips{{-40, -40, -5}, {40, 40, 50}};
    const std::vector<RevolvedPiece> pieces = tool(2.0, 2.0);
    const ToolField field = built(part, pieces, tips, 1.0);
    const auto exact = [&](const glm::dvec3& tip) { return part.clearance(pieces, {tip, {0, 0, 1}}).clearance; };
    const Deviation d = deviation(
        field, tips, exact, [](const glm::dvec3&, double c) { return c > 0.0; }, 20000);
    QVERIFY(d.coarse > 5000);
    QVERIFY(d.coarseAbove <= 0.0);
    QVERIFY(field.at({0, 0, 45}).clearance > 40.0); // and sufficient for large steps
}

void ToolFieldTest::aToolGoesFreeWhereItIsClear_data() {
    QTest::addColumn<double>("edge"); // mm, of a voxel
    QTest::addColumn<double>("corner");
    for (const double edge : {0.2, 0.5, 0.65})
        for (const double corner : {0.0, 1.0, 5.0})
            QTest::addRow("voxel %g, corner radius %g", edge, corner) << edge << corner;
}

/// Where the tool's clearance from the part exceeds the largest allowance by a tenth of a voxel, no allowance holds it:
/// otherwise the hand would stick where there is nothing. A plate with a boss, in air above and beside it.
void ToolFieldTest::aToolGoesFreeWhereItIsClear() {
    QFETCH(const double, edge);
    QFETCH(const double, corner);
    constexpr double allowance = 1.0;
    TriangleMesh solid = shapes::box({-21, -13, -8}, {21, 13, 0});
    const TriangleMesh boss = shapes::box({-9, -7, 0.01}, {4, 6, 6});
    const auto first = static_cast<std::uint32_t>(solid.vertices.size());
    solid.vertices.insert(solid.vertices.end(), boss.vertices.begin(), boss.vertices.end());
    for (auto triangle : boss.triangles) {
        for (std::uint32_t& vertex : triangle) vertex += first;
        solid.triangles.push_back(triangle);
    }
    const MeshDistance part(solid);
    const Box tips{{-36, -28, -6}, {36, 28, 30}};
    const std::vector<RevolvedPiece> pieces = tool(5.0, corner);
    Progress progress;
    const Result<ToolField> field = ToolField::build(part, {pieces, tips, edge, allowance}, progress);
    QVERIFY(field);
    Points points;
    int clear = 0;
    for (int i = 0; i < 30000; ++i) {
        const glm::dvec3 tip = points.in(tips);
        const double truth = part.clearance(pieces, {tip, {0, 0, 1}}).clearance;
        if (truth < allowance + 0.1 * edge) continue;
        ++clear;
        const double told = field->at(tip).clearance;
        QVERIFY2(
            told > allowance,
            qPrintable(
                QString("%1 %2 %3: %4 mm clear, told %5 mm").arg(tip.x).arg(tip.y).arg(tip.z).arg(truth).arg(told)));
    }
    QVERIFY(clear > 10000);
}

void ToolFieldTest::insideLeadsOut() {
    const MeshDistance part(shapes::sphere(10.0, 300, 150));
    const ToolField field = built(part, tool(3.0, 3.0), {{-14, -14, 0}, {14, 14, 14}});
    for (const double depth : {0.2, 0.7, 1.4})
        for (int i = 0; i < 24; ++i) {
            const double u = 0.27 * i, v = 0.3 + 0.05 * i;
            const glm::dvec3 out{std::cos(u) * std::cos(v), std::sin(u) * std::cos(v), std::sin(v)};
            const FieldSample sample = field.at((13.0 - depth) * out - glm::dvec3(0, 0, 3.0));
            QVERIFY(std::abs(sample.clearance + depth) < (depth < voxel ? 0.05 : 0.2) * voxel + 0.003);
            QVERIFY(glm::dot(glm::normalize(sample.gradient), out) > 0.99);
        }
}

void ToolFieldTest::outsideTheBoxIsItsNearestPoint() {
    const MeshDistance part(shapes::box({-30, -30, -12}, {30, 30, 0}));
    const ToolField field = built(part, tool(3.0, 0.0), {{-8, -8, -1}, {8, 8, 3}});
    const FieldSample sample = field.at({20.0, 0.0, 1.0});
    QVERIFY(!sample.fine);
    QCOMPARE(sample.clearance, field.at({8.0, 0.0, 1.0}).clearance);
    QCOMPARE(field.errorBoundAt({20.0, 0.0, 1.0}), field.errorBoundAt({8.0, 0.0, 1.0}) + 12.0); // it may fall so fast
    QVERIFY(std::isfinite(field.at({std::nan(""), 0.0, 0.0}).clearance));
}

void ToolFieldTest::zeroIsOutsideThePart() {
    // The proxy relies on this: a tip that the field calls clear is clear, to 0.05 voxel.
    const TriangleMesh bumps = shapes::starShaped(
        240, 120, [](double u, double v) { return 12.0 + 0.8 * std::sin(4.0 * u) * std::cos(v) * std::cos(v); });
    const MeshDistance part(bumps);
    const Box tips{{4, -6, 0}, {15, 6, 12}};
    const std::vector<RevolvedPiece> ball = tool(3.0, 3.0);
    const ToolField field = built(part, ball, tips);
    Points points;
    int stood = 0;
    double deepest = 0.0;
    for (int i = 0; i < 4000; ++i) {
        glm::dvec3 tip = points.in(tips);
        FieldSample sample = field.at(tip);
        if (!sample.fine || sample.clearance < 0.0) continue;
        for (int step = 0; step < 30; ++step) { // down onto the surface, from outside
            const glm::dvec3 next =
                tip - 0.9 * sample.clearance * sample.gradient / std::max(glm::length(sample.gradient), 1e-9);
            const FieldSample there = field.at(next);
            if (!(there.clearance >= 0.0)) break;
            tip = next;
            sample = there;
        }
        ++stood;
        deepest = std::min(deepest, part.clearance(ball, {tip, {0, 0, 1}}).clearance);
    }
    qInfo("%d tips, deepest %.4f voxel", stood, deepest / voxel);
    QVERIFY(stood > 500);
    QVERIFY(deepest >= -0.05 * voxel);
}

void ToolFieldTest::emptyPartIsFree() {
    const ToolField field = built(MeshDistance{TriangleMesh{}}, tool(3.0, 3.0), {{-8, -8, -1}, {8, 8, 3}});
    const FieldSample sample = field.at({0, 0, 0});
    QVERIFY(sample.clearance > 1e5 && std::isfinite(sample.clearance) && isFinite(sample.gradient));
}

void ToolFieldTest::askingDoesNotAllocate() {
    const MeshDistance part(shapes::box({-10, -10, -10}, {10, 10, 0}));
    const Box tips{{-16, -16, -6}, {0, 0, 8}};
    const ToolField field = built(part, tool(3.0, 3.0), tips);
    Points points;
    double sum = 0.0;
    const std::size_t before = allocationCount.load();
    for (int i = 0; i < 10000; ++i) {
        const glm::dvec3 tip = points.in(tips);
        sum += field.at(tip).clearance + field.errorBoundAt(tip) + field.errorBound() + field.spacing();
    }
    QCOMPARE(allocationCount.load(), before);
    QVERIFY(std::isfinite(sum));
}

void ToolFieldTest::canBeCancelled() {
    const MeshDistance part(shapes::torus(14.0, 5.0, 400, 200));
    const ToolFieldRequest request{tool(3.0, 0.0), {{-25, -25, -10}, {25, 25, 20}}, 0.2, 1.0};
    Progress progress;
    std::thread impatient([&] {
        while (progress.fraction() < 0.12) std::this_thread::yield();
        progress.cancel();
    });
    const Result<ToolField> field = ToolField::build(part, request, progress);
    impatient.join();
    QVERIFY(!field);
    QCOMPARE(field.error().code, ErrorCode::cancelled);
}

void ToolFieldTest::refusesWhatMakesNoField() {
    const MeshDistance part(shapes::box({-10, -10, -10}, {10, 10, 0}));
    const Box tips{{-1, -1, -1}, {1, 1, 1}};
    Progress progress;
    const auto code = [&](const ToolFieldRequest& request) {
        const Result<ToolField> field = ToolField::build(part, request, progress);
        return field ? ErrorCode::internalFault : field.error().code;
    };
    QCOMPARE(code({{}, tips, 0.5, 1.0}), ErrorCode::argumentInvalid);
    QCOMPARE(code({tool(3.0, 0.0), tips, 0.0, 1.0}), ErrorCode::argumentInvalid);
    QCOMPARE(code({tool(3.0, 0.0), tips, std::nan(""), 1.0}), ErrorCode::argumentInvalid);
    QCOMPARE(code({tool(3.0, 0.0), Box{}, 0.5, 1.0}), ErrorCode::argumentInvalid);
    QCOMPARE(code({tool(3.0, 0.0), {{-1e6, -1e6, -1e6}, {1e6, 1e6, 1e6}}, 1e-3, 1.0}), ErrorCode::outOfMemory);

    // Bricks of 8 samples and some 33 bytes, as many along an axis as take one and a half times the available memory.
    const double bricks = std::cbrt(1.5 * static_cast<double>(availableMemory()) / 33.0), voxel = 0.05;
    const double half = 0.5 * 8.0 * voxel * bricks;
    const ToolFieldRequest large{tool(3.0, 0.0), {glm::dvec3(-half), glm::dvec3(half)}, voxel, 1.0};
    const Result<ToolField> field = ToolField::build(part, large, progress);
    QVERIFY(!field && field.error().code == ErrorCode::outOfMemory);
    QVERIFY(!field.error().place.empty() || bricks > 990.0); // reported before memory is allocated
}

BURIN_TEST(ToolFieldTest, NoApplication)

} // namespace burin::tst_tool_field

#include "tst_tool_field.moc"

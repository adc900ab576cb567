// SPDX-FileCopyrightText: 2026 The Burin authors
// SPDX-License-Identifier: Apache-2.0
#include "core/base/available_memory.h"
#include "tests/oracles/allocation_count.h"
#include "tests/part_field/part_field.h"

#include "tests/core/geometry/random_shapes.h"
#include "tests/core/geometry/shapes.h"
#include "tests/random_cases.h"
#include "tests/test_program.h"

#include <QtTest>

#include <functional>
#include <limits>
#include <random>
#include <thread>

namespace burin::tst_part_field {

namespace {

constexpr double voxel = 0.5;
using Formula = std::function<double(const glm::dvec3&)>;

PartField built(const TriangleMesh& mesh, double reach = 0.0, double edge = voxel) {
    Progress progress;
    Result<PartField> field = PartField::build(mesh, {edge, reach}, progress);
    if (!field) qFatal("no field");
    return std::move(*field);
}

class Points {
public:
    double number(double low, double high) { return std::uniform_real_distribution<double>(low, high)(engine_); }
    glm::dvec3 around(double reach) {
        const double x = number(-reach, reach), y = number(-reach, reach), z = number(-reach, reach);
        return {x, y, z};
    }

private:
    std::mt19937_64 engine_{20260103};
};

glm::dvec3 turned(const glm::dvec3& v, double angle) { // about two axes, so that no face is parallel to the grid
    const double c = std::cos(angle), s = std::sin(angle);
    const glm::dvec3 u{c * v.x - s * v.y, s * v.x + c * v.y, v.z};
    return {u.x, c * u.y - s * u.z, s * u.y + c * u.z};
}
glm::dvec3 turnedBack(const glm::dvec3& v, double angle) {
    const double c = std::cos(angle), s = std::sin(angle);
    const glm::dvec3 u{v.x, c * v.y + s * v.z, -s * v.y + c * v.z};
    return {c * u.x + s * u.y, -s * u.x + c * u.y, u.z};
}
TriangleMesh turned(TriangleMesh mesh, double angle) {
    for (glm::dvec3& vertex : mesh.vertices) vertex = turned(vertex, angle);
    return mesh;
}

/// Independent reference: the distance to all triangles, one by one, and the solid angle that they subtend for the
/// side.
double bruteForce(const TriangleMesh& mesh, const glm::dvec3& p) {
    double least = 1e300, covered = 0.0;
    const auto toSegment = [&](const glm::dvec3& a, const glm::dvec3& b) {
        const double t = std::clamp(glm::dot(p - a, b - a) / glm::dot(b - a, b - a), 0.0, 1.0);
        return glm::length(p - a - t * (b - a));
    };
    for (const auto& [i, j, k] : mesh.triangles) {
        const glm::dvec3 a = mesh.vertices[i], b = mesh.vertices[j], c = mesh.vertices[k];
        const glm::dvec3 normal = glm::normalize(glm::cross(b - a, c - a));
        const auto left = [&](const glm::dvec3& from, const glm::dvec3& to) {
            return glm::dot(glm::cross(to - from, p - from), normal) >= 0.0;
        };
        least = std::min({least, toSegment(a, b), toSegment(b, c), toSegment(c, a)});
        if (left(a, b) && left(b, c) && left(c, a)) least = std::min(least, std::abs(glm::dot(p - a, normal)));
        // A. van Oosterom and J. Strackee, The solid angle of a plane triangle (1983).
        const glm::dvec3 u = a - p, v = b - p, w = c - p;
        const double lu = glm::length(u), lv = glm::length(v), lw = glm::length(w);
        covered += 2.0 * std::atan2(glm::dot(u, glm::cross(v, w)),
                                    lu * lv * lw + glm::dot(u, v) * lw + glm::dot(v, w) * lu + glm::dot(w, u) * lv);
    }
    return covered > 2.0 * std::numbers::pi ? -least : least;
}

/// Errors of a field at sample points: the largest error within 4 voxels of the surface and beyond, and the largest
/// excess of an error over the field's bound at that point.
struct Errors {
    double fine = 0.0, coarse = 0.0, overBound = -1e9;
    int wrongSide = 0;

    void meet(const PartField& field, const glm::dvec3& point, double wanted, double meshError) {
        const double value = field.value(point), error = std::abs(value - wanted);
        double& worst = std::abs(wanted) <= 4.0 * voxel ? fine : coarse;
        worst = std::max(worst, error);
        overBound = std::max(overBound, error - field.errorBoundAt(point) - meshError);
        if (std::abs(wanted) > field.errorBoundAt(point) + meshError && (value < 0.0) != (wanted < 0.0)) ++wrongSide;
    }
    void report(const char* name) const {
        qInfo("%s: error %.4f voxel in the band, %.3f beyond; over the bound %.5f", name, fine / voxel, coarse / voxel,
              overBound / voxel);
    }
};

/// Points near a surface, found by following the formula's gradient, and points anywhere.
glm::dvec3 somewhere(Points& points, const Formula& formula, double reach, int number) {
    glm::dvec3 p = points.around(reach);
    if (number % 4 == 0) return p;
    for (int step = 0; step < 6; ++step) {
        const double d = formula(p), h = 1e-4;
        p -= d *
             glm::dvec3(formula(p + glm::dvec3(h, 0, 0)) - d, formula(p + glm::dvec3(0, h, 0)) - d,
                        formula(p + glm::dvec3(0, 0, h)) - d) /
             h;
    }
    return p + points.around(2.5 * voxel);
}

} // namespace

class PartFieldTest : public QObject {
    Q_OBJECT

private slots:
    void smoothPartsAreWithinThreeHundredths();
    void sharpEdgesKeepTheirBound();
    void randomTetrahedraAgreeWithBruteForce();
    void narrowGapsAndThinWallsKeepTheirSide();
    void spikesBetweenSamplesAreFound();
    void spikesBesideABrickAreFoundInIt();
    void farPointsAreWithinTheirBound();
    void lowerBoundIsNeverTooMuch();
    void gradientPointsAway();
    void manyAtOnceAreTheSame_data();
    void manyAtOnceAreTheSame();
    void manyOnBordersOfCellsAreWithinTheBound();
    void manyMayHoldWhatIsNoNumber();
    void takesAtMostFiveBytesABandVoxel();
    void emptyPartIsFar();
    void askingDoesNotAllocate();
    void canBeCancelled();
    void cancelledAtOnceItWantsNoMemory();
    void refusesWhatMakesNoField();
};

void PartFieldTest::smoothPartsAreWithinThreeHundredths() {
    Points points;
    const auto check = [&](const char* name, const TriangleMesh& mesh, const Formula& formula, double chord) {
        const PartField field = built(mesh, 6.0);
        Errors errors;
        for (int i = 0; i < 40000; ++i) {
            const glm::dvec3 p = somewhere(points, formula, 26.0, i);
            errors.meet(field, p, formula(p), chord);
        }
        errors.report(name);
        QVERIFY(errors.fine <= 0.03 * voxel + chord);
        QVERIFY(errors.overBound <= 0.0);
        QCOMPARE(errors.wrongSide, 0);
    };
    check(
        "sphere", shapes::sphere(20.0, 400, 200), [](const glm::dvec3& p) { return glm::length(p) - 20.0; }, 0.0015);
    check(
        "torus", shapes::torus(14.0, 6.0, 600, 240),
        [](const glm::dvec3& p) { return std::hypot(std::hypot(p.x, p.y) - 14.0, p.z) - 6.0; }, 0.001);
}

void PartFieldTest::sharpEdgesKeepTheirBound() {
    Points points;
    const glm::dvec3 half{12.0, 9.0, 5.0};
    for (const double angle : {0.0, 0.3, 0.7}) {
        const PartField field = built(turned(shapes::box(-half, half), angle), 6.0);
        const Formula formula = [&](const glm::dvec3& p) {
            return shapes::boxDistance(-half, half, turnedBack(p, angle));
        };
        Errors errors;
        for (int i = 0; i < 40000; ++i) {
            glm::dvec3 p = somewhere(points, formula, 18.0, i);
            if (i % 3 == 0) { // at edges and corners
                const glm::dvec3 near = glm::sign(points.around(1.0)) * half + points.around(2.0 * voxel);
                p = turned(i % 2 == 0 ? near : glm::dvec3(points.number(-12.0, 12.0), near.y, near.z), angle);
            }
            errors.meet(field, p, formula(p), 0.0);
        }
        errors.report("box");
        QVERIFY(errors.fine <= 0.08 * voxel); // a trilinear cell there would be off by a third
        QVERIFY(errors.overBound <= 0.0);
        QCOMPARE(errors.wrongSide, 0);
    }
}

void PartFieldTest::randomTetrahedraAgreeWithBruteForce() {
    const bool held = testing::holdsInShare("acute edges, slivers, corners", [] {
        TriangleMesh mesh;
        for (const glm::dvec3& corner : {glm::dvec3(1, 1, 1), {-1, -1, 1}, {-1, 1, -1}, {1, -1, -1}})
            mesh.vertices.push_back(4.0 * corner + random::point(4.0));
        mesh.triangles = {{0, 2, 1}, {0, 1, 3}, {1, 2, 3}, {2, 0, 3}};
        if (signedVolume(mesh) < 0.0)
            for (auto& triangle : mesh.triangles) std::swap(triangle[1], triangle[2]);
        RC_PRE(signedVolume(mesh) > 1.0);
        const PartField field = built(mesh, 4.0);
        Errors errors;
        for (int i = 0; i < 400; ++i) {
            const glm::dvec3 &a = mesh.vertices[std::size_t(i % 4)], &b = mesh.vertices[std::size_t((i / 4) % 4)];
            const glm::dvec3 p = glm::mix(a, b, random::number(0.0, 1.0)) + random::point(i % 3 == 0 ? 6.0 : 1.0);
            errors.meet(field, p, bruteForce(mesh, p), 1e-6);
        }
        RC_ASSERT(errors.overBound <= 0.0);
        RC_ASSERT(errors.wrongSide == 0);
        RC_ASSERT(errors.fine <= 0.1 * voxel);
    });
    QVERIFY(held);
}

void PartFieldTest::narrowGapsAndThinWallsKeepTheirSide() {
    // A wall of 0.3 voxels, a gap of 0.4 next to it, then a block.
    const double wall = 0.3 * voxel, gap = 0.4 * voxel;
    const TriangleMesh mesh = turned(shapes::cells({-wall - gap, -gap, 0.0, 6.0}, {-8.0, 8.0}, {-8.0, 7.0, 8.0},
                                                   [](int i, int, int k) { return i != 1 || k == 1; }),
                                     0.2);
    const PartField field = built(mesh);
    Points points;
    Errors errors;
    for (int i = 0; i < 30000; ++i) {
        const glm::dvec3 flat{points.number(-1.0, 0.6), points.number(-9.0, 9.0), points.number(-9.0, 9.0)};
        const glm::dvec3 p = turned(flat, 0.2);
        errors.meet(field, p, bruteForce(mesh, p), 1e-6);
    }
    errors.report("wall and gap");
    QVERIFY(errors.overBound <= 0.0);
    QCOMPARE(errors.wrongSide, 0);
}

void PartFieldTest::spikesBetweenSamplesAreFound() {
    // Pins of half a voxel on a flat face, which are not nearest to any of the samples that are far apart. In the
    // middle of the face, and in bricks that an edge passes through, next to a flat one: detected in the first by its
    // own check, in the next because it is adjacent.
    const glm::dvec3 corner(-20.0, -20.0, -8.0), top(20.0, 20.0, 0.0);
    for (int place = 0; place < 8; ++place) {
        const glm::dvec3 low = place < 4 ? glm::dvec3(0.9 + 0.53 * place, 1.1 - 0.59 * place, -0.01)
                                         : glm::dvec3(18.05, 0.3 + 0.8 * (place - 4), -0.01);
        const glm::dvec3 high = low + glm::dvec3(0.25, 0.25, 1.91);
        TriangleMesh mesh = shapes::box(corner, top);
        append(mesh, shapes::box(low, high));
        const PartField field = built(mesh);
        Points points;
        Errors errors;
        for (int i = 0; i < 8000; ++i) {
            const glm::dvec3 p = glm::dvec3(low.x, low.y, 1.5) + points.around(2.5);
            if (p.z < 0.4) continue; // outside, the smaller of both distances is right
            errors.meet(field, p, std::min(shapes::boxDistance(corner, top, p), shapes::boxDistance(low, high, p)),
                        1e-6);
        }
        errors.report("pin");
        QVERIFY(errors.overBound <= 0.0);
    }
}

/// A pin of one voxel close to where two bricks meet, half-way along their common face: the corners of the adjacent
/// brick are nearer to the flat face on which the pin stands, so that the brick is taken for smooth. The pin's own
/// brick is smooth too, or is one that is sampled closely (the part's edge passes through) and represents the pin.
void PartFieldTest::spikesBesideABrickAreFoundInIt() {
    const glm::dvec3 corner(-20.0, -20.0, -10.0), top(20.0, 20.0, 0.0);
    // Bricks are counted from the margin around the part, four voxels: they meet in the plane of the flat face, and in
    // the other directions at 2 and 18.
    const double brick = 8.0 * voxel, margin = 4.0 * voxel;
    QCOMPARE(std::remainder(top.z - (corner.z - margin), brick), 0.0);
    QCOMPARE(std::remainder(2.0 - (corner.x - margin), brick), 0.0);
    for (const int axis : {0, 1})
        for (const double border : {-2.0, 2.0, 18.0}) {
            const double towards = border == 18.0 ? -1.0 : std::copysign(1.0, border);
            glm::dvec3 middle(0.0, 0.0, 0.24);
            middle[axis] = border - towards * 0.05;
            const glm::dvec3 low = middle - glm::dvec3(0.03, 0.03, 0.25), high = middle + glm::dvec3(0.03, 0.03, 0.25);
            TriangleMesh mesh = shapes::box(corner, top);
            append(mesh, shapes::box(low, high));
            const PartField field = built(mesh);
            Points points;
            Errors beside;
            for (int i = 0; i < 4000; ++i) {
                glm::dvec3 p(points.number(-2.0, 2.0), points.number(-2.0, 2.0), points.number(0.3, 4.0));
                p[axis] = border + towards * points.number(0.0, brick);
                beside.meet(field, p, std::min(shapes::boxDistance(corner, top, p), shapes::boxDistance(low, high, p)),
                            1e-6);
            }
            beside.report("beside a pin");
            QVERIFY(beside.overBound <= 0.0);
        }
}

void PartFieldTest::farPointsAreWithinTheirBound() {
    const glm::dvec3 half{12.0, 9.0, 5.0};
    const TriangleMesh mesh = shapes::pocket(12.0, 9.0, 6.0, 5.0);
    const PartField field = built(mesh, 25.0);
    Points points;
    Errors errors;
    double inReach = 0.0;
    for (int i = 0; i < 20000; ++i) {
        const glm::dvec3 p = points.around(i % 2 == 0 ? 25.0 : 80.0);
        const double wanted = bruteForce(mesh, p);
        errors.meet(field, p, wanted, 1e-6);
        if (std::abs(wanted) <= 25.0) inReach = std::max(inReach, field.errorBoundAt(p));
    }
    errors.report("pocket, far");
    qInfo("largest bound within the reach %.2f voxel", inReach / voxel);
    QVERIFY(errors.overBound <= 0.0);
    QVERIFY(inReach <= 0.87 * 8.0 * voxel);
}

void PartFieldTest::lowerBoundIsNeverTooMuch() {
    const TriangleMesh mesh = shapes::pocket(12.0, 9.0, 6.0, 5.0);
    const PartField field = built(mesh, 25.0);
    Points points;
    double least = 1e9;
    for (int i = 0; i < 3000; ++i) {
        Box box;
        box.include(points.around(40.0));
        box.include(box.low + points.around(i % 2 == 0 ? 2.0 : 12.0));
        const double bound = field.lowerBound(box);
        QVERIFY(bound >= 0.0);
        for (int k = 0; k < 6; ++k) {
            const glm::dvec3 share{points.number(0, 1), points.number(0, 1), points.number(0, 1)};
            least = std::min(least, std::abs(bruteForce(mesh, box.low + share * box.size())) - bound);
        }
    }
    QVERIFY(least >= -1e-6);
    QVERIFY(field.lowerBound({{30, 30, 30}, {31, 31, 31}}) > 20.0); // and not a trivial bound
}

void PartFieldTest::gradientPointsAway() {
    const PartField field = built(shapes::sphere(20.0, 400, 200));
    Points points;
    for (int i = 0; i < 5000; ++i) {
        const glm::dvec3 out = glm::normalize(points.around(1.0));
        const PartDistance sample = field.at((20.0 + points.number(-3.9, 3.9) * voxel) * out);
        QVERIFY(glm::length(glm::dvec3(sample.gradient) - out) < 0.05);
    }
}

void PartFieldTest::manyAtOnceAreTheSame_data() {
    QTest::addColumn<int>("everyFarAway");
    QTest::newRow("all within the field's box") << 0;
    QTest::newRow("one in five beyond it") << 5;
    QTest::newRow("one in 301 beyond it") << 301;
}

void PartFieldTest::manyAtOnceAreTheSame() {
    QFETCH(int, everyFarAway);
    const PartField field = built(turned(shapes::box({-6, -5, -4}, {6, 5, 4}), 0.3), 6.0);
    Points points;
    for (const std::size_t count : std::initializer_list<std::size_t>{1, 7, 8, 9, 64, 255, 256, 257, 1001}) {
        std::vector<glm::dvec3> places;
        for (int i = 0; i < static_cast<int>(count); ++i)
            places.push_back(points.around(everyFarAway != 0 && i % everyFarAway == 0 ? 60.0 : 9.0));
        std::vector<PartDistance> answers(count);
        field.at(places, answers);
        for (std::size_t i = 0; i < count; ++i) {
            const PartDistance one = field.at(places[i]);
            QVERIFY(std::abs(one.distance - answers[i].distance) <= 1e-5F * (1.0F + std::abs(one.distance)));
            QVERIFY(glm::length(one.gradient - answers[i].gradient) <= 1e-4F);
        }
    }
}

/// The values of both adjacent cells, or bricks, are right there.
void PartFieldTest::manyOnBordersOfCellsAreWithinTheBound() {
    const TriangleMesh mesh = turned(shapes::box({-6, -5, -4}, {6, 5, 4}), 0.3);
    const PartField field = built(mesh, 6.0);
    std::vector<glm::dvec3> places;
    for (int i = 0; i < 3000; ++i)
        for (const double beside : {-1e-10, -1e-13, 0.0, 1e-13, 1e-10})
            places.push_back(glm::dvec3(i % 37 - 18, i % 31 - 15, i % 29 - 14) * (0.5 * voxel) + beside);
    std::vector<PartDistance> answers(places.size());
    field.at(places, answers);
    for (std::size_t i = 0; i < places.size(); ++i) {
        const double off =
            std::abs(static_cast<double>(answers[i].distance) - field.exact().closest(places[i]).signedDistance);
        QVERIFY2(off <= field.errorBoundAt(places[i]) + 1e-5, qPrintable(QString::number(off)));
    }
}

void PartFieldTest::manyMayHoldWhatIsNoNumber() {
    const PartField field = built(turned(shapes::box({-6, -5, -4}, {6, 5, 4}), 0.3), 6.0);
    constexpr double infinite = std::numeric_limits<double>::infinity();
    Points points;
    for (const double odd : {std::nan(""), -std::nan(""), infinite, -infinite, 1e300, -1e300}) {
        std::vector<glm::dvec3> places;
        for (int i = 0; i < 300; ++i) places.push_back(points.around(9.0));
        for (int axis = 0; axis < 3; ++axis) places[static_cast<std::size_t>(50 + 70 * axis)][axis] = odd;
        std::vector<PartDistance> answers(places.size());
        field.at(places, answers);
        for (std::size_t i = 0; i < places.size(); ++i) {
            const float one = field.at(places[i]).distance;
            QVERIFY(one == answers[i].distance ||
                    std::abs(one - answers[i].distance) <= 1e-5F * (1.0F + std::abs(one)));
        }
    }
}

void PartFieldTest::takesAtMostFiveBytesABandVoxel() {
    const PartField field = built(shapes::sphere(30.0, 400, 200));
    const double bytes = double(field.fineBytes()) / double(field.bandVoxels());
    const double expected = 4.0 / 3.0 * std::numbers::pi * (std::pow(64.0, 3) - std::pow(56.0, 3));
    qInfo("%.2f bytes a band voxel", bytes);
    QVERIFY(std::abs(double(field.bandVoxels()) / expected - 1.0) < 0.01);
    QVERIFY(bytes <= 5.0);
}

void PartFieldTest::emptyPartIsFar() {
    const PartField field = built(TriangleMesh{}, 5.0);
    QVERIFY(field.value({0, 0, 0}) > 1e5);
    QVERIFY(std::isfinite(field.value({std::nan(""), 1.0, 2.0})));
    QVERIFY(field.lowerBound({{0, 0, 0}, {1, 1, 1}}) >= 0.0);
}

void PartFieldTest::askingDoesNotAllocate() {
    const PartField field = built(turned(shapes::box({-6, -5, -4}, {6, 5, 4}), 0.3), 6.0);
    Points points;
    std::vector<glm::dvec3> places;
    for (int i = 0; i < 3000; ++i) places.push_back(points.around(9.0));
    std::vector<PartDistance> answers(places.size());
    double sum = 0.0;
    const std::size_t before = allocationCount.load();
    field.at(places, answers);
    for (const glm::dvec3& p : places)
        sum += field.value(p) + field.errorBoundAt(p) + field.lowerBound({p, p + glm::dvec3(1.0)});
    QCOMPARE(allocationCount.load(), before);
    QVERIFY(std::isfinite(sum));
}

void PartFieldTest::canBeCancelled() {
    const TriangleMesh mesh = shapes::torus(14.0, 5.0, 400, 200);
    Progress progress;
    std::thread impatient([&] {
        while (progress.fraction() < 0.1) std::this_thread::yield();
        progress.cancel();
    });
    const Result<PartField> field = PartField::build(mesh, {0.1, 5.0}, progress);
    impatient.join();
    QVERIFY(!field);
    QCOMPARE(field.error().code, ErrorCode::cancelled);
}

/// Bricks that were not sampled must not count as near the surface: some 14 million bricks would need 20 GB.
void PartFieldTest::cancelledAtOnceItWantsNoMemory() {
    const TriangleMesh mesh = shapes::torus(14.0, 5.0, 40, 20);
    Progress progress;
    progress.cancel();
    const Result<PartField> field = PartField::build(mesh, {0.02, 5.0}, progress);
    QVERIFY(!field);
    QCOMPARE(field.error().code, ErrorCode::cancelled);
}

void PartFieldTest::refusesWhatMakesNoField() {
    Progress progress;
    const auto code = [&](const PartFieldRequest& request) {
        const Result<PartField> field = PartField::build(shapes::box({-1, -1, -1}, {1, 1, 1}), request, progress);
        return field ? ErrorCode::internalFault : field.error().code;
    };
    QCOMPARE(code({0.0, 1.0}), ErrorCode::argumentInvalid);
    QCOMPARE(code({std::nan(""), 1.0}), ErrorCode::argumentInvalid);
    QCOMPARE(code({0.5, std::numeric_limits<double>::infinity()}), ErrorCode::argumentInvalid);
    QCOMPARE(code({1e-4, 1000.0}), ErrorCode::outOfMemory); // more than can be counted

    // Blocks of 64 voxels and some 30 kB, as many along an axis as take one and a half times the available memory.
    const double blocks = std::cbrt(1.5 * static_cast<double>(availableMemory()) / 30e3), voxel = 0.05;
    const PartFieldRequest large{voxel, 0.5 * 64.0 * voxel * blocks - 1.0};
    const Result<PartField> field = PartField::build(shapes::box({-1, -1, -1}, {1, 1, 1}), large, progress);
    QVERIFY(!field && field.error().code == ErrorCode::outOfMemory);
    QVERIFY(!field.error().place.empty() || blocks > 200.0); // reported before memory is allocated
}

BURIN_TEST(PartFieldTest, NoApplication)

} // namespace burin::tst_part_field

#include "tst_part_field.moc"

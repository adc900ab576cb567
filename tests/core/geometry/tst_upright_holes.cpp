// SPDX-FileCopyrightText: 2026 The Burin authors
// SPDX-License-Identifier: Apache-2.0
#include "core/base/units.h"
#include "core/geometry/upright_holes.h"
#include "tests/test_program.h"

#include <QtTest>

#include <cmath>
#include <random>

namespace burin::tst_upright_holes {

namespace {

/// The upright wall of a regular prism, without its ends; the solid is outside of it, or inside for a stud.
void addWall(std::vector<Triangle>& triangles, const glm::dvec2& centre, double radius, int corners, double low,
             double high, bool stud = false, double share = 1.0) {
    const auto on = [&](int i, double z) {
        const double angle = 2.0 * pi * (i % corners) / corners + 0.1;
        return glm::dvec3(centre + radius * glm::dvec2(std::cos(angle), std::sin(angle)), z);
    };
    for (int i = 0; i < static_cast<int>(share * corners); ++i) {
        Triangle one{on(i, low), on(i, high), on(i + 1, high)}, other{on(i, low), on(i + 1, high), on(i + 1, low)};
        if (stud) {
            std::swap(one[1], one[2]);
            std::swap(other[1], other[2]);
        }
        triangles.push_back(one);
        triangles.push_back(other);
    }
}

} // namespace

class UprightHolesTest final : public QObject {
    Q_OBJECT

private slots:
    /// Holes of random positions and sizes, shuffled among walls that are not holes.
    void holesAreFoundAmongOtherWalls() {
        std::mt19937 random(3);
        std::uniform_real_distribution<double> share(0.0, 1.0);
        std::vector<Triangle> triangles;
        std::vector<UprightHole> made;
        for (int i = 0; i < 30; ++i) {
            const glm::dvec2 centre(40.0 * i, 100.0 * share(random));
            const double radius = 0.5 + 15.0 * share(random), low = -10.0 * share(random), high = 5.0 * share(random);
            const int corners = 12 + static_cast<int>(80.0 * share(random));
            addWall(triangles, centre, radius, corners, low, high);
            made.push_back({centre, radius, radius * std::cos(pi / corners), high, low});
        }
        addWall(triangles, {-100.0, 0.0}, 6.0, 6, 0.0, 5.0);               // for a key
        addWall(triangles, {-150.0, 0.0}, 6.0, 64, 0.0, 5.0, true);        // a stud
        addWall(triangles, {-200.0, 0.0}, 6.0, 64, 0.0, 5.0, false, 0.75); // open to one side
        std::ranges::shuffle(triangles, random);
        const std::vector<UprightHole> found = uprightHoles(triangles), studs = uprightStuds(triangles);
        QCOMPARE(studs.size(), std::size_t(1));
        QVERIFY(studs[0].stud && std::abs(studs[0].radius - 6.0) < 1e-9 && studs[0].centre.x < -149.9);
        QVERIFY(studs[0].top == 5.0 && studs[0].bottom == 0.0 && studs[0].clearRadius < 6.0);
        QCOMPARE(found.size(), made.size());
        for (std::size_t i = 0; i < found.size(); ++i) {
            QVERIFY(glm::distance(found[i].centre, made[i].centre) < 1e-9);
            QVERIFY(std::abs(found[i].radius - made[i].radius) < 1e-9);
            QVERIFY(std::abs(found[i].clearRadius - made[i].clearRadius) < 1e-9);
            QCOMPARE(found[i].top, made[i].top);
            QCOMPARE(found[i].bottom, made[i].bottom);
            QVERIFY(!found[i].stud);
        }
    }

    /// A bore that a cross hole cuts in two is one hole; a counterbore and the hole in it are two.
    void piecesOfOneBoreAreOne() {
        std::vector<Triangle> triangles;
        addWall(triangles, {5.0, 5.0}, 3.0, 48, 0.0, 4.0);
        addWall(triangles, {5.0, 5.0}, 3.0, 48, 9.0, 12.0);
        addWall(triangles, {5.0, 5.0}, 5.0, 64, 12.0, 15.0);
        const std::vector<UprightHole> found = uprightHoles(triangles);
        QCOMPARE(found.size(), std::size_t(2));
        const UprightHole& bore = found[0].radius < 4.0 ? found[0] : found[1];
        QCOMPARE(bore.bottom, 0.0);
        QCOMPARE(bore.top, 12.0);
    }

    void nothingHasNoHole() {
        QVERIFY(uprightHoles({}).empty());
        const double infinity = std::numeric_limits<double>::infinity();
        const std::vector<Triangle> odd{{glm::dvec3(0.0), glm::dvec3(0.0), glm::dvec3(0.0)},
                                        {glm::dvec3(infinity), glm::dvec3(1.0), glm::dvec3(2.0, 0.0, 1.0)}};
        QVERIFY(uprightHoles(odd).empty());
    }
};

BURIN_TEST(UprightHolesTest, NoApplication)

} // namespace burin::tst_upright_holes

#include "tst_upright_holes.moc"

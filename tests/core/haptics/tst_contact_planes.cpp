// SPDX-FileCopyrightText: 2026 The Burin authors
// SPDX-License-Identifier: Apache-2.0
#include "core/haptics/boundary/contact_planes.h"
#include "tests/core/geometry/random_shapes.h"
#include "tests/test_program.h"

#include <QtTest>
#include <rapidcheck.h>

#include <functional>
#include <optional>
#include <vector>

namespace burin::tst_contact_planes {

namespace {

PoseVector anyVector(double reach) {
    return {random::point(reach), random::point(reach)};
}

/// The change that lies exactly on the given planes, by Gaussian elimination; none if the planes are linearly
/// dependent.
std::optional<PoseVector> heldBy(const std::vector<ContactPlane>& planes, const PoseVector& goal) {
    const std::size_t n = planes.size();
    std::vector<std::vector<double>> rows(n, std::vector<double>(n + 1));
    for (std::size_t i = 0; i < n; ++i) {
        for (std::size_t j = 0; j < n; ++j) rows[i][j] = dot(planes[i].normal, planes[j].normal);
        rows[i][n] = -planes[i].gap - dot(planes[i].normal, goal);
    }
    for (std::size_t i = 0; i < n; ++i) {
        std::size_t pivot = i;
        for (std::size_t k = i + 1; k < n; ++k)
            if (std::abs(rows[k][i]) > std::abs(rows[pivot][i])) pivot = k;
        std::swap(rows[i], rows[pivot]);
        if (std::abs(rows[i][i]) < 1e-9) return std::nullopt;
        for (std::size_t k = 0; k < n; ++k) {
            if (k == i) continue;
            const double factor = rows[k][i] / rows[i][i];
            for (std::size_t j = i; j <= n; ++j) rows[k][j] -= factor * rows[i][j];
        }
    }
    PoseVector held = goal;
    for (std::size_t i = 0; i < n; ++i) held = held + planes[i].normal * (rows[i][n] / rows[i][i]);
    return held;
}

/// By trying every subset of the planes.
double leastDistance(const std::vector<ContactPlane>& planes, const PoseVector& goal) {
    double least = length(goal); // the origin is allowed
    for (unsigned set = 0; set < (1U << planes.size()); ++set) {
        std::vector<ContactPlane> holding;
        for (std::size_t i = 0; i < planes.size(); ++i)
            if (set & (1U << i)) holding.push_back(planes[i]);
        const std::optional<PoseVector> candidate = heldBy(holding, goal);
        if (!candidate) continue;
        const bool allowed = std::all_of(planes.begin(), planes.end(), [&](const ContactPlane& plane) {
            return dot(plane.normal, *candidate) >= -plane.gap - 1e-7;
        });
        if (allowed) least = std::min(least, length(*candidate - goal));
    }
    return least;
}

/// Compares with every subset of some planes with these normals.
void holdsTheNearest(const std::function<PoseVector()>& normal) {
    ContactPlanes planes;
    std::vector<ContactPlane> held;
    const int count = *rc::gen::inRange(1, 8);
    for (int i = 0; i < count; ++i) {
        ContactPlane plane{normal(), random::number(0.0, 1.0)};
        if (*rc::gen::inRange(0, 4) == 0) plane.gap = 0.0;
        planes.add(plane);
    }
    for (int i = 0; i < planes.size(); ++i) held.push_back(planes[i]);
    const PoseVector goal = anyVector(3.0), nearest = planes.nearestTo(goal);
    for (const ContactPlane& plane : held) RC_ASSERT(dot(plane.normal, nearest) >= -plane.gap - 1e-8);
    RC_ASSERT(std::abs(length(nearest - goal) - leastDistance(held, goal)) < 1e-5);
}

} // namespace

class TestContactPlanes : public QObject {
    Q_OBJECT
private slots:
    /// Thirty sets of planes per case: formerly one in a thousand was given up, and the tool stood still for a tick.
    void theAllowedChangeNearestToTheGoalIsFound() {
        QVERIFY(rc::check("every set of up to seven planes", [] {
            for (int set = 0; set < 30; ++set)
                holdsTheNearest([] { return PoseVector{random::direction(), random::point(1.0)}; });
        }));
    }

    /// The faces met by a tool with a fixed axis: three hold it, and a fourth is a combination of them.
    void planesThatSpanEachOtherHoldTogether() {
        QVERIFY(rc::check("faces along a few directions", [] {
            for (int set = 0; set < 30; ++set)
                holdsTheNearest([] {
                    const auto step = [] { return double(*rc::gen::inRange(-2, 3)); };
                    const double x = step(), y = step();
                    return PoseVector{glm::normalize(glm::dvec3(x, y, x == 0.0 && y == 0.0 ? 1.0 : step())), {}};
                });
        }));
    }

    void oppositeWallsLeaveOnlyWhatLiesBetween() {
        ContactPlanes planes;
        planes.add({{{1, 0, 0}, {}}, 0.25});
        planes.add({{{-1, 0, 0}, {}}, 0.5});
        const PoseVector held = planes.nearestTo({{3, 4, 5}, {1, 2, 3}});
        QVERIFY(length(held - PoseVector{{0.5, 4, 5}, {1, 2, 3}}) < 1e-12);
    }

    void aTurnIsHeldByContactsOnBothSidesOfTheTool() {
        // A flat end on a floor, with lever arms of 3 mm to the rim: a rotation lifts it, a pressing force does not
        // rotate it.
        ContactPlanes planes(0.1);
        for (const glm::dvec3& arm :
             {glm::dvec3(3, 0, 0), glm::dvec3(-3, 0, 0), glm::dvec3(0, 3, 0), glm::dvec3(0, -3, 0)})
            planes.add({{{0, 0, 1}, glm::cross(arm, glm::dvec3(0, 0, 1))}, 0.0});
        QCOMPARE(planes.size(), 4);
        const PoseVector pressed = planes.nearestTo({{1, 0, -2}, {}});
        QVERIFY(length(pressed - PoseVector{{1, 0, 0}, {}}) < 1e-12);
        // Least energy: the tip's height is h = 3 t for a rotation t, the goal is t = 1: h² + (t - 1)² is least at t =
        // 0.1.
        const PoseVector turnedUp = planes.nearestTo({{}, {1, 0, 0}});
        QVERIFY(length(turnedUp - PoseVector{{0, 0, 0.3}, {0.1, 0, 0}}) < 1e-12);
    }

    void aFaceThatBentAwayIsForgotten() {
        ContactPlanes planes;
        planes.add({{{0, 0, 1}, {}}, 0.0});
        planes.moveOrigin({{1, 0, -0.1}, {}}, 0.0); // below the plane, and yet without contact
        QCOMPARE(planes.size(), 0);
    }
};

BURIN_TEST(TestContactPlanes, NoApplication)

} // namespace burin::tst_contact_planes

#include "tst_contact_planes.moc"

// SPDX-FileCopyrightText: 2026 The Burin authors
// SPDX-License-Identifier: Apache-2.0
#include "core/geometry/grown_pieces.h"
#include "core/geometry/revolved_piece.h"

#include "tests/core/geometry/random_shapes.h"
#include "tests/test_program.h"

#include <QtTest>

#include <cmath>
#include <limits>
#include <numbers>

namespace burin::tst_revolved_piece {

namespace {

/// Outline of the profile from axis to axis, as many short straight lines.
std::vector<glm::dvec2> outline(const RevolvedPiece& piece) {
    std::vector<glm::dvec2> points{{0.0, piece.bottom}};
    const double c = piece.cornerRadius;
    for (int i = 0; i <= 400 && c > 0.0; ++i) {
        const double angle = 0.5 * std::numbers::pi * (i / 400.0 - 1.0);
        points.push_back({piece.bottomRadius - c + c * std::cos(angle), piece.bottom + c + c * std::sin(angle)});
    }
    if (c == 0.0) points.push_back({piece.bottomRadius, piece.bottom});
    if (piece.bulges()) {
        const double low =
            std::asin(std::clamp((piece.bottom - piece.bulgeCentreHeight) / piece.bulgeRadius, -1.0, 1.0));
        const double high = std::asin(std::clamp((piece.top - piece.bulgeCentreHeight) / piece.bulgeRadius, -1.0, 1.0));
        for (int i = 1; i < 800; ++i) {
            const double angle = low + (high - low) * i / 800.0;
            points.push_back({piece.bulgeCentreRadius + piece.bulgeRadius * std::cos(angle),
                              piece.bulgeCentreHeight + piece.bulgeRadius * std::sin(angle)});
        }
    }
    points.push_back({piece.topRadius, piece.top});
    points.push_back({0.0, piece.top});
    return points;
}

double distanceToOutline(const std::vector<glm::dvec2>& points, const glm::dvec2& p) {
    double least = std::numeric_limits<double>::infinity();
    for (std::size_t i = 0; i + 1 < points.size(); ++i) {
        const glm::dvec2 way = points[i + 1] - points[i];
        const double length = glm::dot(way, way);
        const double t = length > 0.0 ? std::clamp(glm::dot(p - points[i], way) / length, 0.0, 1.0) : 0.0;
        least = std::min(least, glm::length(p - points[i] - t * way));
    }
    return least;
}

bool within(const RevolvedPiece& piece, double radius, double height) {
    if (height < piece.bottom || height > piece.top) return false;
    if (piece.bulges())
        return std::hypot(std::max(radius - piece.bulgeCentreRadius, 0.0), height - piece.bulgeCentreHeight) <=
               piece.bulgeRadius;
    const double part = (height - piece.bottom) / (piece.top - piece.bottom);
    if (radius > piece.bottomRadius + part * (piece.topRadius - piece.bottomRadius)) return false;
    const double beside = radius - (piece.bottomRadius - piece.cornerRadius);
    const double over = height - (piece.bottom + piece.cornerRadius);
    return !(beside > 0.0 && over < 0.0 && std::hypot(beside, over) > piece.cornerRadius);
}

} // namespace

class RevolvedPieceTest : public QObject {
    Q_OBJECT

private slots:
    void knownValues();
    void agreesWithTheOutline();
    void isConvexAndSteepByOne();
    void slopeIsASubgradient();
    void heightsAndRadiiAgreeWithTheDistance();
    void nothingOfThePieceIsFartherThanItsFarthest();
    void aGrownPieceIsAllThatIsNear();
};

void RevolvedPieceTest::knownValues() {
    const RevolvedPiece ball{0.0, 20.0, 3.0, 3.0, 3.0};
    QCOMPARE(signedDistance(ball, 0.0, -2.0), 2.0);
    QCOMPARE(signedDistance(ball, 0.0, 3.0), -3.0);
    QCOMPARE(signedDistance(ball, 4.0, 0.0), 2.0); // 5 from the centre
    QCOMPARE(signedDistance(ball, 7.0, 24.0), std::hypot(4.0, 4.0));
    const RevolvedPiece flat{0.0, 20.0, 5.0, 5.0, 0.0};
    QCOMPARE(signedDistance(flat, 8.0, -4.0), 5.0);
    QCOMPARE(signedDistance(flat, 4.5, 0.25), -0.25);
    QCOMPARE(signedDistance(flat, 4.75, 8.0), -0.25);
    const RevolvedPiece bull{0.0, 20.0, 5.0, 5.0, 1.0};
    QCOMPARE(signedDistance(bull, 3.0, -2.0), 2.0);
    QCOMPARE(signedDistance(bull, 7.0, -3.0), 4.0);      // ring at (4, 1)
    const RevolvedPiece cone{10.0, 13.0, 2.0, 6.0, 0.0}; // flank 4 : 3
    QCOMPARE(signedDistance(cone, 4.0 + 3.0, 11.5 - 4.0), 5.0);
    QCOMPARE(signedDistance(cone, 1.0, 8.0), 2.0);
}

void RevolvedPieceTest::agreesWithTheOutline() {
    QVERIFY(rc::check("distance to the profile's outline", [] {
        const RevolvedPiece piece = random::piece();
        const double radius = random::number(0.0, 9.0), height = random::number(-6.0, 26.0);
        const double far = distanceToOutline(outline(piece), {radius, height});
        const double wanted = within(piece, radius, height) ? -far : far;
        // The outline's arcs are made of 400 chords.
        RC_ASSERT(std::abs(signedDistance(piece, radius, height) - wanted) <
                  1e-9 + 2e-6 * std::max(piece.cornerRadius, piece.bulgeRadius));
    }));
}

void RevolvedPieceTest::isConvexAndSteepByOne() {
    QVERIFY(rc::check("between two points never above the straight line", [] {
        const RevolvedPiece piece = random::piece();
        const auto at = [&](const glm::dvec3& p) { return signedDistance(piece, std::hypot(p.x, p.y), p.z); };
        const glm::dvec3 a = random::point(20.0), b = random::point(20.0);
        const double t = random::number(0.0, 1.0);
        RC_ASSERT(at((1.0 - t) * a + t * b) <= (1.0 - t) * at(a) + t * at(b) + 1e-12);
        RC_ASSERT(std::abs(at(a) - at(b)) <= glm::length(a - b) + 1e-12);
    }));
}

void RevolvedPieceTest::slopeIsASubgradient() {
    QVERIFY(rc::check("the tangent stays below", [] {
        const RevolvedPiece piece = random::piece();
        const double radius = random::number(0.0, 9.0), height = random::number(-6.0, 26.0);
        const double otherRadius = random::number(0.0, 9.0), otherHeight = random::number(-6.0, 26.0);
        const PieceDistance d = signedDistanceAndSlope(piece, radius, height);
        RC_ASSERT(std::abs(std::hypot(d.alongRadius, d.alongHeight) - 1.0) < 1e-12);
        RC_ASSERT(d.distance + d.alongRadius * (otherRadius - radius) + d.alongHeight * (otherHeight - height) <=
                  signedDistance(piece, otherRadius, otherHeight) + 1e-9);
    }));
}

/// The heights that a piece covers at a distance from its axis, and its radius at a height, end where its distance is
/// 0.
void RevolvedPieceTest::heightsAndRadiiAgreeWithTheDistance() {
    QVERIFY(rc::check("heights and radii", [] {
        const RevolvedPiece piece = random::piece();
        const double radius = random::number(0.0, 7.0);
        const std::optional<HeightRange> heights = heightsAt(piece, radius);
        RC_ASSERT(heights.has_value() == (radius <= piece.widestRadius()));
        if (heights) {
            RC_ASSERT(std::abs(signedDistance(piece, radius, heights->low)) < 1e-7);
            RC_ASSERT(std::abs(signedDistance(piece, radius, heights->high)) < 1e-7);
            RC_ASSERT(signedDistance(piece, radius, 0.5 * (heights->low + heights->high)) < 1e-7);
        }
        const double height = piece.bottom + random::number(0.0, 1.0) * (piece.top - piece.bottom);
        RC_ASSERT(std::abs(signedDistance(piece, std::max(radiusAt(piece, height), 0.0), height)) < 1e-7);
    }));
}

void RevolvedPieceTest::nothingOfThePieceIsFartherThanItsFarthest() {
    QVERIFY(rc::check("any direction", [] {
        const RevolvedPiece piece = random::piece();
        const double angle = random::number(-0.5 * std::numbers::pi, 0.5 * std::numbers::pi);
        const double radial = std::cos(angle), axial = std::sin(angle);
        const ProfilePoint farthest = farthestIn(piece, radial, axial);
        RC_ASSERT(std::abs(signedDistance(piece, farthest.radius, farthest.height)) < 1e-7);
        for (const glm::dvec2& point : outline(piece))
            RC_ASSERT(point.x * radial + point.y * axial <= farthest.radius * radial + farthest.height * axial + 1e-9);
    }));
}

void RevolvedPieceTest::aGrownPieceIsAllThatIsNear() {
    QVERIFY(rc::check("a place is in the grown piece when it is no farther from the piece", [] {
        const double bottom = random::number(-3.0, 3.0);
        const RevolvedPiece piece{bottom, bottom + random::number(0.1, 10.0), random::number(0.0, 4.0),
                                  random::number(0.1, 5.0), 0.0};
        const double by = random::number(0.01, 2.0), radius = random::number(0.0, 8.0);
        const double height = random::number(piece.bottom - 3.0, piece.top + 3.0);
        const double distance = signedDistance(piece, radius, height);
        if (std::abs(distance - by) < 1e-9) return;
        bool in = false;
        for (const RevolvedPiece& grown : grownPieces(piece, by))
            in = in || signedDistance(grown, radius, height) <= 0.0;
        RC_ASSERT(in == (distance < by));
    }));
}

BURIN_TEST(RevolvedPieceTest, NoApplication)

} // namespace burin::tst_revolved_piece

#include "tst_revolved_piece.moc"

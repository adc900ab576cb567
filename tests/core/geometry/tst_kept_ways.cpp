// SPDX-FileCopyrightText: 2026 The Burin authors
// SPDX-License-Identifier: Apache-2.0
#include "core/geometry/mesh_distance.h"
#include "core/geometry/piece_minimum.h"
#include "core/geometry/way_search.h"

#include "tests/core/geometry/random_shapes.h"
#include "tests/core/geometry/shapes.h"
#include "tests/test_program.h"

#include <QtTest>

namespace burin::tst_kept_ways {

namespace {

constexpr glm::dvec3 up(0.0, 0.0, 1.0);

/// Flutes, a neck and a holder that is wider than both.
std::vector<RevolvedPiece> toolWith(const RevolvedPiece& flutes) {
    return {flutes,
            {flutes.top, flutes.top + 6.0, 0.8 * flutes.topRadius, 0.8 * flutes.topRadius, 0.0},
            {flutes.top + 6.0, flutes.top + 16.0, 6.0, 9.0, 0.0}};
}

/// The least clearance at points of a segment, each queried separately.
double leastOnWay(const MeshDistance& mesh, std::span<const RevolvedPiece> tool, const glm::dvec3& from,
                  const glm::dvec3& to, int places) {
    double least = std::numeric_limits<double>::infinity();
    for (int i = 0; i <= places; ++i)
        least = std::min(least, mesh.clearance(tool, {glm::mix(from, to, double(i) / places), up}).clearance);
    return least;
}

TriangleMesh wavyBlock() {
    return shapes::starShaped(
        120, 60, [](double u, double v) { return 12.0 + 0.9 * std::sin(4.0 * u) * std::cos(v) * std::cos(v); });
}

} // namespace

class KeptWaysTest : public QObject {
    Q_OBJECT

private slots:
    void whatIsKeptHoldsEverywhere_data();
    void whatIsKeptHoldsEverywhere();
    void aBallBesideASurfaceIsShownToKeep();
    void aToolInTheSolidKeepsNothing();
    void spheresAreInThePieceAndTouchItsEnds();
};

void KeptWaysTest::whatIsKeptHoldsEverywhere_data() {
    QTest::addColumn<int>("shape");
    QTest::newRow("torus") << 0;
    QTest::newRow("waves") << 1;
    QTest::newRow("pocket of few triangles") << 2;
}

/// Segments that graze the surface: from a position where the tool just touches, in any direction.
void KeptWaysTest::whatIsKeptHoldsEverywhere() {
    QFETCH(int, shape);
    const TriangleMesh mesh = shape == 0   ? shapes::torus(10.0, 4.0, 60, 30)
                              : shape == 1 ? wavyBlock()
                                           : shapes::pocket(12.0, 9.0, 7.0, 5.0);
    const MeshDistance distance(mesh);
    int kept = 0, refused = 0;
    QVERIFY(rc::check("nothing on the way is nearer", [&] {
        const std::vector<RevolvedPiece> tool = toolWith(random::piece());
        ClearanceAsker asker(distance, tool);
        glm::dvec3 from = random::point(14.0);
        for (int i = 0; i < 3; ++i) // towards the surface, or away from it
            if (const ToolClearance found = distance.clearance(tool, {from, up}); std::abs(found.clearance) < 50.0)
                from -= found.clearance * found.away;
        for (int i = 0; i < 4; ++i) {
            const glm::dvec3 to = from + random::point(i == 3 ? 12.0 : 0.8);
            const double least = leastOnWay(distance, tool, from, to, 40);
            const double wanted = least + (i % 2 == 0 ? random::number(-0.05, 0.02) : random::number(-1.0, 0.3));
            const bool keeps = asker.keeps(from, to, wanted);
            keeps ? ++kept : ++refused;
            if (keeps) RC_ASSERT(least >= wanted - 1e-7);
            from = to;
        }
    }));
    QVERIFY2(kept > 30 && refused > 30, qPrintable(QString("%1 %2").arg(kept).arg(refused)));
}

/// For a ball the query is exact, however the surface is curved and wherever the segment leads.
void KeptWaysTest::aBallBesideASurfaceIsShownToKeep() {
    for (const TriangleMesh& mesh : {shapes::torus(10.0, 4.0, 60, 30), wavyBlock()}) {
        const MeshDistance distance(mesh);
        QVERIFY(rc::check("kept, if by a micrometre", [&] {
            const std::vector<RevolvedPiece> tool{{0.0, 60.0, 2.0, 2.0, 2.0}};
            ClearanceAsker asker(distance, tool);
            const glm::dvec3 from = random::point(8.0) + glm::dvec3(0.0, 0.0, 14.0), to = from + random::point(1.0);
            const glm::dvec3 lowering(0.0, 0.0, -leastOnWay(distance, tool, from, to, 50));
            const double least = leastOnWay(distance, tool, from + lowering, to + lowering, 400);
            RC_PRE(least > -0.5); // otherwise a point of the axis may be the deepest one
            // Between two of 400 points no clearance decreases by more than half of the distance between them.
            const double between = 0.5 * glm::length(to - from) / 400.0;
            RC_ASSERT(asker.keeps(from + lowering, to + lowering, least - between - 1e-3));
        }));
    }
}

void KeptWaysTest::aToolInTheSolidKeepsNothing() {
    const MeshDistance distance(shapes::torus(14.0, 6.0, 120, 60));
    const std::vector<RevolvedPiece> small{{0.0, 1.0, 0.5, 0.5, 0.0}};
    ClearanceAsker asker(distance, small);
    QVERIFY(!asker.keeps({14.0, 0.0, -0.5}, {14.0, 0.4, -0.5}, -0.2)); // no point of the mesh is in the tool
    QVERIFY(asker.keeps({0.0, 0.0, -0.5}, {0.0, 0.4, -0.5}, 5.0));     // in the hole
    QVERIFY(!asker.keeps({0.0, 0.0, -0.5}, {14.0, 0.0, -0.5}, -0.2));  // into the solid
    const double nan = std::numeric_limits<double>::quiet_NaN();
    QVERIFY(!asker.keeps({0.0, nan, 0.0}, {0.0, 0.0, 0.0}, -0.2));
}

void KeptWaysTest::spheresAreInThePieceAndTouchItsEnds() {
    QVERIFY(rc::check("of any piece", [] {
        const RevolvedPiece piece = random::piece();
        const EndSpheres spheres = endSpheres(piece);
        const double below = spheres.height - piece.bottom;
        RC_ASSERT(spheres.leastRadius >= 0.0 && spheres.leastRadius <= below + 1e-12);
        RC_ASSERT(-signedDistance(piece, 0.0, spheres.height) >= below - 1e-9);
        if (piece.bottomRadius > 0.1 && piece.topRadius > 0.1) RC_ASSERT(spheres.leastRadius > 0.0);
    }));
    QCOMPARE(endSpheres({0.0, 3.0, 0.0, 3.0, 0.0}).leastRadius, 0.0); // a sharp tip
    QCOMPARE(endSpheres({0.0, 20.0, 3.0, 3.0, 3.0}).height, 3.0);     // a ball
}

BURIN_TEST(KeptWaysTest, NoApplication)

} // namespace burin::tst_kept_ways

#include "tst_kept_ways.moc"

// SPDX-FileCopyrightText: 2026 The Burin authors
// SPDX-License-Identifier: Apache-2.0
#include "core/volume/surface/surface.h"
#include "tests/core/volume/random_surfaces.h"
#include "tests/random_cases.h"
#include "tests/test_program.h"

#include <QtTest>
#include <rapidcheck.h>

namespace burin::tst_surface_bricks {

using namespace burin::test;

namespace {

using Corner = std::array<float, 6>;
using Face = std::array<std::pair<Corner, PropertyIndex>, 3>;

void addFaces(const SurfaceMesh& mesh, std::vector<Face>& all) {
    for (std::size_t i = 0; i < mesh.triangles.size(); i += 3) {
        Face face;
        for (std::size_t corner = 0; corner < 3; ++corner) {
            const std::uint32_t at = mesh.triangles[i + corner];
            const glm::vec3 &p = mesh.points[at], &n = mesh.normals[at];
            face[corner] = {Corner{p.x, p.y, p.z, n.x, n.y, n.z}, mesh.properties[at]};
        }
        all.push_back(face);
    }
}

} // namespace

class TestSurfaceBricks : public QObject {
    Q_OBJECT

private slots:
    void bricksAreTheTile();
    void changedBricksAreAllThatChanged();
    void changesAreFoundAlongTheRuns();
    void slantedPlanesAreFlat_data();
    void slantedPlanesAreFlat();
};

void TestSurfaceBricks::bricksAreTheTile() {
    QVERIFY(testing::holdsInShare(
        "bricks together: the points, normals, materials and triangles of their tile, bit for bit", [] {
            const Grid grid = randomlyTurnedGrid({70, 66, 97});
            RunVolume volume = emptyVolume(grid);
            fillAtRandom(volume);
            const VolumeSnapshot workpiece = volume.snapshot();
            SurfaceExtractor extractor;
            SurfaceMesh piece;
            std::vector<Face> whole, together;
            const glm::ivec2 tiles = surfaceTiles(grid);
            for (int v = 0; v < tiles.y; ++v)
                for (int u = 0; u < tiles.x; ++u) {
                    extractor.extract(workpiece, {u, v}, {}, piece);
                    addFaces(piece, whole);
                }
            eachBrick(grid, [&](SurfaceBrick brick) {
                extractor.extractBrick(workpiece, brick, piece);
                addFaces(piece, together);
            });
            std::ranges::sort(whole);
            std::ranges::sort(together);
            RC_ASSERT(whole == together);
        }));
}

void TestSurfaceBricks::changedBricksAreAllThatChanged() {
    QVERIFY(testing::holdsInShare("what changedSurfaceBricks does not name is meshed alike", [] {
        const Grid grid = randomlyTurnedGrid({80, 70, 130});
        RunVolume volume = emptyVolume(grid);
        fillAtRandom(volume);
        const VolumeSnapshot before = volume.snapshot();
        RunAmounts removed;
        for (int i = *rc::gen::inRange(1, 4); i > 0; --i) {
            const LineIndex at{*rc::gen::inRange(0, grid.lineCountU()), *rc::gen::inRange(0, grid.lineCountV())};
            const std::int32_t side = *rc::gen::inRange(1, 12);
            const auto from = *rc::gen::inRange<RunPosition>(0, grid.lineEnd());
            const auto to = from + *rc::gen::inRange<RunPosition>(1, 9000);
            const bool fills = *rc::gen::arbitrary<bool>();
            for (std::int32_t u = at.u; u < std::min(at.u + side, grid.lineCountU()); ++u)
                for (std::int32_t v = at.v; v < std::min(at.v + side, grid.lineCountV()); ++v)
                    if (fills)
                        RC_ASSERT(volume.fillSpan({u, v}, from, std::min(to, grid.lineEnd()), aluminium));
                    else
                        (void)volume.removeSpan({u, v}, from, to, removed);
        }
        const VolumeSnapshot now = volume.snapshot();
        std::vector<SurfaceBrick> changed;
        changedSurfaceBricks(before, now, changed);
        SurfaceExtractor extractor;
        SurfaceMesh old, fresh;
        std::size_t named = 0;
        eachBrick(grid, [&](SurfaceBrick brick) {
            if (std::ranges::find(changed, brick) != changed.end()) {
                ++named;
                return;
            }
            extractor.extractBrick(before, brick, old);
            extractor.extractBrick(now, brick, fresh);
            RC_ASSERT(old.points == fresh.points);
            RC_ASSERT(old.normals == fresh.normals);
            RC_ASSERT(old.properties == fresh.properties);
            RC_ASSERT(old.triangles == fresh.triangles);
        });
        RC_ASSERT(named == changed.size()); // each once, and inside the grid
    }));
}

void TestSurfaceBricks::changesAreFoundAlongTheRuns() {
    const Grid grid = cubeGrid({96, 96, 256}, RunAxis::z, 0.25);
    RunVolume volume = emptyVolume(grid);
    QVERIFY(volume.fillBlock({0, 0}, {96, 96}, 0, grid.lineEnd(), wax));
    QVERIFY(volume.fillBlock({0, 0}, {96, 96}, 150 * unitsPerVoxel, grid.lineEnd(), aluminium));
    const VolumeSnapshot before = volume.snapshot();
    RunAmounts removed;
    (void)volume.removeSpan({48, 48}, 112 * unitsPerVoxel, 113 * unitsPerVoxel, removed);
    std::vector<SurfaceBrick> changed;
    changedSurfaceBricks(before, volume.snapshot(), changed);
    // In the middle of a brick: only that brick, although its lines continue in both directions.
    QCOMPARE(changed, (std::vector<SurfaceBrick>{{1, 1, 3}}));
    changedSurfaceBricks(before, before, changed);
    QVERIFY(changed.empty());
    changedSurfaceBricks({}, before, changed);
    QCOMPARE(changed.size(), std::size_t{3 * 3 * 8});
}

void TestSurfaceBricks::slantedPlanesAreFlat_data() {
    QTest::addColumn<double>("slopeU");
    QTest::addColumn<double>("slopeV");
    for (const auto& [u, v] : {std::pair(0.0, 0.0), {0.1, 0.0}, {0.3, 0.2}, {-0.5, 0.4}, {0.7, -0.7}, {1.0, 0.0}})
        QTest::addRow("%g, %g", u, v) << u << v;
}
/// A plane inclined by up to 45 degrees against the runs' normal plane is where the run ends put it, and is shaded
/// flat.
void TestSurfaceBricks::slantedPlanesAreFlat() {
    QFETCH(double, slopeU);
    QFETCH(double, slopeV);
    const Grid grid = cubeGrid({64, 64, 128});
    RunVolume volume = emptyVolume(grid);
    const auto height = [&](glm::dvec2 place) { return 64.2 + slopeU * (place.x - 32.0) + slopeV * (place.y - 32.0); };
    fillLines(volume, wax, [&](glm::dvec2 place) { return std::pair(0.0, height(place)); });
    const VolumeSnapshot workpiece = volume.snapshot();
    const glm::dvec3 normal = glm::normalize(glm::dvec3(-slopeU, -slopeV, 1.0));
    SurfaceExtractor extractor;
    SurfaceMesh piece;
    double off = 0.0, turn = 0.0;
    std::size_t found = 0;
    eachBrick(grid, [&](SurfaceBrick brick) {
        extractor.extractBrick(workpiece, brick, piece);
        for (std::size_t i = 0; i < piece.points.size(); ++i) {
            const glm::dvec3 point(piece.points[i]);
            if (glm::length(glm::max(glm::abs(glm::dvec2(point) - 32.0), 28.0) - 28.0) > 0.0 || point.z < 4.0) continue;
            ++found;
            off = std::max(off, std::abs(point.z - height(point)) * normal.z);
            turn =
                std::max(turn, glm::degrees(std::acos(std::min(1.0, glm::dot(normal, glm::dvec3(piece.normals[i]))))));
        }
    });
    qInfo("%zu points, %.4f voxels off, normals %.3f degrees", found, off, turn);
    QVERIFY(found > 3000);
    QVERIFY(off < 0.02);
    QVERIFY(turn < 2.5);
}

BURIN_TEST(TestSurfaceBricks, NoApplication)

} // namespace burin::tst_surface_bricks

#include "tst_surface_bricks.moc"

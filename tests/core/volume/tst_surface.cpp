// SPDX-FileCopyrightText: 2026 The Burin authors
// SPDX-License-Identifier: Apache-2.0
#include "core/geometry/mesh_distance.h"
#include "core/volume/surface/surface.h"
#include "core/volume/surface/surface_simplification.h"
#include "tests/core/volume/surfaces.h"
#include "tests/core/volume/volumes.h"
#include "tests/random_cases.h"
#include "tests/test_program.h"

#include <QtTest>
#include <rapidcheck.h>

#include <random>

namespace burin::tst_surface {

using namespace burin::test;

namespace {

constexpr double voxel = 0.25;

Grid gridOf(glm::ivec3 count, RunAxis axis = RunAxis::z) {
    return Grid::make({-3.0, 5.0, 1.0}, voxel, count, axis).value();
}

RunVolume filled(const Grid& grid, PropertyIndex property) {
    RunVolume volume = emptyVolume(grid);
    (void)volume.fillBlock({0, 0}, {grid.lineCountU(), grid.lineCountV()}, 0, grid.lineEnd(), property);
    return volume;
}

double exactVolume(const VolumeSnapshot& workpiece) {
    const RunAmounts amounts = workpiece.amounts();
    std::uint64_t units = 0;
    for (std::size_t property = 1; property < amounts.units.size(); ++property) units += amounts.units[property];
    return static_cast<double>(units) * workpiece.grid().unitVolume();
}

/// A block with the groove of a ball, a pocket with inclined walls and a protected dome.
RunVolume milledBlock(RunAxis axis = RunAxis::z) {
    const Grid grid = gridOf({100, 90, 60}, axis);
    RunVolume volume = filled(grid, aluminium);
    const glm::dvec3 centre = grid.box().centre();
    fillSphere(volume, part, centre, 7.0);
    RunAmounts removed;
    for (double way = -9.0; way < 9.0; way += 0.1)
        for (std::int32_t v = 0; v < grid.lineCountV(); ++v)
            for (std::int32_t u = 0; u < grid.lineCountU(); ++u) {
                const glm::dvec2 across = grid.lineCentre({u, v}) -
                                          glm::dvec2(centre[grid.axisOfU()] + way, centre[grid.axisOfV()] + 0.4 * way);
                const double square = 9.0 - glm::dot(across, across);
                if (square <= 0.0) continue;
                const double bottom = centre[grid.axisOfRuns()] + 5.0 - std::sqrt(square);
                (void)volume.removeSpan({u, v}, grid.toRunPosition(bottom), grid.lineEnd(), removed);
            }
    return volume;
}

/// Points spread over the triangles of a mesh.
std::vector<glm::dvec3> samples(const TriangleMesh& mesh, std::size_t count) {
    std::mt19937 random(5);
    std::uniform_int_distribution<std::size_t> any(0, mesh.triangles.size() - 1);
    std::uniform_real_distribution<double> share(0.0, 1.0);
    std::vector<glm::dvec3> points;
    while (points.size() < count) {
        const auto& [a, b, c] = mesh.triangles[any(random)];
        const double s = std::sqrt(share(random)), t = share(random);
        points.push_back((1.0 - s) * mesh.vertices[a] + s * (1.0 - t) * mesh.vertices[b] + s * t * mesh.vertices[c]);
    }
    return points;
}

double farthest(const TriangleMesh& from, const TriangleMesh& to) {
    const MeshDistance distance(to);
    double worst = 0.0;
    for (const glm::dvec3& point : from.vertices) worst = std::max(worst, distance.closest(point).distance);
    for (const glm::dvec3& point : samples(from, 20'000)) worst = std::max(worst, distance.closest(point).distance);
    return worst;
}

} // namespace

class SurfaceTest : public QObject {
    Q_OBJECT
private slots:
    void ballIsRound_data();
    void ballIsRound();
    void planesAcrossTheRunsAreExact_data();
    void planesAcrossTheRunsAreExact();
    void blockFillsItsGrid_data();
    void blockFillsItsGrid();
    void enclosesWhatTheRunsHold_data();
    void enclosesWhatTheRunsHold();
    void hasNoGaps();
    void solidInsideCostsNothing();
    void changedTilesAreAllThatChanged();
    void everythingChangesWithAnotherVolume();
    void simplifiedStaysWithinTolerance_data();
    void simplifiedStaysWithinTolerance();
    void flatFacesNeedFewTriangles();
    void simplifiedFacesShadeFlat();
    void coloursKeepTheirPlace();
    void bareWithinAVoxelIsPart();
};

void SurfaceTest::ballIsRound_data() {
    QTest::addColumn<int>("axis");
    QTest::addColumn<int>("level");
    QTest::addColumn<double>("voxelsOff");
    QTest::addColumn<double>("voxelsOffWhereFlat"); // where the slope of the surface relative to the runs' normal plane
                                                    // is below 45 degrees
    QTest::addColumn<double>("degreesOff");
    QTest::addColumn<double>("degreesOffWhereFlat");
    for (int axis = 0; axis < 3; ++axis) { // walls along the runs: a scanline is in or out
        QTest::addRow("axis %d, full detail", axis) << axis << 0 << 0.5 << 0.05 << 21.0 << 4.0;
        QTest::addRow("axis %d, level 1", axis) << axis << 1 << 0.5 << 0.15 << 10.0 << 5.0;
        QTest::addRow("axis %d, level 2", axis) << axis << 2 << 0.7 << 0.5 << 10.0 << 7.0;
    }
}
void SurfaceTest::ballIsRound() {
    QFETCH(int, axis);
    QFETCH(int, level);
    QFETCH(double, voxelsOff);
    QFETCH(double, voxelsOffWhereFlat);
    QFETCH(double, degreesOff);
    QFETCH(double, degreesOffWhereFlat);
    RunVolume volume = emptyVolume(gridOf({90, 84, 96}, static_cast<RunAxis>(axis)));
    const glm::dvec3 centre = volume.grid().box().centre() + glm::dvec3(0.07, -0.11, 0.03);
    constexpr double radius = 9.3;
    fillSphere(volume, wax, centre, radius);
    const SurfaceMesh surface = wholeSurface(volume.snapshot(), {level, 0.0});
    QVERIFY(surface.triangles.size() > 1000);
    double off = 0.0, offWhereFlat = 0.0, turn = 0.0, turnWhereFlat = 0.0;
    for (const std::uint32_t i : surface.triangles) {
        const glm::dvec3 way = glm::dvec3(surface.points[i]) - centre, out = glm::normalize(way);
        const double distance = std::abs(glm::length(way) - radius) / voxel;
        const double angle = glm::degrees(std::acos(std::min(1.0, glm::dot(out, glm::dvec3(surface.normals[i])))));
        off = std::max(off, distance);
        turn = std::max(turn, angle);
        if (std::abs(out[axis]) > std::sqrt(0.5)) {
            offWhereFlat = std::max(offWhereFlat, distance);
            turnWhereFlat = std::max(turnWhereFlat, angle);
        }
        QCOMPARE(surface.properties[i], wax);
    }
    qInfo("off %.3f, where flat %.3f voxels; normals %.2f, where flat %.2f degrees", off, offWhereFlat, turn,
          turnWhereFlat);
    QVERIFY(off <= voxelsOff && offWhereFlat <= voxelsOffWhereFlat);
    QVERIFY(turn <= degreesOff && turnWhereFlat <= degreesOffWhereFlat);
}

void SurfaceTest::planesAcrossTheRunsAreExact_data() {
    QTest::addColumn<int>("units");
    QTest::addColumn<int>("level");
    for (const int units : {0, 1, 64, 127, 128, 129, 200, 255})
        for (const int level : {0, 1}) QTest::addRow("%d/256 voxel, level %d", units, level) << units << level;
}
void SurfaceTest::planesAcrossTheRunsAreExact() {
    QFETCH(int, units);
    QFETCH(int, level);
    const Grid grid = gridOf({40, 40, 40});
    RunVolume volume = emptyVolume(grid);
    const RunPosition top = 23 * unitsPerVoxel + static_cast<RunPosition>(units);
    (void)volume.fillBlock({0, 0}, {40, 40}, 0, top, wax);
    const SurfaceMesh surface = wholeSurface(volume.snapshot(), {level, 0.0});
    const double height = grid.toMillimetres(top);
    int found = 0;
    const double middle = grid.box().centre().x, centreY = grid.box().centre().y;
    for (const std::uint32_t i : surface.triangles) {
        const glm::vec3 point = surface.points[i];
        if (std::abs(point.x - middle) > 3.0 || std::abs(point.y - centreY) > 3.0 || point.z < grid.low().z + 2.0)
            continue;
        ++found;
        QVERIFY2(std::abs(point.z - height) < (level + 1) * voxel / 200.0,
                 qPrintable(QString::number(point.z - height)));
        QVERIFY(surface.normals[i].z > 0.9999F);
    }
    QVERIFY(found > 100);
}

void SurfaceTest::blockFillsItsGrid_data() {
    QTest::addColumn<int>("axis");
    QTest::addColumn<double>("tolerance");
    for (int axis = 0; axis < 3; ++axis)
        for (const double tolerance : {0.0, 0.2})
            QTest::addRow("axis %d, tolerance %g voxel", axis, tolerance) << axis << tolerance * voxel;
}
void SurfaceTest::blockFillsItsGrid() {
    QFETCH(int, axis);
    QFETCH(double, tolerance);
    const Grid grid = gridOf({70, 41, 33}, static_cast<RunAxis>(axis));
    RunVolume volume = filled(grid, wax);
    const TriangleMesh mesh = triangleMesh(wholeSurface(volume.snapshot(), {0, tolerance}));
    QCOMPARE(countOpenEdges(mesh), std::size_t{0});
    const Box box = boundingBox(mesh), whole = grid.box();
    QVERIFY(glm::length(box.low - whole.low) < 1e-4 && glm::length(box.high - whole.high) < 1e-4);
    for (const glm::dvec3& point : mesh.vertices) { // on a face, or off it where an edge is rounded
        const glm::dvec3 inside = glm::min(point - whole.low, whole.high - point);
        QVERIFY(std::min({inside.x, inside.y, inside.z}) < 0.75 * voxel);
    }
}

void SurfaceTest::enclosesWhatTheRunsHold_data() {
    QTest::addColumn<int>("axis");
    for (int axis = 0; axis < 3; ++axis) QTest::addRow("axis %d", axis) << axis;
}
void SurfaceTest::enclosesWhatTheRunsHold() {
    QFETCH(int, axis);
    RunVolume volume = milledBlock(static_cast<RunAxis>(axis));
    const VolumeSnapshot workpiece = volume.snapshot();
    const double exact = exactVolume(workpiece);
    for (const SurfaceDetail detail : {SurfaceDetail{0, 0.0}, {0, 0.1 * voxel}, {1, 0.0}, {1, 0.25 * voxel}}) {
        const TriangleMesh mesh = triangleMesh(wholeSurface(workpiece, detail));
        const double off = signedVolume(mesh) - exact;
        qInfo("level %d, tolerance %.3f: %.4f mm3 off in %.1f", detail.level, detail.tolerance, off, exact);
        const double thickness = detail.level == 0 ? 0.02 : 0.08; // voxels, over the whole surface
        QVERIFY(std::abs(off) < thickness * voxel * surfaceArea(mesh));
    }
}

void SurfaceTest::hasNoGaps() {
    QVERIFY(testing::holdsInShare("random runs: every edge is met as often from one side as from the other", [] {
        const auto axis = static_cast<RunAxis>(*rc::gen::inRange(0, 3));
        const Grid grid = gridOf({70, 70, 70}, axis);
        RunVolume volume = emptyVolume(grid);
        const int balls = *rc::gen::inRange(1, 8);
        RunAmounts removed;
        for (int i = 0; i < balls; ++i) {
            const glm::dvec3 share(*rc::gen::inRange(0, 100), *rc::gen::inRange(0, 100), *rc::gen::inRange(0, 100));
            const auto property = static_cast<PropertyIndex>(*rc::gen::inRange(0, 4));
            fillSphere(volume, property, grid.box().low + share / 100.0 * grid.box().size(),
                       voxel * *rc::gen::inRange(1, 30));
        }
        for (int i = 0; i < 60; ++i) { // irregular runs as well
            const LineIndex line{*rc::gen::inRange(0, 70), *rc::gen::inRange(0, 70)};
            const auto from = *rc::gen::inRange<RunPosition>(0, grid.lineEnd());
            (void)volume.removeSpan(line, from, from + *rc::gen::inRange<RunPosition>(0, 5000), removed);
        }
        const SurfaceDetail detail{*rc::gen::inRange(0, 4), voxel * *rc::gen::element(0.0, 0.1, 0.5)};
        const TriangleMesh mesh = triangleMesh(wholeSurface(volume.snapshot(), detail));
        RC_ASSERT(countGaps(mesh) == std::size_t{0});
    }));
}

void SurfaceTest::solidInsideCostsNothing() {
    RunVolume volume = filled(gridOf({96, 96, 96}), wax);
    const VolumeSnapshot workpiece = volume.snapshot();
    SurfaceExtractor extractor;
    SurfaceMesh mesh;
    extractor.extract(workpiece, {1, 1}, {}, mesh);
    QCOMPARE(mesh.triangles.size(), std::size_t{2 * 3 * 32 * 32 * 2}); // only top and bottom
}

void SurfaceTest::changedTilesAreAllThatChanged() {
    QVERIFY(testing::holdsInShare("what changedSurface does not name is meshed alike", [] {
        const Grid grid = gridOf({200, 140, 40});
        RunVolume volume = filled(grid, aluminium);
        const int level = *rc::gen::inRange(0, 4);
        const SurfaceDetail detail{level, *rc::gen::element(0.0, 0.05)};
        RunAmounts removed;
        const auto cut = [&] {
            const LineIndex at{*rc::gen::inRange(0, 200), *rc::gen::inRange(0, 140)};
            const std::int32_t side = *rc::gen::inRange(1, 12);
            const auto from = *rc::gen::inRange<RunPosition>(0, grid.lineEnd());
            for (std::int32_t u = at.u; u < std::min(at.u + side, 200); ++u)
                for (std::int32_t v = at.v; v < std::min(at.v + side, 140); ++v)
                    (void)volume.removeSpan({u, v}, from, grid.lineEnd(), removed);
        };
        cut();
        const VolumeSnapshot before = volume.snapshot();
        cut();
        if (*rc::gen::arbitrary<bool>()) cut();
        RunVolume copy = filled(grid, aluminium); // a volume of its own, as for a past workpiece
        const VolumeSnapshot held = volume.snapshot();
        for (LineIndex line{0, 0}; line.v < 140; ++line.v)
            for (line.u = 0; line.u < 200; ++line.u) RC_ASSERT(copy.setLine(line, held.line(line)));
        const VolumeSnapshot now = *rc::gen::arbitrary<bool>() ? held : copy.snapshot();
        const std::vector<SurfaceTile> changed = changedSurface(before, now, level);
        SurfaceExtractor extractor;
        SurfaceMesh old, fresh;
        const glm::ivec2 tiles = surfaceTiles(grid);
        RC_ASSERT(changed.size() < static_cast<std::size_t>(tiles.x * tiles.y));
        for (int v = 0; v < tiles.y; ++v)
            for (int u = 0; u < tiles.x; ++u) {
                const SurfaceTile tile{u, v};
                if (std::find(changed.begin(), changed.end(), tile) != changed.end()) continue;
                extractor.extract(before, tile, detail, old);
                extractor.extract(now, tile, detail, fresh);
                RC_ASSERT(old.points == fresh.points);
                RC_ASSERT(old.normals == fresh.normals);
                RC_ASSERT(old.properties == fresh.properties);
                RC_ASSERT(old.triangles == fresh.triangles);
            }
    }));
}

void SurfaceTest::everythingChangesWithAnotherVolume() {
    const Grid grid = gridOf({70, 40, 20});
    RunVolume one = filled(grid, wax), other = filled(grid, aluminium), alike = filled(grid, wax),
              wider = filled(gridOf({71, 40, 20}), wax);
    const VolumeSnapshot first = one.snapshot();
    QCOMPARE(changedSurface({}, first).size(), std::size_t{3 * 2});
    QCOMPARE(changedSurface(other.snapshot(), first).size(), std::size_t{3 * 2});
    QCOMPARE(changedSurface(wider.snapshot(), first).size(), std::size_t{3 * 2});
    QVERIFY(changedSurface(alike.snapshot(), first).empty());
    QVERIFY(changedSurface(first, one.snapshot()).empty());
}

void SurfaceTest::simplifiedStaysWithinTolerance_data() {
    QTest::addColumn<double>("tolerance");
    for (const double tolerance : {0.05, 0.1, 0.2, 0.5}) QTest::addRow("%g voxel", tolerance) << tolerance * voxel;
}
void SurfaceTest::simplifiedStaysWithinTolerance() {
    QFETCH(double, tolerance);
    RunVolume volume = milledBlock();
    const VolumeSnapshot workpiece = volume.snapshot();
    const TriangleMesh full = triangleMesh(wholeSurface(workpiece, {0, 0.0}));
    const TriangleMesh thin = triangleMesh(wholeSurface(workpiece, {0, tolerance}));
    const double there = farthest(full, thin), back = farthest(thin, full);
    qInfo("%zu triangles become %zu; %.3f and %.3f of the tolerance", full.triangles.size(), thin.triangles.size(),
          there / tolerance, back / tolerance);
    QVERIFY(thin.triangles.size() * 2 < full.triangles.size());
    QVERIFY2(there <= tolerance && back <= tolerance,
             qPrintable(QString("%1, %2").arg(there / tolerance).arg(back / tolerance)));
}

void SurfaceTest::flatFacesNeedFewTriangles() {
    RunVolume volume = filled(gridOf({128, 128, 60}), wax);
    const VolumeSnapshot workpiece = volume.snapshot();
    const SurfaceDetail detail{0, 0.1 * voxel};
    std::vector<SurfaceMesh> tiles(16);
    std::vector<const SurfaceMesh*> pieces;
    SurfaceExtractor extractor;
    for (int i = 0; i < 16; ++i) {
        extractor.extract(workpiece, {i % 4, i / 4}, detail, tiles[static_cast<std::size_t>(i)]);
        pieces.push_back(&tiles[static_cast<std::size_t>(i)]);
    }
    SurfaceMesh whole;
    SurfaceSimplifier simplifier;
    simplifier.join(pieces, whole);
    simplifier.simplify(whole, detail.tolerance, voxel);
    qInfo("%zu triangles", whole.triangles.size() / 3);
    QVERIFY(whole.triangles.size() / 3 < 500);
    QVERIFY(simplifier.rim(whole).empty());
}

void SurfaceTest::simplifiedFacesShadeFlat() {
    RunVolume volume = filled(gridOf({64, 64, 64}), wax);
    const SurfaceMesh surface = wholeSurface(volume.snapshot(), {0, 0.1 * voxel});
    for (std::size_t i = 0; i < surface.triangles.size(); i += 3) {
        const glm::vec3 &a = surface.points[surface.triangles[i]], &b = surface.points[surface.triangles[i + 1]],
                        &c = surface.points[surface.triangles[i + 2]];
        const glm::vec3 twice = glm::cross(b - a, c - a);
        if (glm::length(twice) < 100.0 * voxel * voxel) continue;
        for (std::size_t corner = 0; corner < 3; ++corner)
            QVERIFY(glm::dot(surface.normals[surface.triangles[i + corner]], glm::normalize(twice)) > 0.985F);
    }
}

void SurfaceTest::coloursKeepTheirPlace() {
    const Grid grid = gridOf({60, 60, 20});
    RunVolume volume = filled(grid, wax);
    (void)volume.fillBlock({30, 0}, {60, 60}, 0, grid.lineEnd(), aluminium);
    const double border = grid.low().x + 30 * voxel;
    for (const double tolerance : {0.0, 0.1 * voxel}) {
        const SurfaceMesh surface = wholeSurface(volume.snapshot(), {0, tolerance});
        for (const std::uint32_t i : surface.triangles) {
            const double x = surface.points[i].x;
            if (x < border - voxel) QCOMPARE(surface.properties[i], wax);
            if (x > border + voxel) QCOMPARE(surface.properties[i], aluminium);
        }
    }
}

void SurfaceTest::bareWithinAVoxelIsPart() {
    const Grid grid = gridOf({40, 40, 40});
    RunVolume volume = filled(grid, part);
    const RunPosition face = 20 * unitsPerVoxel;
    (void)volume.fillBlock({0, 0}, {40, 40}, face, grid.lineEnd(), airProperty);
    (void)volume.fillBlock({0, 0}, {20, 40}, face, face + 60, wax);   // a film of a quarter of a voxel
    (void)volume.fillBlock({20, 0}, {40, 40}, face, face + 700, wax); // remaining stock
    const SurfaceMesh surface = wholeSurface(volume.snapshot(), {});
    const glm::dvec3 middle = grid.low() + glm::dvec3(40, 40, 40) * voxel * 0.5;
    for (const std::uint32_t i : surface.triangles) {
        const glm::vec3& point = surface.points[i];
        if (point.z < middle.z - 0.1 || surface.normals[i].z < 0.9F || std::abs(point.x - middle.x) < 3 * voxel)
            continue;
        QCOMPARE(surface.properties[i], point.x < middle.x ? part : wax);
    }
}

BURIN_TEST(SurfaceTest, NoApplication)

} // namespace burin::tst_surface

#include "tst_surface.moc"

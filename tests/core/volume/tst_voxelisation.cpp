// SPDX-FileCopyrightText: 2026 The Burin authors
// SPDX-License-Identifier: Apache-2.0
#include "core/volume/voxelisation/voxelisation.h"
#include "tests/core/volume/shapes.h"
#include "tests/core/volume/voxelised.h"
#include "tests/oracles/line_scatter.h"
#include "tests/test_program.h"

#include <QtTest>
#include <rapidcheck.h>

#include <random>

namespace burin::tst_voxelisation {

using namespace burin::test;

namespace {

/// Volume, mm³, of a mesh in a grid about the origin. Negative: the report is not clean.
double voxelisedVolume(const TriangleMesh& mesh, double edge, RunAxis axis) {
    const Grid grid = *Grid::make(glm::dvec3(-11.0), edge, glm::ivec3(static_cast<int>(std::ceil(22.0 / edge))), axis);
    RunVolume volume = emptyVolume(grid, 8'000'000);
    const VoxelisationReport report = fill(mesh, volume);
    if (report.linesWithOddCrossings + report.turnedFaces.count + report.clippedLines > 0) return -1e9;
    if (report.filledUnits != volume.amounts().units[part]) return -1e9;
    return static_cast<double>(volume.amounts().units[part]) * grid.unitVolume();
}

/// Errors of the volume at positions and orientations unrelated to the grid. @param finest mm, edge of a voxel; others
/// are up to a fifth larger, as the radii in voxels count as well
oracles::Scatter scatterOf(const TriangleMesh& mesh, double finest, double surface, int trials) {
    std::mt19937 random(static_cast<unsigned>(100.0 / finest));
    oracles::Scatter scatter;
    const double expected = signedVolume(mesh);
    for (int trial = 0; trial < trials; ++trial) {
        const RunAxis axis = everyAxis[static_cast<std::size_t>(trial % 3)];
        const double edge = finest * (1.0 + 0.1 * (trial % 3));
        const glm::dmat3 turn = oracles::anyTurn(random);
        const glm::dvec3 place = oracles::anyPlace(random, edge);
        TriangleMesh moved = mesh;
        for (glm::dvec3& point : moved.vertices) point = place + turn * point;
        scatter.add(voxelisedVolume(moved, edge, axis) - expected, oracles::lineSamplingError(surface, edge));
    }
    return scatter;
}

/// Triangles that meet at shared corners on whole and half voxels, so that nearly everything is a tie.
TriangleMesh latticeBlob(std::uint32_t seed) {
    std::mt19937 random(seed);
    TriangleMesh mesh = sphereMesh({8, 8, 8}, 6.0, 5);
    for (glm::dvec3& point : mesh.vertices)
        for (int axis = 0; axis < 3; ++axis)
            point[axis] = 0.5 * std::round(2.0 * point[axis] + static_cast<double>(random() % 5) - 2.0);
    return mesh;
}

/// Winding number of a closed mesh around a point by the solid angles of its triangles
/// (Van Oosterom & Strackee 1983); independent of any grid.
double windingNumber(const TriangleMesh& mesh, const glm::dvec3& point) {
    double sum = 0.0;
    for (const auto& [ia, ib, ic] : mesh.triangles) {
        const glm::dvec3 a = mesh.vertices[ia] - point, b = mesh.vertices[ib] - point, c = mesh.vertices[ic] - point;
        const double la = glm::length(a), lb = glm::length(b), lc = glm::length(c);
        sum += std::atan2(glm::dot(a, glm::cross(b, c)),
                          la * lb * lc + glm::dot(a, b) * lc + glm::dot(b, c) * la + glm::dot(c, a) * lb);
    }
    return sum / (2.0 * pi);
}

} // namespace

class TestVoxelisation : public QObject {
    Q_OBJECT

private slots:
    void volumesConvergeToTheClosedFormula_data() {
        QTest::addColumn<TriangleMesh>("mesh");
        QTest::addColumn<double>("volume");
        QTest::addColumn<double>("surface");
        QTest::addColumn<bool>("isRound");
        QTest::newRow("sphere") << sphereMesh({}, 7.3, 250) << 4.0 / 3.0 * pi * 7.3 * 7.3 * 7.3 << 4.0 * pi * 7.3 * 7.3
                                << true;
        QTest::newRow("torus") << torusMesh({}, 5.7, 2.1, 250) << 2.0 * pi * pi * 5.7 * 2.1 * 2.1
                               << 4.0 * pi * pi * 5.7 * 2.1 << true;
        QTest::newRow("box") << boxMesh({-4, -3, -5}, {4, 3, 5}) << 480.0 << 376.0 << false;
    }
    /// An exact voxelisation has no error except that of its lines: zero mean, and for round bodies a deviation of
    /// second order and known magnitude (line_scatter.h). For a box all of that comes from few orientations, where a
    /// face or an edge is parallel to the lattice; at the others only its corners contribute, and their transforms
    /// decrease as k^-3: third order.
    void volumesConvergeToTheClosedFormula() {
        QFETCH(const TriangleMesh, mesh);
        QFETCH(const double, volume);
        QFETCH(const double, surface);
        QFETCH(const bool, isRound);
        QVERIFY(std::abs(signedVolume(mesh) - volume) < 2e-4 * volume); // accuracy of the mesh itself
        std::array<double, 3> typical{};
        for (std::size_t i = 0; i < typical.size(); ++i) {
            const double edge = std::ldexp(0.5, -static_cast<int>(i));
            const oracles::Scatter scatter = scatterOf(mesh, edge, surface, isRound ? 30 : 600);
            const double mean = scatter.mean(), deviation = scatter.deviation();
            typical[i] = isRound ? deviation : scatter.median();
            qInfo("edge %g mm, of the error that lines make: mean %.3f +- %.3f, deviation %.2f, median %.3f", edge,
                  mean, scatter.standardError(), deviation, scatter.median());
            QVERIFY(std::abs(mean) < 3.5 * scatter.standardError());
            if (isRound) QVERIFY(deviation > 0.75 && deviation < 1.3);
        }
        const double order = oracles::orderOf(typical[0], typical[2]), expected = isRound ? 2.0 : 3.0;
        qInfo("order %.2f", order);
        QVERIFY(std::abs(order - expected) < 0.3);
    }

    void boxesOnVoxelFacesAreExact() {
        const Grid grid = *Grid::make(glm::dvec3(-1.0), 0.5, {20, 24, 28});
        RunVolume volume = emptyVolume(grid);
        const auto report = fill(boxMesh({1, 2, 3}, {4, 5.5, 7.25}), volume);
        QCOMPARE(report.linesWithOddCrossings, std::size_t{0});
        QCOMPARE(volume.amounts().units[part], std::uint64_t{6 * 7 * 17 * 128}); // 17 half-edges of 128 units
    }

    void everyPlaceOfALineIsInsideWhenItWindsAroundIt() {
        const Grid grid = cubeGrid({16, 16, 16});
        const bool held = rc::check("blobs full of ties", [&] {
            const auto seed = *rc::gen::arbitrary<std::uint32_t>();
            const TriangleMesh mesh = latticeBlob(seed);
            RC_ASSERT(countOpenEdges(mesh) == 0U);
            RunVolume volume = emptyVolume(grid);
            const auto report = fill(mesh, volume);
            RC_ASSERT(report.linesWithOddCrossings == 0U);
            RC_ASSERT(report.turnedFaces.count == 0U);
            // The lines pass exactly through corners and edges: an adjacent contact decides as the tie was decided.
            std::mt19937 random(seed);
            for (int i = 0; i < 60; ++i) {
                const LineIndex line{static_cast<int>(random() % 16), static_cast<int>(random() % 16)};
                const auto unit = static_cast<RunPosition>(random() % grid.lineEnd());
                const glm::dvec3 place(line.u + 0.5 + 1e-5, line.v + 0.5 - 1e-8, (unit + 0.5) / 256.0);
                const double winding = windingNumber(mesh, place);
                double nearest = 1.0;
                for (const double step : {-1.0 / 256, 1.0 / 256}) // a run end is rounded to 1/256
                    nearest = std::min(
                        nearest,
                        std::abs(windingNumber(mesh, place + glm::dvec3(0, 0, step)) - winding) > 0.5 ? 0.0 : 1.0);
                if (nearest == 0.0) continue;
                const PropertyIndex found = propertyAt(volume, line, unit);
                RC_ASSERT((found == part) == (std::abs(std::round(winding)) > 0.5));
            }
        });
        QVERIFY(held);
    }

    void overlappingShellsFillTheirUnion() {
        const Grid grid = *Grid::make(glm::dvec3(0.0), 1.0, {16, 16, 16});
        RunVolume volume = emptyVolume(grid);
        TriangleMesh mesh = boxMesh({1, 1, 1}, {9, 9, 9});
        append(mesh, boxMesh({5, 5, 5}, {13, 13, 13}));
        fill(mesh, volume);
        QCOMPARE(volume.amounts().units[part], std::uint64_t{(512 + 512 - 64) * 256});
    }

    void aShellTurnedInsideOutFillsTheSame() {
        const Grid grid = *Grid::make(glm::dvec3(0.0), 1.0, {16, 16, 16});
        RunVolume volume = emptyVolume(grid);
        TriangleMesh mesh = boxMesh({1, 1, 1}, {9, 9, 9});
        for (auto& triangle : mesh.triangles) std::swap(triangle[0], triangle[1]);
        QCOMPARE(fill(mesh, volume).turnedFaces.count, std::size_t{0});
        QCOMPARE(volume.amounts().units[part], std::uint64_t{512 * 256});
    }

    void bigAndSmallTrianglesMeetWithoutGaps() {
        const bool held = rc::check("blobs of any size against their winding number", [] {
            const auto seed = *rc::gen::arbitrary<std::uint32_t>();
            std::mt19937 random(seed);
            const double scale = std::exp2(*rc::gen::inRange(0, 6)); // edges of some 2 to 150 voxels
            TriangleMesh mesh = latticeBlob(seed);
            for (glm::dvec3& point : mesh.vertices) point = (point - 8.0) * scale + 64.0;
            append(mesh, latticeBlob(seed + 1)); // in a corner of the grid
            const Grid grid = cubeGrid({128, 128, 128}, everyAxis[random() % 3]);
            RunVolume volume = emptyVolume(grid);
            const auto report = fill(mesh, volume);
            RC_ASSERT(report.linesWithOddCrossings + report.turnedFaces.count == 0U);
            RC_ASSERT(report.filledUnits == volume.amounts().units[part]);
            for (int i = 0; i < 40; ++i) {
                const VoxelIndex voxel{static_cast<int>(random() % 128), static_cast<int>(random() % 128),
                                       static_cast<int>(random() % 128)};
                const LineIndex line = grid.lineOf(voxel);
                const std::int32_t along = grid.alongOf(voxel);
                glm::dvec3 place(voxel.i + 0.5, voxel.j + 0.5, voxel.k + 0.5), step(0.0);
                place[grid.axisOfU()] += 1e-5;
                place[grid.axisOfV()] -= 1e-8;
                step[grid.axisOfRuns()] = 1.0 / 256;
                const double winding = windingNumber(mesh, place);
                if (std::abs(windingNumber(mesh, place + step) - winding) > 0.5 ||
                    std::abs(windingNumber(mesh, place - step) - winding) > 0.5)
                    continue; // a run end is rounded to 1/256
                const PropertyIndex found =
                    propertyAt(volume, line, static_cast<RunPosition>(along) * unitsPerVoxel + unitsPerVoxel / 2);
                RC_ASSERT((found == part) == (std::abs(std::round(winding)) > 0.5));
            }
        });
        QVERIFY(held);
    }

    void severalBodiesAreFilledAsOneAfterTheOther() {
        const bool held = rc::check("bodies in one pass", [] {
            std::mt19937 random(*rc::gen::arbitrary<std::uint32_t>());
            const Grid grid = cubeGrid({20, 17, 23}, everyAxis[random() % 3]);
            std::vector<TriangleMesh> meshes;
            std::vector<BodyMesh> bodies;
            for (int i = *rc::gen::inRange(0, 5); i > 0; --i) {
                meshes.push_back(latticeBlob(static_cast<std::uint32_t>(random())));
                for (glm::dvec3& point : meshes.back().vertices) point += static_cast<double>(random() % 5);
                if (random() % 4 == 0) meshes.back().triangles.resize(meshes.back().triangles.size() - 3);
            }
            for (const TriangleMesh& mesh : meshes)
                bodies.push_back({&mesh, static_cast<PropertyIndex>(1 + random() % 3), static_cast<int>(random() % 3)});
            RunVolume together = emptyVolume(grid, 2'000'000), apart = emptyVolume(grid, 2'000'000);
            for (RunVolume* volume : {&together, &apart}) volume->fillBlock({2, 3}, {15, 14}, 700, 4000, wax);
            Progress progress;
            const auto reports = voxelise(bodies, together, progress);
            RC_ASSERT(static_cast<bool>(reports));
            RC_ASSERT(reports->size() == bodies.size());
            for (const int priority : {0, 1, 2})
                for (std::size_t i = 0; i < bodies.size(); ++i) {
                    if (bodies[i].priority != priority) continue;
                    const RunAmounts before = apart.amounts();
                    const auto report = fill(*bodies[i].mesh, apart, bodies[i].property);
                    RC_ASSERT(report.filledUnits == (*reports)[i].filledUnits);
                    RC_ASSERT(report.replaced == (*reports)[i].replaced);
                    for (std::size_t p = 0; p < 4; ++p)
                        RC_ASSERT(before.units[p] - report.replaced.units[p] +
                                      (p == bodies[i].property ? report.filledUnits : 0) ==
                                  apart.amounts().units[p]);
                }
            for (LineIndex line; line.v < grid.lineCountV(); ++line.v)
                for (line.u = 0; line.u < grid.lineCountU(); ++line.u)
                    RC_ASSERT(std::ranges::equal(together.line(line), apart.line(line)));
            RC_ASSERT(together.amounts() == apart.amounts());
            RC_ASSERT(together.amounts() == together.snapshot().amounts());
        });
        QVERIFY(held);
    }

    void theResultAlongXAndYIsThatOfTheTurnedMeshAlongZ() {
        const bool held = rc::check("run axes", [] {
            std::mt19937 random(*rc::gen::arbitrary<std::uint32_t>());
            const TriangleMesh mesh = latticeBlob(static_cast<std::uint32_t>(random()));
            const glm::ivec3 count(17, 16, 18);
            for (const RunAxis axis : {RunAxis::x, RunAxis::y}) {
                const Grid grid = cubeGrid(count, axis);
                TriangleMesh turnedMesh = mesh;
                for (glm::dvec3& point : turnedMesh.vertices)
                    point = {point[grid.axisOfU()], point[grid.axisOfV()], point[grid.axisOfRuns()]};
                RunVolume volume = emptyVolume(grid),
                          alongZ = emptyVolume(cubeGrid({grid.lineCountU(), grid.lineCountV(), grid.voxelsPerLine()}));
                RC_ASSERT(fill(mesh, volume).filledUnits == fill(turnedMesh, alongZ).filledUnits);
                for (LineIndex line; line.v < grid.lineCountV(); ++line.v)
                    for (line.u = 0; line.u < grid.lineCountU(); ++line.u)
                        RC_ASSERT(std::ranges::equal(volume.line(line), alongZ.line(line)));
            }
        });
        QVERIFY(held);
    }

    void whatReachesOutOfTheGridIsClippedAndReported() {
        const Grid grid = *Grid::make(glm::dvec3(0.0), 1.0, {16, 16, 16});
        RunVolume volume = emptyVolume(grid);
        const auto report = fill(boxMesh({-1e5, -1e5, -1e5}, {8, 8, 1e5}), volume);
        QCOMPARE(report.clippedLines, std::size_t{64});
        QCOMPARE(report.linesWithOddCrossings, std::size_t{0});
        QCOMPARE(volume.amounts().units[part], std::uint64_t{8 * 8 * 16 * 256});
    }

    void aVertexThatIsNotFiniteIsRefused() {
        RunVolume volume = emptyVolume(cubeGrid({4, 4, 4}));
        TriangleMesh mesh = boxMesh({1, 1, 1}, {2, 2, 2});
        mesh.vertices[3].y = std::nan("");
        Progress progress;
        const auto result = voxelise(mesh, part, volume, progress);
        QVERIFY(!result);
        QVERIFY(result.error().code == ErrorCode::argumentInvalid);
    }

    void usedUpMemoryAndCancellingAreErrors() {
        const Grid grid = cubeGrid({64, 64, 8});
        RunVolume volume = emptyVolume(grid, 4096);
        Progress progress;
        const auto full = voxelise(sphereMesh({32, 32, 4}, 30, 12), part, volume, progress);
        QVERIFY(!full && full.error().code == ErrorCode::volumeOutOfMemory);
        progress.cancel();
        const auto stopped = voxelise(sphereMesh({32, 32, 4}, 30, 12), part, volume, progress);
        QVERIFY(!stopped && stopped.error().code == ErrorCode::cancelled);
    }
};

BURIN_TEST(TestVoxelisation, NoApplication)

} // namespace burin::tst_voxelisation

#include "tst_voxelisation.moc"

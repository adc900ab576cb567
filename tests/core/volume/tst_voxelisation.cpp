// SPDX-FileCopyrightText: 2026 The Burin authors
// SPDX-License-Identifier: Apache-2.0
#include "core/volume/voxelisation.h"
#include "tests/core/volume/shapes.h"
#include "tests/core/volume/volumes.h"
#include "tests/oracles/dense_grid.h"

#include <QtTest>
#include <rapidcheck.h>

#include <random>

using namespace burin;
using namespace burin::test;

namespace {

VoxelisationReport fill(const TriangleMesh& mesh, RunVolume& volume, PropertyIndex property = part) {
    Progress progress;
    return *voxelise(mesh, property, volume, progress);
}

/// Volume, mm³, that a mesh has in a grid over a 20 mm cube that is moved by `shift` voxels. Negative: the report is
/// not clean.
double voxelisedVolume(const TriangleMesh& mesh, int voxels, RunAxis axis, const glm::dvec3& shift) {
    const double edge = 20.0 / voxels;
    const Grid grid = *Grid::make(glm::dvec3(-10.0) + edge * shift, edge, glm::ivec3(voxels), axis);
    RunVolume volume = emptyVolume(grid);
    const VoxelisationReport report = fill(mesh, volume);
    if (report.linesWithOddCrossings + report.linesWithTurnedFaces + report.clippedLines > 0) return -1e9;
    if (report.filledUnits != volume.amounts().units[part]) return -1e9;
    return static_cast<double>(volume.amounts().units[part]) * grid.unitVolume();
}

/// Root of the mean square error over places of the grid and axes of the runs; one place alone may be lucky.
double typicalError(const TriangleMesh& mesh, int voxels) {
    const double expected = signedVolume(mesh);
    double sum = 0.0;
    int count = 0;
    for (const RunAxis axis : {RunAxis::x, RunAxis::y, RunAxis::z})
        for (double shift = 0.0; shift < 0.99; shift += 0.125, ++count) {
            const double error =
                voxelisedVolume(mesh, voxels, axis, {shift, shift * shift, 0.5 - shift}) / expected - 1.0;
            sum += error * error;
        }
    return std::sqrt(sum / count);
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
        QTest::addColumn<int>("shape");
        QTest::newRow("sphere") << 0;
        QTest::newRow("torus") << 1;
        QTest::newRow("box turned about three axes") << 2;
    }
    void volumesConvergeToTheClosedFormula() {
        QFETCH(int, shape);
        const glm::dvec3 centre(0.123, -0.077, 0.031);
        const TriangleMesh mesh = shape == 0   ? sphereMesh(centre, 7.3, 250)
                                  : shape == 1 ? torusMesh(centre, 5.7, 2.1, 250)
                                               : turned(boxMesh({-4, -3, -5}, {4, 3, 5}), 0.7, {1, 2, 3}, {0, 0, 0});
        const double exact = shape == 0   ? 4.0 / 3.0 * pi * 7.3 * 7.3 * 7.3
                             : shape == 1 ? 2.0 * pi * pi * 5.7 * 2.1 * 2.1
                                          : 480.0;
        // The mesh itself is some 1e-4 small; what the grid adds has to vanish faster than its edge does: a midpoint
        // sum over lines is of order 1.5 for a smooth outline with vertical tangents, 2 for planes.
        std::vector<double> errors;
        for (const int voxels : {40, 80, 160, 320}) errors.push_back(typicalError(mesh, voxels));
        QVERIFY(std::abs(signedVolume(mesh) - exact) < 2e-4 * exact);
        const double order = std::log2(errors.front() / errors.back()) / 3.0;
        qInfo("relative errors %.1e %.1e %.1e %.1e, order %.2f", errors[0], errors[1], errors[2], errors[3], order);
        QVERIFY(order > 1.2);
        QVERIFY(errors.back() < 3e-4);
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
            RC_ASSERT(report.linesWithTurnedFaces == 0U);
            // The lines pass exactly through corners and edges: a touch beside them decides as the tie was decided.
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
                PropertyIndex found = airProperty;
                for (const Segment segment : volume.line(line))
                    if (segment.end() > unit) {
                        found = segment.property();
                        break;
                    }
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
        QCOMPARE(fill(mesh, volume).linesWithTurnedFaces, std::size_t{0});
        QCOMPARE(volume.amounts().units[part], std::uint64_t{512 * 256});
    }

    void facesThatDisagreeAreFilledByParityAndReported() {
        const Grid grid = *Grid::make(glm::dvec3(0.0), 1.0, {16, 16, 16});
        RunVolume volume = emptyVolume(grid);
        TriangleMesh mesh = boxMesh({1, 1, 1}, {9, 9, 9});
        std::swap(mesh.triangles[2][0], mesh.triangles[2][1]); // half of the top
        const auto report = fill(mesh, volume);
        QVERIFY(report.linesWithTurnedFaces >= 28 && report.linesWithTurnedFaces <= 36); // a triangle of 8 × 8 lines
        QCOMPARE(report.linesWithOddCrossings, std::size_t{0});
        QCOMPARE(volume.amounts().units[part], std::uint64_t{512 * 256});
    }

    void anOpenBoxIsFilledToItsRim() {
        const Grid grid = *Grid::make(glm::dvec3(0.0), 1.0, {16, 16, 16});
        RunVolume volume = emptyVolume(grid);
        TriangleMesh mesh = boxMesh({1, 1, 1}, {9, 9, 9});
        mesh.triangles.erase(mesh.triangles.begin() + 2, mesh.triangles.begin() + 4); // the top
        const auto report = fill(mesh, volume);
        QCOMPARE(report.linesWithOddCrossings, std::size_t{64});
        QCOMPARE(report.linesThroughHoles, std::size_t{64});
        QCOMPARE(report.openEdges, std::size_t{4});
        QCOMPARE(report.holes, std::size_t{1});
        QCOMPARE(volume.amounts().units[part], std::uint64_t{512 * 256});
        QCOMPARE(report.warning(), std::string("the surface is open at 4 edges (1 rim): what it encloses on 64 scanlines "
                                               "is a guess, between (1.000, 1.000, 1.000) and (9.000, 9.000, 9.000) mm"));
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

QTEST_APPLESS_MAIN(TestVoxelisation)
#include "tst_voxelisation.moc"

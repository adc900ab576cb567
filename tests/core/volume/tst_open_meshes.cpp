// SPDX-FileCopyrightText: 2026 The Burin authors
// SPDX-License-Identifier: Apache-2.0
#include "core/volume/voxelisation/open_mesh.h"
#include "core/volume/voxelisation/voxelisation.h"
#include "tests/core/volume/shapes.h"
#include "tests/core/volume/voxelised.h"
#include "tests/places.h"
#include "tests/random_cases.h"
#include "tests/test_program.h"

#include <QtTest>
#include <rapidcheck.h>

#include <cstring>
#include <fstream>
#include <iterator>
#include <random>

namespace burin::tst_open_meshes {

using namespace burin::test;

namespace {

/// A sphere around the origin without the part above a height.
TriangleMesh openSphere(double radius, double height) {
    TriangleMesh mesh = sphereMesh({0, 0, 0}, radius, 200);
    std::erase_if(mesh.triangles, [&](const auto& triangle) {
        return std::ranges::all_of(triangle, [&](std::uint32_t v) { return mesh.vertices[v].z > height - 1e-9; });
    });
    return mesh;
}

/// Triangles of a binary STL file, no vertex shared.
TriangleMesh readBinaryStl(const std::string& file, double scale) {
    std::ifstream stream(file, std::ios::binary);
    const std::vector<char> bytes{std::istreambuf_iterator<char>(stream), {}};
    TriangleMesh mesh;
    for (std::size_t at = 84; at + 50 <= bytes.size(); at += 50) {
        std::array<float, 12> numbers{};
        std::memcpy(numbers.data(), bytes.data() + at, sizeof numbers);
        const auto first = static_cast<std::uint32_t>(mesh.vertices.size());
        for (std::size_t corner = 3; corner < 12; corner += 3)
            mesh.vertices.push_back(scale * glm::dvec3(numbers[corner], numbers[corner + 1], numbers[corner + 2]));
        mesh.triangles.push_back({first, first + 1, first + 2});
    }
    return mesh;
}

bool isBox(const Box& box, const glm::dvec3& low, const glm::dvec3& high) {
    return box.low == low && box.high == high;
}

} // namespace

/// Meshes that are not a single clean closed shell, and the rules for them (voxelisation.h).
class TestOpenMeshes : public QObject {
    Q_OBJECT

private slots:
    void anOpenBoxIsFilledToItsRim() {
        const Grid grid = *Grid::make(glm::dvec3(0.0), 1.0, {16, 16, 16});
        RunVolume volume = emptyVolume(grid);
        TriangleMesh mesh = boxMesh({1, 1, 1}, {9, 9, 9});
        mesh.triangles.erase(mesh.triangles.begin() + 2, mesh.triangles.begin() + 4); // the top
        const auto report = fill(mesh, volume);
        QCOMPARE(report.linesWithOddCrossings, std::size_t{64});
        QCOMPARE(report.throughHoles.count, std::size_t{64});
        QCOMPARE(report.openEdges, std::size_t{4});
        QCOMPARE(report.holes, std::size_t{1});
        QCOMPARE(volume.amounts().units[part], std::uint64_t{512 * 256});
        QVERIFY(!report.clean());
        QVERIFY(isBox(report.throughHoles.place, {1, 1, 1}, {9, 9, 9}));
    }

    void facesThatDisagreeAreFilledByParityAndReported() {
        const Grid grid = *Grid::make(glm::dvec3(0.0), 1.0, {16, 16, 16});
        RunVolume volume = emptyVolume(grid);
        TriangleMesh mesh = boxMesh({1, 1, 1}, {9, 9, 9});
        std::swap(mesh.triangles[2][0], mesh.triangles[2][1]); // half of the top
        const auto report = fill(mesh, volume);
        QVERIFY(report.turnedFaces.count >= 28 && report.turnedFaces.count <= 36); // a triangle of 8 × 8 lines
        QCOMPARE(report.linesWithOddCrossings, std::size_t{0});
        QCOMPARE(volume.amounts().units[part], std::uint64_t{512 * 256});
    }

    void aSphereCutOpenEndsInThePlaneOfItsRim() {
        const double radius = 10.0, height = 10.0 * std::cos(pi * 50 / 200);
        const TriangleMesh mesh = openSphere(radius, height);
        const double cap = radius - height;
        const double exact = 4.0 / 3.0 * pi * 1000.0 - pi * cap * cap * (3 * radius - cap) / 3.0;
        for (const RunAxis axis : everyAxis)
            for (const int voxels : {50, 100, 200}) {
                VoxelisationReport report;
                const double volume = volumeAlong(mesh, voxels, axis, &report);
                qInfo("axis %d, %d voxels: %+.2e, %zu lines through the hole", static_cast<int>(axis), voxels,
                      volume / exact - 1.0, report.throughHoles.count);
                QVERIFY(std::abs(volume / exact - 1.0) < (axis == RunAxis::z ? 0.002 : 1.0 / voxels));
                QCOMPARE(report.openEdges, std::size_t{400});
                QCOMPARE(report.holes, std::size_t{1});
                QVERIFY(!report.clean());
                if (axis == RunAxis::z) QVERIFY(report.linesWithOddCrossings > 0);
            }
    }

    void patchesTornOutOfAShapeCostNoMoreThanTheirBulge() {
        const bool held = testing::holdsInShare("a torus with holes", [] {
            std::mt19937 random(*rc::gen::arbitrary<std::uint32_t>());
            const TriangleMesh whole = torusMesh({0.1, 0.2, 0.3}, 8.0, 3.0, 60);
            TriangleMesh mesh = whole;
            const double reach = 1.2;
            const int holes = *rc::gen::inRange(1, 4);
            for (int i = 0; i < holes; ++i) {
                const glm::dvec3 middle = whole.vertices[random() % whole.vertices.size()];
                std::erase_if(mesh.triangles, [&](const auto& triangle) {
                    return std::ranges::all_of(
                        triangle, [&](std::uint32_t v) { return glm::distance(whole.vertices[v], middle) < reach; });
                });
            }
            // A cone over the rim stays within the hole's own convexity and saddle: at most the curvature of the tube.
            const double bulge = 3.0 - std::sqrt(3.0 * 3.0 - reach * reach);
            const double bound = holes * pi * reach * reach * bulge;
            for (const RunAxis axis : everyAxis) {
                const double difference = volumeAlong(mesh, 90, axis) - volumeAlong(whole, 90, axis);
                RC_ASSERT(std::abs(difference) < bound + 2.0); // plus the grid's own error
            }
        });
        QVERIFY(held);
    }

    void aSieveIsFilledAsIfItWereWhole() {
        // Each hole is a triangle, so its cap is exactly what is missing. With few holes that are examined closely, and
        // with too many for that.
        const TriangleMesh whole = sphereMesh({0.1, 0.2, 0.3}, 10.0, 160);
        for (const std::size_t every : {std::size_t{40}, std::size_t{5}}) {
            TriangleMesh sieve = whole;
            std::size_t count = 0;
            std::erase_if(sieve.triangles, [&](const auto&) { return ++count % every == 0; });
            VoxelisationReport report;
            const double volume = volumeAlong(sieve, 60, RunAxis::y, &report);
            QCOMPARE(report.openEdges > 20'000, every == 5);
            QVERIFY(report.linesWithOddCrossings > 50);
            QVERIFY(std::abs(volume / volumeAlong(whole, 60, RunAxis::y) - 1.0) < 1e-4);
        }
    }

    void aTubeWithoutEndsIsFilledFromRimToRim() {
        TriangleMesh tube;
        constexpr std::uint32_t count = 64;
        for (const double z : {0.0, 30.0})
            for (std::uint32_t i = 0; i < count; ++i)
                tube.vertices.emplace_back(5 * std::cos(2 * pi * i / count), 5 * std::sin(2 * pi * i / count), z);
        for (std::uint32_t i = 0; i < count; ++i) {
            const std::uint32_t next = (i + 1) % count;
            tube.triangles.push_back({i, next, count + next});
            tube.triangles.push_back({i, count + next, count + i});
        }
        const double exact = 0.5 * count * std::sin(2 * pi / count) * 25.0 * 30.0;
        for (const RunAxis axis : everyAxis) QVERIFY(std::abs(volumeAlong(tube, 100, axis) / exact - 1.0) < 0.02);
        VoxelisationReport report;
        volumeAlong(tube, 100, RunAxis::z, &report);
        QCOMPARE(report.holes, std::size_t{2});
        QCOMPARE(report.linesWithOddCrossings, std::size_t{0});
        QVERIFY(report.throughHoles.count > 600);
        // A ring that is much wider than high encloses nothing.
        for (glm::dvec3& point : tube.vertices) point.z /= 30.0;
        const Grid grid = *Grid::make({-6, -6, -1}, 0.25, {48, 48, 12});
        RunVolume volume = emptyVolume(grid);
        fill(tube, volume);
        QCOMPARE(propertyAt(volume, {24, 24}, 6 * 256), airProperty);
    }

    void sixLooseFacesStillMakeABox() {
        const TriangleMesh box = boxMesh({2, 2, 2}, {14, 14, 14});
        for (const double gap : {1e-6, 0.02, 0.6}) { // negligible, a slit, and wider than any slit
            TriangleMesh mesh;
            for (std::size_t face = 0; face < 6; ++face) {
                TriangleMesh single;
                for (const auto& triangle : {box.triangles[2 * face], box.triangles[2 * face + 1]}) {
                    for (const std::uint32_t vertex : triangle) single.vertices.push_back(box.vertices[vertex]);
                    const auto first = static_cast<std::uint32_t>(single.vertices.size() - 3);
                    single.triangles.push_back({first, first + 1, first + 2});
                }
                const glm::dvec3 middle = boundingBox(single).centre();
                for (glm::dvec3& point : single.vertices)
                    point += 0.5 * gap * glm::sign(middle - point); // shrinks within its plane
                append(mesh, single);
            }
            for (const RunAxis axis : everyAxis) {
                RunVolume volume = emptyVolume(cubeGrid({16, 16, 16}, axis));
                const auto report = fill(mesh, volume);
                const double units = 12.0 * 12.0 * 12.0 * 256.0;
                QVERIFY(std::abs(static_cast<double>(volume.amounts().units[part]) - units) <
                        (gap == 0.02 ? 0.003 : 1e-4) * units);
                QCOMPARE(report.clean(), gap < 0.05);
            }
        }
    }

    void trianglesTwiceWithoutAreaOrUnweldedChangeNothing() {
        const TriangleMesh box = boxMesh({1, 1, 1}, {9, 9, 9});
        TriangleMesh twice = box, flat = box, soup;
        for (const std::size_t t : {0U, 3U, 3U, 8U}) twice.triangles.push_back(box.triangles[t]);
        flat.triangles.push_back({0, 0, 7});
        flat.triangles.push_back({3, 5, 5});
        flat.vertices.emplace_back(5, 5, 1); // on the diagonal of the floor
        flat.triangles.push_back({0, 8, 3});
        for (const auto& triangle : box.triangles) {
            const auto first = static_cast<std::uint32_t>(soup.vertices.size());
            for (const std::uint32_t vertex : triangle) soup.vertices.push_back(box.vertices[vertex]);
            soup.triangles.push_back({first, first + 1, first + 2});
        }
        for (const RunAxis axis : everyAxis)
            for (const TriangleMesh& mesh : {twice, flat, soup}) {
                RunVolume volume = emptyVolume(cubeGrid({16, 16, 16}, axis));
                const auto report = fill(mesh, volume);
                QCOMPARE(volume.amounts().units[part], std::uint64_t{512 * 256});
                QCOMPARE(report.linesWithOddCrossings, std::size_t{0});
                QCOMPARE(report.duplicateTriangles, std::size_t{mesh.triangles.size() == 16 ? 4U : 0U});
            }
        RunVolume volume = emptyVolume(cubeGrid({16, 16, 16}));
        QVERIFY(!fill(twice, volume).clean());
    }

    void junctionsInTheMiddleOfAnEdgeLeaveNoGap() {
        // The floor's neighbour has a corner halfway along their edge; it deviates from the edge by rounding.
        const bool held = testing::holdsInShare("T-junctions", [] {
            TriangleMesh mesh = boxMesh({1.3, 1.2, 1.1}, {12.7, 13.1, 12.9});
            const double share = *rc::gen::inRange(1, 100) / 100.0, off = *rc::gen::inRange(-5, 6) * 0.01;
            mesh.vertices.push_back(glm::mix(mesh.vertices[0], mesh.vertices[1], share) + glm::dvec3(0, off, off));
            std::erase(mesh.triangles, std::array<std::uint32_t, 3>{0, 3, 1});
            mesh.triangles.push_back({0, 3, 8});
            mesh.triangles.push_back({8, 3, 1});
            const TriangleMesh box = turned(mesh, 0.3, {1, 2, 3}, {8, 8, 8});
            const double exact = 11.4 * 11.9 * 11.8;
            for (const RunAxis axis : everyAxis) RC_ASSERT(std::abs(volumeAlong(box, 60, axis) - exact) < 0.01 * exact);
        });
        QVERIFY(held);
    }

    void aShellTurnedInwardsIsFilledAndReportedACavityIsNot() {
        const Grid grid = cubeGrid({24, 24, 24});
        TriangleMesh inwards = boxMesh({2, 2, 2}, {6, 6, 6});
        for (auto& triangle : inwards.triangles) std::swap(triangle[0], triangle[1]);
        TriangleMesh beside = boxMesh({10, 10, 10}, {20, 20, 20}), within = boxMesh({1, 1, 1}, {20, 20, 20});
        append(beside, inwards);
        append(within, inwards);
        RunVolume volume = emptyVolume(grid);
        const auto report = fill(beside, volume);
        QCOMPARE(volume.amounts().units[part], std::uint64_t{(1000 + 64) * 256});
        QCOMPARE(report.insideOut.count, std::size_t{16});
        QVERIFY(!report.clean());
        QVERIFY(isBox(report.insideOut.place, {2, 2, 2}, {6, 6, 6}));
        RunVolume hollow = emptyVolume(grid);
        QVERIFY(fill(within, hollow).clean());
        QCOMPARE(hollow.amounts().units[part], std::uint64_t{(19 * 19 * 19 - 64) * 256});
    }

    void shellsThatOverlapAreReported() {
        RunVolume volume = emptyVolume(cubeGrid({16, 16, 16}));
        TriangleMesh mesh = boxMesh({1, 1, 1}, {9, 9, 9});
        append(mesh, boxMesh({5, 5, 5}, {13, 13, 13}));
        const auto report = fill(mesh, volume);
        QCOMPARE(volume.amounts().units[part], std::uint64_t{(512 + 512 - 64) * 256});
        QCOMPARE(report.overlaps.count, std::size_t{16});
        QVERIFY(!report.clean());
        QVERIFY(isBox(report.overlaps.place, {5, 5, 5}, {9, 9, 9}));
    }

    void linesWithOverlapsAreCounted() {
        std::size_t overlapping = 0, apart = 0;
        const bool held = testing::holdsInShare("boxes in each other, counted run unit by run unit", [&] {
            std::mt19937 random(*rc::gen::arbitrary<std::uint32_t>());
            std::vector<Box> boxes;
            TriangleMesh mesh;
            for (int i = *rc::gen::inRange(2, 5); i > 0; --i) {
                glm::dvec3 low, size; // multiples of 1/32 voxel: tiny overlaps are among them
                for (int axis = 0; axis < 3; ++axis) {
                    low[axis] = static_cast<double>(random() % 200) / 32.0 + 1.0 / 128.0;
                    size[axis] = static_cast<double>(1 + random() % 250) / 32.0;
                }
                const double little = static_cast<double>(random() % 5) / 32.0;
                switch (boxes.empty() ? 3 : random() % 4) {
                case 0:
                    low.z = boxes.back().high.z - little; // begins where the last one ends
                    break;
                case 1:
                    low.z = boxes.back().high.z + little - size.z; // ends there as well
                    break;
                default:
                    break;
                }
                boxes.push_back({low, low + size});
                append(mesh, boxMesh(low, low + size));
            }
            const bool inwards = random() % 2 == 0; // the orientation of the whole does not matter
            if (inwards)
                for (auto& triangle : mesh.triangles) std::swap(triangle[0], triangle[1]);
            for (const RunAxis axis : everyAxis) {
                const Grid grid = cubeGrid({16, 16, 16}, axis);
                std::size_t wanted = 0;
                for (LineIndex line; line.v < 16; ++line.v)
                    for (line.u = 0; line.u < 16; ++line.u) {
                        glm::dvec3 place(0.0);
                        place[grid.axisOfU()] = line.u + 0.5;
                        place[grid.axisOfV()] = line.v + 0.5;
                        int longest = 0, now = 0;
                        for (int unit = 0; unit < 16 * 256; ++unit) {
                            place[grid.axisOfRuns()] = (unit + 0.5) / 256.0;
                            const auto holding =
                                std::ranges::count_if(boxes, [&](const Box& box) { return box.contains(place); });
                            now = holding > 1 ? now + 1 : 0;
                            longest = std::max(longest, now);
                        }
                        wanted += longest > 16 ? 1U : 0U; // 1/16 voxel still counts as touching
                    }
                RunVolume volume = emptyVolume(grid);
                const auto report = fill(mesh, volume);
                RC_ASSERT(report.overlaps.count == wanted);
                RC_ASSERT(inwards || report.clean() == (wanted == 0));
                (wanted > 0 ? overlapping : apart) += 1;
            }
        });
        QVERIFY(held);
        QVERIFY2(overlapping > 8 && apart > 8, qPrintable(QStringLiteral("%1, %2").arg(overlapping).arg(apart)));
    }

    /// Neither shells of one body that meet in a face, at any position, nor separate bodies that overlap are reported.
    void shellsThatTouchAndBodiesThatOverlapAreInOrder() {
        const bool held = testing::holdsInShare("a box in two halves", [] {
            std::mt19937 random(*rc::gen::arbitrary<std::uint32_t>());
            const auto real = [&] { return static_cast<double>(random() % 10'000) / 10'000.0; };
            const double border = 6.0 + 4.0 * real();
            TriangleMesh mesh = boxMesh({4, 5, 4}, {border, 11, 12});
            append(mesh, boxMesh({border, 5, 4}, {12, 11, 12}));
            const TriangleMesh halves =
                turned(mesh, 3.0 * real(), {real() - 0.5, real() - 0.5, real() + 0.1}, {8, 8, 8});
            for (const RunAxis axis : everyAxis) {
                RunVolume volume = emptyVolume(cubeGrid({16, 16, 16}, axis));
                RC_ASSERT(fill(halves, volume).clean());
            }
        });
        QVERIFY(held);
        const TriangleMesh one = boxMesh({1, 1, 1}, {9, 9, 9}), other = boxMesh({5, 5, 5}, {13, 13, 13});
        const std::array bodies{BodyMesh{&one, part}, BodyMesh{&other, wax}};
        RunVolume volume = emptyVolume(cubeGrid({16, 16, 16}));
        Progress progress;
        const auto reports = voxelise(bodies, volume, progress);
        QVERIFY(reports && (*reports)[0].clean() && (*reports)[1].clean());
    }

    void aRealFileWithHolesHasItsVolume() {
        // trimesh's featuretype.STL: 576 edges without a neighbour. The same part as a B-rep has 190,544.5 mm³.
        const TriangleMesh mesh = readBinaryStl(BURIN_FIXTURES "/models/featuretype.stl", 25.4);
        QVERIFY(mesh.triangles.size() > 3000);
        for (const RunAxis axis : everyAxis) {
            // Walls along the runs are within half a voxel, so that a single grid may be a percent off.
            double sum = 0.0;
            for (const double shift : {0.05, 0.25, 0.45, 0.65, 0.85}) {
                VoxelisationReport report;
                sum += volumeAlong(mesh, 200, axis, &report, shift) / 190544.5;
                QCOMPARE(report.linesWithOddCrossings, std::size_t{0}); // all of them are slits
            }
            qInfo("%+.4f %%", 100.0 * (sum / 5.0 - 1.0));
            QVERIFY(std::abs(sum / 5.0 - 1.0) < 0.004);
        }
    }
};

BURIN_TEST(TestOpenMeshes, NoApplication)

} // namespace burin::tst_open_meshes

#include "tst_open_meshes.moc"

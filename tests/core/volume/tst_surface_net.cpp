// SPDX-FileCopyrightText: 2026 The Burin authors
// SPDX-License-Identifier: Apache-2.0
#include "core/volume/surface/surface.h"
#include "tests/core/volume/random_surfaces.h"
#include "tests/oracles/surface_net.h"
#include "tests/random_cases.h"
#include "tests/test_program.h"

#include <QtTest>
#include <rapidcheck.h>

namespace burin::tst_surface_net {

using namespace burin::test;

namespace {

using Face = std::array<DenseSurfaceNet::Cube, 4>; ///< sorted
using Faces = std::multiset<Face>;

/// Whether each face has an opposite face at the same position, as where the solid is too thin for the net: it encloses
/// nothing.
bool isFilm(const Faces& faces) {
    return std::ranges::all_of(faces, [&](const Face& face) {
        const bool hasArea = std::set(face.begin(), face.end()).size() > 2;
        return !hasArea || faces.count(face) % 2 == 0;
    });
}

} // namespace

class TestSurfaceNet : public QObject {
    Q_OBJECT

private slots:
    void bricksAreTheDenseNet();
};

void TestSurfaceNet::bricksAreTheDenseNet() {
    QVERIFY(testing::holdsInShare("the faces and points of a dense net of doubles, closed and turned outwards", [] {
        // Two tiles in either direction; or three bricks along the runs, of which the middle one contains no line end.
        const Grid grid =
            randomlyTurnedGrid(*rc::gen::element(glm::ivec3(34, 33, 41), glm::ivec3(34, 9, 75), glm::ivec3(9, 33, 75)));
        RunVolume volume = emptyVolume(grid);
        fillAtRandom(volume);
        const VolumeSnapshot workpiece = volume.snapshot();
        const DenseSurfaceNet dense(workpiece);
        const glm::ivec3 axes(grid.axisOfU(), grid.axisOfV(), grid.axisOfRuns());
        const auto inLines = [&](const glm::dvec3& way) { return glm::dvec3(way[axes.x], way[axes.y], way[axes.z]); };
        SurfaceExtractor extractor;
        SurfaceMesh piece, whole;
        Faces faces;
        eachBrick(grid, [&](SurfaceBrick brick) {
            extractor.extractBrick(workpiece, brick, piece);
            RC_ASSERT(piece.normals.size() == piece.points.size() && piece.properties.size() == piece.points.size());
            std::vector<DenseSurfaceNet::Cube> cubes;
            for (std::size_t i = 0; i < piece.points.size(); ++i) {
                const glm::dvec3 place = inLines(glm::dvec3(piece.points[i]) - grid.low()) / surfaceVoxel;
                const std::vector<DenseSurfaceNet::Cube> at = dense.cubesAt(place, 1e-4);
                RC_ASSERT(!at.empty());
                cubes.push_back(at.front());
                const glm::dvec3 normal = inLines(glm::dvec3(piece.normals[i]));
                RC_ASSERT(std::abs(glm::length(normal) - 1.0) < 1e-5);
                RC_ASSERT(std::ranges::any_of(at, [&](const DenseSurfaceNet::Cube& cube) {
                    const glm::dvec3 exact = dense.points().at(cube).gradient;
                    return glm::length(exact) < 0.01 || glm::dot(normal, glm::normalize(exact)) > 0.9999;
                }));
            }
            for (std::size_t i = 0; i < piece.triangles.size(); i += 6) { // two triangles a face: a b c, a c d
                const std::uint32_t* corner = piece.triangles.data() + i;
                std::array face{cubes[corner[0]], cubes[corner[1]], cubes[corner[2]], cubes[corner[5]]};
                RC_ASSERT(corner[0] == corner[3] && corner[2] == corner[4]);
                std::ranges::sort(face);
                faces.insert(face);
            }
            const auto first = static_cast<std::uint32_t>(whole.points.size());
            whole.points.insert(whole.points.end(), piece.points.begin(), piece.points.end());
            for (const std::uint32_t corner : piece.triangles) whole.triangles.push_back(first + corner);
        });
        Faces expected;
        for (Face face : dense.faces()) {
            for (DenseSurfaceNet::Cube& cube : face) cube = dense.cubesAt(dense.points().at(cube).place, 1e-4).front();
            std::ranges::sort(face);
            expected.insert(face);
        }
        RC_ASSERT(faces == expected);
        const TriangleMesh mesh = triangleMesh(whole);
        RC_ASSERT(countGaps(mesh) == std::size_t{0});
        RC_ASSERT(isFilm(expected) || signedVolume(mesh) > 0.0);
    }));
}

BURIN_TEST(TestSurfaceNet, NoApplication)

} // namespace burin::tst_surface_net

#include "tst_surface_net.moc"

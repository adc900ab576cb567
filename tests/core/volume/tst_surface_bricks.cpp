// SPDX-FileCopyrightText: 2026 The Burin authors
// SPDX-License-Identifier: Apache-2.0
#include "core/volume/surface.h"
#include "tests/core/volume/surfaces.h"
#include "tests/core/volume/volumes.h"

#include <QtTest>
#include <rapidcheck.h>

using namespace burin;
using namespace burin::test;

namespace {

constexpr double voxel = 0.25;

} // namespace

class TestSurfaceBricks : public QObject {
    Q_OBJECT

private slots:
    void bricksAreTheTile() {
        const bool held =
            rc::check("bricks together: the points, normals, materials and triangles of their tile, bit for bit", [] {
                const auto axis = static_cast<RunAxis>(*rc::gen::inRange(0, 3));
                const Grid grid = *Grid::make({-3.0, 5.0, 1.0}, voxel, {70, 66, 97}, axis);
                RunVolume volume = emptyVolume(grid);
                RC_ASSERT(volume.fillBlock({0, 0}, {grid.lineCountU(), grid.lineCountV()},
                                           *rc::gen::inRange<RunPosition>(0, 9000), grid.lineEnd(), wax));
                RunAmounts removed;
                for (int i = *rc::gen::inRange(0, 40); i > 0; --i) { // splinters
                    const LineIndex line{*rc::gen::inRange(0, grid.lineCountU()),
                                         *rc::gen::inRange(0, grid.lineCountV())};
                    const auto from = *rc::gen::inRange<RunPosition>(0, grid.lineEnd());
                    (void)volume.removeSpan(line, from, from + *rc::gen::inRange<RunPosition>(0, 20000), removed);
                }
                for (int i = *rc::gen::inRange(1, 6); i > 0; --i) {
                    const glm::dvec3 share(*rc::gen::inRange(0, 100), *rc::gen::inRange(0, 100),
                                           *rc::gen::inRange(0, 100));
                    fillSphere(volume, *rc::gen::inRange<PropertyIndex>(0, 4),
                               grid.box().low + share / 100.0 * grid.box().size(), voxel * *rc::gen::inRange(1, 30));
                }
                const VolumeSnapshot workpiece = volume.snapshot();
                using Corner = std::array<float, 6>;
                using Face = std::array<std::pair<Corner, PropertyIndex>, 3>;
                const auto faces = [](const SurfaceMesh& mesh, std::vector<Face>& all) {
                    for (std::size_t i = 0; i < mesh.triangles.size(); i += 3) {
                        Face face;
                        for (std::size_t corner = 0; corner < 3; ++corner) {
                            const std::uint32_t at = mesh.triangles[i + corner];
                            const glm::vec3 &p = mesh.points[at], &n = mesh.normals[at];
                            face[corner] = {Corner{p.x, p.y, p.z, n.x, n.y, n.z}, mesh.properties[at]};
                        }
                        all.push_back(face);
                    }
                };
                SurfaceExtractor extractor;
                SurfaceMesh piece;
                const glm::ivec2 tiles = surfaceTiles(grid);
                for (int v = 0; v < tiles.y; ++v)
                    for (int u = 0; u < tiles.x; ++u) {
                        std::vector<Face> whole, together;
                        extractor.extract(workpiece, {u, v}, {}, piece);
                        faces(piece, whole);
                        for (int n = 0; n * linesPerSurfaceTile < grid.voxelsPerLine(); ++n) {
                            extractor.extractBrick(workpiece, {u, v, n}, piece);
                            faces(piece, together);
                        }
                        std::ranges::sort(whole);
                        std::ranges::sort(together);
                        RC_ASSERT(whole == together);
                    }
            });
        QVERIFY(held);
    }
};

QTEST_APPLESS_MAIN(TestSurfaceBricks)
#include "tst_surface_bricks.moc"

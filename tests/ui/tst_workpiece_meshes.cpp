// SPDX-FileCopyrightText: 2026 The Burin authors
// SPDX-License-Identifier: Apache-2.0
#include "core/base/progress.h"
#include "core/cutting/removal.h"
#include "core/geometry/mesh_distance.h"
#include "core/setup/stock_shape.h"
#include "core/volume/voxelisation/voxelisation.h"
#include "tests/core/volume/shapes.h"
#include "tests/core/volume/volumes.h"
#include "tests/test_program.h"
#include "tests/ui/offscreen_stage.h"
#include "ui/scene/workpiece_mesher.h"

#include <QCoreApplication>
#include <vtkActor.h>
#include <vtkCamera.h>
#include <vtkGenericOpenGLRenderWindow.h>
#include <vtkIdList.h>
#include <vtkNew.h>
#include <vtkObject.h>
#include <vtkPointData.h>
#include <vtkPolyDataMapper.h>
#include <vtkProperty.h>
#include <vtkRenderer.h>
#include <vtkUnsignedCharArray.h>

#include <QImage>
#include <QtTest>

#include <array>
#include <cstring>
#include <map>
#include <memory>
#include <optional>

namespace burin::tst_workpiece_meshes {

using namespace burin::test;

namespace {

using Surfaces = std::vector<vtkSmartPointer<vtkPolyData>>; // by group

constexpr int side = 900; // pixels
/// Triangle limits while things move, chosen so that all levels of detail are drawn, down to the coarsest.
constexpr std::array<std::size_t, 5> movingLimits{1'000'000, 4'000, 1'500, 500, 1};

/// @param earlier shown before it; empty: none
Surfaces surfaces(const VolumeSnapshot& workpiece, std::size_t movingLimit, SurfaceLayer layer, bool partDrawn = false,
                  const std::optional<ExcessColours>& left = {}, const VolumeSnapshot& earlier = {}) {
    WorkpieceMesher mesher({movingLimit, 10'000'000}, [] {});
    mesher.setPartDrawn(partDrawn);
    mesher.setExcess(left);
    std::map<std::size_t, vtkSmartPointer<vtkPolyData>> byGroup;
    for (const VolumeSnapshot* shown : {&earlier, &workpiece}) {
        if (!shown->empty()) mesher.show(*shown, std::nullopt);
        for (bool busy = !shown->empty(); busy;) {
            QTest::qWait(10);
            busy = mesher.busy();
            for (SurfaceUpdate& update : mesher.take().updates)
                if (update.layer == layer) byGroup[update.group] = update.data;
        }
    }
    Surfaces all;
    for (auto& [group, data] : byGroup) all.push_back(data);
    return all;
}

/// The surfaces at rest, and at all levels of detail of things that move.
std::vector<Surfaces> atAllDetails(const VolumeSnapshot& workpiece) {
    std::vector<Surfaces> all{surfaces(workpiece, 1'000'000, SurfaceLayer::rest)};
    for (const std::size_t limit : movingLimits) all.push_back(surfaces(workpiece, limit, SurfaceLayer::moving));
    return all;
}

TriangleMesh meshOf(const Surfaces& pieces) {
    TriangleMesh mesh;
    for (const auto& piece : pieces) {
        const auto first = static_cast<std::uint32_t>(mesh.vertices.size());
        for (vtkIdType i = 0; i < piece->GetNumberOfPoints(); ++i) {
            const double* place = piece->GetPoint(i);
            mesh.vertices.push_back({place[0], place[1], place[2]});
        }
        for (vtkIdType i = 0; i < piece->GetNumberOfPolys(); ++i) {
            vtkNew<vtkIdList> corners;
            piece->GetCellPoints(i, corners);
            const auto corner = [&](vtkIdType n) { return first + static_cast<std::uint32_t>(corners->GetId(n)); };
            mesh.triangles.push_back({corner(0), corner(1), corner(2)});
        }
    }
    return mesh;
}

/// The lines in which a surface enters a sphere, triangle by triangle.
std::vector<std::array<glm::dvec3, 2>> cutBySphere(const Surfaces& pieces, const glm::dvec3& centre, double radius) {
    const TriangleMesh mesh = meshOf(pieces);
    std::vector<std::array<glm::dvec3, 2>> lines;
    for (const auto& at : mesh.triangles) {
        std::vector<glm::dvec3> ends;
        for (std::size_t i = 0; i < 3; ++i) {
            const glm::dvec3 &a = mesh.vertices[at[i]], &b = mesh.vertices[at[(i + 1) % 3]];
            const double outA = glm::distance(a, centre) - radius, outB = glm::distance(b, centre) - radius;
            if ((outA < 0.0) != (outB < 0.0)) ends.push_back(glm::mix(a, b, outA / (outA - outB)));
        }
        if (ends.size() == 2) lines.push_back({ends[0], ends[1]});
    }
    return lines;
}

bool isBarePart(vtkPolyData& piece, vtkIdType point) {
    const double* colour = piece.GetPointData()->GetScalars()->GetTuple(point);
    return std::equal(barePartColour.begin(), barePartColour.end(), colour);
}

RunVolume milled(const Box& stock, double voxel) {
    const glm::ivec3 count(glm::ceil(stock.size() / voxel - 1e-6));
    RunVolume volume = RunVolume::make(*Grid::make(stock.low, voxel, count), someProperties()).value();
    (void)BoxStock(stock).fill(volume, wax);
    return volume;
}

void clear(RunVolume& volume, const Box& box) {
    const Grid& grid = volume.grid();
    const glm::ivec3 low(glm::round((box.low - grid.low()) / grid.edge())),
        high(glm::min(glm::round((box.high - grid.low()) / grid.edge()), glm::dvec3(grid.count())));
    (void)volume.fillBlock({low.x, low.y}, {high.x, high.y}, grid.toRunPosition(box.low.z),
                           grid.toRunPosition(box.high.z), airProperty);
}

class Stage : public testing::OffscreenStage {
public:
    Stage() : OffscreenStage(side) {}
    void look(const Box& box, const glm::dvec3& from, double scale) {
        const glm::dvec3 centre = box.centre(), eye = centre + 500.0 * glm::normalize(from);
        vtkCamera* camera = renderer->GetActiveCamera();
        camera->ParallelProjectionOn();
        camera->SetFocalPoint(centre.x, centre.y, centre.z);
        camera->SetPosition(eye.x, eye.y, eye.z);
        camera->SetViewUp(0.0, 0.0, 1.0);
        camera->SetParallelScale(scale);
        camera->SetClippingRange(1.0, 1000.0);
    }
    QPoint pixelOf(const glm::dvec3& point) {
        renderer->SetWorldPoint(point.x, point.y, point.z, 1.0);
        renderer->WorldToDisplay();
        const double* display = renderer->GetDisplayPoint();
        return {static_cast<int>(display[0]), side - 1 - static_cast<int>(display[1])};
    }
    QImage render(const Surfaces& pieces) {
        renderer->RemoveAllViewProps();
        for (const auto& piece : pieces) {
            vtkNew<vtkPolyDataMapper> mapper;
            mapper->SetColorModeToDirectScalars();
            mapper->SetInputData(piece);
            vtkNew<vtkActor> actor;
            actor->SetMapper(mapper);
            actor->GetProperty()->BackfaceCullingOn();
            renderer->AddActor(actor);
        }
        window->Render();
        vtkNew<vtkUnsignedCharArray> bytes;
        window->GetPixelData(0, 0, side - 1, side - 1, 0, bytes.Get(), 0);
        QImage image(side, side, QImage::Format_RGB888);
        for (int y = 0; y < side; ++y)
            std::memcpy(image.scanLine(side - 1 - y), bytes->GetPointer(3 * y * side), std::size_t{3} * side);
        return image;
    }
};

} // namespace

class WorkpieceMeshesTest : public QObject {
    Q_OBJECT
private slots:
    void initTestCase() { vtkObject::GlobalWarningDisplayOff(); } // two lines about GLEW without X
    void edgesOfTheStockAreSharp_data();
    void edgesOfTheStockAreSharp();
    void facesOfTheStockShadeFlat();
    void shallowCutsStay();
    void wallsShowNoNotch();
    void groovesShadeAlike_data();
    void groovesShadeAlike();
    void stockEndsOnBarePartInALine_data();
    void stockEndsOnBarePartInALine();
    void theLineLeadsOverTheLimitsOfTiles_data();
    void theLineLeadsOverTheLimitsOfTiles();
    void coloursTellWhatIsLeft_data();
    void coloursTellWhatIsLeft();
    void coloursAfterACutAreThoseOfTheWhole();
};

void WorkpieceMeshesTest::edgesOfTheStockAreSharp_data() {
    QTest::addColumn<glm::dvec3>("size");
    QTest::newRow("whole cells of all levels") << glm::dvec3(48.0, 40.0, 16.0);
    QTest::newRow("whole voxels") << glm::dvec3(47.75, 40.25, 15.5);
    QTest::newRow("height of no whole voxels") << glm::dvec3(47.75, 40.25, 15.6);
}
/// A slot crosses two edges and two faces; everywhere else the edges and corners of the box are exact, at rest and
/// while something moves.
void WorkpieceMeshesTest::edgesOfTheStockAreSharp() {
    QFETCH(glm::dvec3, size);
    const Box stock{{-3.0, 5.0, 1.0}, glm::dvec3(-3.0, 5.0, 1.0) + size};
    RunVolume volume = milled(stock, 0.25);
    clear(volume, {{9.0, 5.0, 8.0}, {15.0, 60.0, 20.0}});
    int detail = 0;
    for (const Surfaces& pieces : atAllDetails(volume.snapshot())) {
        const MeshDistance surface(meshOf(pieces));
        const double beside = detail == 0 ? 1.0 : 8.0; // mm within which the slot's own edges may be rounded
        double worst = 0.0;
        glm::dvec3 where(0.0);
        for (int axis = 0; axis < 3; ++axis)
            for (unsigned corner = 0; corner < 8; ++corner) {
                if ((corner & 1U << axis) != 0) continue;
                const glm::dvec3 from = stock.corner(corner), to = stock.corner(corner | 1U << axis);
                for (int i = 0; i <= 400; ++i) {
                    const glm::dvec3 place = glm::mix(from, to, i / 400.0);
                    const bool besideTheSlot =
                        place.z > 8.0 - beside && place.x > 9.0 - beside && place.x < 15.0 + beside;
                    const double off = besideTheSlot ? 0.0 : surface.closest(place).distance;
                    if (off > worst) where = place;
                    worst = std::max(worst, off);
                }
            }
        QVERIFY2(
            worst < 0.002,
            qPrintable(
                QString("detail %1: %2 mm at %3 %4 %5").arg(detail).arg(worst).arg(where.x).arg(where.y).arg(where.z)));
        ++detail;
    }
}

/// Every triangle in a face of the stock has the face's normal, up to the edge.
void WorkpieceMeshesTest::facesOfTheStockShadeFlat() {
    const Box stock{{0.0, 0.0, 0.0}, {48.0, 40.0, 16.0}};
    RunVolume volume = milled(stock, 0.25);
    for (const Surfaces& pieces : atAllDetails(volume.snapshot())) {
        std::size_t corners = 0;
        for (const auto& piece : pieces)
            for (vtkIdType i = 0; i < piece->GetNumberOfPolys(); ++i) {
                vtkNew<vtkIdList> ids;
                piece->GetCellPoints(i, ids);
                std::array<glm::dvec3, 3> at;
                for (int n = 0; n < 3; ++n) piece->GetPoint(ids->GetId(n), &at[static_cast<std::size_t>(n)].x);
                const glm::dvec3 twice = glm::cross(at[1] - at[0], at[2] - at[0]);
                for (int axis = 0; axis < 3; ++axis)
                    for (const double face : {stock.low[axis], stock.high[axis]}) {
                        const auto onFace = [&](const glm::dvec3& p) { return std::abs(p[axis] - face) < 1e-4; };
                        if (!std::all_of(at.begin(), at.end(), onFace) || glm::length(twice) < 0.01) continue;
                        for (vtkIdType n = 0; n < 3; ++n, ++corners) {
                            glm::dvec3 normal;
                            piece->GetPointData()->GetNormals()->GetTuple(ids->GetId(n), &normal.x);
                            QVERIFY(glm::dot(normal, glm::normalize(twice)) > 0.9999);
                        }
                    }
            }
        QVERIFY(corners >= 36);
    }
}

/// Stock with a tenth of a voxel removed from its top is not drawn as untouched, but where its surface is.
void WorkpieceMeshesTest::shallowCutsStay() {
    const Box stock{{0.0, 0.0, 0.0}, {48.0, 40.0, 16.0}};
    RunVolume volume = milled(stock, 0.25);
    clear(volume, {{0.0, 0.0, 15.975}, {48.0, 40.0, 16.0}});
    const TriangleMesh mesh = meshOf(surfaces(volume.snapshot(), 1'000'000, SurfaceLayer::rest));
    double highest = 0.0;
    for (const glm::dvec3& vertex : mesh.vertices) highest = std::max(highest, vertex.z);
    QVERIFY(std::abs(highest - 15.975) < 0.002);
}

/// A wall of 2.5 mm across several groups, seen at right angles and along it, has a single even colour.
void WorkpieceMeshesTest::wallsShowNoNotch() {
    Stage stage;
    const Box stock{{0.0, 0.0, 0.0}, {120.0, 40.0, 20.0}};
    RunVolume volume = milled(stock, 0.25);
    clear(volume, {{0.0, 0.0, 4.0}, {120.0, 18.0, 20.0}});
    clear(volume, {{0.0, 20.5, 4.0}, {120.0, 40.0, 20.0}});
    const Box seen{{5.0, 18.0, 8.0}, {115.0, 18.0, 16.0}};
    for (const Surfaces& pieces : atAllDetails(volume.snapshot()))
        for (const glm::dvec3& from : {glm::dvec3(0.0, -1.0, 0.0), glm::dvec3(-1.0, -0.4, 0.5)}) {
            stage.look(seen, from, 55.0);
            const QImage image = stage.render(pieces);
            const QRgb wall = image.pixel(stage.pixelOf(seen.centre() + glm::dvec3(3.0, 0.0, 0.0)));
            QVERIFY(qBlue(wall) < 250); // not the colour of the background
            int others = 0;
            for (double x = seen.low.x; x < seen.high.x; x += 0.1)
                for (double z = seen.low.z; z < seen.high.z; z += 0.1)
                    others += std::abs(qGreen(image.pixel(stage.pixelOf({x, 18.0, z}))) - qGreen(wall)) > 24 ? 1 : 0;
            QCOMPARE(others, 0);
        }
}

void WorkpieceMeshesTest::groovesShadeAlike_data() {
    QTest::addColumn<double>("angle");
    for (const double angle : {0.0, 17.0, 30.0, 45.0, 63.0}) QTest::addRow("%.0f degrees", angle) << angle;
}
/// A groove of a ball-end mill is part of a cylinder: its shading must not vary along it like a string of beads.
void WorkpieceMeshesTest::groovesShadeAlike() {
    QFETCH(double, angle);
    constexpr double voxel = 0.5, radius = 3.0, depth = 1.5;
    const Box stock{{0.0, 0.0, 0.0}, {60.0, 60.0, 10.0}};
    RunVolume volume = milled(stock, voxel);
    const glm::dvec3 along(std::cos(glm::radians(angle)), std::sin(glm::radians(angle)), 0.0);
    const glm::dvec3 tip(30.07, 30.11, stock.high.z - depth), axis = tip + glm::dvec3(0.0, 0.0, radius);
    MaterialRemoval ball({CutterType::ball, 2.0 * radius, radius, 100.0, 2.0 * radius, 150.0, {}}, volume.grid());
    ball.cut(volume, tip - 22.0 * along, tip + 22.0 * along);
    (void)ball.settle(volume);

    double squares = 0.0, area = 0.0;
    for (const auto& piece : surfaces(volume.snapshot(), 1'000'000, SurfaceLayer::rest))
        for (vtkIdType i = 0; i < piece->GetNumberOfPolys(); ++i) {
            vtkNew<vtkIdList> ids;
            piece->GetCellPoints(i, ids);
            std::array<glm::dvec3, 3> at, normal;
            for (int n = 0; n < 3; ++n) {
                piece->GetPoint(ids->GetId(n), &at[static_cast<std::size_t>(n)].x);
                piece->GetPointData()->GetNormals()->GetTuple(ids->GetId(n), &normal[static_cast<std::size_t>(n)].x);
            }
            const double share = 0.5 * glm::length(glm::cross(at[1] - at[0], at[2] - at[0])) / 10.0;
            for (int a = 0; a <= 3; ++a)
                for (int b = 0; a + b <= 3; ++b) { // interpolated as the screen does it from the normals of the corners
                    const double u = a / 3.0, v = b / 3.0, w = 1.0 - u - v;
                    const glm::dvec3 place = u * at[0] + v * at[1] + w * at[2];
                    const glm::dvec3 out = axis + glm::dot(place - axis, along) * along - place;
                    const bool inGroove = place.z < stock.high.z - 1.5 * voxel && place.z > tip.z - voxel &&
                                          std::abs(glm::dot(place - axis, along)) < 20.0 && glm::length(out) < 4.0;
                    if (!inGroove) continue;
                    const double cosine =
                        glm::dot(glm::normalize(u * normal[0] + v * normal[1] + w * normal[2]), glm::normalize(out));
                    const double off = std::acos(std::min(cosine, 1.0));
                    squares += share * off * off;
                    area += share;
                }
        }
    QVERIFY(area > 100.0); // mm²
    const double degrees = glm::degrees(std::sqrt(squares / area));
    QVERIFY2(degrees < 3.0, qPrintable(QString::number(degrees)));
}

void WorkpieceMeshesTest::stockEndsOnBarePartInALine_data() {
    QTest::addColumn<double>("height");
    QTest::newRow("shallow") << 11.0;
    QTest::newRow("oblique") << 9.6;
    QTest::newRow("steep") << 8.1;
    QTest::newRow("upright") << 7.1;
}
/// A sphere that protrudes from a plane: the plane ends in a circle around it that has the length of a circle (the
/// border of voxels would be a quarter longer), and no gap lets light through.
void WorkpieceMeshesTest::stockEndsOnBarePartInALine() {
    QFETCH(double, height);
    constexpr double voxel = 0.25, radius = 6.0;
    const glm::dvec3 centre(7.03, 7.11, 7.0);
    RunVolume volume = milled({{0.0, 0.0, 0.0}, {14.25, 14.25, 14.0}}, voxel);
    clear(volume, {{0.0, 0.0, height}, {14.25, 14.25, 14.0}});
    Progress progress;
    QVERIFY(voxelise(sphereMesh(centre, radius, 400), part, volume, progress));
    const double circle = std::sqrt(radius * radius - (height - centre.z) * (height - centre.z));
    const Surfaces pieces = surfaces(volume.snapshot(), 1'000'000, SurfaceLayer::rest, true);
    for (const auto& piece : pieces)
        for (vtkIdType i = 0; i < piece->GetNumberOfPoints(); ++i) QVERIFY(!isBarePart(*piece, i));

    double length = 0.0, farthest = 0.0; // mm, voxels
    for (const auto& [from, to] : cutBySphere(pieces, centre, radius)) {
        length += glm::distance(from, to);
        farthest = std::max(farthest, std::abs(glm::length(glm::dvec2(from - centre)) - circle) / voxel);
    }
    const double ratio = length / (2.0 * pi * circle);
    QVERIFY2(ratio > 0.98 && ratio < 1.1, qPrintable(QString::number(ratio)));
    QVERIFY2(farthest < 1.0, qPrintable(QString::number(farthest)));
}

void WorkpieceMeshesTest::theLineLeadsOverTheLimitsOfTiles_data() {
    QTest::addColumn<double>("height");
    QTest::newRow("shallow") << 19.0;
    QTest::newRow("oblique") << 17.0;
    QTest::newRow("steep") << 14.0;
    QTest::newRow("upright") << 12.1;
}
/// The surface is made in tiles of 32 voxels. Where a circle of stock around a sphere crosses from one tile to another,
/// it is as round as within a tile, at rest and while things move.
void WorkpieceMeshesTest::theLineLeadsOverTheLimitsOfTiles() {
    QFETCH(double, height);
    constexpr double voxel = 0.25, radius = 11.0, tile = linesPerSurfaceTile * voxel;
    const glm::dvec3 centre(14.03, 14.11, 12.0);
    RunVolume volume = milled({{0.0, 0.0, 0.0}, {28.25, 28.25, 24.0}}, voxel);
    clear(volume, {{0.0, 0.0, height}, {28.25, 28.25, 24.0}});
    Progress progress;
    QVERIFY(voxelise(sphereMesh(centre, radius, 400), part, volume, progress));
    const double circle = std::sqrt(radius * radius - (height - centre.z) * (height - centre.z));
    for (const SurfaceLayer layer : {SurfaceLayer::rest, SurfaceLayer::moving}) {
        const double cell = layer == SurfaceLayer::rest ? voxel : 2.0 * voxel;
        double atLimits = 0.0, between = 0.0; // largest distance from the circle, cells
        int crossings = 0;
        for (const auto& [from, to] :
             cutBySphere(surfaces(volume.snapshot(), 1'000'000, layer, true), centre, radius)) {
            const glm::dvec3 middle = 0.5 * (from + to);
            const double off = std::abs(glm::length(glm::dvec2(middle - centre)) - circle) / cell;
            const auto toLimit = [&](double along) { return std::abs(along - tile * std::round(along / tile)); };
            const bool atLimit = std::min(toLimit(middle.x), toLimit(middle.y)) < 1.5 * cell;
            double& farthest = atLimit ? atLimits : between;
            farthest = std::max(farthest, off);
            crossings += atLimit ? 1 : 0;
        }
        QVERIFY(crossings > 0);
        QVERIFY2(atLimits < between + 0.12, qPrintable(QStringLiteral("%1 %2").arg(atLimits).arg(between)));
    }
}

void WorkpieceMeshesTest::coloursTellWhatIsLeft_data() {
    QTest::addColumn<SurfaceLayer>("layer");
    QTest::addColumn<int>("most"); // of a colour's 255 steps, of which a band has up to 80
    QTest::newRow("at rest") << SurfaceLayer::rest << 36;
    QTest::newRow("while things move") << SurfaceLayer::moving << 60;
}
/// A flat face is 0.6 mm above a ball: its triangles are large, yet each of their points has the colour of its own
/// distance to the ball. Dividing the triangles moved nothing. A floor from which the ball protrudes is white where it
/// is bare.
void WorkpieceMeshesTest::coloursTellWhatIsLeft() {
    QFETCH(SurfaceLayer, layer);
    QFETCH(int, most);
    constexpr double voxel = 0.25, radius = 8.0;
    const glm::dvec3 centre(10.03, 10.11, 8.0);
    RunVolume volume = milled({{0.0, 0.0, 0.0}, {20.0, 20.0, 16.6}}, voxel);
    const auto ball = std::make_shared<const MeshDistance>(sphereMesh(centre, radius, 400));
    const DeviationTolerance tolerance;
    const DeviationScale scale = ExcessColours{ball, tolerance}.scale();
    const Surfaces plain = surfaces(volume.snapshot(), 1'000'000, layer);
    const Surfaces pieces = surfaces(volume.snapshot(), 1'000'000, layer, false, ExcessColours{ball, tolerance});
    const MeshDistance surface(meshOf(plain));
    constexpr int steps = 6;
    int worst = 0;
    std::size_t coloured = 0, all = 0;
    for (const auto& piece : pieces) {
        auto* colours = vtkUnsignedCharArray::SafeDownCast(piece->GetPointData()->GetScalars());
        const TriangleMesh mesh = meshOf({piece});
        for (const auto& corner : mesh.triangles) {
            for (const std::uint32_t at : corner) QVERIFY(surface.closest(mesh.vertices[at]).distance < 1e-4);
            for (int i = 0; i <= steps; ++i)
                for (int j = 0; j <= steps - i; ++j) {
                    const glm::dvec3 share(i / 6.0, j / 6.0, (steps - i - j) / 6.0);
                    glm::dvec3 place(0.0), colour(0.0);
                    for (int k = 0; k < 3; ++k) {
                        place += share[k] * mesh.vertices[corner[static_cast<std::size_t>(k)]];
                        for (int c = 0; c < 3; ++c)
                            colour[c] += share[k] * colours->GetTypedComponent(corner[static_cast<std::size_t>(k)], c);
                    }
                    const double left = glm::distance(place, centre) - radius;
                    const DeviationColour wanted = scale.colourOf(left);
                    ++all;
                    coloured += left < scale.marks().back().deviation ? 1U : 0U;
                    for (int c = 0; c < 3; ++c)
                        worst = std::max(worst, std::abs(static_cast<int>(std::lround(colour[c])) -
                                                         wanted[static_cast<std::size_t>(c)]));
                }
        }
    }
    QVERIFY2(coloured > 1000, qPrintable(QStringLiteral("%1 of %2").arg(coloured).arg(all)));
    QVERIFY2(worst <= most, qPrintable(QString::number(worst)));

    RunVolume bare = milled({{0.0, 0.0, 0.0}, {20.0, 20.0, 17.0}}, voxel);
    clear(bare, {{0.0, 0.0, 14.0}, {20.0, 20.0, 17.0}});
    Progress progress;
    QVERIFY(voxelise(sphereMesh(centre, radius, 400), part, bare, progress));
    std::size_t white = 0;
    for (const auto& piece : surfaces(bare.snapshot(), 1'000'000, layer, false, ExcessColours{ball, tolerance}))
        for (vtkIdType i = 0; i < piece->GetNumberOfPoints(); ++i) {
            const glm::dvec3 place(piece->GetPoint(i)[0], piece->GetPoint(i)[1], piece->GetPoint(i)[2]);
            if (place.z < 15.0) continue;
            const double* colour = piece->GetPointData()->GetScalars()->GetTuple(i);
            const DeviationColour nominal = scale.colourOf(0.0);
            QVERIFY(std::equal(nominal.begin(), nominal.end(), colour));
            ++white;
        }
    QVERIFY(white > 4);
}

/// Points that were there before a cut are not measured again: points and colours are those of a surface that is
/// measured as a whole. So they are after the tolerance has changed.
void WorkpieceMeshesTest::coloursAfterACutAreThoseOfTheWhole() {
    RunVolume volume = milled({{0.0, 0.0, 0.0}, {24.0, 20.0, 16.6}}, 0.25);
    const auto ball = std::make_shared<const MeshDistance>(sphereMesh({10.03, 10.11, 8.0}, 8.0, 400));
    const ExcessColours left{ball, {}};
    const VolumeSnapshot before = volume.snapshot();
    clear(volume, {{2.0, 9.0, 16.25}, {17.0, 11.0, 16.6}});
    const VolumeSnapshot cut = volume.snapshot();
    const Surfaces whole = surfaces(cut, 1'000'000, SurfaceLayer::rest, false, left);
    const Surfaces followed = surfaces(cut, 1'000'000, SurfaceLayer::rest, false, left, before);
    const auto same = [](vtkPolyData& one, vtkPolyData& other) {
        const auto colours = [](vtkPolyData& of) {
            return vtkUnsignedCharArray::SafeDownCast(of.GetPointData()->GetScalars());
        };
        if (one.GetNumberOfPoints() != other.GetNumberOfPoints()) return false;
        for (vtkIdType i = 0; i < one.GetNumberOfPoints(); ++i)
            for (int k = 0; k < 3; ++k)
                if (one.GetPoint(i)[k] != other.GetPoint(i)[k] ||
                    colours(one)->GetTypedComponent(i, k) != colours(other)->GetTypedComponent(i, k))
                    return false;
        return true;
    };
    QCOMPARE(followed.size(), whole.size());
    for (std::size_t i = 0; i < whole.size(); ++i) QVERIFY(same(*whole[i], *followed[i]));

    DeviationTolerance wider;
    wider.excess *= 2.0;
    WorkpieceMesher mesher({1'000'000, 10'000'000}, [] {});
    Surfaces changed(whole.size());
    for (const ExcessColours& each : {left, ExcessColours{ball, wider}}) {
        mesher.setExcess(each);
        mesher.show(cut, std::nullopt);
        for (bool busy = true; busy;) {
            QTest::qWait(10);
            busy = mesher.busy();
            for (SurfaceUpdate& update : mesher.take().updates)
                if (update.layer == SurfaceLayer::rest) changed.at(update.group) = update.data;
        }
    }
    const Surfaces anew = surfaces(cut, 1'000'000, SurfaceLayer::rest, false, ExcessColours{ball, wider});
    for (std::size_t i = 0; i < anew.size(); ++i) QVERIFY(same(*anew[i], *changed[i]) && !same(*anew[i], *whole[i]));
}

BURIN_TEST(WorkpieceMeshesTest, QCoreApplication)

} // namespace burin::tst_workpiece_meshes

#include "tst_workpiece_meshes.moc"

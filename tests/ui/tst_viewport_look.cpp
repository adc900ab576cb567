// SPDX-FileCopyrightText: 2026 The Burin authors
// SPDX-License-Identifier: Apache-2.0
#include "core/base/progress.h"
#include "core/volume/voxelisation/voxelisation.h"
#include "tests/core/volume/shapes.h"
#include "tests/test_program.h"
#include "tests/ui/viewport_fixture.h"
#include "ui/theme/colour.h"

#include <algorithm>
#include <map>

#include <QApplication>

namespace burin::tst_viewport_look {

using fixture::stock;

namespace {

/// A plate with a boss whose top is chamfered: rectangles over one another (half sizes and height, mm), closed.
std::shared_ptr<const Model> bossOnPlate() {
    const std::vector<glm::dvec3> rings{
        {25.0, 18.0, 0.0}, {25.0, 18.0, 4.0}, {12.0, 10.0, 4.0}, {12.0, 10.0, 9.0}, {8.0, 6.0, 13.0}};
    TriangleMesh mesh;
    for (const glm::dvec3& r : rings)
        for (const glm::dvec2 corner : {glm::dvec2(1, 1), glm::dvec2(-1, 1), glm::dvec2(-1, -1), glm::dvec2(1, -1)})
            mesh.vertices.emplace_back(corner.x * r.x, corner.y * r.y, r.z);
    const auto quad = [&](std::uint32_t a, std::uint32_t b, std::uint32_t c, std::uint32_t d) {
        mesh.triangles.push_back({a, b, c});
        mesh.triangles.push_back({a, c, d});
    };
    for (std::uint32_t ring = 0; ring + 1 < rings.size(); ++ring)
        for (std::uint32_t i = 0; i < 4; ++i) {
            const std::uint32_t low = 4 * ring, next = (i + 1) % 4;
            quad(low + i, low + next, low + 4 + next, low + 4 + i);
        }
    const auto top = static_cast<std::uint32_t>(4 * (rings.size() - 1));
    quad(top, top + 1, top + 2, top + 3);
    quad(3, 2, 1, 0);
    auto model = std::make_shared<Model>();
    Body body;
    body.name = "boss";
    body.mesh = std::move(mesh);
    body.box = boundingBox(body.mesh);
    model->bodies.push_back(std::move(body));
    return model;
}

/// Half sizes and heights of a bar that is rotated about Z, mm.
constexpr glm::dvec2 barHalf{14.0, 7.0};
constexpr double barTop = 9.0, floorHeight = 3.0, barTurn = 0.3;

glm::dvec3 onBar(double x, double y, double z) {
    return {x * std::cos(barTurn) - y * std::sin(barTurn), x * std::sin(barTurn) + y * std::cos(barTurn), z};
}

TriangleMesh barMesh() {
    return test::turned(test::boxMesh({-barHalf.x, -barHalf.y, 0.0}, {barHalf.x, barHalf.y, barTop}), barTurn,
                        {0.0, 0.0, 1.0}, glm::dvec3(0.0));
}

/// Stock whose floor was milled around the bar, in voxels of 0.8 mm, some 10 pixels wide.
RunVolume milledAroundBar() {
    PropertyList properties;
    Property wax, part;
    wax.id = wax.name = "wax";
    wax.colour = {190, 190, 190};
    part.id = part.name = "part";
    part.machinability = Machinability::isProtected;
    const PropertyIndex stockIndex = *properties.add(wax), partIndex = *properties.add(part);
    const Grid grid = *Grid::make({-24.0, -16.0, -2.0}, 0.8, {60, 40, 20});
    RunVolume volume = *RunVolume::make(grid, properties);
    (void)volume.fillBlock({0, 0}, {60, 40}, grid.toRunPosition(-2.0), grid.toRunPosition(floorHeight), stockIndex);
    Progress progress;
    (void)voxelise(barMesh(), partIndex, volume, progress);
    return volume;
}

/// Unmilled stock around the boss on its plate, up to a height, mm.
VolumeSnapshot blockUpTo(double top) {
    PropertyList properties;
    Property wax;
    wax.id = wax.name = "wax";
    wax.colour = {190, 190, 190};
    const PropertyIndex stockIndex = *properties.add(wax);
    const Grid grid = *Grid::make({-30.0, -22.0, -4.0}, 0.5, {120, 88, static_cast<int>(2.0 * (top + 4.0))});
    RunVolume volume = *RunVolume::make(grid, properties);
    (void)volume.fillBlock({0, 0}, {120, 88}, 0, grid.lineEnd(), stockIndex);
    return volume.snapshot();
}

double lightnessOf(const QColor& colour) {
    return contrast(colour, Qt::black); // 1 … 21
}

EvaluatedPath straight(MoveKind kind, MillingSide side) {
    EvaluatedPath path;
    path.path.points = {{{{-7.0, 0.0, 13.0}}, kind, 0.0, 0, -1}, {{{7.0, 0.0, 13.0}}, kind, 0.0, 0, -1}};
    path.sides = {{0, 1, side}};
    return path;
}

} // namespace

/// How the scene looks: light, edges, shadow, and lines that stand out.
class TestViewportLook : public QObject {
    Q_OBJECT

private slots:
    void initTestCase() {
        rig_ = std::make_unique<fixture::ViewportWindow>();
        viewport_ = rig_->viewport;
        viewport_->setToolVisible(false);
        viewport_->setPart(bossOnPlate());
        QTRY_VERIFY(rig_->ready());
    }
    void init() {
        viewport_->setPalette3D(fixture::palette());
        viewport_->setStandardView(StandardView::top);
        viewport_->setStockOutline(std::nullopt);
    }

    /// Faces that face the eye equally or lean by the same angle, and a floor below a top, differ in lightness.
    void facesOfAPrismDifferFromAbove() {
        const QImage image = viewport_->grabFramebuffer();
        const std::map<QString, glm::dvec3> faces{{"top", {2.0, 1.0, 13.0}},    {"floor", {18.0, 13.0, 4.0}},
                                                  {"left", {-10.0, 1.0, 11.0}}, {"right", {10.0, 1.0, 11.0}},
                                                  {"back", {2.0, 8.0, 11.0}},   {"front", {2.0, -8.0, 11.0}}};
        for (const auto& [one, at] : faces)
            for (const auto& [other, beside] : faces) {
                if (one == other) continue;
                const double ratio = lightnessOf(pixelAt(image, at)) / lightnessOf(pixelAt(image, beside));
                QVERIFY2(std::max(ratio, 1.0 / ratio) > 1.06, qPrintable(one + " and " + other));
            }
        QVERIFY(rig_->save("viewport-prism-above", image));
        viewport_->setStandardView(StandardView::isometric);
        QVERIFY(rig_->save("viewport-prism"));
    }

    /// The top is red as the file has it and stays so whatever the colour of the body; bare in the workpiece all of the
    /// part is blue.
    void facesHaveTheirOwnColours() {
        auto model = std::make_shared<Model>(*bossOnPlate());
        model->bodies.front().faceColours = {{32, 2, {220, 20, 20}}}; // after 4 rings of 4 sides with 2 triangles each
        viewport_->setPart(model);
        const glm::dvec3 top(2.0, 1.0, 13.0), floor(18.0, 13.0, 4.0);
        const auto isRed = [&](const QImage& image, const glm::dvec3& place) {
            const QColor colour = pixelAt(image, place);
            return colour.red() > colour.blue() + 60 && colour.red() > colour.green() + 60;
        };
        const auto isBlue = [&](const QImage& image, const glm::dvec3& place) {
            const QColor colour = pixelAt(image, place);
            return colour.blue() > colour.red() + 40;
        };
        QTRY_VERIFY(isRed(viewport_->grabFramebuffer(), top));
        QImage image = viewport_->grabFramebuffer();
        QVERIFY(isBlue(image, floor) && isBlue(image, {-10.0, 1.0, 11.0}));
        QVERIFY(rig_->save("viewport-face-colours", image));
        viewport_->setBodyColours({QColor(240, 220, 40)});
        QTRY_VERIFY(!isBlue(viewport_->grabFramebuffer(), floor));
        image = viewport_->grabFramebuffer();
        QVERIFY(isRed(image, top));
        QVERIFY(pixelAt(image, floor).green() > pixelAt(image, floor).blue() + 60);
        viewport_->setBodyColours({});
        viewport_->setPartVisible(false);
        viewport_->setWorkpiece(blockUpTo(6.0));
        rig_->settle();
        QVERIFY(isBlue(viewport_->grabFramebuffer(), top));
        viewport_->setWorkpiece({});
        viewport_->setPartVisible(true);
        viewport_->setPart(bossOnPlate());
        QTRY_VERIFY(rig_->ready());
    }

    /// From above a vertical wall is only a line, so that line has to be dark.
    void edgesOfAPrismAreDarkLines() {
        const QImage image = viewport_->grabFramebuffer();
        const double ratio = viewport_->devicePixelRatio();
        for (const glm::dvec3& edge : {glm::dvec3(8.0, 0.5, 13.0), glm::dvec3(1.0, -6.0, 13.0)}) {
            const QPoint at = (viewport_->project(edge) * ratio).toPoint();
            const int reach = static_cast<int>(3 * ratio);
            double darkest = 21.0;
            for (int dy = -reach; dy <= reach; ++dy)
                for (int dx = -reach; dx <= reach; ++dx)
                    darkest = std::min(darkest, lightnessOf(image.pixelColor(at + QPoint(dx, dy))));
            const double beside = std::min(lightnessOf(pixelAt(image, edge * glm::dvec3(0.9, 0.9, 1.0))),
                                           lightnessOf(pixelAt(image, edge * glm::dvec3(1.1, 1.1, 0.95))));
            QVERIFY2(darkest < 0.6 * beside, qPrintable(QStringLiteral("%1 %2").arg(darkest).arg(beside)));
        }
    }

    void aPathStandsOutFromThePart_data() {
        QTest::addColumn<int>("theme");
        QTest::newRow("dark") << static_cast<int>(Theme::dark);
        QTest::newRow("light") << static_cast<int>(Theme::light);
    }
    void aPathStandsOutFromThePart() {
        QFETCH(int, theme);
        const Palette palette = *loadPalette(static_cast<Theme>(theme));
        viewport_->setPalette3D(palette);
        const QImage bare = viewport_->grabFramebuffer();
        const auto check = [&](const QColor& line) {
            const QImage image = viewport_->grabFramebuffer();
            const QString name = line.name();
            QVERIFY2(linePixels(image, line) >= 2.0 * viewport_->devicePixelRatio(), qPrintable(name));
            QVERIFY2(linePixels(image, palette.pathHalo) >= 2.0 * viewport_->devicePixelRatio(), qPrintable(name));
            const QColor ground = pixelAt(bare, {3.0, 0.0, 13.0});
            QVERIFY2(std::max(contrast(line, ground), contrast(palette.pathHalo, ground)) >= 3.0, qPrintable(name));
        };
        viewport_->setPath(straight(MoveKind::cut, MillingSide::climb));
        check(palette.path);
        QVERIFY(rig_->save(theme == 0 ? "viewport-path-dark" : "viewport-path-light"));
        viewport_->setPath(straight(MoveKind::cut, MillingSide::conventional));
        check(palette.conventionalPath);
        viewport_->setPath(straight(MoveKind::retract, MillingSide::climb));
        check(palette.rapidPath);
        viewport_->setPathVisible(false);
        viewport_->appendLivePath(std::vector<glm::vec3>{{-7.0F, 0.0F, 13.0F}, {7.0F, 0.0F, 13.0F}}, true);
        check(palette.livePath);
        viewport_->clearLivePath();
        viewport_->setMoveMark({{{-7.0, 0.0, 13.0}, {7.0, 0.0, 13.0}}});
        check(palette.chosenPath);
        viewport_->setMoveMark({});
        viewport_->setPathVisible(true);
        viewport_->setPath({});
    }

    /// The shadow gets lighter with the distance; from below the bench hides nothing that stands on it.
    void theBenchCastsASoftShadow() {
        viewport_->setStockOutline(stock);
        viewport_->setStandardView(StandardView::top);
        rig_->wheel(QPointF(viewport_->rect().center()), -4); // so that some of the bench is visible
        rig_->settle();
        const QImage image = viewport_->grabFramebuffer();
        const glm::dvec3 near{31.0, 2.5, -4.0}, far{38.0, 2.5, -4.0};
        QVERIFY(lightnessOf(pixelAt(image, near)) < 0.93 * lightnessOf(pixelAt(image, far)));
        viewport_->setStandardView(StandardView::bottom);
        const QImage below = viewport_->grabFramebuffer();
        QVERIFY(lightnessOf(pixelAt(below, near)) > 0.98 * lightnessOf(pixelAt(below, far)));
    }

    /// However light or dark the scene below it is.
    void theScaleStandsOnAPlate() {
        rig_->wheel(QPointF(viewport_->rect().center()), 20); // the part's top fills the view
        rig_->settle();
        const QImage image = viewport_->grabFramebuffer();
        const double ratio = viewport_->devicePixelRatio();
        const QPoint corner(static_cast<int>(18 * ratio), image.height() - static_cast<int>(19 * ratio));
        const QColor plate = image.pixelColor(corner), ground = image.pixelColor(QPoint(corner.x() / 3, corner.y()));
        QVERIFY(contrast(plate, ground) > 2.0);
        QVERIFY(contrast(fixture::palette().text, plate) >= 7.0);
        int ink = 0;
        for (int y = image.height() - static_cast<int>(50 * ratio); y < image.height(); ++y)
            for (int x = 0; x < static_cast<int>(150 * ratio); ++x)
                if (image.pixelColor(x, y) == fixture::palette().text) ++ink;
        QVERIFY(ink > 60 * ratio);
        QVERIFY(rig_->save("viewport-scale", image));
    }

    /// Otherwise every frame would have to draw its triangles.
    void aPartThatStockHidesIsNotDrawn() {
        viewport_->setPartVisible(false);
        viewport_->setWorkpiece(blockUpTo(18.0));
        rig_->settle();
        const std::size_t withPart = viewport_->statistics().triangles;
        viewport_->setPart(nullptr);
        rig_->settle();
        QVERIFY(withPart > 0);
        QCOMPARE(withPart, viewport_->statistics().triangles);
        viewport_->setWorkpiece({});
        viewport_->setPartVisible(true);
    }

    /// Outside the voxels nothing is known to hide the part.
    void aPartThatStandsOutOfTheStockIsSeen() {
        viewport_->setPart(bossOnPlate());
        QTRY_VERIFY(rig_->ready());
        viewport_->setPartVisible(false);
        viewport_->setWorkpiece(blockUpTo(6.0));
        rig_->settle();
        const QImage image = viewport_->grabFramebuffer();
        QVERIFY(rig_->save("viewport-part-out-of-stock", image));
        const auto isPart = [&](const glm::dvec3& place) {
            const QColor colour = pixelAt(image, place);
            return colour.blue() > colour.red() + 40;
        };
        for (const glm::dvec3& place : {glm::dvec3(2.0, 1.0, 13.0), {-10.0, 1.0, 11.0}, {2.0, 8.0, 11.0}})
            QVERIFY(isPart(place));
        QVERIFY(!isPart({18.0, 13.0, 6.0})); // stock above the plate
        viewport_->setWorkpiece({});
    }

    /// Drawn up to its edges and no farther, not up to the border of its voxels, which are ten pixels wide.
    void barePartIsDrawnWhereItLies() {
        auto model = std::make_shared<Model>();
        model->bodies.emplace_back();
        model->bodies.back().mesh = barMesh();
        model->bodies.back().box = boundingBox(model->bodies.back().mesh);
        viewport_->setPart(model);
        RunVolume volume = milledAroundBar();
        viewport_->setWorkpiece(volume.snapshot());
        viewport_->setPartVisible(false); // its visibility switch: the part is still seen where the workpiece is bare
        viewport_->fit();
        rig_->settle();
        const QImage image = viewport_->grabFramebuffer();
        QVERIFY(rig_->save("viewport-bare-part", image));
        const double pixel = 1.0 / (glm::distance(at(1.0), at(0.0)) * viewport_->devicePixelRatio()); // mm
        QVERIFY(pixel < 0.15);
        const auto isPart = [&](const glm::dvec3& place) {
            const QColor colour = pixelAt(image, place);
            return colour.blue() > colour.red() + 40;
        };
        const double line = 4.0 * pixel; // the width of the edge itself, with a pixel on each side
        for (int i = -20; i <= 20; ++i) {
            const double x = 0.9 * barHalf.x * i / 20.0, y = 0.9 * barHalf.y * i / 20.0;
            for (const double side : {-1.0, 1.0}) {
                QVERIFY(isPart(onBar(x, side * (barHalf.y - line), barTop)));
                QVERIFY(isPart(onBar(side * (barHalf.x - line), y, barTop)));
                QVERIFY(!isPart(onBar(x, side * (barHalf.y + line), barTop)));
                QVERIFY(!isPart(onBar(side * (barHalf.x + line), y, barTop)));
            }
        }
        viewport_->setWorkpiece({});
    }

    /// Although it is drawn in pieces, it looks like one: the side of a block, below the part in it, is uniform.
    void aTransparentWorkpieceShowsNoSeams() {
        Property wax;
        wax.id = wax.name = "wax";
        wax.colour = {190, 190, 190};
        PropertyList properties;
        const PropertyIndex stockIndex = *properties.add(wax);
        RunVolume volume = *RunVolume::make(*Grid::make({-24.0, -12.0, -2.0}, 0.125, {384, 192, 64}), properties);
        (void)volume.fillBlock({0, 0}, {384, 192}, volume.grid().toRunPosition(-2.0), volume.grid().toRunPosition(6.0),
                               stockIndex);
        viewport_->setPartVisible(false);
        viewport_->setWorkpiece(volume.snapshot());
        viewport_->setWorkpieceOpacity(0.5);
        viewport_->setStandardView(StandardView::front);
        rig_->settle();
        const QImage image = viewport_->grabFramebuffer();
        QVERIFY(rig_->save("viewport-glass", image));
        const QColor middle = pixelAt(image, {0.3, -12.0, -1.0});
        QVERIFY(middle != pixelAt(image, {-25.0, -12.0, -1.0})); // it is drawn
        for (double x = -23.0; x <= 23.0; x += 0.05)
            QVERIFY2(std::abs(pixelAt(image, {x, -12.0, -1.0}).lightness() - middle.lightness()) <= 3,
                     qPrintable(QString::number(x)));
        viewport_->setWorkpieceOpacity(1.0);
        viewport_->setWorkpiece({});
    }

    void cleanupTestCase() { rig_.reset(); }

private:
    /// The position on the screen, device-independent pixels.
    glm::dvec2 at(double x) const {
        const QPointF place = viewport_->project({x, 0.0, barTop});
        return {place.x(), place.y()};
    }
    QColor pixelAt(const QImage& image, const glm::dvec3& place) const {
        return image.pixelColor((viewport_->project(place) * viewport_->devicePixelRatio()).toPoint());
    }
    /// The number of pixels of a colour across the straight path.
    int linePixels(const QImage& image, const QColor& colour) const {
        const QPoint at = (viewport_->project({3.0, 0.0, 13.0}) * viewport_->devicePixelRatio()).toPoint();
        int count = 0;
        for (int dy = -12; dy <= 12; ++dy) {
            const QColor pixel = image.pixelColor(at + QPoint(0, dy));
            if (std::abs(pixel.red() - colour.red()) <= 2 && std::abs(pixel.green() - colour.green()) <= 2 &&
                std::abs(pixel.blue() - colour.blue()) <= 2)
                ++count;
        }
        return count;
    }

    std::unique_ptr<fixture::ViewportWindow> rig_;
    Viewport* viewport_ = nullptr;
};

BURIN_TEST(TestViewportLook, QApplication)

} // namespace burin::tst_viewport_look

#include "tst_viewport_look.moc"

// SPDX-FileCopyrightText: 2026 The Burin authors
// SPDX-License-Identifier: Apache-2.0
#include "tests/test_program.h"
#include "tests/ui/viewport_fixture.h"

#include <QApplication>
#include <QElapsedTimer>
#include <QSignalSpy>
#include <QStackedWidget>

namespace burin::tst_viewport_picture {

using fixture::marksAt;
using fixture::radii;
using fixture::stock;

namespace {

/// A stroke over the dome at one x.
std::vector<glm::vec3> wave(float x) {
    std::vector<glm::vec3> tips;
    for (int i = 0; i <= 400; ++i) {
        const float y = -16.0F + 0.08F * static_cast<float>(i);
        const float inside = 1.0F - x * x / 576.0F - y * y / 256.0F;
        tips.emplace_back(x, y, std::max(4.0F, 14.0F * std::sqrt(std::max(0.0F, inside))));
    }
    return tips;
}

Path somePath() {
    Path path;
    const auto add = [&path](double x, double y, double z, MoveKind kind) {
        path.points.push_back({{{x, y, z}}, kind, 0.0, 0, -1});
    };
    add(-26.0, -18.0, 26.0, MoveKind::rapid);
    for (double x = -26.0; x < -2.0; x += 6.0) {
        add(x, -18.0, 26.0, MoveKind::rapid);
        add(x, -18.0, 4.0, MoveKind::plunge);
        for (const glm::vec3& tip : wave(static_cast<float>(x))) add(tip.x, tip.y, tip.z, MoveKind::cut);
        add(x, 18.0, 4.0, MoveKind::cut);
        add(x, 18.0, 26.0, MoveKind::retract);
    }
    return path;
}

double pixels(const QPointF& a, const QPointF& b) {
    return std::hypot(a.x() - b.x(), a.y() - b.y());
}

/// The number of a picture's pixels in a rectangle that have about the hue of a colour and at least a share of its
/// lightness.
int countLike(const QImage& image, const QRect& where, const QColor& colour, int tolerance) {
    int count = 0;
    for (int y = std::max(0, where.top()); y <= std::min(image.height() - 1, where.bottom()); ++y)
        for (int x = std::max(0, where.left()); x <= std::min(image.width() - 1, where.right()); ++x) {
            const QColor pixel = image.pixelColor(x, y);
            if (std::abs(pixel.red() - colour.red()) <= tolerance &&
                std::abs(pixel.green() - colour.green()) <= tolerance &&
                std::abs(pixel.blue() - colour.blue()) <= tolerance)
                ++count;
        }
    return count;
}

bool alike(const QColor& one, const QColor& other, int tolerance) {
    return std::abs(one.red() - other.red()) <= tolerance && std::abs(one.green() - other.green()) <= tolerance &&
           std::abs(one.blue() - other.blue()) <= tolerance;
}

TriangleMesh boxMesh(const Box& box) {
    TriangleMesh mesh;
    for (int i = 0; i < 8; ++i)
        mesh.vertices.emplace_back((i & 1) != 0 ? box.high.x : box.low.x, (i & 2) != 0 ? box.high.y : box.low.y,
                                   (i & 4) != 0 ? box.high.z : box.low.z);
    for (const auto& [a, b, c, d] : {std::array<std::uint32_t, 4>{0, 2, 3, 1},
                                     {4, 5, 7, 6},
                                     {0, 1, 5, 4},
                                     {2, 6, 7, 3},
                                     {0, 4, 6, 2},
                                     {1, 3, 7, 5}}) {
        mesh.triangles.push_back({a, b, c});
        mesh.triangles.push_back({a, c, d});
    }
    return mesh;
}

} // namespace

/// What the viewport draws.
class TestViewportPicture : public QObject {
    Q_OBJECT

private slots:
    void initTestCase() {
        rig_ = std::make_unique<fixture::ViewportWindow>();
        viewport_ = rig_->viewport;
        QTRY_VERIFY(rig_->ready());
    }

    void init() {
        viewport_->setInteractiveTool(nullptr);
        viewport_->setStandardView(StandardView::isometric);
    }

    /// A view that was warmed up while something else was shown draws the same as any other.
    void warmingUpLeavesNothingBehind() {
        QMainWindow window;
        auto* pages = new QStackedWidget;
        auto* warm = new Viewport;
        pages->addWidget(new QWidget);
        pages->addWidget(warm);
        window.setCentralWidget(pages);
        window.resize(rig_->window->size());
        window.show();
        QVERIFY(QTest::qWaitForWindowExposed(&window));
        QSignalSpy painted(warm, &Viewport::painted);
        warm->warmUp();
        QTest::qWait(100);
        QCOMPARE(painted.count(), 0);
        QVERIFY(warm->contentBox().empty());
        pages->setCurrentWidget(warm);
        QTest::qWait(100);
        QCOMPARE(warm->statistics().triangles, std::size_t{0}); // the view is empty
        fixture::ViewportWindow::fill(*warm);
        QTRY_COMPARE(warm->contentBox().size(), viewport_->contentBox().size());
        rig_->settle();
        const QImage expected = viewport_->grabFramebuffer();
        QTRY_VERIFY(warm->grabFramebuffer() == expected);
    }

    /// What is drawn appears where project() says: the exact tip of the tool, drawn alone in front of the background.
    void theToolAppearsWhereItIsProjected() {
        viewport_->setStandardView(StandardView::front);
        for (const glm::dvec3& tip : {glm::dvec3(-20.0, 0.0, 10.0), glm::dvec3(21.0, 3.0, 12.0)}) {
            viewport_->setToolMarks(marksAt(tip));
            const QImage image = viewport_->grabFramebuffer();
            viewport_->setToolVisible(false);
            const QImage without = viewport_->grabFramebuffer();
            viewport_->setToolVisible(true);
            const double ratio = viewport_->devicePixelRatio();
            QRect drawn;
            for (int y = 0; y < image.height(); ++y)
                for (int x = 0; x < image.width(); ++x)
                    if (image.pixel(x, y) != without.pixel(x, y)) drawn |= QRect(x, y, 1, 1);
            const QPointF at = viewport_->project(tip) * ratio;
            QVERIFY(std::abs(drawn.bottom() - at.y()) <= 2.0 * ratio);
            // The lowest row of the ball is around its tip.
            int low = image.width(), high = 0;
            for (int x = 0; x < image.width(); ++x)
                if (image.pixel(x, drawn.bottom() - 1) != without.pixel(x, drawn.bottom() - 1)) {
                    low = std::min(low, x);
                    high = std::max(high, x);
                }
            QVERIFY(std::abs(0.5 * (low + high) - at.x()) <= 2.0 * ratio);
        }
    }

    void theLayersOfTheToolAreToldApart() {
        viewport_->setStandardView(StandardView::front);
        viewport_->setToolMarks(marksAt({0.0, -30.0, 0.0}));
        const QImage image = viewport_->grabFramebuffer();
        const double ratio = viewport_->devicePixelRatio();
        const auto colourAt = [&](double height) {
            const QPointF at = viewport_->project({-0.8, -30.0, height}) * ratio;
            return image.pixelColor(at.toPoint());
        };
        const QColor flutes = colourAt(5.0), shank = colourAt(15.0);
        QVERIFY(flutes.lightness() > shank.lightness() + 25);
    }

    void showsTheBench() {
        volume_ = std::make_unique<RunVolume>(fixture::milledBlock(stock, 0.25, radii));
        const auto cut = std::chrono::steady_clock::now();
        viewport_->resetStatistics();
        viewport_->setWorkpiece(volume_->snapshot(), cut);
        ToolMarks marks = marksAt({-9.0, -7.0, 12.4});
        marks.stylusTip = {-8.0, -6.0, 9.5};
        marks.force = {-0.9, -0.6, 1.4};
        marks.ghost = true;
        viewport_->setToolMarks(marks);
        for (float x = -20.0F; x < -8.0F; x += 2.0F) viewport_->appendLivePath(wave(x), true);
        QTRY_VERIFY_WITH_TIMEOUT(viewport_->statistics().fullDetail, 30000);
        rig_->settle();
        const FrameStatistics statistics = viewport_->statistics();
        QCOMPARE(statistics.cutsShown, std::size_t{1});
        QVERIFY(statistics.triangles > 1000);
        const QImage image = viewport_->grabFramebuffer();
        QVERIFY(countLike(image, image.rect(), fixture::palette().force, 3) > 60);     // the arrow
        QVERIFY(countLike(image, image.rect(), fixture::palette().livePath, 3) > 200); // the path
        QVERIFY(rig_->save("viewport-workpiece"));
        qInfo("paint p95 %.1f ms, longest %.1f ms, cut to screen %.1f ms, %zu triangles", statistics.paintP95,
              statistics.paintMaximum, statistics.cutToScreenMaximum, statistics.triangles);
    }

    /// From above shank and holder (10 mm in radius) cover the work, which is seen through them, nearly as without
    /// them.
    void theHolderFadesWhereItHidesTheWork() {
        volume_ = std::make_unique<RunVolume>(fixture::milledBlock(stock, 0.25, radii));
        viewport_->setWorkpiece(volume_->snapshot());
        viewport_->setStandardView(StandardView::top);
        viewport_->setToolMarks(marksAt({-9.0, -7.0, 30.0})); // parked above the milled side, where the part is visible
        QTRY_VERIFY_WITH_TIMEOUT(viewport_->statistics().fullDetail, 30000);
        rig_->settle();
        QVERIFY(rig_->save("viewport-faded-holder"));
        const QImage with = viewport_->grabFramebuffer();
        viewport_->setToolVisible(false);
        const QImage without = viewport_->grabFramebuffer();
        viewport_->setToolVisible(true);
        const QPointF tip = viewport_->project({-9.0, -7.0, 30.0}), side = viewport_->project({-4.0, -7.0, 30.0});
        const double ratio = viewport_->devicePixelRatio(), pixel = pixels(side, tip) * ratio / 5.0; // pixels per mm
        int seen = 0;
        for (int i = 0; i < 12; ++i) { // a ring of 6 mm: beside the flutes (3 mm), under the holder
            const double angle = 0.3 + i * pi / 6.0;
            const QPoint at = (tip * ratio + 6.0 * pixel * QPointF(std::cos(angle), std::sin(angle))).toPoint();
            const QColor now = with.pixelColor(at), bare = without.pixelColor(at);
            QVERIFY(now != bare); // but the tool is still drawn
            const int off = std::max({std::abs(now.red() - bare.red()), std::abs(now.green() - bare.green()),
                                      std::abs(now.blue() - bare.blue())});
            if (off < 80) ++seen;
        }
        QCOMPARE(seen, 12);
        // From the side the tool hides nothing and is fully opaque, in front of the background and of the stock.
        viewport_->setStandardView(StandardView::front);
        viewport_->setToolMarks(marksAt({0.0, -30.0, -15.0}));
        rig_->settle();
        const QColor shank =
            viewport_->grabFramebuffer().pixelColor((viewport_->project({-2.0, -34.0, 10.0}) * ratio).toPoint());
        const QColor expected = fixture::palette().shank;
        QVERIFY(std::abs(shank.hslHueF() - expected.hslHueF()) < 0.06 && shank.lightness() > 60);
        viewport_->setStandardView(StandardView::isometric);
    }

    /// A clamp above the work is opaque while nothing is cut under it. Where it lies between the eye and the cut, or
    /// the point that a press would cut, the work is seen through it, nearly as without it.
    void aFixtureFadesWhereItHidesTheCut() {
        volume_ = std::make_unique<RunVolume>(fixture::milledBlock(stock, 0.25, radii));
        viewport_->setWorkpiece(volume_->snapshot());
        viewport_->setStandardView(StandardView::top);
        const glm::dvec3 under(-9.0, -7.0, 12.4), aside(24.0, 16.0, 30.0);
        Obstacle clamp;
        clamp.name = "clamp";
        clamp.shape = Box{{under.x - 8.0, under.y - 8.0, 22.0}, {under.x + 8.0, under.y + 8.0, 30.0}};
        const std::vector<ObstacleMark> clamped{{std::make_shared<const Obstacle>(clamp), true, false}};
        const double ratio = viewport_->devicePixelRatio();
        const auto pictureOf = [&](const glm::dvec3& tip, const std::vector<ObstacleMark>& obstacles) {
            viewport_->setToolMarks(marksAt(tip));
            viewport_->setObstacles(obstacles);
            rig_->settle();
            return viewport_->grabFramebuffer();
        };
        // Two rows of points beside the flutes, within the clamp.
        const auto colours = [&](const QImage& image) {
            std::vector<QColor> found;
            for (int i = -6; i <= 6; i += 2)
                for (const glm::dvec2 at : {glm::dvec2(i, -6.5), glm::dvec2(i, 6.5)})
                    found.push_back(image.pixelColor(
                        (viewport_->project({under.x + at.x, under.y + at.y, 30.0}) * ratio).toPoint()));
            return found;
        };
        const auto seenThrough = [&](const QImage& image, const QImage& bare) {
            const std::vector<QColor> now = colours(image), without = colours(bare);
            for (std::size_t i = 0; i < now.size(); ++i)
                if (!alike(now[i], without[i], 40) || now[i] == without[i]) return false; // but still drawn
            return true;
        };
        const auto solid = [&](const QImage& image) {
            const std::vector<QColor> now = colours(image);
            return std::ranges::all_of(now, [&](const QColor& colour) {
                return alike(colour, now.front(), 6) && std::abs(colour.red() - colour.blue()) < 60 &&
                       alike(colour, fixture::palette().holder, 60);
            });
        };
        QTRY_VERIFY_WITH_TIMEOUT(solid(pictureOf(aside, clamped)), 30000); // its mesh is made on another thread
        QVERIFY(rig_->save("viewport-solid-fixture"));
        const QImage bare = pictureOf(under, {}), bareAside = pictureOf(aside, {});
        QTRY_VERIFY_WITH_TIMEOUT(seenThrough(pictureOf(under, clamped), bare), 30000);
        QVERIFY(rig_->save("viewport-faded-fixture"));
        QVERIFY(solid(pictureOf(aside, clamped))); // it is opaque again
        viewport_->setPressMark(PressMark{under, {0.0, 0.0, 1.0}, 3.0, 1.0, std::nullopt});
        QVERIFY(seenThrough(viewport_->grabFramebuffer(), bareAside));
        viewport_->setPressMark({});
        QVERIFY(solid(viewport_->grabFramebuffer()));
        // Beside the cut it stays opaque: seen from the front it is behind the tool.
        viewport_->setToolMarks(marksAt({under.x, -24.0, 24.0}));
        viewport_->setStandardView(StandardView::front);
        rig_->settle();
        const QColor front = viewport_->grabFramebuffer().pixelColor(
            (viewport_->project({under.x - 7.0, under.y - 8.0, 26.0}) * ratio).toPoint());
        QVERIFY(alike(front, fixture::palette().holder, 60));
        viewport_->setObstacles({});
        viewport_->setStandardView(StandardView::isometric);
    }

    void anAlarmFlashesAndCarriesAnOutline() {
        ToolMarks marks = marksAt({-9.0, -7.0, 12.4});
        marks.alarm = true;
        viewport_->setToolMarks(marks);
        QTest::qWait(60);
        const QColor red = fixture::palette().force;
        int least = 1'000'000, most = 0;
        for (int i = 0; i < 12; ++i) {
            QTest::qWait(60);
            const QImage image = viewport_->grabFramebuffer();
            int reddish = 0;
            for (int y = 0; y < image.height(); y += 3)
                for (int x = 0; x < image.width(); x += 3) {
                    const QColor pixel = image.pixelColor(x, y);
                    if (pixel.red() > 2 * pixel.green() && pixel.red() > 2 * pixel.blue()) ++reddish;
                }
            QVERIFY(countLike(image, image.rect(), red, 2) > 500); // the outline stays
            least = std::min(least, reddish);
            most = std::max(most, reddish);
            if (i == 0) QVERIFY(rig_->save("viewport-alarm"));
        }
        QVERIFY(most > least + 200);
        marks.alarm = false;
        viewport_->setToolMarks(marks);
        rig_->settle();
        QSignalSpy painted(viewport_, &Viewport::painted);
        QTest::qWait(400);
        QCOMPARE(painted.count(), 0); // and nothing flashes any longer
    }

    void theMovesOfAnEditedPathAreToldApart() {
        viewport_->clearLivePath();
        EvaluatedPath path;
        path.path = somePath();
        viewport_->setPath(path);
        const Palette palette = fixture::palette();
        const QImage climbing = viewport_->grabFramebuffer();
        const int cuts = countLike(climbing, climbing.rect(), palette.path, 3);
        const int pink = countLike(climbing, climbing.rect(), palette.conventionalPath, 3);
        QVERIFY(cuts > 200);
        // Half of the path is reversed.
        const std::size_t last = path.path.points.size() - 1;
        path.sides = {{1, last / 2, MillingSide::climb}, {last / 2 + 1, last, MillingSide::conventional}};
        viewport_->setPath(path);
        const QImage image = viewport_->grabFramebuffer();
        QVERIFY(countLike(image, image.rect(), palette.path, 3) < 3 * cuts / 4);
        QVERIFY(countLike(image, image.rect(), palette.conventionalPath, 3) > pink + cuts / 4);
        QVERIFY(countLike(image, image.rect(), palette.plungePath, 6) > 20);
        QVERIFY(rig_->save("viewport-path"));
        // The part of the path that an edit left out is red, even if it is too short for a line.
        const auto red = [&] {
            const QImage now = viewport_->grabFramebuffer();
            return countLike(now, now.rect(), palette.force, 3);
        };
        const int none = red();
        const glm::dvec3 from = path.path.points[last / 2].pose.tip + glm::dvec3(0.0, 0.0, 6.0);
        EditReport report;
        report.omissions = {{OmissionReason::shank, 1, 0, 9, {from, from + glm::dvec3(1e-3, 0.0, 0.0)}, 1e-3}};
        path.reports = {report};
        viewport_->setPath(path);
        const int dot = red();
        QVERIFY2(dot > none + 8, qPrintable(QString::number(dot)));
        path.reports.front().omissions.front().line.back() = from + glm::dvec3(12.0, 4.0, 0.0);
        viewport_->setPath(path);
        QVERIFY(red() > dot + 60);
        QVERIFY(rig_->save("viewport-path-omission"));
        viewport_->setPathVisible(false);
        QCOMPARE(countLike(viewport_->grabFramebuffer(), image.rect(), palette.path, 3), 0);
        QCOMPARE(red(), none);
    }

    /// A plate with 0.3 mm of stock on its left half, a gouge in it, and nothing measured on the right: each is shown
    /// by its colour, and the part's own colour is not visible anywhere.
    void theDeviationIsASurfaceInTheColoursOfItsScale() {
        const glm::dvec3 half(24.0, 16.0, 5.0);
        auto plate = std::make_shared<Model>();
        Body body;
        body.mesh = boxMesh({-half, half});
        body.box = boundingBox(body.mesh);
        plate->bodies.push_back(body);
        auto samples = std::make_shared<std::vector<DeviationSample>>();
        for (double x = -23.75; x < 0.0; x += 0.5)
            for (double y = -15.75; y < 16.0; y += 0.5) samples->push_back({{x, y, half.z}, 0.3, 0.0, true});
        DeviationSample& gouge = (*samples)[samples->size() / 2];
        gouge.gouge = 0.4;
        gouge.excess = 0.0;
        viewport_->setPart(plate);
        viewport_->setPartVisible(true);
        viewport_->setWorkpieceVisible(false);
        viewport_->setToolVisible(false);
        viewport_->setStockOutline(std::nullopt);
        viewport_->setStandardView(StandardView::top);
        viewport_->setDeviations({samples, {0.02, 0.1, 0.0}, 0.5});
        const double ratio = viewport_->devicePixelRatio();
        QImage image;
        const auto pixel = [&](double x, double y) {
            return image.pixelColor((viewport_->project({x, y, half.z}) * ratio).toPoint());
        };
        const QColor expected(120, 180, 213); // a third of the way from the colour of 0.2 mm to that of 0.5 mm
        QTRY_VERIFY((image = viewport_->grabFramebuffer(), alike(pixel(-6.0, 7.0), expected, 12)));
        for (double x = -23.0; x < -1.0; x += 0.37)
            for (double y = -15.0; y < 15.0; y += 0.41)
                if (glm::distance(glm::dvec2(x, y), glm::dvec2(gouge.place)) > 1.5)
                    QVERIFY(alike(pixel(x, y), expected, 12));
        const QColor deep = pixel(gouge.place.x, gouge.place.y); // 0.4 mm: the deepest of the scale
        QVERIFY(deep.red() > 100 && deep.red() > 3 * deep.green() && deep.red() > 2 * deep.blue());
        int dark = 0, light = 0;
        for (double x = 2.0; x < 23.0; x += 0.1) {
            const QColor grey = pixel(x, 3.0);
            QVERIFY(std::abs(grey.red() - grey.blue()) < 16 && std::abs(grey.red() - grey.green()) < 12);
            ++(grey.green() < 95 ? dark : light);
        }
        QVERIFY(dark > 40 && light > 80); // hatched
        QVERIFY(rig_->save("viewport-deviation"));
        viewport_->setStandardView(StandardView::isometric);
        rig_->settle();
        QVERIFY(rig_->save("viewport-deviation-isometric"));
        // Without deviations the part is drawn as before.
        viewport_->setDeviations({});
        viewport_->setStandardView(StandardView::top);
        image = viewport_->grabFramebuffer();
        QVERIFY(pixel(-6.0, 7.0).blue() > pixel(-6.0, 7.0).red() + 60);
        viewport_->setPart(fixture::model(radii));
        viewport_->setWorkpieceVisible(true);
        viewport_->setToolVisible(true);
        viewport_->setStockOutline(stock);
    }

    /// The excess grows from 0 to 2 mm along a dome: each point has the colour of its value, apart from shading.
    void theDeviationOfACurvedPartIsContinuous() {
        const auto excessAt = [](double x) { return std::pow((x + radii.x) / (2.0 * radii.x), 3.0) * 2.0; };
        auto samples = std::make_shared<std::vector<DeviationSample>>();
        for (double x = -radii.x; x < radii.x; x += 0.5)
            for (double y = -radii.y; y < radii.y; y += 0.5) {
                const double inside = 1.0 - x * x / (radii.x * radii.x) - y * y / (radii.y * radii.y);
                if (inside > 0.0) samples->push_back({{x, y, radii.z * std::sqrt(inside)}, excessAt(x), 0.0, true});
            }
        viewport_->setPart(fixture::model(radii));
        viewport_->setPartVisible(true);
        viewport_->setWorkpieceVisible(false);
        viewport_->setToolVisible(false);
        viewport_->setStandardView(StandardView::top);
        viewport_->setDeviations({samples, {0.02, 0.1, 0.0}, 0.5});
        const double ratio = viewport_->devicePixelRatio();
        QImage image;
        const auto pixel = [&](double x, double y) {
            const double z = radii.z * std::sqrt(1.0 - x * x / (radii.x * radii.x) - y * y / (radii.y * radii.y));
            return image.pixelColor((viewport_->project({x, y, z}) * ratio).toPoint());
        };
        QTRY_VERIFY((image = viewport_->grabFramebuffer(), pixel(-12.0, 1.0).red() > 190)); // 0.03 mm: nearly white
        // Values and colours of the legend; between them the colours are interpolated.
        const std::vector<std::pair<double, glm::dvec3>> legend{{0.0, {247, 247, 247}}, {0.1, {209, 229, 240}},
                                                                {0.2, {146, 197, 222}}, {0.5, {67, 147, 195}},
                                                                {1.0, {42, 114, 181}},  {2.0, {23, 74, 140}}};
        for (double x = -15.0; x <= 17.0; x += 1.0) {
            const double value = excessAt(x);
            std::size_t above = 1;
            while (legend[above].first < value) ++above;
            const auto& [low, lowColour] = legend[above - 1];
            const auto& [high, highColour] = legend[above];
            const glm::dvec3 expected = glm::mix(lowColour, highColour, (value - low) / (high - low));
            const QColor drawn = pixel(x, 1.0);
            const glm::dvec3 found(drawn.red(), drawn.green(), drawn.blue());
            const double shade = glm::dot(found, expected) / glm::dot(expected, expected);
            QVERIFY2(shade > 0.6 && shade < 1.06 && glm::distance(found, shade * expected) < 16.0,
                     qPrintable(QString("%1 mm at %2: %3").arg(value).arg(x).arg(drawn.name())));
        }
        viewport_->setStandardView(StandardView::isometric);
        rig_->settle();
        QVERIFY(rig_->save("viewport-deviation-dome"));
        viewport_->setDeviations({});
        viewport_->setWorkpieceVisible(true);
        viewport_->setToolVisible(true);
    }

    void anHourOfPathStaysCheap() {
        QElapsedTimer timer;
        timer.start();
        qint64 slowest = 0;
        for (int i = 0; i < 3000; ++i) {
            std::vector<glm::vec3> tips;
            for (int k = 0; k < 16; ++k) {
                const float angle = 0.05F * static_cast<float>(16 * i + k);
                tips.emplace_back(20.0F * std::cos(angle), 20.0F * std::sin(1.37F * angle), 19.0F);
            }
            const qint64 before = timer.nsecsElapsed();
            viewport_->appendLivePath(tips, i == 0);
            slowest = std::max(slowest, timer.nsecsElapsed() - before);
        }
        qInfo("48000 points in %lld ms, slowest 16 points %.2f ms", timer.elapsed(),
              static_cast<double>(slowest) / 1e6);
        QVERIFY(countLike(viewport_->grabFramebuffer(), viewport_->rect(), fixture::palette().livePath, 3) > 5000);
        viewport_->clearLivePath();
    }

    void survivesAnotherParent() {
        QTest::mouseMove(viewport_, {300, 500}); // outside the view cube
        rig_->settle();
        const QImage before = viewport_->grabFramebuffer();
        {
            QMainWindow other; // another window: another context
            other.setCentralWidget(viewport_);
            other.resize(rig_->window->size());
            other.show();
            QVERIFY(QTest::qWaitForWindowExposed(&other));
            rig_->settle();
            after_ = viewport_->grabFramebuffer();
            rig_->window->setCentralWidget(viewport_);
        }
        QCOMPARE(after_.size(), before.size());
        QRect different;
        for (int y = 0; y < before.height(); ++y)
            for (int x = 0; x < before.width(); ++x)
                if (before.pixel(x, y) != after_.pixel(x, y)) different |= QRect(x, y, 1, 1);
        QVERIFY(different.isEmpty());
    }

    void cleanupTestCase() { rig_.reset(); }

private:
    std::unique_ptr<fixture::ViewportWindow> rig_;
    Viewport* viewport_ = nullptr;
    std::unique_ptr<RunVolume> volume_;
    QImage after_;
};

BURIN_TEST(TestViewportPicture, QApplication)

} // namespace burin::tst_viewport_picture

#include "tst_viewport_picture.moc"

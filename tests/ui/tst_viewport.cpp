// SPDX-FileCopyrightText: 2026 The Burin authors
// SPDX-License-Identifier: Apache-2.0
#include "tests/ui/bench_fixture.h"
#include "ui/scene/viewport.h"

#include <QApplication>
#include <QDir>
#include <QMainWindow>
#include <QProcess>
#include <QProxyStyle>
#include <QSignalSpy>
#include <QTest>
#include <QWheelEvent>

using namespace burin;

namespace {

constexpr const char* screenshots = BURIN_BUILD_DIRECTORY "/tests/screenshots/";
const Box stock{{-30.0, -22.0, -4.0}, {30.0, 22.0, 18.0}};
const glm::dvec3 radii{24.0, 16.0, 14.0};

/// As a desktop that asks for reduced motion.
class StillStyle : public QProxyStyle {
public:
    int styleHint(StyleHint hint, const QStyleOption* option, const QWidget* widget,
                  QStyleHintReturn* data) const override {
        return hint == SH_Widget_Animation_Duration ? 0 : QProxyStyle::styleHint(hint, option, widget, data);
    }
};

ToolMarks marksAt(const glm::dvec3& tip) {
    ToolMarks marks;
    marks.proxy.tip = tip;
    marks.stylusTip = tip;
    return marks;
}

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
        path.points.push_back({{x, y, z}, kind, 0.0, 0, -1});
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

/// Takes what it is told to and remembers what it saw.
class Recorder : public InteractiveTool {
public:
    bool press(const ViewportEvent& event) override { return note("press", event); }
    bool move(const ViewportEvent& event) override { return note("move", event); }
    bool release(const ViewportEvent& event) override { return note("release", event); }
    bool wheel(const ViewportEvent& event) override { return note("wheel", event); }
    bool key(int key, Qt::KeyboardModifiers) override {
        keys.push_back(key);
        return takes;
    }
    void leave() override { ++left; }
    bool note(const char* what, const ViewportEvent& event) {
        seen.push_back(QString::fromLatin1(what));
        last = event;
        return takes;
    }
    QStringList seen;
    std::vector<int> keys;
    ViewportEvent last;
    bool takes = true;
    int left = 0;
};

double pixels(const QPointF& a, const QPointF& b) {
    return std::hypot(a.x() - b.x(), a.y() - b.y());
}

/// How many of a picture's pixels near a place are about a colour's hue and at least as light as a share of it.
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

} // namespace

class TestViewport : public QObject {
    Q_OBJECT

private slots:
    void initTestCase() {
        if (qEnvironmentVariableIsSet("BURIN_TEST_OLD_OPENGL")) return;
        QApplication::setStyle(new StillStyle);
        QDir().mkpath(QString::fromLatin1(screenshots));
        window_ = std::make_unique<QMainWindow>();
        viewport_ = new Viewport(window_.get());
        window_->setCentralWidget(viewport_);
        window_->resize(1000, 700);
        viewport_->setPalette3D(fixture::palette());
        viewport_->setPart(fixture::model(radii));
        viewport_->setStockOutline(stock);
        viewport_->setTool(fixture::ballTool());
        viewport_->setToolMarks(marksAt({6.0, -4.0, 20.0}));
        window_->show();
        QVERIFY(QTest::qWaitForWindowExposed(window_.get()));
        QTRY_VERIFY(picks({0.0, 0.0, 14.0})); // the part is shaded on another thread
        settle();
        save("viewport-part");
    }

    void init() {
        if (!viewport_) return;
        viewport_->setInteractiveTool(nullptr);
        viewport_->setStandardView(StandardView::isometric);
    }

    void sightAndProjectionAreInverse() {
        for (const QPoint& at : {QPoint(10, 10), QPoint(500, 350), QPoint(990, 20), QPoint(333, 600)}) {
            const ViewportEvent event = viewport_->sight(at);
            QVERIFY(std::abs(glm::length(event.rayDirection) - 1.0) < 1e-12);
            QVERIFY(pixels(viewport_->project(event.rayOrigin + 137.0 * event.rayDirection), at) < 1e-6);
        }
    }

    /// What is drawn stands where project() says: the very tip of the tool, drawn alone before the background.
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

    void orbitTurnsWithoutRolling() {
        const glm::dvec3 before = viewport_->sight({500.0, 350.0}).rayDirection;
        drag(Qt::RightButton, {500, 350}, {620, 300});
        const glm::dvec3 after = viewport_->sight({500.0, 350.0}).rayDirection;
        QVERIFY(glm::distance(before, after) > 0.2);
        // z still points up in the picture: two places above each other share their column in the middle.
        const glm::dvec3 centre = stock.centre();
        const QPointF low = viewport_->project(centre), high = viewport_->project(centre + glm::dvec3(0.0, 0.0, 1.0));
        QVERIFY(high.y() < low.y());
        const ViewportEvent left = viewport_->sight({0.0, 350.0}), right = viewport_->sight({1000.0, 350.0});
        QVERIFY(std::abs(glm::normalize(left.rayDirection - right.rayDirection).z) < 1e-9);
    }

    void orbitKeepsThePlaceUnderThePointer() {
        const glm::dvec3 summit(0.0, 0.0, 14.0);
        const QPointF at = viewport_->project(summit);
        drag(Qt::MiddleButton, at.toPoint(), at.toPoint() + QPoint(90, 20));
        QVERIFY(pixels(viewport_->project(summit), at) < 3.0); // the pointer stands on whole pixels
    }

    void panMovesThePlaceWithThePointer() {
        const glm::dvec3 summit(0.0, 0.0, 14.0);
        const QPoint at = viewport_->project(summit).toPoint();
        drag(Qt::MiddleButton, at, at + QPoint(70, -40), Qt::ShiftModifier);
        QVERIFY(pixels(viewport_->project(summit), at + QPoint(70, -40)) <= 2.0);
    }

    void zoomKeepsThePlaceUnderThePointer() {
        const glm::dvec3 summit(0.0, 0.0, 14.0);
        const QPointF at = viewport_->project(summit);
        const double before = pixels(viewport_->project({5.0, 0.0, 0.0}), viewport_->project({0.0, 0.0, 0.0}));
        wheel(at, 3);
        QVERIFY(pixels(viewport_->project(summit), at) <= 1.0);
        QVERIFY(pixels(viewport_->project({5.0, 0.0, 0.0}), viewport_->project({0.0, 0.0, 0.0})) > 1.3 * before);
        viewport_->fit();
        QVERIFY(std::abs(pixels(viewport_->project({5.0, 0.0, 0.0}), viewport_->project({0.0, 0.0, 0.0})) - before) <
                1e-6);
    }

    void standardViewsLookTheRightWay() {
        const auto along = [this](StandardView view) {
            viewport_->setStandardView(view);
            return viewport_->sight(QPointF(0.5 * viewport_->width(), 0.5 * viewport_->height())).rayDirection;
        };
        QVERIFY(glm::distance(along(StandardView::top), {0.0, 0.0, -1.0}) < 1e-9);
        QVERIFY(glm::distance(along(StandardView::front), {0.0, 1.0, 0.0}) < 1e-9);
        QVERIFY(glm::distance(along(StandardView::right), {-1.0, 0.0, 0.0}) < 1e-9);
        for (const Box& box : {stock})
            for (const glm::dvec3& corner : {box.low, box.high})
                QVERIFY(QRectF(viewport_->rect()).contains(viewport_->project(corner)));
    }

    void aClickOnTheCubeSetsItsView() {
        // The top face of the cube is the upper one in the isometric view.
        const QPoint top(viewport_->width() - 60, 40);
        QTest::mouseMove(viewport_, top);
        save("viewport-cube");
        QTest::mouseClick(viewport_, Qt::LeftButton, Qt::NoModifier, top);
        QVERIFY(glm::distance(viewport_->sight({500.0, 350.0}).rayDirection, glm::dvec3(0.0, 0.0, -1.0)) < 0.05);
    }

    void anActiveToolIsAskedFirst() {
        Recorder tool;
        viewport_->setInteractiveTool(&tool);
        const glm::dvec3 before = viewport_->sight({500.0, 350.0}).rayDirection;
        QTest::mousePress(viewport_, Qt::LeftButton, Qt::ShiftModifier, {400, 300});
        QCOMPARE(tool.last.button, Qt::LeftButton);
        QCOMPARE(tool.last.modifiers, Qt::ShiftModifier);
        QCOMPARE(tool.last.rayDirection, viewport_->sight({400.0, 300.0}).rayDirection);
        QTest::mouseRelease(viewport_, Qt::LeftButton, Qt::NoModifier, {400, 300});
        wheel({400.0, 300.0}, 2);
        QCOMPARE(tool.last.wheelSteps, 2.0);
        QCOMPARE(viewport_->sight({500.0, 350.0}).rayDirection, before);
        viewport_->setFocus();
        QTest::keyClick(viewport_, Qt::Key_Escape);
        QCOMPARE(tool.keys.back(), static_cast<int>(Qt::Key_Escape));
        tool.takes = false;
        drag(Qt::RightButton, {500, 350}, {560, 350});
        QVERIFY(viewport_->sight({500.0, 350.0}).rayDirection != before);
        viewport_->setInteractiveTool(nullptr);
        QCOMPARE(tool.left, 1);
    }

    void nothingIsDrawnInVain() {
        viewport_->setToolMarks(marksAt({6.0, -4.0, 20.0}));
        settle();
        QSignalSpy painted(viewport_, &Viewport::painted);
        for (int i = 0; i < 10; ++i) {
            viewport_->setToolMarks(marksAt({6.0, -4.0, 20.0})); // the same again
            QTest::qWait(50);
        }
        QCOMPARE(painted.count(), 0);
    }

    void manyChangesMakeOnePaint() {
        QSignalSpy painted(viewport_, &Viewport::painted);
        for (int i = 0; i < 50; ++i) viewport_->setToolMarks(marksAt({0.1 * i, -4.0, 20.0}));
        QTRY_VERIFY(painted.count() > 0);
        QVERIFY(painted.count() <= 2);
        settle();
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
        QTRY_VERIFY_WITH_TIMEOUT(viewport_->statistics().fullDetail, 5000);
        settle();
        const FrameStatistics statistics = viewport_->statistics();
        QCOMPARE(statistics.cutsShown, std::size_t{1});
        QVERIFY(statistics.triangles > 1000);
        const QImage image = viewport_->grabFramebuffer();
        QVERIFY(countLike(image, image.rect(), fixture::palette().force, 3) > 60);     // the arrow
        QVERIFY(countLike(image, image.rect(), fixture::palette().livePath, 3) > 200); // the path
        save("viewport-bench");
        qInfo("paint p95 %.1f ms, longest %.1f ms, cut to screen %.1f ms, %zu triangles", statistics.paintP95,
              statistics.paintMaximum, statistics.cutToScreenMaximum, statistics.triangles);
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
            if (i == 0) save("viewport-alarm");
        }
        QVERIFY(most > least + 200);
        marks.alarm = false;
        viewport_->setToolMarks(marks);
        settle();
        QSignalSpy painted(viewport_, &Viewport::painted);
        QTest::qWait(400);
        QCOMPARE(painted.count(), 0); // and nothing flashes any more
    }

    void theMovesOfAnEditedPathAreToldApart() {
        viewport_->clearLivePath();
        viewport_->setPath(somePath());
        const QImage image = viewport_->grabFramebuffer();
        const Palette palette = fixture::palette();
        QVERIFY(countLike(image, image.rect(), palette.path, 3) > 200);
        QVERIFY(countLike(image, image.rect(), palette.text, 6) > 20);
        save("viewport-path");
        viewport_->setPathVisible(false);
        QCOMPARE(countLike(viewport_->grabFramebuffer(), image.rect(), palette.path, 3), 0);
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
        QTest::mouseMove(viewport_, {300, 500}); // off the cube
        settle();
        const QImage before = viewport_->grabFramebuffer();
        {
            QMainWindow other; // another window: another context
            other.setCentralWidget(viewport_);
            other.resize(window_->size());
            other.show();
            QVERIFY(QTest::qWaitForWindowExposed(&other));
            settle();
            after_ = viewport_->grabFramebuffer();
            window_->setCentralWidget(viewport_);
        }
        QCOMPARE(after_.size(), before.size());
        QRect different;
        for (int y = 0; y < before.height(); ++y)
            for (int x = 0; x < before.width(); ++x)
                if (before.pixel(x, y) != after_.pixel(x, y)) different |= QRect(x, y, 1, 1);
        QVERIFY(different.isEmpty());
    }

    void tellsWhenOpenGlIsMissingOrTooOld_data() {
        QTest::addColumn<QString>("platform");
        QTest::addColumn<QString>("version");
        QTest::newRow("none") << "offscreen"
                              << "";
        QTest::newRow("2.1") << "xcb"
                             << "2.1";
    }
    void tellsWhenOpenGlIsMissingOrTooOld() {
        if (qEnvironmentVariableIsSet("BURIN_TEST_OLD_OPENGL")) return;
        QFETCH(QString, platform);
        QFETCH(QString, version);
        QProcessEnvironment environment = QProcessEnvironment::systemEnvironment();
        environment.insert("BURIN_TEST_OLD_OPENGL", "1");
        environment.insert("QT_QPA_PLATFORM", platform);
        if (!version.isEmpty()) environment.insert("MESA_GL_VERSION_OVERRIDE", version);
        QProcess child;
        child.setProcessEnvironment(environment);
        child.start(QApplication::applicationFilePath(), {QStringLiteral("drawingFails")});
        QVERIFY(child.waitForFinished(30000));
        QVERIFY2(child.exitCode() == 0, child.readAllStandardOutput().constData());
    }
    /// Runs in the child of the test above.
    void drawingFails() {
        if (!qEnvironmentVariableIsSet("BURIN_TEST_OLD_OPENGL")) return;
        QVERIFY(Viewport::drawingObstacle().contains("OpenGL 3.2"));
        if (QGuiApplication::platformName() == "offscreen") return; // none at all: no viewport is made
        Viewport viewport;
        QSignalSpy failed(&viewport, &Viewport::drawingFailed);
        viewport.resize(300, 200);
        viewport.setTool(fixture::ballTool());
        viewport.show();
        QTRY_COMPARE(failed.count(), 1);
        QVERIFY(failed.at(0).at(0).toString().contains("OpenGL 3.2"));
        viewport.setToolMarks(marksAt({1.0, 2.0, 3.0}));
        QTest::qWait(100); // nothing is drawn, nothing crashes
        QCOMPARE(viewport.statistics().frames, std::size_t{0});
    }

    void cleanupTestCase() {
        viewport_ = nullptr;
        window_.reset();
    }

private:
    /// Until the last motion is over and full detail is drawn.
    void settle() { QTest::qWait(420); }
    bool picks(const glm::dvec3& place) {
        viewport_->update();
        const QPointF at = viewport_->project(place + glm::dvec3(0.0, 0.0, -1.0)) * viewport_->devicePixelRatio();
        const QColor pixel = viewport_->grabFramebuffer().pixelColor(at.toPoint());
        return pixel.blue() > pixel.red() + 60;
    }
    void drag(Qt::MouseButton button, const QPoint& from, const QPoint& to,
              Qt::KeyboardModifiers modifiers = Qt::NoModifier) {
        QTest::mousePress(viewport_, button, modifiers, from);
        for (int i = 1; i <= 5; ++i) {
            const QPoint at = from + (to - from) * i / 5;
            QMouseEvent move(QEvent::MouseMove, at, viewport_->mapToGlobal(at), Qt::NoButton, button, modifiers);
            QApplication::sendEvent(viewport_, &move);
        }
        QTest::mouseRelease(viewport_, button, modifiers, to);
    }
    void wheel(const QPointF& at, int notches) {
        QWheelEvent event(at, viewport_->mapToGlobal(at), QPoint(), QPoint(0, 120 * notches), Qt::NoButton,
                          Qt::NoModifier, Qt::NoScrollPhase, false);
        QApplication::sendEvent(viewport_, &event);
    }
    void save(const char* name) {
        const QString ratio = viewport_->devicePixelRatio() > 1.5 ? QStringLiteral("@2x") : QString();
        QVERIFY(viewport_->grabFramebuffer().save(QString::fromLatin1(screenshots) + QString::fromLatin1(name) + ratio +
                                                  QStringLiteral(".png")));
    }

    std::unique_ptr<QMainWindow> window_;
    Viewport* viewport_ = nullptr;
    std::unique_ptr<RunVolume> volume_;
    QImage after_;
};

QTEST_MAIN(TestViewport)
#include "tst_viewport.moc"

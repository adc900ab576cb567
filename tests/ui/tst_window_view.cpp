// SPDX-FileCopyrightText: 2026 The Burin authors
// SPDX-License-Identifier: Apache-2.0
#include "tests/long_run.h"
#include "tests/test_program.h"
#include "tests/ui/window_steps.h"

#include <QApplication>
#include <QDoubleSpinBox>
#include <QSlider>
#include <QtTest>

#include <cmath>

namespace burin::tst_window_view {

using namespace burin::testing;

namespace {

/// The rectangle in which two pictures of the same size differ, pixels.
QRect difference(const QImage& a, const QImage& b) {
    QRect differs;
    for (int y = 0; y < a.height(); ++y)
        for (int x = 0; x < a.width(); ++x)
            if (a.pixel(x, y) != b.pixel(x, y)) differs |= QRect(x, y, 1, 1);
    return differs;
}

/// The difference between two colours, 0 … 255.
int apart(const QColor& a, const QColor& b) {
    return std::max({std::abs(a.red() - b.red()), std::abs(a.green() - b.green()), std::abs(a.blue() - b.blue())});
}

bool startMilling(WindowDriver& driver) {
    if (!driver.step(JobStep::mill)) return false;
    driver.key(Qt::Key_M);
    return driver.waitFor([&] { return driver.window().workbench().mill.active(); });
}

bool pressed(const QAction* action) {
    return action != nullptr && action->isChecked();
}

} // namespace

/// Settings of the view, and what milling shows in it.
class TestWindowView : public QObject {
    Q_OBJECT
private slots:
    void aClickInTheParallelTopViewCutsThere();
    void thePartAndThePlaceOfAPressAreSeenThroughTheStock();
    void theProjectionIsRemembered();
    BURIN_ONLY_IN_LONG_RUNS void theSliderShowsThePartThroughTheWorkpiece();
    void aSectionShowsWhatIsInside();
};

/// In a plan view, the point under a pixel follows by proportion from the borders of the stock in the picture.
void TestWindowView::aClickInTheParallelTopViewCutsThere() {
    WindowDriver driver;
    QVERIFY(makeReady(driver));
    Workbench& workbench = driver.window().workbench();
    Viewport& viewport = driver.window().viewport();
    QVERIFY(driver.step(JobStep::mill));
    driver.key(Qt::Key_1);
    QTest::qWait(800);
    const QImage stock = viewport.grabFramebuffer();
    driver.key(Qt::Key_2, Qt::ControlModifier);
    QTest::qWait(300);
    const QRect borders = difference(stock, viewport.grabFramebuffer());
    driver.key(Qt::Key_2, Qt::ControlModifier);
    const Box box = workbench.setup.setup().stock;
    const double scale = box.size().x / borders.width(); // mm a pixel
    QVERIFY(std::abs(box.size().y / borders.height() - scale) < 0.01 * scale);

    QVERIFY(startMilling(driver));
    const QPoint at = borders.topLeft() + QPoint(borders.width() / 5, borders.height() / 4);
    const glm::dvec2 expected(box.low.x + (at.x() + 0.5 - borders.left()) * scale,
                              box.high.y - (at.y() + 0.5 - borders.top()) * scale);
    QTest::mouseMove(&viewport, at);
    QTest::qWait(300);
    QTest::mousePress(&viewport, Qt::LeftButton, Qt::NoModifier, at);
    QTest::qWait(600);
    QVERIFY(workbench.session.state().cutting);
    const glm::dvec3 tip = workbench.session.state().sample.proxy.tip;
    driver.shoot("30-top-view");
    QTest::mouseRelease(&viewport, Qt::LeftButton, Qt::NoModifier, at);
    QVERIFY(glm::distance(glm::dvec2(tip), expected) < 1.5 * scale);
    QVERIFY(tip.z < box.high.z);
    QVERIFY(driver.waitFor([&] { return !workbench.session.state().cutting; }));
    QTest::qWait(300); // before the tool has risen, Esc would end only the stroke
    driver.key(Qt::Key_Escape);
    QVERIFY(driver.waitFor([&] { return !workbench.session.running(); }));
}

void TestWindowView::thePartAndThePlaceOfAPressAreSeenThroughTheStock() {
    WindowDriver driver;
    QVERIFY(makeReady(driver));
    Workbench& workbench = driver.window().workbench();
    Viewport& viewport = driver.window().viewport();
    QVERIFY(startMilling(driver));
    const Box part = workbench.model.model()->box(), stock = workbench.setup.setup().stock;
    const glm::dvec3 place(part.centre().x - 5.0, part.low.y + 6.0, stock.high.z);
    const auto bareView = [&] { // the tool stays where it is, the pointer is elsewhere
        QEvent leave(QEvent::Leave);
        QApplication::sendEvent(&viewport, &leave);
        QTest::qWait(500);
        return viewport.grabFramebuffer();
    };
    QTest::mouseMove(&viewport, viewport.project(place).toPoint());
    QTest::qWait(900);
    const QImage hovering = viewport.grabFramebuffer();
    driver.shoot("31-ghost");
    const QImage bare = bareView();
    // An edge at the foot of the part and the outline of the cutter, both deep within the stock.
    const double ratio = viewport.devicePixelRatioF();
    const auto drawn = [&](const glm::dvec3& where) {
        const QPoint at = (viewport.project(where) * ratio).toPoint();
        int most = 0;
        for (int dx = -1; dx <= 1; ++dx)
            for (int dy = -1; dy <= 1; ++dy)
                most = std::max(most,
                                apart(hovering.pixelColor(at + QPoint(dx, dy)), bare.pixelColor(at + QPoint(dx, dy))));
        return most;
    };
    QVERIFY(drawn({part.high.x, part.low.y, part.low.z + 8.0}) > 40); // a vertical edge
    QVERIFY(drawn({part.high.x - 9.0, part.low.y, part.low.z}) > 40);
    // A millimetre deep, according to the depth of cut, or as deep as the part permits.
    const double radius = workbench.workpiece.milling()->tool.cutter.radius();
    const double depth = std::min(1.0, stock.high.z - part.high.z);
    QVERIFY(drawn({place.x - radius, place.y, stock.high.z - depth}) > 25);
    QVERIFY(drawn({place.x, place.y - radius, stock.high.z - depth}) > 25);
    // While the tool cuts, nothing of that is drawn.
    QTest::mouseMove(&viewport, viewport.project(place).toPoint());
    QTest::mousePress(&viewport, Qt::LeftButton, Qt::NoModifier, viewport.project(place).toPoint());
    QTest::qWait(500);
    const QImage cutting = viewport.grabFramebuffer();
    QTest::mouseRelease(&viewport, Qt::LeftButton, Qt::NoModifier, viewport.project(place).toPoint());
    const QPoint foot = (viewport.project({part.high.x - 9.0, part.low.y, part.low.z}) * ratio).toPoint();
    QVERIFY(apart(cutting.pixelColor(foot), bare.pixelColor(foot)) < 12);
    QVERIFY(driver.waitFor([&] { return workbench.workpiece.strokes().count() == 1; })); // else Esc ends the stroke
    driver.key(Qt::Key_Escape);
    QVERIFY(driver.waitFor([&] { return !workbench.session.running(); }));
}

void TestWindowView::theProjectionIsRemembered() {
    WindowDriver driver;
    const auto isParallel = [&] {
        Viewport& viewport = driver.window().viewport();
        return viewport.sight({10.0, 10.0}).rayDirection == viewport.sight({400.0, 300.0}).rayDirection;
    };
    QVERIFY(makeReady(driver, 1.0));
    QVERIFY(!isParallel());
    driver.key(Qt::Key_P);
    QVERIFY(pressed(menuAction(driver, QStringLiteral("parallelViewAction"))));
    QVERIFY(driver.waitFor(isParallel));
    QTest::qWait(500);
    driver.shoot("32-parallel");
    QVERIFY(driver.restart(true));
    QVERIFY(pressed(menuAction(driver, QStringLiteral("parallelViewAction"))));
    QVERIFY(isParallel());
    driver.key(Qt::Key_P);
    QVERIFY(driver.waitFor([&] { return !isParallel(); }));
}

void TestWindowView::theSliderShowsThePartThroughTheWorkpiece() {
    WindowDriver driver;
    QVERIFY(makeReady(driver));
    Viewport& viewport = driver.window().viewport();
    const Box part = driver.window().workbench().model.model()->box();
    const double ratio = viewport.devicePixelRatioF();
    const auto bluish = [&] { // at a face of the part, deep within the green stock
        QTest::qWait(600);
        const glm::dvec3 place(part.high.x, part.centre().y, part.centre().z);
        const QColor colour = viewport.grabFramebuffer().pixelColor((viewport.project(place) * ratio).toPoint());
        return colour.blue() - colour.green();
    };
    auto* slider = driver.visible<QSlider>("transparencySlider");
    QVERIFY(slider != nullptr);
    const int opaque = bluish();
    slider->setFocus();
    for (int i = 0; i < 3; ++i) QTest::keyClick(slider, Qt::Key_PageUp);
    QVERIFY(pressed(menuAction(driver, QStringLiteral("seeThroughAction"))));
    const int through = bluish();
    driver.shoot("33-transparent");
    QVERIFY(through > opaque + 15);
    // The stock beside the part is still visible: without it, the scene behind it would be.
    const Box stock = driver.window().workbench().setup.setup().stock;
    const QPoint foot = (viewport.project({stock.high.x, stock.centre().y, stock.low.z + 2.0}) * ratio).toPoint();
    const QColor glass = viewport.grabFramebuffer().pixelColor(foot);
    driver.key(Qt::Key_2, Qt::ControlModifier);
    QTest::qWait(600);
    QVERIFY(apart(glass, viewport.grabFramebuffer().pixelColor(foot)) > 8);
    driver.key(Qt::Key_2, Qt::ControlModifier);
    QTest::qWait(300);
    driver.key(Qt::Key_I);
    QCOMPARE(slider->value(), 0);
    QVERIFY(std::abs(bluish() - opaque) < 6);
    driver.key(Qt::Key_I); // as transparent as before
    QCOMPARE(slider->value(), 60);
    QVERIFY(driver.restart(true));
    QCOMPARE(driver.window().findChild<QSlider*>("transparencySlider")->value(), 60);
}

/// The block lies 5 mm within its stock: a cut through its middle shows a frame of stock around it.
void TestWindowView::aSectionShowsWhatIsInside() {
    WindowDriver driver;
    QVERIFY(makeReady(driver));
    Workbench& workbench = driver.window().workbench();
    Viewport& viewport = driver.window().viewport();
    const Box part = workbench.model.model()->box(), stock = workbench.setup.setup().stock;
    const double ratio = viewport.devicePixelRatioF();
    const auto isPart = [&](const glm::dvec3& place) {
        const QColor colour = viewport.grabFramebuffer().pixelColor((viewport.project(place) * ratio).toPoint());
        return colour.blue() > colour.green() + 20;
    };
    driver.key(Qt::Key_S);
    QTest::qWait(700);
    const double middle = stock.centre().y;
    const glm::dvec3 inPart(part.low.x + 2.0, middle, part.low.z + 2.0),
        inStock(stock.low.x + 2.0, middle, stock.low.z + 2.0);
    driver.shoot("34-section");
    QVERIFY(isPart(inPart));
    QVERIFY(!isPart(inStock));
    const auto picked = viewport.pick(viewport.project(inPart)); // the pointer hits the visible face
    QVERIFY(picked && glm::distance(*picked, inPart) < 0.5);
    // The field moves it into the stock before the part.
    QVERIFY(driver.enter("sectionField", QLocale().toString(stock.low.y + 2.0)));
    QTest::qWait(700);
    QVERIFY(!isPart({inPart.x, stock.low.y + 2.0, inPart.z}));
    // Moved back by the handle, at the upper corner of the section's outline: 3 % of the diagonal beyond the stock.
    const double beyond = 0.03 * glm::length(stock.size());
    const glm::dvec3 grip(stock.high.x + beyond, stock.low.y + 2.0, stock.high.z + beyond);
    const QPoint from = viewport.project(grip).toPoint();
    const QPoint to = viewport.project({grip.x, middle, grip.z}).toPoint();
    QTest::mouseMove(&viewport, from);
    QTest::mousePress(&viewport, Qt::LeftButton, Qt::NoModifier, from);
    for (int i = 1; i <= 10; ++i) {
        const QPoint at = from + (to - from) * i / 10;
        QMouseEvent move(QEvent::MouseMove, at, viewport.mapToGlobal(at), Qt::NoButton, Qt::LeftButton, Qt::NoModifier);
        QApplication::sendEvent(&viewport, &move);
        QTest::qWait(20);
    }
    QTest::mouseRelease(&viewport, Qt::LeftButton, Qt::NoModifier, to);
    const auto* field = driver.visible<QDoubleSpinBox>("sectionField");
    QVERIFY(field != nullptr);
    QVERIFY(std::abs(field->value() - middle) < 0.5);
    QTest::qWait(700);
    QVERIFY(isPart({inPart.x, field->value(), inPart.z}));
    // Milling goes on, and the cut face follows.
    const double before = workbench.workpiece.milling()->workpieceVolume();
    QVERIFY(recordLine(driver, {-15.0, 5.0}, {15.0, 5.0}));
    QVERIFY(workbench.workpiece.milling()->workpieceVolume() < before);
    driver.shoot("35-section-milled");
    driver.key(Qt::Key_S);
    QTest::qWait(700);
    QVERIFY(!isPart(inPart));
    QVERIFY(driver.visible<QWidget>("sectionField") == nullptr);
}

BURIN_TEST(TestWindowView, QApplication)

} // namespace burin::tst_window_view

#include "tst_window_view.moc"

// SPDX-FileCopyrightText: 2026 The Burin authors
// SPDX-License-Identifier: Apache-2.0
#include "tests/test_program.h"
#include "tests/ui/window_steps.h"

#include <QApplication>
#include <QCheckBox>
#include <QComboBox>
#include <QScrollArea>
#include <QtTest>

#include <algorithm>
#include <cmath>

namespace burin::tst_window_guides {

using namespace burin::testing;

namespace {

/// Scrolls a widget of the mill page into view.
void scrollTo(WindowDriver& driver, const char* name) {
    auto* page = driver.visible<QScrollArea>("millPage");
    auto* widget = driver.window().findChild<QWidget*>(QLatin1String(name));
    if (page && widget) page->ensureWidgetVisible(widget);
    QCoreApplication::processEvents();
}

} // namespace

class TestWindowGuides : public QObject {
    Q_OBJECT
private slots:
    void aStrokeBesideAPlaneIsMilledOnIt();
};

void TestWindowGuides::aStrokeBesideAPlaneIsMilledOnIt() {
    WindowDriver driver;
    Workbench& workbench = driver.window().workbench();
    QVERIFY(makeReady(driver));
    QVERIFY(driver.step(JobStep::mill));
    auto* kind = driver.window().findChild<QComboBox*>("guideKind");
    QVERIFY(kind);
    kind->setCurrentIndex(1);
    scrollTo(driver, "addGuideButton");
    QVERIFY(driver.clickOn("addGuideButton"));
    QVERIFY(driver.waitFor([&] { return workbench.guides.guides().size() == 1; }));
    QCOMPARE(workbench.guides.guides()[0].kind, GuideKind::plane);
    Guide plane = workbench.guides.guides()[0];
    plane.direction = {0, 1, 0};
    const double zero = workbench.setup.setup().workOffset.y; // strokes are given relative to program zero
    plane.point.y = zero;
    workbench.guides.change(0, plane);

    QVERIFY(driver.clickOn("millButton"));
    QVERIFY(driver.waitFor([&] { return workbench.mill.active(); }));
    double farthest = 0.0, wanted = 0.0;
    bool told = false;
    QObject::connect(&workbench.session, &SessionRunner::ticked, this, [&] {
        const SessionState& state = workbench.session.state();
        if (state.guides[0].is != GuideNews::Is::holding) return; // a guide does not catch a stylus farther away
        told = true;
        if (!state.cutting || std::abs(state.sample.proxy.tip.x - workbench.setup.setup().workOffset.x) > 8.0) return;
        farthest = std::max(farthest, std::abs(state.sample.proxy.tip.y - zero));
        wanted = std::max(wanted, std::abs(state.sample.stylusTip.y - zero));
    });
    // On a busy machine the window is notified of few ticks: a whole stroke may pass without one in its middle.
    for (std::size_t stroke = 1; stroke <= 5 && wanted <= 1.0; ++stroke) {
        millLine(driver, {-20, 1.2}, {20, 1.2});
        QVERIFY(driver.waitFor([&] { return workbench.workpiece.strokes().count() == stroke; }));
    }
    QVERIFY(told);
    QVERIFY2(wanted > 1.0, qPrintable(QString::number(wanted)));
    QVERIFY2(farthest < 0.01, qPrintable(QString::number(farthest)));
    scrollTo(driver, "recentreButton");
    driver.shoot("guides");
    scrollTo(driver, "levelAboveButton");
    driver.shoot("guides-cards");

    driver.key(Qt::Key_Escape);
    QVERIFY(driver.waitFor([&] { return !workbench.session.running(); }));
    driver.key(Qt::Key_G); // all guides, by the keyboard
    QVERIFY(driver.waitFor([&] { return !workbench.guides.on(); }));
    const auto* guidesSwitch = driver.window().findChild<QCheckBox*>("guidesSwitch");
    QVERIFY(driver.waitFor([&] { return !guidesSwitch->isChecked(); }));
}

BURIN_TEST(TestWindowGuides, QApplication)

} // namespace burin::tst_window_guides

#include "tst_window_guides.moc"

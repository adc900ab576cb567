// SPDX-FileCopyrightText: 2026 The Burin authors
// SPDX-License-Identifier: Apache-2.0
#include "tests/test_program.h"
#include "tests/ui/window_steps.h"
#include "ui/panels/notice.h"

#include <QApplication>
#include <QCheckBox>
#include <QFile>
#include <QScrollArea>
#include <QtTest>

#include <algorithm>
#include <cmath>

namespace burin::tst_window_surroundings {

using namespace burin::testing;

namespace {

bool scrollTo(WindowDriver& driver, const char* page, const char* name) {
    auto* area = driver.visible<QScrollArea>(page);
    auto* widget = driver.window().findChild<QWidget*>(QLatin1String(name));
    if (area == nullptr || widget == nullptr) return false;
    area->ensureWidgetVisible(widget);
    QCoreApplication::processEvents();
    return true;
}

/// The largest X coordinate of the tip from program zero while it cut, mm.
class Farthest {
public:
    explicit Farthest(Workbench& workbench) : workbench_(workbench) {
        connection_ = QObject::connect(&workbench.session, &SessionRunner::ticked, [this] {
            const SessionState& state = workbench_.session.state();
            if (state.cutting)
                farthest_ = std::max(farthest_, state.sample.proxy.tip.x - workbench_.setup.setup().workOffset.x);
        });
    }
    ~Farthest() { QObject::disconnect(connection_); }
    double get() const { return farthest_; }

private:
    Workbench& workbench_;
    QMetaObject::Connection connection_;
    double farthest_ = -1e9;
};

} // namespace

class TestWindowSurroundings : public QObject {
    Q_OBJECT
private slots:
    void theToolKeepsOutOfAFixture();
};

void TestWindowSurroundings::theToolKeepsOutOfAFixture() {
    WindowDriver driver;
    Workbench& workbench = driver.window().workbench();
    QVERIFY(makeReady(driver));
    // A clamp on the stock's top, starting 5 mm right of its middle; the tool keeps 1 mm away from it.
    QVERIFY(scrollTo(driver, "stockPage", "addObstacleButton"));
    QVERIFY(driver.clickOn("addObstacleButton"));
    QVERIFY(driver.waitFor([&] { return workbench.surroundings.obstacles().size() == 1; }));
    for (const auto& [field, value] :
         {std::pair{"obstacle0PlaceX", "5"}, {"obstacle0PlaceZ", "0"}, {"obstacle0SizeZ", "8"}})
        QVERIFY2(driver.enter(field, value), field);
    QVERIFY(driver.waitFor(
        [&] { return std::abs(boundsOf(*workbench.surroundings.obstacles()[0].obstacle).size().z - 8.0) < 1e-9; }));
    QVERIFY(driver.settle());
    QVERIFY(driver.waitFor([&] { return boundAlike(workbench.workpiece.bound(), workbench.surroundings.wanted()); }));
    driver.shoot("16-fixture");

    QVERIFY(driver.step(JobStep::mill));
    QVERIFY(driver.clickOn("millButton"));
    QVERIFY(driver.waitFor([&] { return workbench.mill.active(); }));
    bool told = false;
    const auto* hint = driver.window().findChild<Notice*>("millHint");
    const auto listening = QObject::connect(&workbench.session, &SessionRunner::ticked, this, [&] {
        told = told || hint->sentence().contains(QStringLiteral("Fixture 1"));
    });
    {
        const Farthest farthest(workbench);
        millLine(driver, {-20, 0}, {20, 0});
        // the tool's radius and the margin before the clamp's face
        QVERIFY2(farthest.get() > -5.0 && farthest.get() < 5.0 - 3.0 - 1.0 + 0.05,
                 qPrintable(QString::number(farthest.get())));
    }
    QVERIFY(told);
    driver.shoot("17-held-by-a-fixture");
    QObject::disconnect(listening);

    QVERIFY(scrollTo(driver, "millPage", "bound0Switch"));
    QTest::mouseClick(driver.window().findChild<QCheckBox*>("bound0Switch"), Qt::LeftButton, {}, QPoint(8, 8));
    QVERIFY(driver.waitFor([&] { return !workbench.surroundings.obstacles()[0].on; }));
    QVERIFY(workbench.mill.recording()); // switching does not end the recording
    {
        const Farthest farthest(workbench);
        millLine(driver, {-20, 3}, {20, 3});
        QVERIFY2(farthest.get() > 15.0, qPrintable(QString::number(farthest.get())));
    }
    driver.key(Qt::Key_Escape);
    QVERIFY(driver.waitFor([&] { return !workbench.session.running(); }));
    workbench.guides.add(GuideKind::levels);

    const QString file = driver.folder().filePath("clamped.burin");
    QVERIFY(saveAs(driver, file));
    QVERIFY(driver.restart());
    QVERIFY(driver.clickOn("recentFileButton"));
    Workbench& again = driver.window().workbench();
    QVERIFY(driver.waitFor([&] { return again.workpiece.ready(); }));
    QVERIFY(driver.settle());
    QCOMPARE(again.surroundings.obstacles().size(), std::size_t{1});
    QVERIFY(!again.surroundings.obstacles()[0].on);
    QCOMPARE(again.surroundings.obstacles()[0].obstacle->name, std::string("Fixture 1"));
    QCOMPARE(again.guides.guides().size(), std::size_t{1});
    QTest::qWait(500);
    QVERIFY(!again.document.unsaved());
}

BURIN_TEST(TestWindowSurroundings, QApplication)

} // namespace burin::tst_window_surroundings

#include "tst_window_surroundings.moc"

// SPDX-FileCopyrightText: 2026 The Burin authors
// SPDX-License-Identifier: Apache-2.0
// Fixtures of the library, placed by mouse and keys.
#include "core/base/units.h"
#include "tests/places.h"
#include "tests/test_program.h"
#include "tests/ui/window_steps.h"
#include "ui/panels/project_tree.h"

#include <QApplication>
#include <QComboBox>
#include <QInputDialog>
#include <QLabel>
#include <QMenu>
#include <QPushButton>
#include <QtTest>

namespace burin::tst_window_fixtures {

using namespace burin::testing;

namespace {

Workbench& workbenchOf(WindowDriver& driver) {
    return driver.window().workbench();
}

QPoint pixelOf(WindowDriver& driver, const glm::dvec3& place) {
    return driver.window().viewport().project(place).toPoint();
}

void clickAt(WindowDriver& driver, const glm::dvec3& place) {
    QTest::mouseClick(&driver.window().viewport(), Qt::LeftButton, {}, pixelOf(driver, place));
}

/// Opens the dialog by its key and chooses a kind.
bool beginFixture(WindowDriver& driver, const QString& kind) {
    driver.key(Qt::Key_W, Qt::ControlModifier | Qt::AltModifier);
    if (!driver.waitFor([&] { return driver.visible("fixtureDialog") != nullptr; })) return false;
    auto* box = driver.visible<QComboBox>("fixtureKind");
    box->setFocus();
    QTest::keyClick(box, Qt::Key_Home);
    for (int i = 0; i < box->count() && box->currentText() != kind; ++i) QTest::keyClick(box, Qt::Key_Down);
    return box->currentText() == kind;
}

bool isClosed(WindowDriver& driver) {
    return driver.waitFor([&] { return driver.visible("fixtureDialog") == nullptr; });
}

const Obstacle* lastOf(WindowDriver& driver) {
    const std::vector<PlacedObstacle>& all = workbenchOf(driver).surroundings.obstacles();
    return all.empty() ? nullptr : all.back().obstacle.get();
}

bool near(const glm::dvec3& one, const glm::dvec3& other) {
    return glm::distance(one, other) < 1e-6;
}

} // namespace

class TestWindowFixtures : public QObject {
    Q_OBJECT
private slots:
    /// A click on the stock's top stands the clamp there; keys move and turn it; undo takes it away.
    void aStepClampStandsWhereTheStockIsClicked() {
        WindowDriver driver;
        QVERIFY(makeReady(driver, 1.0));
        const Box stock = workbenchOf(driver).setup.setup().stock;
        driver.window().viewport().setStandardView(StandardView::top);
        QTest::qWait(500);
        QVERIFY(beginFixture(driver, "Step clamp"));
        const glm::dvec3 middle = stock.centre(), click(middle.x + 14.0, middle.y - 3.0, stock.high.z);
        clickAt(driver, click);
        QTRY_VERIFY(workbenchOf(driver).fixtures.placing());
        QTRY_VERIFY(near(workbenchOf(driver).fixtures.design().place, click));
        QCOMPARE(workbenchOf(driver).fixtures.design().turn, 0.0); // towards +X, the nearest side
        QVERIFY(workbenchOf(driver).surroundings.obstacles().empty());
        driver.window().viewport().setStandardView(StandardView::isometric);
        QTest::qWait(600);
        driver.shoot("fixtures-1-step-clamp");
        driver.window().viewport().setStandardView(StandardView::top);
        QTest::qWait(500);

        // As the command line places it (end_to_end.fixture_library compares that with the same function).
        const FixtureDesign expected = placedAt(standardFixture(FixtureKind::stepClamp), {}, siteOf(stock, {}), click);
        QCOMPARE(workbenchOf(driver).fixtures.design(), expected);
        Viewport& viewport = driver.window().viewport();
        QTest::keyClick(&viewport, Qt::Key_Right);
        QTest::keyClick(&viewport, Qt::Key_Up, Qt::ShiftModifier);
        QVERIFY(near(workbenchOf(driver).fixtures.design().place, click + glm::dvec3(1.0, 0.1, 0.0)));
        QTest::keyClick(&viewport, Qt::Key_R);
        QVERIFY(std::abs(workbenchOf(driver).fixtures.design().turn - pi / 12.0) < 1e-9);
        QTest::keyClick(&viewport, Qt::Key_Return);
        QVERIFY(isClosed(driver));
        QTRY_VERIFY(lastOf(driver) != nullptr);
        QCOMPARE(lastOf(driver)->name, std::string("Step clamp"));
        QVERIFY(lastOf(driver)->design && near(lastOf(driver)->design->place, click + glm::dvec3(1.0, 0.1, 0.0)));
        QVERIFY(driver.settle());
        QTRY_VERIFY(boundAlike(workbenchOf(driver).workpiece.bound(), workbenchOf(driver).surroundings.wanted()));
        driver.key(Qt::Key_Z, Qt::ControlModifier);
        QTRY_VERIFY(lastOf(driver) == nullptr);
        driver.key(Qt::Key_Z, Qt::ControlModifier | Qt::ShiftModifier);
        QTRY_VERIFY(lastOf(driver) != nullptr);
    }

    /// The vise closes on the clicked side; what would enter the stock is not added; sizes are changed later.
    void aViseClosesOnTheClickedSide() {
        WindowDriver driver;
        QVERIFY(makeReady(driver, 1.0));
        const Box stock = workbenchOf(driver).setup.setup().stock;
        driver.window().viewport().setStandardView(StandardView::front);
        QTest::qWait(500);
        QVERIFY(beginFixture(driver, "Vise"));
        clickAt(driver, {stock.centre().x, stock.low.y, stock.centre().z});
        QTRY_VERIFY(std::abs(workbenchOf(driver).fixtures.design().turn + 0.5 * pi) < 1e-9);
        QCOMPARE(valueOf(workbenchOf(driver).fixtures.design(), "opening"), stock.size().y);
        QVERIFY(driver.enter("fixture-grip", "12"));
        QVERIFY(driver.enter("fixture-jaw-width", "100"));
        QCOMPARE(valueOf(workbenchOf(driver).fixtures.design(), "grip"), 12.0);
        QVERIFY(driver.clickOn("fixtureTurn15"));
        QVERIFY(workbenchOf(driver).fixtures.problem());
        QCOMPARE(workbenchOf(driver).fixtures.problem()->code, ErrorCode::fixtureInStock);
        QTRY_VERIFY(!driver.visible<QPushButton>("acceptFixtureButton")->isEnabled());
        driver.shoot("fixtures-2-in-the-stock");
        keepPicture(*driver.visible("fixtureDialog"), "fixtures-2-dialog");
        QVERIFY(driver.clickOn("fixtureTurn-15"));
        QVERIFY(!workbenchOf(driver).fixtures.problem());
        QTRY_VERIFY(driver.visible<QPushButton>("acceptFixtureButton")->isEnabled());
        driver.window().viewport().setStandardView(StandardView::isometric);
        QTest::qWait(600);
        driver.window().viewport().fit();
        QTest::qWait(600);
        driver.shoot("fixtures-3-vise");
        QVERIFY(driver.clickOn("acceptFixtureButton"));
        QVERIFY(isClosed(driver));
        QTRY_VERIFY(lastOf(driver) != nullptr);
        QCOMPARE(valueOf(*lastOf(driver)->design, "opening"), stock.size().y);

        // Changed by its card, kept by the project, and renamed in the tree.
        QVERIFY(driver.clickOn("obstacle0Change"));
        QTRY_VERIFY(driver.visible("fixtureDialog") != nullptr);
        QVERIFY(!driver.visible<QComboBox>("fixtureKind")->isEnabled());
        QVERIFY(driver.enter("fixture-jaw-depth", "20"));
        QVERIFY(driver.clickOn("acceptFixtureButton"));
        QVERIFY(isClosed(driver));
        QTRY_COMPARE(valueOf(*lastOf(driver)->design, "jaw-depth"), 20.0);
        QCOMPARE(workbenchOf(driver).surroundings.obstacles().size(), std::size_t{1});
        auto* origin = driver.visible<QLabel>("obstacle0Origin");
        QVERIFY(origin != nullptr && origin->accessibleName().contains("Vise") &&
                !origin->accessibleName().contains("deep"));
        rename(driver, "Bench vise");
        QTRY_COMPARE(lastOf(driver)->name, std::string("Bench vise"));
        const Obstacle before = *lastOf(driver);
        const QString file = driver.folder().filePath("held.burin");
        QVERIFY(driver.settle());
        QVERIFY(saveAs(driver, file));
        QVERIFY(driver.restart());
        QVERIFY(driver.clickOn("recentFileButton"));
        QTRY_VERIFY_WITH_TIMEOUT(lastOf(driver) != nullptr, 30000);
        QVERIFY(*lastOf(driver) == before);
    }

    /// Esc leaves nothing behind; a drag takes the fixture along; the other steps end placing.
    void placingIsGivenUp() {
        WindowDriver driver;
        QVERIFY(makeReady(driver, 1.0));
        const Box stock = workbenchOf(driver).setup.setup().stock;
        Viewport& viewport = driver.window().viewport();
        viewport.setStandardView(StandardView::top);
        QTest::qWait(500);
        InteractiveTool* before = viewport.interactiveTool();
        QVERIFY(beginFixture(driver, "Socket screw"));
        const glm::dvec3 top(stock.centre().x, stock.centre().y, stock.high.z);
        QTest::mousePress(&viewport, Qt::LeftButton, {}, pixelOf(driver, top));
        QTest::mouseMove(&viewport, pixelOf(driver, top + glm::dvec3(6.0, 4.0, 0.0)));
        QTRY_VERIFY(near(workbenchOf(driver).fixtures.design().place, top + glm::dvec3(6.0, 4.0, 0.0)));
        QTest::mouseRelease(&viewport, Qt::LeftButton, {}, pixelOf(driver, top + glm::dvec3(6.0, 4.0, 0.0)));
        viewport.setFocus();
        QTest::keyClick(&viewport, Qt::Key_Escape);
        QVERIFY(isClosed(driver));
        QVERIFY(lastOf(driver) == nullptr && viewport.interactiveTool() == before);
        QVERIFY(beginFixture(driver, "Base plate"));
        QVERIFY(driver.step(JobStep::mill));
        QVERIFY(isClosed(driver));
        QVERIFY(lastOf(driver) == nullptr);
    }

private:
    static void rename(WindowDriver& driver, const QString& name) {
        driver.key(Qt::Key_F10, Qt::ControlModifier);
        QTRY_VERIFY(driver.visible<ProjectTree>("projectTree") != nullptr);
        auto& tree = *driver.visible<ProjectTree>("projectTree");
        QTRY_VERIFY(!tree.findItems("Vise", Qt::MatchExactly | Qt::MatchRecursive, 0).isEmpty());
        QTreeWidgetItem* row = tree.findItems("Vise", Qt::MatchExactly | Qt::MatchRecursive, 0).front();
        tree.scrollToItem(row);
        const QPoint place = tree.visualItemRect(row).center();
        QContextMenuEvent event(QContextMenuEvent::Mouse, place, tree.viewport()->mapToGlobal(place));
        QApplication::sendEvent(tree.viewport(), &event);
        QTRY_VERIFY(driver.window().findChild<QMenu*>("fixtureMenu") != nullptr);
        auto* menu = driver.window().findChild<QMenu*>("fixtureMenu");
        auto* action = menu->findChild<QAction*>("renameFixtureAction");
        QVERIFY(action != nullptr);
        driver.whenDialogStands([name](QWidget& dialog) {
            auto* input = qobject_cast<QInputDialog*>(&dialog);
            if (input == nullptr) return;
            input->setTextValue(name);
            input->accept();
        });
        QTest::mouseClick(menu, Qt::LeftButton, Qt::NoModifier, menu->actionGeometry(action).center());
    }
};

BURIN_TEST(TestWindowFixtures, QApplication)

} // namespace burin::tst_window_fixtures

#include "tst_window_fixtures.moc"

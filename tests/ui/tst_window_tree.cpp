// SPDX-FileCopyrightText: 2026 The Burin authors
// SPDX-License-Identifier: Apache-2.0
// The project's tree, and hiding bodies in the view, by mouse and keys.
#include "tests/long_run.h"
#include "tests/places.h"
#include "tests/test_program.h"
#include "tests/ui/window_steps.h"

#include "ui/panels/project_tree.h"

#include <QApplication>
#include <QColorDialog>
#include <QDragMoveEvent>
#include <QInputDialog>
#include <QMenu>
#include <QMimeData>
#include <QtTest>

#include <memory>

namespace burin::tst_window_tree {

using namespace burin::testing;

namespace {

Workbench& workbenchOf(WindowDriver& driver) {
    return driver.window().workbench();
}

QTreeWidgetItem* rowOf(const ProjectTree& tree, const QString& name) {
    const QList<QTreeWidgetItem*> found = tree.findItems(name, Qt::MatchExactly | Qt::MatchRecursive, 0);
    return found.isEmpty() ? nullptr : found.front();
}

ProjectTree* openTree(WindowDriver& driver) {
    driver.key(Qt::Key_F10, Qt::ControlModifier);
    driver.waitFor([&] { return driver.visible<ProjectTree>("projectTree") != nullptr; });
    return driver.visible<ProjectTree>("projectTree");
}

void doubleClick(ProjectTree& tree, QTreeWidgetItem& row) {
    const QPoint place = tree.visualItemRect(&row).center();
    QTest::mouseClick(tree.viewport(), Qt::LeftButton, Qt::NoModifier, place);
    QTest::mouseDClick(tree.viewport(), Qt::LeftButton, Qt::NoModifier, place);
}

/// Opens the context menu of a row; null if it does not appear.
QMenu* openMenu(WindowDriver& driver, ProjectTree& tree, QTreeWidgetItem& row, const char* menu) {
    const QPoint place = tree.visualItemRect(&row).center();
    QContextMenuEvent event(QContextMenuEvent::Mouse, place, tree.viewport()->mapToGlobal(place));
    QApplication::sendEvent(tree.viewport(), &event);
    QMenu* shown = nullptr;
    if (!driver.waitFor([&] {
            shown = driver.window().findChild<QMenu*>(menu);
            return shown != nullptr && shown->isVisible();
        }))
        return nullptr;
    return shown;
}

/// Triggers an action of the context menu of a row.
bool chooseFromMenu(WindowDriver& driver, ProjectTree& tree, QTreeWidgetItem& row, const char* menu,
                    const char* action) {
    QMenu* shown = openMenu(driver, tree, row, menu);
    auto* chosen = shown != nullptr ? shown->findChild<QAction*>(action) : nullptr;
    if (chosen == nullptr) return false;
    QTest::mouseClick(shown, Qt::LeftButton, Qt::NoModifier, shown->actionGeometry(chosen).center());
    return true;
}

/// Triggers an action of a menu within the menu of a body or an assembly.
bool chooseFromSubmenu(WindowDriver& driver, ProjectTree& tree, QTreeWidgetItem& row, const char* submenu,
                       const char* action) {
    QMenu* shown = openMenu(driver, tree, row, "bodyMenu");
    auto* within = shown != nullptr ? shown->findChild<QMenu*>(submenu) : nullptr;
    if (within == nullptr) return false;
    QTest::mouseClick(shown, Qt::LeftButton, Qt::NoModifier, shown->actionGeometry(within->menuAction()).center());
    if (!driver.waitFor([&] { return within->isVisible(); })) return false;
    auto* chosen = within->findChild<QAction*>(action);
    if (chosen == nullptr) return false;
    QTest::mouseClick(within, Qt::LeftButton, Qt::NoModifier, within->actionGeometry(chosen).center());
    return true;
}

} // namespace

class TestWindowTree : public QObject {
    Q_OBJECT
private slots:
    /// The tree shows everything that was made, and a double click leads to it.
    void theTreeShowsTheJob() {
        WindowDriver driver;
        QVERIFY(makeReady(driver, 1.0));
        ProjectTree* tree = openTree(driver);
        QVERIFY(tree);
        QTRY_VERIFY(rowOf(*tree, "Setups") && rowOf(*tree, "Part") && rowOf(*tree, "Tools"));
        QVERIFY(rowOf(*tree, "Takes") == nullptr); // nothing has been milled yet
        QVERIFY(recordLine(driver, {-10.0, 0.0}, {10.0, 0.0}));
        QVERIFY(newPath(driver));
        QTRY_VERIFY(rowOf(*tree, "Takes") && rowOf(*tree, "Paths"));
        driver.shoot("tree-1-job");
        QVERIFY(driver.step(JobStep::part));
        QTreeWidgetItem* path = rowOf(*tree, "Paths")->child(0);
        QVERIFY(path && path->font(0).bold());
        doubleClick(*tree, *path);
        QTRY_VERIFY(driver.visible<QWidget>("pathPanel") != nullptr);
        // A tool by the keyboard: its row, and Enter.
        workbenchOf(driver).tool.choose("flat-10");
        QVERIFY(driver.settle());
        QTRY_COMPARE(rowOf(*tree, "Tools")->childCount(), 2);
        QTreeWidgetItem* other = rowOf(*tree, "Tools")->child(0);
        QVERIFY(!other->font(0).bold());
        tree->setFocus();
        tree->setCurrentItem(other);
        QTest::keyClick(tree, Qt::Key_Return);
        QTRY_VERIFY(workbenchOf(driver).tool.current().id != "flat-10");
    }

    /// A take is renamed and deleted by its menu; undo restores it.
    void rowsHaveMenus() {
        WindowDriver driver;
        QVERIFY(makeReady(driver, 1.0));
        QVERIFY(recordLine(driver, {-10.0, 0.0}, {10.0, 0.0}));
        ProjectTree* tree = openTree(driver);
        QVERIFY(tree);
        QTRY_VERIFY(rowOf(*tree, "Takes") && workbenchOf(driver).time.recorded());
        driver.whenDialogStands([](QWidget& dialog) {
            auto* input = qobject_cast<QInputDialog*>(&dialog);
            if (input == nullptr) return;
            input->setTextValue("slot");
            input->accept();
        });
        QVERIFY(chooseFromMenu(driver, *tree, *rowOf(*tree, "Takes")->child(0), "takeMenu", "renameTakeAction"));
        QTRY_VERIFY(rowOf(*tree, "slot") != nullptr);
        QVERIFY(chooseFromMenu(driver, *tree, *rowOf(*tree, "slot"), "takeMenu", "deleteTakeAction"));
        QTRY_VERIFY_WITH_TIMEOUT(workbenchOf(driver).mill.takes().empty(), 30000);
        QVERIFY(driver.settle());
        driver.key(Qt::Key_Z, Qt::ControlModifier);
        QTRY_COMPARE_WITH_TIMEOUT(workbenchOf(driver).mill.takes().size(), std::size_t{1}, 30000);
        QTRY_VERIFY(rowOf(*tree, "slot") != nullptr);
    }

    /// Moves a take by the keys in its row, and copies it by its menu. The path gets the copy only by its menu, and
    /// each change can be undone.
    BURIN_ONLY_IN_LONG_RUNS void takesAreMovedAndCopied() {
        WindowDriver driver;
        QVERIFY(makeReady(driver, 1.0));
        QVERIFY(recordLine(driver, {-10.0, 0.0}, {10.0, 0.0}) && driver.settle());
        QVERIFY(recordLine(driver, {-10.0, 6.0}, {10.0, 6.0}) && driver.settle());
        QVERIFY(newPath(driver));
        ProjectTree* tree = openTree(driver);
        QVERIFY(tree);
        const auto names = [&] {
            QStringList texts;
            if (QTreeWidgetItem* takes = rowOf(*tree, "Takes"))
                for (int i = 0; i < takes->childCount(); ++i) texts << takes->child(i)->text(0);
            return texts;
        };
        const auto sources = [&] { return workbenchOf(driver).path.stored()->sources; };
        QTRY_COMPARE(names(), (QStringList{"take 1", "take 2"}));
        const std::vector<PathSource> before = sources();
        const quint64 version = workbenchOf(driver).path.version();
        tree->setFocus();
        tree->setCurrentItem(rowOf(*tree, "take 2"));
        driver.key(Qt::Key_Up, Qt::ControlModifier | Qt::ShiftModifier);
        QTRY_COMPARE(names(), (QStringList{"take 2", "take 1"}));
        QCOMPARE(tree->currentItem()->text(0), QString("take 2"));
        driver.shoot("tree-3-moved");
        QVERIFY(chooseFromMenu(driver, *tree, *rowOf(*tree, "take 1"), "takeMenu", "moveTakeUpAction"));
        QTRY_COMPARE(names(), (QStringList{"take 1", "take 2"}));
        QVERIFY(chooseFromMenu(driver, *tree, *rowOf(*tree, "take 1"), "takeMenu", "copyTakeAction"));
        QTRY_COMPARE(names(), (QStringList{"take 1", "take 2", "take 1 (copy)"}));
        QVERIFY(driver.settle());
        QVERIFY(sources() == before && !workbenchOf(driver).path.outdated());
        QCOMPARE(workbenchOf(driver).path.version(), version); // the posted program is up to date
        QVERIFY(chooseFromMenu(driver, *tree, *rowOf(*tree, "take 1 (copy)"), "takeMenu", "takeInPathAction"));
        QTRY_COMPARE(sources().size(), before.size() + 1);
        QVERIFY(driver.settle());
        driver.shoot("tree-4-copied");
        driver.key(Qt::Key_Z, Qt::ControlModifier);
        QTRY_VERIFY(sources() == before);
        driver.key(Qt::Key_Z, Qt::ControlModifier);
        QTRY_COMPARE(names(), (QStringList{"take 1", "take 2"}));
        driver.key(Qt::Key_Z, Qt::ControlModifier);
        QTRY_COMPARE(names(), (QStringList{"take 2", "take 1"}));
        driver.key(Qt::Key_Z, Qt::ControlModifier | Qt::ShiftModifier);
        QTRY_COMPARE(names(), (QStringList{"take 1", "take 2"}));
    }

    /// The bodies of an assembly are below it; its role and colour are those of all of them, and one undo restores
    /// them.
    void anAssemblyIsChangedAsAWhole() {
        WindowDriver driver;
        drop(driver.window(), QStringLiteral(BURIN_FIXTURES "/models/mayo-332.stp"));
        QVERIFY(driver.waitFor([&] { return workbenchOf(driver).setup.hasPart(); }));
        QVERIFY(driver.settle());
        ProjectTree* tree = openTree(driver);
        QVERIFY(tree);
        QTRY_VERIFY(rowOf(*tree, "Root") != nullptr);
        QCOMPARE(rowOf(*tree, "Root")->childCount(), 3);
        QCOMPARE(rowOf(*tree, "Root")->child(1)->text(0), QString("Part 2"));
        const auto roles = [&] {
            std::vector<BodyRole> each;
            for (std::size_t i = 0; i < 3; ++i) each.push_back(roleOf(workbenchOf(driver).setup.setup(), i));
            return each;
        };
        QVERIFY(chooseFromSubmenu(driver, *tree, *rowOf(*tree, "Root"), "bodyRoleMenu", "role-ignored"));
        QTRY_COMPARE(roles(), std::vector(3, BodyRole::ignored));
        QTRY_COMPARE(rowOf(*tree, "Root")->text(1), QString("Ignored"));
        QVERIFY(chooseFromSubmenu(driver, *tree, *rowOf(*tree, "Part 2"), "bodyRoleMenu", "role-part"));
        QTRY_COMPARE(rowOf(*tree, "Root")->text(1), QString("several roles"));
        driver.shoot("tree-5-assembly");
        driver.key(Qt::Key_Z, Qt::ControlModifier);
        QTRY_COMPARE(roles(), std::vector(3, BodyRole::ignored));
        driver.key(Qt::Key_Z, Qt::ControlModifier);
        QTRY_COMPARE(roles(), std::vector(3, BodyRole::part));
        const std::vector<BodyColour> before = workbenchOf(driver).model.colours();
        driver.whenDialogStands([](QWidget& dialog) {
            auto* colours = qobject_cast<QColorDialog*>(&dialog);
            if (colours == nullptr) return;
            colours->setCurrentColor(QColor(10, 200, 30));
            colours->accept();
        });
        QVERIFY(chooseFromMenu(driver, *tree, *rowOf(*tree, "Root"), "bodyMenu", "bodyColourAction"));
        QTRY_VERIFY(workbenchOf(driver).model.colours() == std::vector<BodyColour>(3, BodyColour({10, 200, 30})));
        QVERIFY(driver.settle());
        driver.shoot("tree-6-coloured");
        driver.key(Qt::Key_Z, Qt::ControlModifier);
        QTRY_VERIFY(workbenchOf(driver).model.colours() == before);
    }

    /// A tick of the assembly hides and shows all of its bodies; it is half ticked if only some are shown.
    void anAssemblyIsHiddenAndFolded() {
        WindowDriver driver;
        drop(driver.window(), QStringLiteral(BURIN_FIXTURES "/models/mayo-332.stp"));
        QVERIFY(driver.waitFor([&] { return workbenchOf(driver).setup.hasPart(); }));
        QVERIFY(driver.settle());
        ProjectTree* tree = openTree(driver);
        QVERIFY(tree);
        QTRY_VERIFY(rowOf(*tree, "Root") != nullptr);
        auto& viewport = *driver.visible<Viewport>("viewport");
        const QPointF centre = QRectF(viewport.rect()).center();
        QTRY_VERIFY(viewport.pick(centre).has_value());
        QVERIFY(chooseFromMenu(driver, *tree, *rowOf(*tree, "Part 2"), "bodyMenu", "hideBodyAction"));
        QTRY_COMPARE(rowOf(*tree, "Root")->checkState(0), Qt::PartiallyChecked);
        QVERIFY(chooseFromMenu(driver, *tree, *rowOf(*tree, "Root"), "bodyMenu", "hideBodyAction"));
        QTRY_COMPARE(rowOf(*tree, "Root")->checkState(0), Qt::Unchecked);
        QTRY_VERIFY(!viewport.pick(centre).has_value());
        tree->setFocus();
        tree->setCurrentItem(rowOf(*tree, "Root"));
        QTest::keyClick(tree, Qt::Key_Space);
        QTRY_COMPARE(rowOf(*tree, "Part 3")->checkState(0), Qt::Checked);
        QTRY_VERIFY(viewport.pick(centre).has_value());
        // Folded by Enter, it stays so when the tree changes.
        tree->setFocus();
        tree->setCurrentItem(rowOf(*tree, "Root"));
        QTest::keyClick(tree, Qt::Key_Return);
        QVERIFY(!rowOf(*tree, "Root")->isExpanded());
        workbenchOf(driver).setup.chooseRole(0, BodyRole::ignored);
        QTRY_COMPARE(rowOf(*tree, "Root")->text(1), QString("several roles"));
        QVERIFY(!rowOf(*tree, "Root")->isExpanded());
    }

    /// A take is dragged before another one and to the end, and nowhere else; undo restores the order.
    BURIN_ONLY_IN_LONG_RUNS void takesAreDragged() {
        WindowDriver driver;
        QVERIFY(makeReady(driver, 1.0));
        for (const double y : {-6.0, 0.0, 6.0}) QVERIFY(recordLine(driver, {-10.0, y}, {10.0, y}) && driver.settle());
        ProjectTree* tree = openTree(driver);
        QVERIFY(tree);
        const auto names = [&] {
            QStringList texts;
            if (QTreeWidgetItem* takes = rowOf(*tree, "Takes"))
                for (int i = 0; i < takes->childCount(); ++i) texts << takes->child(i)->text(0);
            return texts;
        };
        const QStringList recorded{"take 1", "take 2", "take 3"};
        QTRY_COMPARE(names(), recorded);
        QTRY_VERIFY(rowOf(*tree, "take 1")->flags().testFlag(Qt::ItemIsDragEnabled));
        QVERIFY(!rowOf(*tree, "Takes")->flags().testFlag(Qt::ItemIsDragEnabled));
        // Drops a row at a height of another one: 0 at its upper edge, 1 at its lower one.
        const auto dropAt = [&](const QString& name, const QString& other, double height) {
            const std::unique_ptr<QMimeData> row(tree->model()->mimeData({tree->indexFromItem(rowOf(*tree, name))}));
            const QRect area = tree->visualItemRect(rowOf(*tree, other));
            const QPointF place(area.center().x(), area.top() + height * (area.height() - 1));
            QDragEnterEvent enter(place.toPoint(), Qt::MoveAction, row.get(), Qt::LeftButton, Qt::NoModifier);
            QApplication::sendEvent(tree->viewport(), &enter);
            QDragMoveEvent move(place.toPoint(), Qt::MoveAction, row.get(), Qt::LeftButton, Qt::NoModifier);
            QApplication::sendEvent(tree->viewport(), &move);
            driver.shoot("tree-5-dragged");
            QDropEvent drop(place, Qt::MoveAction, row.get(), Qt::LeftButton, Qt::NoModifier);
            QApplication::sendEvent(tree->viewport(), &drop);
            return driver.settle();
        };
        QVERIFY(dropAt("take 3", "take 1", 0.0));
        QTRY_COMPARE(names(), (QStringList{"take 3", "take 1", "take 2"}));
        QVERIFY(dropAt("take 3", "take 2", 1.0));
        QTRY_COMPARE(names(), recorded);
        QVERIFY(dropAt("take 1", "take 2", 1.0));
        QTRY_COMPARE(names(), (QStringList{"take 2", "take 1", "take 3"}));
        QVERIFY(dropAt("take 1", "Part", 0.5));
        QVERIFY(dropAt("take 1", "take 1", 0.0));
        QCOMPARE(names(), (QStringList{"take 2", "take 1", "take 3"}));
        QVERIFY(dropAt("take 1", "Takes", 0.5)); // on the heading: to the end
        QTRY_COMPARE(names(), (QStringList{"take 2", "take 3", "take 1"}));
        for (int i = 0; i < 4; ++i) driver.key(Qt::Key_Z, Qt::ControlModifier);
        QTRY_COMPARE(names(), recorded);
        // As the rules of "Move up" have it, not during a recording.
        QVERIFY(driver.step(JobStep::mill));
        QVERIFY(workbenchOf(driver).mill.startRecording());
        QTRY_VERIFY(workbenchOf(driver).mill.recording());
        QTRY_VERIFY(!rowOf(*tree, "take 1")->flags().testFlag(Qt::ItemIsDragEnabled));
        workbenchOf(driver).mill.leave();
        QTRY_VERIFY(!workbenchOf(driver).session.running());
    }

    /// A body whose box is not ticked is not drawn, without any other effect; nor when the project is opened again.
    void bodiesAreHiddenAndShown() {
        WindowDriver driver;
        drop(driver.window(), writeBlock(driver));
        QVERIFY(driver.waitFor([&] { return workbenchOf(driver).setup.hasPart(); }));
        QVERIFY(driver.settle());
        ProjectTree* tree = openTree(driver);
        QVERIFY(tree);
        QTRY_VERIFY(rowOf(*tree, "Part") != nullptr);
        auto& viewport = *driver.visible<Viewport>("viewport");
        const QPointF centre = QRectF(viewport.rect()).center();
        QTRY_VERIFY(viewport.pick(centre).has_value());
        QTreeWidgetItem* body = rowOf(*tree, "Part")->child(0);
        QCOMPARE(body->checkState(0), Qt::Checked);
        QVERIFY(chooseFromMenu(driver, *tree, *body, "bodyMenu", "hideBodyAction"));
        QTRY_VERIFY(!viewport.pick(centre).has_value());
        driver.shoot("tree-2-hidden");
        body = rowOf(*tree, "Part")->child(0);
        QCOMPARE(body->checkState(0), Qt::Unchecked);
        // Nor can it be picked.
        driver.key(Qt::Key_J, Qt::ControlModifier);
        QTRY_VERIFY(menuAction(driver, "measureAction")->isChecked());
        QTest::mouseClick(&viewport, Qt::LeftButton, Qt::NoModifier, centre.toPoint());
        QVERIFY(!workbenchOf(driver).measure.busy() && workbenchOf(driver).measure.measure() == nullptr);
        driver.key(Qt::Key_Escape);
        QVERIFY(chooseFromMenu(driver, *tree, *body, "bodyMenu", "isolateBodyAction"));
        QTRY_VERIFY(viewport.pick(centre).has_value());
        // By the keyboard: its row, and the space bar.
        tree->setFocus();
        tree->setCurrentItem(rowOf(*tree, "Part")->child(0));
        QTest::keyClick(tree, Qt::Key_Space);
        QTRY_VERIFY(!viewport.pick(centre).has_value());
        QVERIFY(workbenchOf(driver).setup.hasPart());

        QVERIFY(saveAs(driver, driver.folder().filePath("hidden.burin")));
        QVERIFY(driver.restart() && driver.clickOn("recentFileButton"));
        QTRY_VERIFY(workbenchOf(driver).setup.hasPart());
        QVERIFY(driver.settle());
        tree = openTree(driver);
        QVERIFY(tree);
        QTRY_VERIFY(rowOf(*tree, "Part") != nullptr);
        QCOMPARE(rowOf(*tree, "Part")->child(0)->checkState(0), Qt::Unchecked);
        QVERIFY(!driver.visible<Viewport>("viewport")->pick(centre).has_value());
        QVERIFY(chooseFromMenu(driver, *tree, *rowOf(*tree, "Part")->child(0), "bodyMenu", "hideBodyAction"));
        QTRY_VERIFY(driver.visible<Viewport>("viewport")->pick(centre).has_value());
        QVERIFY(!workbenchOf(driver).document.unsaved()); // it is a matter of the view
    }
};

BURIN_TEST(TestWindowTree, QApplication)

} // namespace burin::tst_window_tree

#include "tst_window_tree.moc"

// SPDX-FileCopyrightText: 2026 The Burin authors
// SPDX-License-Identifier: Apache-2.0
#include "tests/long_run.h"
#include "tests/places.h"
#include "tests/test_program.h"
#include "tests/ui/visible_texts.h"
#include "tests/ui/window_steps.h"
#include "ui/panels/layer_panel.h"
#include "ui/panels/notice.h"
#include "ui/panels/row_list.h"

#include <QApplication>
#include <QComboBox>
#include <QLineEdit>
#include <QTemporaryDir>
#include <QtTest>

#include <set>

namespace burin::tst_window_materials {

using namespace burin::testing;

namespace {

constexpr int cylinderRow = 0, cubeRow = 1; // in the order of the file

/// By keys, as a user without a mouse.
bool choose(WindowDriver& driver, const char* name, const QString& text) {
    auto* const choice = driver.visible<QComboBox>(name);
    if (choice == nullptr || choice->findText(text) < 0) return false;
    choice->setFocus();
    QTest::keyClick(choice, Qt::Key_Home);
    for (int i = 0; i < choice->count() && choice->currentText() != text; ++i) QTest::keyClick(choice, Qt::Key_Down);
    return choice->currentText() == text && driver.settle();
}

bool clickRow(WindowDriver& driver, const char* name, int row) {
    auto* const list = driver.visible<RowList>(name);
    if (list == nullptr || list->count() <= row) return false;
    QTest::mouseClick(list->viewport(), Qt::LeftButton, {}, list->visualItemRect(list->item(row)).center());
    return driver.settle();
}

bool type(WindowDriver& driver, const char* name, const QString& text) {
    auto* const field = driver.visible<QWidget>(name);
    if (field == nullptr) return false;
    field->setFocus();
    QTest::keyClick(field, Qt::Key_A, Qt::ControlModifier);
    QTest::keyClicks(field, text);
    QTest::keyClick(field, Qt::Key_Return);
    return driver.settle();
}

bool open(WindowDriver& driver) {
    Workbench& workbench = driver.window().workbench();
    drop(driver.window(), QStringLiteral(BURIN_FIXTURES "/models/red-cube-blue-cylinder.step"));
    return driver.waitFor([&] { return workbench.model.model() && workbench.setup.usable(); });
}

bool embed(WindowDriver& driver) {
    return driver.step(JobStep::stock) && driver.clickOn("embedButton") &&
           driver.waitFor([&] { return driver.window().workbench().workpiece.ready(); }) && driver.settle();
}

double volumeOf(const Workbench& workbench, const std::string& id) {
    for (const MaterialAmount& amount : materialAmounts(workbench.workpiece.milling()->embedded))
        if (amount.id == id) return amount.volume;
    return 0.0;
}

} // namespace

/// A stock of several materials, made and milled in the window.
class TestWindowMaterials : public QObject {
    Q_OBJECT
private slots:
    void aStockOfThreeMaterialsIsMadeAndMilled() {
        WindowDriver driver(QSize(1280, 800));
        Workbench& workbench = driver.window().workbench();
        QVERIFY(open(driver));
        QVERIFY(driver.step(JobStep::part));
        QVERIFY(clickRow(driver, "bodyList", cylinderRow));
        QVERIFY(choose(driver, "bodyRole", QStringLiteral("Insert")));
        QCOMPARE(roleOf(workbench.setup.setup(), cylinderRow), BodyRole::insert);
        QCOMPARE(driver.visible<RowList>("bodyList")->rows()[cylinderRow].badge, QStringLiteral("Insert"));
        driver.shoot("materials-01-role");

        QVERIFY(driver.step(JobStep::material));
        QVERIFY(choose(driver, "body", QStringLiteral("blue_cylinder")));
        QVERIFY(choose(driver, "bodyMaterial", QStringLiteral("Brass CuZn39Pb3")));
        QVERIFY(driver.clickOn("addLayer") && driver.settle());
        QVERIFY(type(driver, "layerName", QStringLiteral("Skin")));
        QVERIFY(choose(driver, "layerMaterial", QStringLiteral("Oak")));
        QVERIFY(type(driver, "layerFrom", QStringLiteral("11")));
        QCOMPARE(workbench.setup.setup().regions.size(), std::size_t{1});
        QCOMPARE(workbench.setup.setup().regions[0].name, std::string("Skin"));
        QVERIFY(embed(driver));
        const double cylinder = 785.398;
        QVERIFY(std::abs(volumeOf(workbench, "brass-cuzn39pb3") / cylinder - 1.0) < 0.02);
        const Box stock = workbench.setup.setup().stock;
        const double skin = stock.size().x * stock.size().y * (stock.high.z - 11.0);
        QVERIFY(std::abs(volumeOf(workbench, "oak") / skin - 1.0) < 0.02);
        QVERIFY(driver.step(JobStep::material) && driver.settle());
        QVERIFY(driver.window().findChild<RowList*>("amountList")->count() >= 4);
        driver.shoot("materials-02-layers");
        for (const VisibleText& cut : clippedTexts(driver.window()))
            QFAIL(qPrintable(QStringLiteral("cut: %1: %2").arg(cut.where, cut.text)));

        QVERIFY(recordLine(driver, {-12, 0}, {12, 0}, LinePace::ofAHand));
        QVERIFY(driver.settle());
        driver.shoot("materials-03-milled");
        QVERIFY(removedSoFar(*workbench.workpiece.milling()) > 1.0);
    }

    BURIN_ONLY_IN_LONG_RUNS void aGradedLayerStatesItsError() {
        WindowDriver driver(QSize(1280, 800));
        Workbench& workbench = driver.window().workbench();
        QVERIFY(open(driver));
        QVERIFY(driver.step(JobStep::material));
        QVERIFY(driver.clickOn("addLayer") && driver.settle());
        QVERIFY(choose(driver, "layerMaterial", QStringLiteral("Polyurethane foam")));
        QVERIFY(choose(driver, "layerGrade", QStringLiteral("By a formula")));
        QVERIFY(choose(driver, "gradeValue", QStringLiteral("Specific cutting energy")));
        QVERIFY(type(driver, "gradeFormula", QStringLiteral("0.01 + 0.001 * Z")));
        QVERIFY(embed(driver));
        QVERIFY(driver.step(JobStep::material) && driver.settle());
        const auto* const notice = driver.window().findChild<Notice*>("gradingNotice");
        QVERIFY2(notice->sentence().contains(QStringLiteral("8 bands")), qPrintable(notice->sentence()));
        driver.shoot("materials-04-graded");

        // An invalid formula is reported in one sentence, and undo restores the previous one.
        QVERIFY(type(driver, "gradeFormula", QStringLiteral("0.01 +")));
        QVERIFY(workbench.setup.problem().has_value());
        QVERIFY(driver.window().findChild<Notice*>("layerProblem")->sentence().contains(QStringLiteral("0.01 +")));
        driver.window().setFocus();
        driver.key(Qt::Key_Z, Qt::ControlModifier);
        QVERIFY(driver.waitFor([&] { return !workbench.setup.problem().has_value(); }));
    }

    void undoBringsRolesAndLayersBack() {
        WindowDriver driver(QSize(1280, 800));
        Workbench& workbench = driver.window().workbench();
        QVERIFY(open(driver));
        QVERIFY(driver.step(JobStep::part));
        QVERIFY(clickRow(driver, "bodyList", cubeRow));
        QVERIFY(choose(driver, "bodyRole", QStringLiteral("Fixture")));
        QVERIFY(driver.step(JobStep::material));
        QVERIFY(driver.clickOn("addLayer") && driver.settle());
        QCOMPARE(workbench.setup.setup().regions.size(), std::size_t{1});
        driver.window().setFocus();
        for (int i = 0; i < 10; ++i) driver.key(Qt::Key_Z, Qt::ControlModifier);
        QVERIFY(driver.waitFor([&] { return workbench.setup.setup().regions.empty(); }));
        QVERIFY(driver.waitFor([&] { return roleOf(workbench.setup.setup(), cubeRow) == BodyRole::part; }));
    }

    /// Figure 13b of the paper.
    BURIN_ONLY_IN_LONG_RUNS void freeCarvingSaysThatNothingPushesBack() {
        WindowDriver driver(QSize(1280, 800));
        Workbench& workbench = driver.window().workbench();
        QVERIFY(open(driver));
        QVERIFY(driver.step(JobStep::part));
        for (const int row : {cylinderRow, cubeRow}) {
            QVERIFY(clickRow(driver, "bodyList", row));
            QVERIFY(choose(driver, "bodyRole", QStringLiteral("Ignored")));
        }
        QVERIFY(workbench.setup.problem().has_value());
        QVERIFY(driver.step(JobStep::stock));
        QVERIFY(driver.clickOn("freeCarvingSwitch") && driver.settle());
        QVERIFY(driver.clickOn("stockStatedSwitch") && driver.settle());
        QVERIFY(!workbench.setup.problem().has_value());
        QVERIFY(type(driver, "stockHighZ", QStringLiteral("15")));
        QCOMPARE(workbench.setup.setup().stock.high.z, 15.0);
        QVERIFY(embed(driver));
        QVERIFY(driver.step(JobStep::material) && driver.settle());
        QVERIFY(!driver.window().findChild<Notice*>("freeCarvingNotice")->sentence().isEmpty());
        driver.shoot("materials-05-free");
        QVERIFY(recordLine(driver, {-5, 0}, {5, 0}));
        QVERIFY(driver.settle());
        QVERIFY(removedSoFar(*workbench.workpiece.milling()) > 1.0);
    }

    /// Aluminium, a brass insert, oak and a graded foam in one drag of the mouse; then the path and its program.
    BURIN_ONLY_IN_LONG_RUNS void oneDragMillsAllFourMaterials() {
        WindowDriver driver(QSize(1280, 800));
        Workbench& workbench = driver.window().workbench();
        QVERIFY(open(driver));
        QVERIFY(driver.step(JobStep::part));
        QVERIFY(clickRow(driver, "bodyList", cylinderRow) && choose(driver, "bodyRole", QStringLiteral("Insert")));
        QVERIFY(clickRow(driver, "bodyList", cubeRow) && choose(driver, "bodyRole", QStringLiteral("Ignored")));
        QVERIFY(driver.step(JobStep::stock));
        QVERIFY(driver.clickOn("freeCarvingSwitch") && driver.settle());
        QVERIFY(driver.clickOn("stockStatedSwitch") && driver.settle());
        QVERIFY(type(driver, "stockHighZ", QStringLiteral("10"))); // the height at which the insert ends
        QVERIFY(driver.step(JobStep::material));
        QVERIFY(choose(driver, "stockMaterial", QStringLiteral("Aluminium 6061-T6")));
        QVERIFY(choose(driver, "body", QStringLiteral("blue_cylinder")));
        QVERIFY(choose(driver, "bodyMaterial", QStringLiteral("Brass CuZn39Pb3")));
        for (const auto& [material, from, to] :
             {std::tuple{"Oak", "2", "8"}, std::tuple{"Polyurethane foam", "8", "20"}}) {
            QVERIFY(driver.clickOn("addLayer") && driver.settle());
            QVERIFY(choose(driver, "layerMaterial", QString::fromLatin1(material)));
            QVERIFY(choose(driver, "layerAxis", QStringLiteral("X")));
            QVERIFY(type(driver, "layerFrom", QString::fromLatin1(from)));
            QVERIFY(type(driver, "layerTo", QString::fromLatin1(to)));
        }
        QVERIFY(choose(driver, "layerGrade", QStringLiteral("By a formula")));
        QVERIFY(choose(driver, "gradeValue", QStringLiteral("Specific cutting energy")));
        QVERIFY(type(driver, "gradeFormula", QStringLiteral("0.01 + 0.001 * X")));
        QVERIFY2(!workbench.setup.problem(), workbench.setup.problem()->subject.c_str());
        QVERIFY(embed(driver));
        QVERIFY(driver.step(JobStep::material) && driver.settle());
        driver.shoot("materials-07-four");
        QVERIFY(recordLine(driver, {-17, 0}, {17, 0}, LinePace::ofAHand));
        QVERIFY(driver.settle());
        driver.shoot("materials-08-one-drag");
        const EmbeddedSetup& embedded = workbench.workpiece.milling()->embedded;
        const RunAmounts left = embedded.workpiece.amounts();
        std::set<std::string> cut;
        for (int i = 1; i < embedded.workpiece.properties().size(); ++i)
            if (const auto property = static_cast<PropertyIndex>(i);
                left.units[property] < embedded.untouched.units[property])
                cut.insert(embedded.workpiece.properties()[property].name);
        for (const char* name : {"Aluminium 6061-T6", "Brass CuZn39Pb3", "Oak"}) QVERIFY2(cut.contains(name), name);
        QVERIFY(cut.size() >= 5); // and several of the foam's bands
        QVERIFY(newPath(driver));
        driver.shoot("materials-09-path");
        QVERIFY(postProgram(driver));
        driver.shoot("materials-10-program");
        std::set<double> feeds;
        for (const PathPoint& point : workbench.path.evaluated()->path.points)
            if (point.kind == MoveKind::cut) feeds.insert(std::round(point.feed));
        // Foam is cut as fast as the machine can, brass is not.
        QVERIFY(*feeds.rbegin() > 1.5 * *feeds.begin());
        for (const VisibleText& text : clippedTexts(driver.window()))
            QFAIL(qPrintable(QStringLiteral("cut: %1: %2").arg(text.where, text.text)));
    }

    BURIN_ONLY_IN_LONG_RUNS void theWorkpieceIsExported() {
        WindowDriver driver(QSize(1280, 800));
        QVERIFY(open(driver));
        QVERIFY(embed(driver));
        const QTemporaryDir folder;
        for (const char* name : {"w.stl", "w.3mf", "w.srle"}) {
            const QString file = folder.filePath(name);
            driver.whenDialogStands([&](QWidget& dialog) {
                auto* const field = dialog.findChild<QLineEdit*>("fileNameEdit");
                field->setText(file);
                QTest::keyClick(field, Qt::Key_Return);
            });
            driver.window().setFocus();
            driver.key(Qt::Key_W, Qt::ControlModifier | Qt::ShiftModifier);
            QVERIFY2(driver.waitFor([&] { return QFile::exists(file); }), name);
            QVERIFY(driver.settle());
        }
    }

    void aRoundBarIsStock() {
        WindowDriver driver(QSize(1280, 800));
        Workbench& workbench = driver.window().workbench();
        QVERIFY(open(driver));
        QVERIFY(driver.step(JobStep::stock));
        QVERIFY(choose(driver, "stockForm", QStringLiteral("Cylinder")));
        QVERIFY(choose(driver, "stockAxis", QStringLiteral("X")));
        QVERIFY(embed(driver));
        const CylinderShape& bar = workbench.setup.setup().cylinder;
        const EmbeddedSetup& embedded = workbench.workpiece.milling()->embedded;
        const double exact = std::acos(-1.0) * bar.radius * bar.radius * bar.height;
        QVERIFY(std::abs((embedded.stockVolume + embedded.partVolume) / exact - 1.0) < 0.01);
        driver.shoot("materials-06-bar");
    }
};

BURIN_TEST(TestWindowMaterials, QApplication)

} // namespace burin::tst_window_materials

#include "tst_window_materials.moc"

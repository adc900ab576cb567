// SPDX-FileCopyrightText: 2026 The Burin authors
// SPDX-License-Identifier: Apache-2.0
#include "core/tool/holder_library.h"
#include "core/tool/tool_solid.h"
#include "tests/core/geometry/shapes.h"
#include "tests/long_run.h"
#include "tests/places.h"
#include "tests/stl_text.h"
#include "tests/test_program.h"
#include "tests/ui/visible_texts.h"
#include "tests/ui/window_steps.h"
#include "ui/panels/notice.h"
#include "ui/panels/row_list.h"
#include "ui/panels/texts.h"
#include "ui/scene/viewport.h"

#include <QApplication>
#include <QComboBox>
#include <QDialog>
#include <QDialogButtonBox>
#include <QDoubleSpinBox>
#include <QLabel>
#include <QLineEdit>
#include <QPointer>
#include <QPushButton>
#include <QTableWidget>
#include <QtTest>

#include <cmath>

namespace burin::tst_window_library {

using namespace burin::testing;

namespace {

bool open(WindowDriver& driver) {
    Workbench& workbench = driver.window().workbench();
    drop(driver.window(), QStringLiteral(BURIN_FIXTURES "/models/red-cube-blue-cylinder.step"));
    return driver.waitFor([&] { return workbench.model.model() && workbench.setup.usable(); }) && driver.settle();
}

QString write(WindowDriver& driver, const char* name, const QByteArray& content) {
    QFile file(driver.folder().filePath(QString::fromLatin1(name)));
    return file.open(QIODevice::WriteOnly) && file.write(content) == content.size() ? file.fileName() : QString();
}

int rowOf(const QTableWidget& table, const QString& key) {
    for (int row = 0; row < table.rowCount(); ++row)
        if (table.item(row, 0)->text() == key) return row;
    return -1;
}

/// By mouse and keys: a click in the cell, F2, the text, Enter.
void enterCell(QTableWidget& table, int row, int column, const QString& text) {
    const QPoint place = table.visualItemRect(table.item(row, column)).center();
    QTest::mouseClick(table.viewport(), Qt::LeftButton, {}, place);
    QTest::keyClick(&table, Qt::Key_F2);
    QWidget* editor = QApplication::focusWidget();
    QTest::keyClick(editor, Qt::Key_A, Qt::ControlModifier);
    QTest::keyClicks(editor, text);
    QTest::keyClick(editor, Qt::Key_Return);
    QTest::qWait(20); // the editor is deleted with the next events
}

QPushButton& button(QWidget& dialog, const char* name) {
    return *dialog.findChild<QPushButton*>(QLatin1String(name));
}

void click(QWidget& dialog, const char* name) {
    QTest::mouseClick(&button(dialog, name), Qt::LeftButton);
}

/// Slots of 6 mm at 12,000 1/min: forces on the tool by Ft = K MRR / v with K = 0.85 J/mm³ and Kr = 0.4, off by
/// hundredths of a newton.
QByteArray forcesOf(const char* material) {
    QByteArray text = "material,force_x_n,force_y_n,force_z_n,axis_x,axis_y,axis_z,feed_x,feed_y,feed_z,"
                      "spindle_speed_1_min,diameter_mm,teeth,axial_depth_mm,radial_depth_mm,feed_mm_min\n";
    const double errors[] = {0.02, -0.01, 0.015, -0.03, 0.01, -0.02, 0.025, -0.005};
    for (int i = 0; i < 8; ++i) {
        const double depth = 1.0 + i % 4, feed = 600.0 + 300.0 * (i / 4);
        const double force = 850.0 * depth * 6.0 * feed / 60.0 / (std::acos(-1.0) * 6.0 * 200.0);
        text += QByteArray(material) + ',' + QByteArray::number(-force + errors[i], 'g', 12) + ",0," +
                QByteArray::number(0.4 * force + errors[7 - i], 'g', 12) + ",0,0,1,1,0,0,12000,6,2," +
                QByteArray::number(depth) + ",6," + QByteArray::number(feed) + '\n';
    }
    return text;
}

/// Closes a dialog even if a check failed in it, so that the test ends as well.
class Closing {
public:
    explicit Closing(QWidget& dialog) : dialog_(qobject_cast<QDialog*>(&dialog)) {}
    ~Closing() {
        if (dialog_ && dialog_->isVisible()) dialog_->done(QDialog::Rejected);
    }

private:
    QPointer<QDialog> dialog_;
};

const Property* materialIn(const std::vector<Property>& materials, const std::string& id) {
    const auto found = std::ranges::find(materials, id, &Property::id);
    return found == materials.end() ? nullptr : &*found;
}

const Tool* toolIn(const std::vector<Tool>& tools, const std::string& id) {
    const auto found = std::ranges::find(tools, id, &Tool::id);
    return found == tools.end() ? nullptr : &*found;
}

} // namespace

/// What a user brings to a job in addition to the part: materials, a stock from a file, the roles of bodies.
class TestWindowLibrary : public QObject {
    Q_OBJECT
private slots:
    void aMaterialIsCopiedChangedAndTakenBack() {
        WindowDriver driver(QSize(1280, 800));
        Workbench& workbench = driver.window().workbench();
        QVERIFY(open(driver));
        driver.whenDialogStands([&](QWidget& dialog) {
            const Closing closing(dialog);
            QVERIFY(!button(dialog, "deleteMaterialButton").isEnabled()); // a shipped material cannot be deleted
            driver.shoot("library-01-shipped");
            click(dialog, "copyMaterialButton");
            auto* const name = dialog.findChild<QLineEdit*>("materialName");
            QVERIFY(name->hasFocus());
            QTest::keyClicks(name, "Wax of our own");
            auto& table = *dialog.findChild<QTableWidget*>("materialValues");
            const int row = rowOf(table, "specific_cutting_energy");
            QVERIFY(row >= 0);
            enterCell(table, row, 1, "a lot");
            QVERIFY(!button(dialog, "saveMaterialButton").isEnabled());
            QVERIFY(dialog.findChild<Notice*>("materialNotice")->sentence().contains("no number"));
            enterCell(table, row, 1, "0.125");
            click(dialog, "addValueButton");
            QTest::keyClicks(QApplication::focusWidget(), "hardness");
            QTest::keyClick(QApplication::focusWidget(), Qt::Key_Return);
            QTest::qWait(20);
            enterCell(table, rowOf(table, "hardness"), 1, "48");
            enterCell(table, rowOf(table, "hardness"), 2, "ShoreD");
            driver.shoot("library-02-changed");
            QTest::keyClick(&dialog, Qt::Key_S, Qt::ControlModifier);
            QVERIFY(driver.waitFor([&] { return !button(dialog, "saveMaterialButton").isEnabled(); }));
            driver.shoot("library-03-saved");
            click(dialog, "closeMaterialsButton");
        });
        driver.window().setFocus();
        driver.key(Qt::Key_T, Qt::ControlModifier | Qt::ShiftModifier);
        const Property* const own = materialIn(workbench.material.materials(), "machinable-wax-copy");
        QVERIFY(own);
        QCOMPARE(own->name, std::string("Wax of our own"));
        QCOMPARE(own->values.find(specificCuttingEnergy)->second.value, 0.125);
        QCOMPARE(own->values.find(std::string_view("hardness"))->second.unit, std::string("ShoreD"));
        // It can be chosen for the stock at once.
        QVERIFY(materialIn(workbench.setup.materials(), "machinable-wax-copy"));
        for (int i = 0; i < 2; ++i) driver.key(Qt::Key_Z, Qt::ControlModifier);
        QVERIFY(!materialIn(workbench.material.materials(), "machinable-wax-copy"));
    }

    void aMaterialIsCalibrated() {
        WindowDriver driver(QSize(1280, 800));
        Workbench& workbench = driver.window().workbench();
        QVERIFY(open(driver));
        const QString forces = write(driver, "forces.csv", forcesOf("our-alloy"));
        driver.whenDialogStands([&](QWidget& dialog) {
            const Closing closing(dialog);
            driver.whenDialogStands([&](QWidget& calibration) {
                const Closing ending(calibration);
                QVERIFY(!button(calibration, "keepCalibrationButton").isEnabled());
                chooseFile(driver, forces);
                click(calibration, "forceFileButton");
                auto* const projection = calibration.findChild<QComboBox*>("forceProjection");
                projection->setFocus();
                QTest::keyClick(projection, Qt::Key_Down);
                auto* const law = calibration.findChild<QComboBox*>("chipLaw");
                law->setFocus();
                QTest::keyClick(law, Qt::Key_Down);
                QVERIFY(button(calibration, "keepCalibrationButton").isEnabled());
                driver.shoot("library-04-calibrated");
                click(calibration, "keepCalibrationButton");
            });
            click(dialog, "calibrateMaterialButton");
            driver.shoot("library-05-kept");
            click(dialog, "closeMaterialsButton");
        });
        driver.window().setFocus();
        driver.key(Qt::Key_T, Qt::ControlModifier | Qt::ShiftModifier);
        const Property* const made = materialIn(workbench.setup.materials(), "our-alloy");
        QVERIFY(made);
        QVERIFY(std::abs(made->values.find(specificCuttingEnergy)->second.value - 0.85) < 0.01);
        QVERIFY(std::abs(made->values.find(radialForceRatio)->second.value - 0.4) < 0.01);
    }

    /// Changed values of the stock's material apply to the embedded workpiece.
    BURIN_ONLY_IN_LONG_RUNS void aChangedMaterialIsThatOfTheWorkpiece() {
        WindowDriver driver(QSize(1280, 800));
        Workbench& workbench = driver.window().workbench();
        QVERIFY(open(driver));
        workbench.material.copyMaterial(*materialIn(workbench.material.materials(), "machinable-wax"), "Own");
        workbench.setup.chooseStockMaterial("machinable-wax-copy");
        QVERIFY(driver.step(JobStep::stock) && driver.clickOn("embedButton") &&
                driver.waitFor([&] { return workbench.workpiece.ready(); }) && driver.settle());
        Property wax = *materialIn(workbench.material.materials(), "machinable-wax-copy");
        wax.values.find(specificCuttingEnergy)->second.value = 0.25;
        workbench.material.keepMaterial(wax);
        QVERIFY(driver.settle());
        const EmbeddedSetup& embedded = workbench.workpiece.milling()->embedded;
        QCOMPARE(embedded.workpiece.properties()[embedded.stockProperty].valueOr(specificCuttingEnergy, 0.0), 0.25);
        QVERIFY(workbench.workpiece.embedded());
    }

    void aClickIntoTheViewChoosesABody() {
        WindowDriver driver(QSize(1280, 800));
        Workbench& workbench = driver.window().workbench();
        QVERIFY(open(driver));
        QVERIFY(driver.step(JobStep::part));
        auto& viewport = *driver.visible<Viewport>("viewport");
        QTest::qWait(400); // the view turns to the model
        const auto clickAt = [&](const glm::dvec3& place) {
            QTest::mouseClick(&viewport, Qt::LeftButton, {}, viewport.project(place).toPoint());
            driver.settle();
        };
        const std::vector<Body>& bodies = workbench.model.model()->bodies;
        for (const std::size_t body : {std::size_t{1}, std::size_t{0}}) {
            clickAt(bodies[body].box.centre());
            QCOMPARE(driver.visible<RowList>("bodyList")->currentRow(), static_cast<int>(body));
        }
        QTest::keyClick(QApplication::focusWidget(), Qt::Key_End); // the role choice has the focus
        QCOMPARE(roleOf(workbench.setup.setup(), 0), BodyRole::ignored);
        driver.shoot("library-06-picked");
        // In other steps the left button does not select bodies.
        QVERIFY(driver.step(JobStep::stock));
        clickAt(bodies[1].box.centre());
        QVERIFY(driver.step(JobStep::part));
        QCOMPARE(driver.visible<RowList>("bodyList")->currentRow(), 0);
    }

    /// A tool is found, copied, given another shape, drawn, saved and loaded into the spindle; undo reverts all of it.
    void aToolIsCopiedChangedAndUsed() {
        WindowDriver driver(QSize(1280, 800));
        Workbench& workbench = driver.window().workbench();
        QVERIFY(open(driver));
        const std::string before = workbench.tool.current().id;
        driver.whenDialogStands([&](QWidget& dialog) {
            const Closing closing(dialog);
            driver.shoot("library-12-tools");
            QTest::keyClick(&dialog, Qt::Key_F, Qt::ControlModifier);
            auto* const search = dialog.findChild<QLineEdit*>("toolSearch");
            QVERIFY(search->hasFocus());
            QTest::keyClicks(search, "drill 6.8");
            auto* const list = dialog.findChild<RowList*>("toolList");
            QCOMPARE(list->count(), 1);
            QTest::mouseClick(list->viewport(), Qt::LeftButton, {}, list->visualItemRect(list->item(0)).center());
            QVERIFY(!button(dialog, "deleteToolButton").isEnabled()); // a shipped tool
            driver.shoot("library-13-found");
            click(dialog, "copyToolButton");
            auto* const name = dialog.findChild<QLineEdit*>("toolName");
            QVERIFY(name->hasFocus());
            QTest::keyClicks(name, "Countersink");
            auto* const form = dialog.findChild<QComboBox*>("cutter");
            form->setFocus();
            QTest::keyClick(form, Qt::Key_Down); // chamfer, which follows drill
            auto* const holder = dialog.findChild<QComboBox*>("holder");
            holder->setFocus();
            QTest::keyClick(holder, Qt::Key_End);
            driver.shoot("library-14-changed");
            QTest::keyClick(&dialog, Qt::Key_S, Qt::ControlModifier); // a button that is pressed by key reacts late
            QTRY_VERIFY2(!button(dialog, "saveToolButton").isEnabled(),
                         qPrintable(dialog.findChild<Notice*>("toolNotice")->sentence()));
            QTest::keyClick(&dialog, Qt::Key_Return, Qt::ControlModifier);
            QTRY_VERIFY(!button(dialog, "useToolButton").isEnabled());
            driver.shoot("library-15-in-the-spindle");
            click(dialog, "closeToolsButton");
        });
        driver.window().setFocus();
        driver.key(Qt::Key_K, Qt::ControlModifier | Qt::ShiftModifier);
        const Tool& own = workbench.tool.current();
        QCOMPARE(own.id, std::string("drill-6.8-copy"));
        QCOMPARE(own.name, std::string("Countersink"));
        QCOMPARE(own.cutter.type, CutterType::chamfer);
        QCOMPARE(own.cutter.diameter, 6.8);
        const Result<Holder> last = loadHolder("shrink-6-hsk63");
        QVERIFY(last && own.cutter.holder.size() == last->segments.size());
        for (int i = 0; i < 3; ++i) driver.key(Qt::Key_Z, Qt::ControlModifier);
        QCOMPARE(workbench.tool.current().id, before);
        QVERIFY(!loadTool("drill-6.8-copy"));
    }

    void aToolGoesToFreecadAndComesBack() {
        WindowDriver driver(QSize(1280, 800));
        Workbench& workbench = driver.window().workbench();
        QVERIFY(open(driver));
        const QString bit = driver.folder().filePath("own.fctb"), table = driver.folder().filePath("all.tbl");
        driver.whenDialogStands([&](QWidget& dialog) {
            const Closing closing(dialog);
            for (const QString& file : {bit, table}) {
                driver.whenDialogStands([&](QWidget& asking) {
                    auto* const field = asking.findChild<QLineEdit*>("fileNameEdit");
                    field->setText(file);
                    QTest::keyClick(field, Qt::Key_Return);
                });
                click(dialog, "exportToolButton");
                QVERIFY2(QFile::exists(file), qPrintable(dialog.findChild<Notice*>("toolNotice")->sentence()));
            }
            driver.shoot("library-16-exported");
            chooseFile(driver, bit);
            click(dialog, "addToolButton");
            driver.shoot("library-17-added");
            QVERIFY(dialog.findChild<Notice*>("toolNotice")->sentence().contains("Stick-out"));
            click(dialog, "closeToolsButton");
        });
        driver.window().setFocus();
        driver.key(Qt::Key_K, Qt::ControlModifier | Qt::ShiftModifier);
        const Tool* const before = toolIn(workbench.tool.library(), "ball-6");
        const Tool* const added = toolIn(workbench.tool.library(), "ball-end-mill-6-mm");
        QVERIFY(before && added);
        QCOMPARE(added->cutter.type, CutterType::ball);
        QCOMPARE(added->cutter.fluteLength, before->cutter.fluteLength);
        driver.key(Qt::Key_Z, Qt::ControlModifier);
        QVERIFY(!toolIn(workbench.tool.library(), "ball-end-mill-6-mm"));
    }

    /// All tools of a Fusion library are added at once, and one undo removes them all.
    void aLibraryOfAnotherProgramIsAdded() {
        WindowDriver driver(QSize(1280, 800));
        Workbench& workbench = driver.window().workbench();
        QVERIFY(open(driver));
        const std::size_t before = workbench.tool.library().size();
        QString told;
        driver.whenDialogStands([&](QWidget& dialog) {
            const Closing closing(dialog);
            chooseFile(driver, QStringLiteral(BURIN_FIXTURES "/tools/fusion.tools"));
            click(dialog, "addToolButton");
            driver.shoot("library-18-fusion");
            told = dialog.findChild<Notice*>("toolNotice")->sentence();
            click(dialog, "closeToolsButton");
        });
        driver.window().setFocus();
        driver.key(Qt::Key_K, Qt::ControlModifier | Qt::ShiftModifier);
        QVERIFY2(told.contains("6 tools were added to the library") && told.contains("Dovetail 12"), qPrintable(told));
        QCOMPARE(workbench.tool.library().size(), before + 6);
        const Tool* const ball = toolIn(workbench.tool.library(), "ball-3-mm-long");
        QVERIFY(ball && ball->number == 7 && ball->cutter.diameter == 3.0);
        driver.key(Qt::Key_Z, Qt::ControlModifier);
        QCOMPARE(workbench.tool.library().size(), before);
        driver.key(Qt::Key_Z, Qt::ControlModifier | Qt::ShiftModifier);
        QCOMPARE(workbench.tool.library().size(), before + 6);
    }

    /// The expected value is from Pythagoras: a rotating bar of 6 × 8 mm sweeps a cylinder of 10 mm.
    BURIN_ONLY_IN_LONG_RUNS void aToolIsMadeOfAModel() {
        WindowDriver driver(QSize(1280, 800));
        Workbench& workbench = driver.window().workbench();
        QVERIFY(open(driver));
        const QString bar = write(driver, "form tool.stl", stlText(shapes::box({-3.0, -4.0, -5.0}, {3.0, 4.0, 15.0})));
        const std::string before = workbench.tool.current().id;
        driver.whenDialogStands([&](QWidget& dialog) {
            const Closing closing(dialog);
            QVERIFY(!button(dialog, "makeToolButton").isEnabled()); // without a model
            chooseFile(driver, bar);
            click(dialog, "flutesFileButton");
            QCOMPARE(dialog.findChild<QLineEdit*>("toolName")->text(), QString("form tool"));
            driver.shoot("library-09-tool-of-models");
            click(dialog, "makeToolButton");
        });
        driver.window().setFocus();
        driver.key(Qt::Key_L, Qt::ControlModifier | Qt::ShiftModifier);
        QVERIFY(driver.waitFor([&] { return workbench.tool.current().id == "form-tool"; }));
        QCOMPARE(workbench.tool.current().cutter.diameter, 10.0);
        QVERIFY(driver.step(JobStep::stock) && driver.clickOn("embedButton") &&
                driver.waitFor([&] { return workbench.workpiece.ready(); }) && driver.settle());
        QVERIFY(driver.step(JobStep::tool) && driver.settle());
        driver.shoot("library-10-its-profile");
        for (const VisibleText& cut : clippedTexts(driver.window()))
            QFAIL(qPrintable(QStringLiteral("cut: %1: %2").arg(cut.where, cut.text)));
        QVERIFY(driver.step(JobStep::mill) && driver.settle());
        driver.shoot("library-11-in-the-spindle");
        driver.key(Qt::Key_Z, Qt::ControlModifier);
        QCOMPARE(workbench.tool.current().id, before);
        QVERIFY(!loadTool("form-tool"));
    }

    /// A scraper of 8 × 2 mm, turned so that its blade is along Y and drawn along Y with the mouse: the slot is as wide
    /// as the blade is thick, not as wide as what it would sweep in a turn.
    void aScraperMillsASlotOfItsOwn() {
        WindowDriver driver(QSize(1280, 800));
        Workbench& workbench = driver.window().workbench();
        QVERIFY(makeReady(driver));
        const QString blade = write(driver, "scraper.stl", stlText(shapes::box({-4.0, -1.0, 0.0}, {4.0, 1.0, 60.0})));
        driver.whenDialogStands([&](QWidget& dialog) {
            const Closing closing(dialog);
            chooseFile(driver, blade);
            click(dialog, "flutesFileButton");
            auto* direction = dialog.findChild<QDoubleSpinBox*>("toolDirection");
            QVERIFY(!direction->isEnabled());
            dialog.findChild<QComboBox*>("toolMotion")->setFocus();
            QTest::keyClick(dialog.findChild<QComboBox*>("toolMotion"), Qt::Key_Down);
            QVERIFY(direction->isEnabled());
            direction->setFocus();
            direction->selectAll();
            QTest::keyClicks(direction, "90");
            QTest::keyClick(direction, Qt::Key_Tab);
            driver.shoot("library-12-a-scraper-of-a-model");
            for (const VisibleText& cut : clippedTexts(dialog))
                QFAIL(qPrintable(QStringLiteral("cut: %1: %2").arg(cut.where, cut.text)));
            click(dialog, "makeToolButton");
        });
        driver.window().setFocus();
        driver.key(Qt::Key_L, Qt::ControlModifier | Qt::ShiftModifier);
        QVERIFY(driver.waitFor([&] { return workbench.tool.current().id == "scraper"; }));
        const Cutter& cutter = workbench.tool.current().cutter;
        QVERIFY(!cutter.turns() && std::abs(cutter.solid->angle - 0.5 * std::acos(-1.0)) < 1e-9);
        QVERIFY(driver.waitFor([&] {
            return workbench.workpiece.ready() && workbench.workpiece.milling()->tool.id == "scraper";
        }) && driver.settle());
        QVERIFY(driver.step(JobStep::tool) && driver.settle());
        driver.shoot("library-13-it-does-not-turn");
        for (const VisibleText& cut : clippedTexts(driver.window()))
            QFAIL(qPrintable(QStringLiteral("cut: %1: %2").arg(cut.where, cut.text)));
        QVERIFY(workbench.passes.possible() && !menuAction(driver, "newPassAction")->isEnabled()); // it has no passes
        const RunVolume& workpiece = workbench.workpiece.milling()->embedded.workpiece;
        const Grid& grid = workpiece.grid();
        QCOMPARE(grid.axis(), RunAxis::z);
        const Setup& setup = workbench.setup.setup();
        QVERIFY(recordLine(driver, {0.0, -6.0}, {0.0, 6.0}) && driver.settle());
        driver.shoot("library-14-its-slot");
        QVERIFY(removedSoFar(*workbench.workpiece.milling()) > 1.0);
        int width = 0; // scanlines, across the slot in its middle
        const auto v = static_cast<std::int32_t>((setup.workOffset.y - grid.low().y) / grid.edge());
        for (std::int32_t u = 0; u < grid.lineCountU(); ++u) {
            const glm::dvec2 centre = grid.lineCentre({u, v});
            if (std::abs(centre.x - setup.workOffset.x) > 10.0) continue; // beside the stock as well
            const auto line = workpiece.line({u, v});
            const RunPosition top = line.back().property() != airProperty ? grid.lineEnd()
                                    : line.size() > 1                     ? line[line.size() - 2].end()
                                                                          : 0;
            if (grid.toMillimetres(top) < setup.stock.high.z - 0.05) ++width;
        }
        QVERIFY2(width >= 4 && width <= 6, qPrintable(QString::number(width))); // 2 mm, and the mouse may waver
    }

    /// A core drill of 12 × 8 mm, made of a model and pressed down with the mouse: the stock inside it stays.
    BURIN_ONLY_IN_LONG_RUNS void aCoreDrillLeavesACore() {
        WindowDriver driver(QSize(1280, 800));
        Workbench& workbench = driver.window().workbench();
        QVERIFY(makeReady(driver));
        const QString tube = write(driver, "core drill.stl", stlText(shapes::tube(6.0, 4.0, 20.0, 180)));
        driver.whenDialogStands([&](QWidget& dialog) {
            const Closing closing(dialog);
            chooseFile(driver, tube);
            click(dialog, "flutesFileButton");
            click(dialog, "makeToolButton");
        });
        driver.window().setFocus();
        driver.key(Qt::Key_L, Qt::ControlModifier | Qt::ShiftModifier);
        QVERIFY(driver.waitFor([&] { return workbench.tool.current().id == "core-drill"; }));
        const Tool& tool = workbench.tool.current();
        QVERIFY(tool.cutter.turns() && tool.cutter.isHollow());
        QVERIFY2(toolSummary(tool, LengthUnit::millimetre).contains("hollow Ø"),
                 qPrintable(toolSummary(tool, LengthUnit::millimetre)));
        QVERIFY(driver.waitFor([&] {
            return workbench.workpiece.ready() && workbench.workpiece.milling()->tool.id == "core-drill";
        }) && driver.settle());
        QVERIFY(driver.step(JobStep::tool) && driver.settle());
        driver.shoot("library-21-a-core-drill");
        for (const VisibleText& cut : clippedTexts(driver.window()))
            QFAIL(qPrintable(QStringLiteral("cut: %1: %2").arg(cut.where, cut.text)));
        QVERIFY(menuAction(driver, "newPassAction")->isEnabled()); // it turns
        QVERIFY(recordLine(driver, {-0.5, 0.0}, {0.5, 0.0}) && driver.settle());
        driver.shoot("library-22-its-core");
        QVERIFY(removedSoFar(*workbench.workpiece.milling()) > 1.0);
        const RunVolume& workpiece = workbench.workpiece.milling()->embedded.workpiece;
        const Grid& grid = workpiece.grid();
        const Setup& setup = workbench.setup.setup();
        int inside = 0, ring = 0; // lowered scanlines, within 2.5 mm of the centre and from 4.7 to 5.3 mm
        for (LineIndex line{0, 0}; line.v < grid.lineCountV(); ++line.v)
            for (line.u = 0; line.u < grid.lineCountU(); ++line.u) {
                const double radius = glm::distance(grid.lineCentre(line), glm::dvec2(setup.workOffset));
                const auto runs = workpiece.line(line);
                const RunPosition top = runs.back().property() != airProperty ? grid.lineEnd()
                                        : runs.size() > 1                     ? runs[runs.size() - 2].end()
                                                                              : 0;
                if (grid.toMillimetres(top) > setup.stock.high.z - 0.05) continue;
                inside += radius < 2.5 ? 1 : 0;
                ring += radius > 4.7 && radius < 5.3 ? 1 : 0;
            }
        QVERIFY2(inside == 0 && ring > 40, qPrintable(QStringLiteral("%1 %2").arg(inside).arg(ring)));
    }

    BURIN_ONLY_IN_LONG_RUNS void theStockComesFromAFile() {
        WindowDriver driver(QSize(1280, 800));
        Workbench& workbench = driver.window().workbench();
        QVERIFY(open(driver));
        // An array around cube and cylinder, voxels of 0.5 mm: oak below, foam above.
        QByteArray values;
        for (int z = 0; z < 28; ++z) values += QByteArray(72 * 32, z < 14 ? '\1' : '\2');
        const QString array = write(driver, "scan.nrrd",
                                    "NRRD0004\ntype: uint8\ndimension: 3\nspace dimension: 3\nsizes: 72 32 28\n"
                                    "space directions: (0.5,0,0) (0,0.5,0) (0,0,0.5)\nspace units: \"mm\" \"mm\" "
                                    "\"mm\"\nspace origin: (-17.75,-2.75,-1.75)\nencoding: raw\n\n" +
                                        values);
        const QString table =
            write(driver, "scan.json",
                  R"({"entries": [{"value": 1, "material": "oak"}, {"value": 2, "material": "pu-foam"}]})");
        driver.whenDialogStands([&](QWidget& dialog) { // first the array, then its table
            dialog.findChild<QLineEdit*>("fileNameEdit")->setText(array);
            QTest::mouseClick(dialog.findChild<QDialogButtonBox*>("buttonBox")->button(QDialogButtonBox::Open),
                              Qt::LeftButton);
            chooseFile(driver, table);
        });
        driver.window().setFocus();
        driver.key(Qt::Key_B, Qt::ControlModifier | Qt::ShiftModifier);
        QVERIFY(driver.waitFor([&] { return workbench.setup.setup().form == StockForm::file; }));
        QVERIFY2(!workbench.setup.problem(), workbench.setup.problem()->subject.c_str());
        QCOMPARE(workbench.setup.setup().voxel, 0.5);
        QVERIFY(driver.step(JobStep::stock) && driver.settle());
        driver.shoot("library-07-stock-file");
        for (const VisibleText& cut : clippedTexts(driver.window()))
            QFAIL(qPrintable(QStringLiteral("cut: %1: %2").arg(cut.where, cut.text)));
        QVERIFY(driver.clickOn("embedButton") && driver.waitFor([&] { return workbench.workpiece.ready(); }) &&
                driver.settle());
        QVERIFY(driver.step(JobStep::mill) && driver.settle());
        driver.shoot("library-08-scan");
        QCOMPARE(workbench.workpiece.milling()->embedded.untouched.units.size(), std::size_t{256});
        double foam = 0.0;
        for (const MaterialAmount& amount : materialAmounts(workbench.workpiece.milling()->embedded))
            if (amount.id == "pu-foam") foam = amount.volume;
        // The layers above z = 5 mm, less the upper halves of a cube of 10 mm and a cylinder of 10 mm.
        const double exact = 36.0 * 16.0 * 7.0 - 500.0 - std::acos(-1.0) * 25.0 * 5.0;
        QVERIFY2(std::abs(foam / exact - 1.0) < 0.02, qPrintable(QString::number(foam / exact)));
        // It is stored in the project.
        const QString file = driver.folder().filePath("scan.burin");
        QVERIFY(saveAs(driver, file));
        QVERIFY(driver.restart());
        drop(driver.window(), file);
        Workbench& again = driver.window().workbench();
        QVERIFY(driver.waitFor([&] { return again.setup.setup().form == StockForm::file; }));
        QVERIFY(again.setup.setup().volume && again.setup.setup().volume->name() == "scan.nrrd");
    }
};

BURIN_TEST(TestWindowLibrary, QApplication)

} // namespace burin::tst_window_library

#include "tst_window_library.moc"

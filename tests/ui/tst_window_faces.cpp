// SPDX-FileCopyrightText: 2026 The Burin authors
// SPDX-License-Identifier: Apache-2.0
// The table of the part's faces: by mouse and keys.
#include "tests/places.h"
#include "tests/test_program.h"
#include "tests/ui/window_steps.h"
#include "ui/panels/notice.h"
#include "ui/scene/camera_view.h"
#include "ui/window/face_dialog.h"

#include <QApplication>
#include <QClipboard>
#include <QFile>
#include <QHeaderView>
#include <QLabel>
#include <QPushButton>
#include <QScrollArea>
#include <QTableView>
#include <QtTest>

#include <cmath>

namespace burin::tst_window_faces {

using namespace burin::testing;

namespace {

Workbench& workbenchOf(WindowDriver& driver) {
    return driver.window().workbench();
}

/// Drops a program on the window, which checks it: a slot along X across the middle of the top of the block, 0.3 mm
/// into the part.
bool openDeepSlot(WindowDriver& driver) {
    const MillingContext& milling = *workbenchOf(driver).workpiece.milling();
    const double deep = milling.partModel->box().high.z - 0.3 - milling.setup.workOffset.z;
    QFile file(driver.folder().filePath("deep.nc"));
    if (!file.open(QIODevice::WriteOnly)) return false;
    file.write("G21 G90 G17 G94 G54\nM3 S9000\nG0 X-12 Y0\nZ5\nG1 Z" + QByteArray::number(deep, 'f', 4) +
               " F150\nX12 F480\nG0 Z20\nM30\n");
    file.close();
    drop(driver.window(), file.fileName());
    ProgramController& program = workbenchOf(driver).program;
    return driver.waitFor([&] { return program.upToDate() && !program.busy(); }) && driver.settle();
}

FaceDialog* dialogOf(WindowDriver& driver) {
    auto* dialog = driver.window().findChild<FaceDialog*>();
    return dialog != nullptr && dialog->isVisible() ? dialog : nullptr;
}

/// Scrolls to the button of the card and clicks it with the mouse.
bool clickFaces(WindowDriver& driver) {
    auto* page = driver.visible<QScrollArea>("programPage");
    auto* button = driver.visible<QPushButton>("facesButton");
    if (page == nullptr || button == nullptr) return false;
    page->ensureWidgetVisible(button);
    QTest::mouseClick(button, Qt::LeftButton);
    return driver.waitFor([&] { return dialogOf(driver) != nullptr; });
}

QString cell(const QTableView& table, int row, int column) {
    return table.model()->index(row, column).data().toString();
}

void clickRow(QTableView& table, int row) {
    const QRect place = table.visualRect(table.model()->index(row, 1));
    QTest::mouseClick(table.viewport(), Qt::LeftButton, Qt::NoModifier, place.center());
}

} // namespace

class TestWindowFaces : public QObject {
    Q_OBJECT
private slots:
    /// The block of 40 x 30 x 20 mm has six faces of known area, of which only the top is gouged.
    void theTableLeadsToTheWorstPoint() {
        WindowDriver driver(QSize(1600, 950));
        QVERIFY(makeReady(driver, 1.0));
        QVERIFY(!menuAction(driver, "facesAction")->isEnabled());
        QVERIFY(openDeepSlot(driver));
        QVERIFY(driver.waitFor([&] { return driver.visible<QPushButton>("facesButton") != nullptr; }));
        QVERIFY(menuAction(driver, "facesAction")->isEnabled());
        QVERIFY(clickFaces(driver));
        FaceDialog& dialog = *dialogOf(driver);
        QVERIFY(!dialog.isModal());
        auto& table = *dialog.findChild<QTableView*>("faceTable");
        QVERIFY(driver.waitFor([&] { return table.model()->rowCount() == 6; }));
        QVERIFY(driver.waitFor([&] { return !dialog.findChild<QWidget*>("faceProgress")->isVisible(); }));
        // The worst face comes first: the top.
        QCOMPARE(cell(table, 0, FaceTableModel::kind), QStringLiteral("Plane"));
        QVERIFY2(cell(table, 0, FaceTableModel::area).startsWith("1200"), qPrintable(cell(table, 0, 2)));
        QVERIFY2(cell(table, 0, FaceTableModel::gouge).startsWith("0.300"), qPrintable(cell(table, 0, 3)));
        for (int row = 1; row < 6; ++row)
            QVERIFY(cell(table, row, FaceTableModel::gouge).startsWith(QStringLiteral("0.000")));
        QVERIFY(dialog.findChild<QLabel*>("faceSummary")->text().contains("With gouges: 1."));

        // Choosing a row moves the view to its worst point, which is in the slot.
        clickRow(table, 0);
        const Viewport& viewport = driver.window().viewport();
        const Box part = workbenchOf(driver).setup.part()->box();
        const glm::dvec3 focus = viewport.cameraView().focus;
        QVERIFY(std::abs(focus.z - part.high.z) < 0.01 && std::abs(focus.y - part.centre().y) < 4.0);
        const QPointF appears = viewport.project(focus);
        QVERIFY(QLineF(appears, QRectF(viewport.rect()).center()).length() < 2.0);
        driver.shoot("faces-1-gouge");
        keepPicture(dialog, "faces-1-table");
        // The arrow key chooses the next face, a side or the bottom, which is seen from outside.
        QTest::keyClick(&table, Qt::Key_Down);
        QVERIFY(glm::distance(viewport.cameraView().focus, focus) > 1.0);
        driver.shoot("faces-2-side");

        // A click on the header of the numbers sorts the table, and it is copied in that order.
        const QHeaderView& header = *table.horizontalHeader();
        QTest::mouseClick(header.viewport(), Qt::LeftButton, Qt::NoModifier,
                          QPoint(header.sectionViewportPosition(0) + 8, header.height() / 2));
        QCOMPARE(cell(table, 0, FaceTableModel::number), QStringLiteral("1"));
        QCOMPARE(cell(table, 5, FaceTableModel::number), QStringLiteral("6"));
        QTest::mouseClick(dialog.findChild<QPushButton*>("copyFacesButton"), Qt::LeftButton);
        const QStringList lines = QApplication::clipboard()->text().split('\n');
        QVERIFY(lines.size() == 8 && lines[0].startsWith("face\tkind\t") && lines[1].startsWith("1\tplane\t"));

        const QString file = driver.folder().filePath("faces.csv");
        chooseFile(driver, file);
        QTest::mouseClick(dialog.findChild<QPushButton*>("exportFacesButton"), Qt::LeftButton);
        QTRY_VERIFY(driver.message().contains("faces.csv"));
        QFile written(file);
        QVERIFY(written.open(QIODevice::ReadOnly));
        QCOMPARE(QString::fromUtf8(written.readAll()), QApplication::clipboard()->text().replace('\t', ','));

        QTest::keyClick(&table, Qt::Key_Escape);
        QVERIFY(dialogOf(driver) == nullptr && !workbenchOf(driver).faces.faces());
    }

    /// The shortcut opens the table; a change of the program empties it, and the next check fills it again.
    void theTableIsOfTheProgramInForce() {
        WindowDriver driver(QSize(1600, 950));
        QVERIFY(makeReady(driver, 1.0));
        QVERIFY(openDeepSlot(driver));
        driver.key(Qt::Key_J, Qt::ControlModifier | Qt::ShiftModifier);
        QVERIFY(driver.waitFor([&] { return dialogOf(driver) != nullptr && workbenchOf(driver).faces.faces(); }));
        FaceDialog& dialog = *dialogOf(driver);
        auto& table = *dialog.findChild<QTableView*>("faceTable");
        auto& notice = *dialog.findChild<Notice*>("faceNotice");
        QTRY_COMPARE(table.model()->rowCount(), 6);
        QVERIFY(!notice.isVisible());
        ProgramController& program = workbenchOf(driver).program;
        program.editText(QString::fromStdString(program.program()->text) + QStringLiteral("(more)\n"));
        QTRY_COMPARE(table.model()->rowCount(), 0);
        QTRY_VERIFY(notice.sentence().contains("check it again"));
        QVERIFY(!dialog.findChild<QPushButton*>("exportFacesButton")->isEnabled());
        driver.shoot("faces-3-outdated");
        program.checkText("deep.nc");
        QVERIFY(driver.waitFor([&] { return table.model()->rowCount() == 6; }));
        // A cancelled inspection is reported, and runs again when the table is reopened.
        program.setGougeTolerance(0.05);
        QTRY_COMPARE(table.model()->rowCount(), 0);                           // the tolerance has changed
        program.editText(program.storedText() + QStringLiteral("(again)\n")); // an unchanged text is not checked again
        FaceController& faces = workbenchOf(driver).faces;
        bool cancelled = false;
        const auto cancelling = QObject::connect(&faces, &Controller::changed, &dialog, [&] {
            if (!faces.busy()) return;
            dialog.findChild<QPushButton*>("cancelFacesButton")->click();
            // The task is listed until its end is delivered, even if it has been through already.
            for (const TaskRow& row : workbenchOf(driver).tasks().rows())
                if (row.kind == TaskKind::faces) cancelled = row.cancelling;
        });
        program.checkText("deep.nc");
        QVERIFY(driver.waitFor([&] { return program.upToDate() && !program.busy(); }));
        QVERIFY(driver.waitFor([&] { return faces.problem() || faces.faces(); }));
        QVERIFY(QObject::disconnect(cancelling));
        QVERIFY(cancelled);
        // It may have been through before it was cancelled.
        if (!faces.faces()) QTRY_VERIFY(notice.sentence().contains("Cancelled"));
        menuAction(driver, "facesAction")->trigger(); // the dialog has the keyboard, the shortcut is the main window's
        QVERIFY(driver.waitFor([&] { return table.model()->rowCount() == 6; }));
    }
};

BURIN_TEST(TestWindowFaces, QApplication)

} // namespace burin::tst_window_faces

#include "tst_window_faces.moc"

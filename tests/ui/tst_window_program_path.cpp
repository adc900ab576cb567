// SPDX-FileCopyrightText: 2026 The Burin authors
// SPDX-License-Identifier: Apache-2.0
// A program of another system as a path, and the path in the colours of a quantity, by mouse and keys.
#include "tests/test_program.h"
#include "tests/ui/window_steps.h"

#include <QApplication>
#include <QComboBox>
#include <QFile>
#include <QtTest>

#include <algorithm>

namespace burin::tst_window_program_path {

using namespace burin::testing;

namespace {

/// Two slots across the block's top.
constexpr const char* slotProgram = "G21 G90 G17 G94 G54\nM3 S9000\nG0 X-18 Y-5\nZ5\nG1 Z-1 F150\nX18 F480\nG0 Z5\n"
                                    "X18 Y5\nG1 Z-2 F150\nX-18 F240\nG0 Z20\nM30\n";

QString write(const WindowDriver& driver, const char* name, const QByteArray& text) {
    const QString path = driver.folder().filePath(name);
    QFile file(path);
    if (file.open(QIODevice::WriteOnly)) file.write(text);
    return path;
}

Workbench& workbenchOf(WindowDriver& driver) {
    return driver.window().workbench();
}

const EvaluatedPath* evaluatedIn(WindowDriver& driver) {
    const PathController& path = workbenchOf(driver).path;
    return path.outdated() || path.busy() ? nullptr : path.evaluated().get();
}

double mostFeed(const EvaluatedPath& path) {
    return std::ranges::max_element(path.path.points, {}, &PathPoint::feed)->feed;
}

bool openSlots(WindowDriver& driver) {
    const QString file = write(driver, "slots.nc", slotProgram);
    chooseFile(driver, file);
    driver.key(Qt::Key_G, Qt::ControlModifier | Qt::AltModifier);
    return driver.waitFor([&] { return evaluatedIn(driver) != nullptr; });
}

} // namespace

class TestWindowProgramPath : public QObject {
    Q_OBJECT
private slots:
    /// Opened, undone, redone, edited and posted again.
    void aProgramIsEditedAsAPath() {
        WindowDriver driver;
        QVERIFY(makeReady(driver, 1.0));
        QVERIFY(openSlots(driver));
        QVERIFY2(driver.message().contains("85") && driver.message().contains("feeds"), qPrintable(driver.message()));
        QCOMPARE(mostFeed(*evaluatedIn(driver)), 480.0);
        driver.shoot("program-path-1-opened");
        driver.key(Qt::Key_Z, Qt::ControlModifier);
        QTRY_VERIFY(workbenchOf(driver).path.stored() == nullptr);
        driver.key(Qt::Key_Z, Qt::ControlModifier | Qt::ShiftModifier);
        QTRY_VERIFY_WITH_TIMEOUT(evaluatedIn(driver) != nullptr, 30000);
        QVERIFY(postProgram(driver));
        const auto& program = workbenchOf(driver).program.program();
        QVERIFY(program && program->passed());
        for (const char* word : {"S9000", "F480", "F240"})
            QVERIFY2(program->text.find(word) != std::string::npos, program->text.c_str());
    }

    /// Cutter locations that are dropped on the window immediately become a path.
    void cutterLocationsAreDropped() {
        WindowDriver driver;
        const QString file = write(driver, "slot.cls",
                                   "PARTNO SLOT\nUNITS/MM\nSPINDL/9000,RPM,CLW\nRAPID\nGOTO/-18,0,5\nFEDRAT/480,MMPM\n"
                                   "GOTO/-18,0,-1\nGOTO/18,0,-1\nFINI\n");
        drop(driver.window(), file);
        QTRY_VERIFY(driver.message().contains("embed"));
        QVERIFY(makeReady(driver, 1.0));
        drop(driver.window(), file);
        QTRY_VERIFY_WITH_TIMEOUT(evaluatedIn(driver) != nullptr, 30000);
        QCOMPARE(mostFeed(*evaluatedIn(driver)), 480.0);
        const QString wrong = write(driver, "bad.cls", "FEDRAT/100\nGOTO/0,0,0\nCUTCOM/LEFT\n");
        drop(driver.window(), wrong);
        QTRY_VERIFY2(driver.message().contains("line 3"), qPrintable(driver.message()));
        QCOMPARE(workbenchOf(driver).path.passes().size(), std::size_t{1});
    }

    /// Each quantity has its colours, which follow changes of the path.
    void thePathShowsAQuantity() {
        WindowDriver driver(QSize(1280, 920));
        QVERIFY(makeReady(driver, 1.0));
        auto* colours = driver.window().findChild<QComboBox*>("pathColour");
        QVERIFY(colours && !colours->isVisible()); // there is no path yet
        QVERIFY(openSlots(driver));
        QVERIFY(driver.waitFor([&] { return colours->isVisible(); }));
        QCOMPARE(colours->count(), 7);
        auto& viewport = *driver.visible<Viewport>("viewport");
        const QImage plain = viewport.grabFramebuffer();
        std::vector<QImage> pictures;
        for (int i = 1; i < colours->count(); ++i) {
            driver.key(Qt::Key_7, Qt::ControlModifier);
            QCOMPARE(colours->currentIndex(), i);
            QVERIFY(driver.waitFor([&] { return workbenchOf(driver).pathValuer.values() != nullptr; }));
            pictures.push_back(viewport.grabFramebuffer());
            QVERIFY(pictures.back() != plain);
            driver.shoot(QStringLiteral("path-colours-%1").arg(i));
        }
        for (std::size_t i = 1; i < pictures.size(); ++i) QVERIFY(pictures[i] != pictures[i - 1]);
        // By the list: feeds, which change with the edit.
        colours->setFocus();
        QTest::keyClick(colours, Qt::Key_Home);
        QTest::keyClick(colours, Qt::Key_Down);
        QVERIFY(driver.waitFor([&] {
            const auto values = workbenchOf(driver).pathValuer.values();
            return values && values->quantity == PathQuantity::feed && values->high == 480.0;
        }));
        const std::vector<Edit> edits = workbenchOf(driver).path.stored()->edits;
        const auto feeds = std::ranges::find_if(
            edits, [](const Edit& edit) { return std::holds_alternative<SetFeed>(edit.parameters); });
        SetFeed half = std::get<SetFeed>(feeds->parameters);
        half.feedFactor = 0.5;
        workbenchOf(driver).path.changeEdit(static_cast<std::size_t>(feeds - edits.begin()), {half});
        QVERIFY(driver.waitFor([&] {
            const auto values = workbenchOf(driver).pathValuer.values();
            return values && values->high == 240.0;
        }));
        colours->setFocus();
        QTest::keyClick(colours, Qt::Key_Home);
        QVERIFY(workbenchOf(driver).pathValuer.values() == nullptr);
    }
};

BURIN_TEST(TestWindowProgramPath, QApplication)

} // namespace burin::tst_window_program_path

#include "tst_window_program_path.moc"

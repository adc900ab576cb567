// SPDX-FileCopyrightText: 2026 The Burin authors
// SPDX-License-Identifier: Apache-2.0
#include "tests/ui/window_driver.h"
#include "ui/messages/messages.h"

#include <QComboBox>
#include <QDialogButtonBox>
#include <QFile>
#include <QFileDialog>
#include <QLabel>
#include <QLineEdit>
#include <QMimeData>
#include <QPushButton>
#include <QtTest>

#include <cmath>

using namespace burin;
using burin::testing::WindowDriver;

namespace {

void drop(MainWindow& window, const QString& file) {
    QMimeData data;
    data.setUrls({QUrl::fromLocalFile(file)});
    QDragEnterEvent enter(QPoint(400, 400), Qt::CopyAction, &data, Qt::LeftButton, Qt::NoModifier);
    QCoreApplication::sendEvent(&window, &enter);
    if (!enter.isAccepted()) return;
    QDropEvent dropped(QPointF(400, 400), Qt::CopyAction, &data, Qt::LeftButton, Qt::NoModifier);
    QCoreApplication::sendEvent(&window, &dropped);
}

/// A block of 40 x 30 x 20 mm as an STL file: read in a moment.
QString writeBlock(const WindowDriver& driver) {
    constexpr int faces[12][3] = {{0, 2, 1}, {1, 2, 3}, {4, 5, 6}, {5, 7, 6}, {0, 1, 4}, {1, 5, 4},
                                  {2, 6, 3}, {3, 6, 7}, {0, 4, 2}, {2, 4, 6}, {1, 3, 5}, {3, 7, 5}};
    QString text = "solid block\n";
    for (const auto& face : faces) {
        text += "facet normal 0 0 0\nouter loop\n";
        for (const int corner : face)
            text += QString("vertex %1 %2 %3\n")
                        .arg((corner & 1) != 0 ? 40 : 0)
                        .arg((corner & 2) != 0 ? 30 : 0)
                        .arg((corner & 4) != 0 ? 20 : 0);
        text += "endloop\nendfacet\n";
    }
    QFile file(driver.folder().filePath("block.stl"));
    if (file.open(QIODevice::WriteOnly)) file.write((text + "endsolid block\n").toLatin1());
    return file.fileName();
}

/// Drops the block on the window and embeds it.
bool makeReady(WindowDriver& driver) {
    Workbench& bench = driver.window().workbench();
    drop(driver.window(), writeBlock(driver));
    if (!driver.waitFor([&] { return bench.model.model() != nullptr; })) return false;
    if (!driver.step(JobStep::stock) || !driver.clickOn("embedButton")) return false;
    return driver.waitFor([&] { return bench.bench.ready(); }) && driver.settle();
}

/// Draws a line on the stock's top with the left button down. Places in mm from the middle of the stock's top.
void millLine(WindowDriver& driver, const glm::dvec2& from, const glm::dvec2& to) {
    Viewport& viewport = driver.window().viewport();
    const Setup& setup = driver.window().workbench().setup.setup();
    const auto at = [&](const glm::dvec2& place) {
        return viewport.project(setup.workOffset + glm::dvec3(place, 0.0)).toPoint();
    };
    QTest::mouseMove(&viewport, at(from));
    QTest::qWait(300);
    QTest::mousePress(&viewport, Qt::LeftButton, Qt::NoModifier, at(from));
    constexpr int steps = 40;
    for (int i = 0; i <= steps; ++i) {
        QTest::mouseMove(&viewport, at(glm::mix(from, to, static_cast<double>(i) / steps)));
        QTest::qWait(20);
    }
    QTest::qWait(400);
    QTest::mouseRelease(&viewport, Qt::LeftButton, Qt::NoModifier, at(to));
    QTest::qWait(200);
}

/// Gives the file dialog that comes a name, and takes it.
void chooseFile(WindowDriver& driver, const QString& file) {
    driver.whenDialogStands([file](QWidget& dialog) {
        auto* name = dialog.findChild<QLineEdit*>("fileNameEdit");
        auto* buttons = dialog.findChild<QDialogButtonBox*>("buttonBox");
        if (name == nullptr || buttons == nullptr) return;
        name->setText(file); // typing would open a list of names above the button
        for (const auto button : {QDialogButtonBox::Save, QDialogButtonBox::Open})
            if (QPushButton* accept = buttons->button(button)) QTest::mouseClick(accept, Qt::LeftButton);
    });
}

bool answer(QWidget& dialog, const char* button) {
    auto* found = dialog.findChild<QWidget*>(button);
    if (found != nullptr) QTest::mouseClick(found, Qt::LeftButton);
    return found != nullptr;
}

double removedSoFar(const Bench& bench) {
    return bench.embedded.stockVolume - bench.workpieceVolume();
}

} // namespace

class TestWindow : public QObject {
    Q_OBJECT
private slots:
    void eachStepTellsWhatItHolds();
    void strokesAreMilledTakenBackSavedAndFoundAgain();
    void settingsCanBeTakenBack();
    void unitAndThemeChangeAtOnce();
    void unsavedChangesAreGuarded();
    void aWrongFileCostsOneSentence();
    void unsavedWorkIsThereAfterAnEndFromOutside();
    void theVirtualOperatorShowsHowItIsDone();
};

void TestWindow::eachStepTellsWhatItHolds() {
    WindowDriver driver(QSize(1280, 800));
    Workbench& bench = driver.window().workbench();
    driver.shoot("small-01-welcome");
    QVERIFY(driver.clickOn("samplePartButton"));
    QVERIFY(driver.waitFor([&] { return bench.model.model() != nullptr; }));
    const std::pair<JobStep, const char*> before[] = {{JobStep::part, "part"},           {JobStep::stock, "stock"},
                                                      {JobStep::material, "material"},   {JobStep::tool, "tool"},
                                                      {JobStep::allowance, "allowance"}, {JobStep::mill, "mill"},
                                                      {JobStep::path, "path"},           {JobStep::program, "program"}};
    for (const auto& [step, name] : before) {
        QVERIFY(driver.step(step));
        driver.shoot(QStringLiteral("small-02-%1").arg(name));
    }
    // Nothing can be milled yet, and the panel says what is to be done first.
    QVERIFY(driver.step(JobStep::mill));
    QVERIFY(!driver.visible<QWidget>("millButton")->isEnabled());
    QVERIFY(driver.visible<QWidget>("millMissing") != nullptr);
    QVERIFY(driver.step(JobStep::stock));
    QVERIFY(driver.clickOn("embedButton"));
    QVERIFY(driver.waitFor([&] { return bench.bench.ready(); }));
    QVERIFY(driver.step(JobStep::mill));
    QVERIFY(driver.clickOn("millButton"));
    QVERIFY(driver.waitFor([&] { return bench.mill.active(); }));
    QTest::qWait(300);
    driver.shoot("small-03-mill");
    driver.key(Qt::Key_Escape);
    QVERIFY(driver.waitFor([&] { return !bench.mill.active(); }, 5000));
}

void TestWindow::strokesAreMilledTakenBackSavedAndFoundAgain() {
    WindowDriver driver;
    Workbench& bench = driver.window().workbench();
    driver.shoot("01-welcome");
    QVERIFY(makeReady(driver));
    driver.shoot("02-embedded");
    QVERIFY(driver.step(JobStep::mill));
    QVERIFY(driver.clickOn("recordButton")); // takes the tool in hand as well
    QVERIFY(driver.waitFor([&] { return bench.mill.recording(); }, 5000));
    millLine(driver, {-20, -12}, {20, -12});
    driver.shoot("03-first-stroke");
    QVERIFY(driver.waitFor([&] { return bench.bench.strokes().count() == 1; }, 3000));
    millLine(driver, {-20, 0}, {20, 0});
    QVERIFY(driver.waitFor([&] { return bench.bench.strokes().count() == 2; }, 3000));
    driver.key(Qt::Key_Z, Qt::ControlModifier);
    QVERIFY(driver.waitFor([&] { return bench.bench.strokes().count() == 1; }, 3000));
    driver.key(Qt::Key_Z, Qt::ControlModifier | Qt::ShiftModifier);
    QVERIFY(driver.waitFor([&] { return bench.bench.strokes().count() == 2; }, 3000));
    driver.key(Qt::Key_Z, Qt::ControlModifier);
    QVERIFY(driver.waitFor([&] { return bench.bench.strokes().count() == 1; }, 3000));
    driver.key(Qt::Key_Escape);
    QVERIFY(driver.waitFor([&] { return !bench.session.running(); }, 5000));
    QCOMPARE(bench.mill.takes().size(), std::size_t{1});
    QVERIFY(bench.setup.locked());
    const double removed = removedSoFar(*bench.bench.bench());
    // One groove of a ball of 6 mm, 1 mm deep and about 40 mm long: a segment of the circle of 3.0 mm².
    const double section = 9.0 * std::acos(2.0 / 3.0) - 2.0 * std::sqrt(5.0);
    QVERIFY2(removed > 0.7 * 40.0 * section && removed < 1.3 * 40.0 * section, qPrintable(QString::number(removed)));
    QVERIFY(driver.step(JobStep::path));
    QVERIFY(driver.clickOn("newPathButton"));
    QVERIFY(driver.waitFor([&] { return bench.path.evaluated() != nullptr; }));
    driver.shoot("04-path");
    QVERIFY(driver.step(JobStep::program));
    QVERIFY(driver.clickOn("postButton"));
    QVERIFY(driver.settle());
    QVERIFY2(!bench.program.problem(),
             bench.program.problem() ? qPrintable(Messages::sentence(*bench.program.problem())) : "");
    QVERIFY(bench.program.program() != nullptr);
    driver.shoot("05-program");
    QVERIFY(bench.program.exportable());
    const QString program = driver.folder().filePath("groove.ngc");
    chooseFile(driver, program);
    QVERIFY(driver.clickOn("exportButton"));
    QVERIFY(driver.waitFor([&] { return QFile::exists(program); }, 5000));

    const QString file = driver.folder().filePath("groove.burin");
    chooseFile(driver, file);
    driver.key(Qt::Key_S, Qt::ControlModifier);
    QVERIFY(driver.waitFor([&] { return QFile::exists(file) && !bench.document.unsaved(); }, 5000));
    QCOMPARE(bench.document.title(), QString("groove"));
    QVERIFY(driver.restart());
    driver.shoot("06-welcome-recent");
    QVERIFY(driver.clickOn("recentFileButton"));
    Workbench& again = driver.window().workbench();
    QVERIFY(driver.waitFor([&] { return again.bench.ready(); }));
    QCOMPARE(again.mill.takes().size(), std::size_t{1});
    QCOMPARE(again.mill.strokesOf(again.mill.takes().front().id), std::size_t{1});
    // Replayed from the recording: exactly what the hand left.
    QCOMPARE(removedSoFar(*again.bench.bench()), removed);
    driver.shoot("07-reopened");
}

void TestWindow::settingsCanBeTakenBack() {
    WindowDriver driver;
    Workbench& bench = driver.window().workbench();
    QVERIFY(makeReady(driver));
    const double voxel = bench.setup.setup().voxel;
    QVERIFY(voxel != 1.0);
    auto* field = driver.visible<QWidget>("voxelField");
    QVERIFY(field != nullptr);
    field->setFocus();
    QTest::keyClick(field, Qt::Key_A, Qt::ControlModifier);
    QTest::keyClicks(field, "1");
    QTest::keyClick(field, Qt::Key_Return);
    QTRY_COMPARE(bench.setup.setup().voxel, 1.0);
    QVERIFY(!bench.bench.embedded());
    QVERIFY(driver.step(JobStep::material));
    QVERIFY(driver.step(JobStep::stock));
    driver.window().setFocus();
    driver.key(Qt::Key_Z, Qt::ControlModifier);
    QTRY_COMPARE(bench.setup.setup().voxel, voxel);
    QVERIFY(bench.bench.embedded()); // it still stands as it was
    driver.key(Qt::Key_Z, Qt::ControlModifier | Qt::ShiftModifier);
    QTRY_COMPARE(bench.setup.setup().voxel, 1.0);
}

void TestWindow::unitAndThemeChangeAtOnce() {
    WindowDriver driver;
    QVERIFY(makeReady(driver));
    QVERIFY(driver.step(JobStep::allowance));
    driver.whenDialogStands([&](QWidget& dialog) {
        for (const char* choice : {"unitChoice", "themeChoice"}) {
            auto* box = dialog.findChild<QComboBox*>(choice);
            box->setFocus();
            QTest::keyClick(box, Qt::Key_Down);
        }
        QTest::qWait(200);
        dialog.grab().save(QStringLiteral(BURIN_BUILD_DIRECTORY "/tests/screenshots/08-preferences.png"));
        QTest::keyClick(&dialog, Qt::Key_Escape);
    });
    driver.key(Qt::Key_Comma, Qt::ControlModifier);
    driver.shoot("09-light-inch");
    QCOMPARE(driver.window().palette().color(QPalette::Window).lightness() > 128, true);
    auto* step = driver.visible<QWidget>("stepAllowance");
    QVERIFY(step != nullptr);
    QVERIFY(driver.restart(true)); // and they are there the next time
    QCOMPARE(UserSettings().preferences().unit, LengthUnit::inch);
    QCOMPARE(UserSettings().preferences().theme, Theme::light);
    driver.shoot("10-light-welcome");
}

void TestWindow::unsavedChangesAreGuarded() {
    WindowDriver driver;
    QVERIFY(makeReady(driver));
    QTRY_VERIFY(driver.window().workbench().document.unsaved());
    bool asked = false;
    driver.whenDialogStands([&](QWidget& dialog) {
        dialog.grab().save(QStringLiteral(BURIN_BUILD_DIRECTORY "/tests/screenshots/11-unsaved.png"));
        asked = answer(dialog, "cancelButton");
    });
    driver.window().close();
    QVERIFY(asked);
    QVERIFY(driver.window().isVisible());
    driver.whenDialogStands([&](QWidget& dialog) { answer(dialog, "discardButton"); });
    QVERIFY(driver.restart());
    QVERIFY(driver.visible<QWidget>("recoverButton") == nullptr); // it was not wanted
}

void TestWindow::aWrongFileCostsOneSentence() {
    WindowDriver driver;
    const QString file = driver.folder().filePath("letter.txt");
    QFile letter(file);
    QVERIFY(letter.open(QIODevice::WriteOnly) && letter.write("Dear Emil, this is no part.\n") > 0);
    letter.close();
    drop(driver.window(), file);
    QVERIFY(driver.waitFor([&] { return !driver.message().isEmpty(); }));
    QVERIFY2(driver.message().contains("letter.txt") && driver.message().endsWith('.'), qPrintable(driver.message()));
    driver.shoot("12-wrong-file");
    QVERIFY(driver.clickOn("dismissMessageButton"));
    QCOMPARE(driver.message(), QString());
    const QString project = driver.folder().filePath("no.burin");
    QVERIFY(QFile::copy(file, project));
    drop(driver.window(), project);
    QVERIFY(driver.waitFor([&] { return driver.message().contains("no.burin"); }));
}

void TestWindow::unsavedWorkIsThereAfterAnEndFromOutside() {
    WindowDriver driver;
    QVERIFY(makeReady(driver));
    QVERIFY(driver.restart(true));
    driver.shoot("13-recover");
    QVERIFY(driver.clickOn("recoverButton"));
    Workbench& bench = driver.window().workbench();
    QVERIFY(driver.waitFor([&] { return bench.model.model() != nullptr; }));
    QCOMPARE(bench.model.model()->bodies.size(), std::size_t{1});
    QTRY_VERIFY(bench.document.unsaved());
    QVERIFY(bench.document.isUnnamed());
}

void TestWindow::theVirtualOperatorShowsHowItIsDone() {
    WindowDriver driver;
    Workbench& bench = driver.window().workbench();
    QVERIFY(driver.clickOn("welcomeShowMeButton"));
    QVERIFY(
        driver.waitFor([&] { return bench.session.running() && bench.session.state().recordedSeconds > 20.0; }, 60000));
    driver.shoot("14-show-me");
    QVERIFY(driver.clickOn("showMeButton")); // stops it
    QVERIFY(driver.waitFor([&] { return !bench.session.running() && !bench.showMe.showing(); }, 5000));
    QVERIFY(driver.waitFor([&] { return !bench.mill.takes().empty() && bench.mill.takes().front().complete; }));
    QVERIFY(bench.mill.takes().front().sampleCount >= 20000); // what was recorded stays
    QVERIFY(driver.waitFor([&] { return bench.path.evaluated() != nullptr; }));
    driver.shoot("15-shown-path");
}

QTEST_MAIN(TestWindow)
#include "tst_window.moc"

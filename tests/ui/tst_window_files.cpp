// SPDX-FileCopyrightText: 2026 The Burin authors
// SPDX-License-Identifier: Apache-2.0
#include "tests/core/geometry/shapes.h"
#include "tests/long_run.h"
#include "tests/places.h"
#include "tests/stl_text.h"
#include "tests/test_program.h"
#include "tests/ui/window_steps.h"

#include <QApplication>
#include <QFile>
#include <QPushButton>
#include <QtTest>

#include <sqlite3.h>
#include <sys/stat.h>

namespace burin::tst_window_files {

using namespace burin::testing;

/// Files that a user drops, opens or clicks by mistake.
class TestWindowFiles : public QObject {
    Q_OBJECT
private slots:
    void aWrongFileLeavesTheOpenProjectAsItIs();
    void aProgramNeedsAWorkpiece();
    BURIN_ONLY_IN_LONG_RUNS void theQuestionComesOnceTheFileIsKnownToBeGood();
    void aMissingRecentFileIsTakenOffTheList();
    void whatIsOpenAlreadyIsShown();
    BURIN_ONLY_IN_LONG_RUNS void whatWasSaidOfAFileEndsWithTheNextOne();
    void aPartThatWasChangedIsReadAgain();
};

namespace {

QString write(const WindowDriver& driver, const char* name, const QByteArray& content) {
    QFile file(driver.folder().filePath(name));
    if (file.open(QIODevice::WriteOnly)) file.write(content);
    return file.fileName();
}

QByteArray contentOf(const QString& name) {
    QFile file(name);
    return file.open(QIODevice::ReadOnly) ? file.readAll() : QByteArray();
}

/// A project that claims to be of a future version.
QString writeNewer(const WindowDriver& driver, const QString& project) {
    const QString newer = driver.folder().filePath("newer.burin");
    if (!QFile::copy(project, newer)) return {};
    sqlite3* database = nullptr;
    if (sqlite3_open(newer.toUtf8().constData(), &database) == SQLITE_OK)
        sqlite3_exec(database, "PRAGMA user_version = 999", nullptr, nullptr, nullptr);
    sqlite3_close(database);
    return newer;
}

/// Records one stroke and leaves it unsaved, so that another part needs another project.
bool milledAndUnsaved(WindowDriver& driver) {
    const Workbench& workbench = driver.window().workbench();
    return makeReady(driver, 1.0) && recordLine(driver, {-10, 0}, {10, 0}) && driver.settle() &&
           driver.waitFor([&] { return workbench.mill.takes().size() == 1 && workbench.document.unsaved(); });
}

} // namespace

void TestWindowFiles::aWrongFileLeavesTheOpenProjectAsItIs() {
    WindowDriver driver;
    QVERIFY(milledAndUnsaved(driver));
    Workbench& workbench = driver.window().workbench();
    const auto fixture = QStringLiteral(BURIN_FIXTURES "/projects/v3/");
    const QString whole = QDir(fixture).filePath(QDir(fixture).entryList({"*.burin"}).value(0));
    const QByteArray project = contentOf(whole);
    QVERIFY(project.size() > 20000);
    const QString pipe = driver.folder().filePath("pipe.burin");
    QCOMPARE(::mkfifo(pipe.toLocal8Bit().constData(), 0600), 0);
    const QString unreadable = write(driver, "secret.step", "ISO-10303-21;");
    const bool locked = QFile::setPermissions(unreadable, {}) && !QFile(unreadable).open(QIODevice::ReadOnly);
    QStringList files{write(driver, "empty.burin", {}),
                      write(driver, "empty.step", {}),
                      write(driver, "letter.step", "Dear Emil, this is no part.\n"),
                      write(driver, "letter.burin", "Dear Emil, this is no project.\n"),
                      write(driver, "cut.burin", project.left(project.size() / 2)),
                      write(driver, "stub.burin", project.left(60)),
                      driver.folder().filePath("none.step"),
                      driver.folder().filePath("none.burin"),
                      pipe,
                      writeNewer(driver, whole)};
    QVERIFY(QDir(driver.folder().path()).mkdir("folder.burin"));
    files << driver.folder().filePath("folder.burin");
    if (locked) files << unreadable; // root can read everything

    const auto open = workbench.document.file();
    const auto model = workbench.model.model();
    const auto workpiece = workbench.workpiece.milling();
    const QString title = driver.window().windowTitle();
    const int undo = workbench.undo().index();
    QVERIFY(undo > 0);
    bool asked = false;
    for (const QString& file : files) {
        driver.whenDialogStands([&](QWidget& dialog) { asked = answer(dialog, "cancelButton"); });
        drop(driver.window(), file);
        const QString name = QFileInfo(file).fileName();
        QVERIFY2(driver.waitFor([&] { return driver.message().contains(name); }), qPrintable(name));
        QVERIFY2(driver.message().endsWith('.') && driver.message().count(QStringLiteral(". ")) == 0,
                 qPrintable(driver.message()));
        QVERIFY2(!asked, qPrintable(name));
        QVERIFY(driver.settle());
        QVERIFY2(workbench.document.file() == open && workbench.model.model() == model &&
                     workbench.workpiece.milling() == workpiece,
                 qPrintable(name));
        QCOMPARE(driver.window().windowTitle(), title);
        QCOMPARE(workbench.undo().index(), undo);
        QVERIFY(workbench.document.unsaved());
        QCOMPARE(workbench.mill.takes().size(), std::size_t{1});
    }
    driver.shoot("40-wrong-file-on-open-project");
    QVERIFY(driver.clickOn("dismissMessageButton"));
}

/// A program is shown on a workpiece: without one, nothing changes.
void TestWindowFiles::aProgramNeedsAWorkpiece() {
    WindowDriver driver;
    drop(driver.window(), write(driver, "part.ngc", "G21\nG0 X1 Y2\nG1 Z-1 F100\nM2\n"));
    QVERIFY(driver.waitFor([&] { return driver.message().contains(QStringLiteral("part.ngc")); }));
    QVERIFY(driver.message().endsWith('.'));
    QVERIFY(driver.settle() && !driver.window().workbench().document.isOpen());
    QVERIFY(driver.window().workbench().program.storedText().isEmpty());
}

void TestWindowFiles::theQuestionComesOnceTheFileIsKnownToBeGood() {
    WindowDriver driver;
    QVERIFY(milledAndUnsaved(driver));
    Workbench& workbench = driver.window().workbench();
    const auto open = workbench.document.file();
    const QString part = driver.folder().filePath("other.stl");
    QVERIFY(QFile::copy(driver.folder().filePath("block.stl"), part));
    const QString fixture = QStringLiteral(BURIN_FIXTURES "/projects/v3/");
    const QString project = driver.folder().filePath("good.burin");
    QVERIFY(QFile::copy(QDir(fixture).filePath(QDir(fixture).entryList({"*.burin"}).value(0)), project));
    const QByteArray before = contentOf(project);
    for (const QString& file : {part, project}) {
        bool asked = false;
        driver.whenDialogStands([&](QWidget& dialog) { asked = answer(dialog, "cancelButton"); });
        drop(driver.window(), file);
        QVERIFY(driver.waitFor([&] { return asked; }));
        QVERIFY(driver.settle());
        QCOMPARE(workbench.document.file(), open);
        QCOMPARE(workbench.mill.takes().size(), std::size_t{1});
    }
    QCOMPARE(contentOf(project), before);
    QVERIFY(!QFile::exists(driver.folder().filePath(".good.burin.working"))); // and the project is no longer locked
    driver.whenDialogStands([&](QWidget& dialog) { answer(dialog, "discardButton"); });
    drop(driver.window(), project);
    QVERIFY(driver.waitFor([&] { return workbench.document.file() == project.toStdString(); }));
    QVERIFY(driver.settle());
}

void TestWindowFiles::aMissingRecentFileIsTakenOffTheList() {
    WindowDriver driver;
    QVERIFY(makeReady(driver, 1.0));
    const QString file = driver.folder().filePath("gone.burin");
    QVERIFY(saveAs(driver, file));
    QVERIFY(driver.restart(true));
    QVERIFY(QFile::remove(file));
    QString question;
    driver.whenDialogStands([&](QWidget& dialog) { answer(dialog, "cancelButton"); });
    QVERIFY(driver.clickOn("recentFileButton"));
    QCOMPARE(UserSettings().recentFiles(), QStringList{file}); // it stays until the user removes it
    driver.whenDialogStands([&](QWidget& dialog) {
        keepPicture(dialog, "41-missing-recent");
        answer(dialog, "confirmButton");
    });
    QVERIFY(driver.clickOn("recentFileButton"));
    QVERIFY(driver.waitFor([&] { return UserSettings().recentFiles().isEmpty(); }));
    QVERIFY(driver.waitFor([&] { return driver.visible<QWidget>("recentFileButton") == nullptr; }));
}

void TestWindowFiles::whatIsOpenAlreadyIsShown() {
    WindowDriver driver;
    QVERIFY(driver.visible<QWidget>("escapeStatus") == nullptr); // there is no project to go back to
    QVERIFY(makeReady(driver, 1.0));
    const QString file = driver.folder().filePath("here.burin");
    QVERIFY(saveAs(driver, file));
    driver.key(Qt::Key_F1, Qt::ControlModifier | Qt::ShiftModifier);
    QVERIFY(driver.waitFor([&] { return driver.visible<QWidget>("recentFileButton") != nullptr; }));
    const auto workpiece = driver.window().workbench().workpiece.milling();
    QVERIFY(driver.clickOn("recentFileButton"));
    QVERIFY(driver.waitFor([&] { return driver.visible<QWidget>("workPage") != nullptr; }));
    QCOMPARE(driver.window().workbench().workpiece.milling(), workpiece);
}

/// As soon as the next file is dropped, not only when it is imported: until then the message would be about the wrong
/// file.
void TestWindowFiles::whatWasSaidOfAFileEndsWithTheNextOne() {
    WindowDriver driver;
    drop(driver.window(), write(driver, "letter.step", "Dear Emil, this is no part.\n"));
    QVERIFY(driver.waitFor([&] { return driver.message().contains(QStringLiteral("letter.step")); }));
    QVERIFY(driver.clickOn("samplePartButton"));
    QVERIFY(!driver.window().workbench().model.model());
    QCOMPARE(driver.message(), QString());
    QVERIFY(driver.settle());
}

/// A pocket is added in the CAD system after a stroke was recorded: stock, zero and recording stay, and the workpiece
/// is embedded again with the new part.
void TestWindowFiles::aPartThatWasChangedIsReadAgain() {
    WindowDriver driver;
    Workbench& workbench = driver.window().workbench();
    QVERIFY(milledAndUnsaved(driver));
    const Setup before = workbench.setup.setup();
    const double volume = workbench.model.model()->volume();
    write(driver, "block.stl", stlText(shapes::box(glm::dvec3(0.0), {40.0, 30.0, 18.0}), "block"));
    driver.key(Qt::Key_U, Qt::ControlModifier | Qt::ShiftModifier);
    QVERIFY(driver.waitFor([&] { return driver.message().contains("Changed bodies: "); }));
    QVERIFY2(driver.message().contains("Stock and program zero stay where they are"), qPrintable(driver.message()));
    QVERIFY(std::abs(workbench.model.model()->volume() - volume * 0.9) < 1e-6 * volume);
    QVERIFY(driver.waitFor([&] { return workbench.workpiece.ready(); }));
    QCOMPARE(workbench.setup.setup().stock.high.z, before.stock.high.z);
    QCOMPARE(workbench.setup.setup().workOffset.z, before.workOffset.z);
    QCOMPARE(workbench.mill.takes().size(), std::size_t{1});
    driver.shoot("part-updated");
    // Once more, unchanged.
    driver.key(Qt::Key_U, Qt::ControlModifier | Qt::ShiftModifier);
    QVERIFY(driver.waitFor([&] { return driver.message() == "The part has not changed."; }));
    QVERIFY(driver.waitFor([&] { return workbench.workpiece.ready(); }));
    // An unreadable file is reported in one sentence.
    write(driver, "block.stl", "nonsense");
    driver.key(Qt::Key_U, Qt::ControlModifier | Qt::ShiftModifier);
    QVERIFY(driver.waitFor([&] { return driver.message().contains("block.stl"); }));
    QVERIFY(workbench.workpiece.ready());
    QCOMPARE(workbench.mill.takes().size(), std::size_t{1});
}

BURIN_TEST(TestWindowFiles, QApplication)

} // namespace burin::tst_window_files

#include "tst_window_files.moc"

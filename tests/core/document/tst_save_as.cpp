// SPDX-FileCopyrightText: 2026 The Burin authors
// SPDX-License-Identifier: Apache-2.0
#include "core/document/left_work.h"
#include "core/document/working_copy.h"
#include "tests/core/document/sample_project.h"
#include "tests/test_program.h"

#include <QCoreApplication>
#include <QTemporaryDir>
#include <QtTest>
#include <filesystem>

namespace burin::tst_save_as {

namespace fs = std::filesystem;
using fixture::modelNamed;

namespace {

std::string nameIn(const fs::path& file) {
    const Result<Project> project = Project::open(file);
    return project ? fixture::nameIn(*project) : "not opened";
}

QStringList filesIn(const QTemporaryDir& folder) {
    return QDir(folder.path()).entryList(QDir::Files | QDir::Hidden, QDir::Name);
}

} // namespace

class TestSaveAs : public QObject {
    Q_OBJECT
private slots:
    void aNewNameGetsTheChangesAndTheOldFileStays() {
        const QTemporaryDir folder;
        const fs::path p = folder.filePath("p.burin").toStdString(), q = folder.filePath("q.burin").toStdString();
        {
            Result<Project> project = Project::create(p);
            QVERIFY(project && project->setModel(modelNamed("first")) && project->save());
            QVERIFY(project->setModel(modelNamed("second")));
            QVERIFY(project->saveAs(q));
            QCOMPARE(project->file(), q);
            QCOMPARE(*project->unsaved(), false);
            QVERIFY(project->setModel(modelNamed("third")) && project->save()); // continues under the new name
        }
        QCOMPARE(nameIn(p), std::string("first"));
        QCOMPARE(nameIn(q), std::string("third"));
        QCOMPARE(filesIn(folder), (QStringList{"p.burin", "q.burin"}));
    }
    void aProjectThatWasNeverSavedLeavesNothingAtItsFirstPlace() {
        const QTemporaryDir scratch, folder;
        Result<Project> project = Project::create(scratch.filePath("untitled.burin").toStdString());
        QVERIFY(project && project->setModel(modelNamed("new")));
        const fs::path q = folder.filePath("q.burin").toStdString();
        QVERIFY(project->saveAs(q));
        QCOMPARE(filesIn(scratch), QStringList());
        project = Project::create(scratch.filePath("other.burin").toStdString());
        QCOMPARE(nameIn(q), std::string("new"));
    }
    /// The remedy if the project's own disk is full: nothing is written next to the old file. (A holder of the copy's
    /// write lock simulates the full disk.)
    void nothingIsWrittenToTheOldWorkingCopy() {
        const QTemporaryDir folder, elsewhere;
        const fs::path p = folder.filePath("p.burin").toStdString(), q = elsewhere.filePath("q.burin").toStdString();
        Result<Project> project = Project::create(p);
        QVERIFY(project && project->setModel(modelNamed("first")) && project->save());
        QVERIFY(project->setModel(modelNamed("second")));
        {
            Result<Database> writer = Database::open(WorkingCopy::pathBeside(p), p.string(), Database::Access::write);
            QVERIFY(writer && writer->execute("BEGIN IMMEDIATE"));
            QVERIFY(!project->save());
            QVERIFY(project->saveAs(q));
        }
        QCOMPARE(*project->unsaved(), false);
        QVERIFY(project->setModel(modelNamed("third")) && project->save());
        QCOMPARE(nameIn(p), std::string("first"));
        project = Project::create(elsewhere.filePath("other.burin").toStdString());
        QCOMPARE(nameIn(q), std::string("third"));
    }
    void anotherKindOfFileIsNeverReplaced() {
        const QTemporaryDir folder;
        QFile letter(folder.filePath("letter.txt"));
        QVERIFY(letter.open(QIODevice::WriteOnly) && letter.write("Dear Emil") > 0);
        letter.close();
        Result<Project> project = Project::create(folder.filePath("p.burin").toStdString());
        QVERIFY(project && project->setModel(modelNamed("new")));
        const Result<void> refused = project->saveAs(letter.fileName().toStdString());
        QVERIFY(!refused);
        QCOMPARE(refused.error().code, ErrorCode::projectNotBurin);
        QVERIFY(letter.open(QIODevice::ReadOnly));
        QCOMPARE(letter.readAll(), QByteArray("Dear Emil"));
        QCOMPARE(*project->unsaved(), true);
    }
    void aProjectThatIsOpenElsewhereIsNotReplaced() {
        const QTemporaryDir folder;
        const fs::path p = folder.filePath("p.burin").toStdString(), q = folder.filePath("q.burin").toStdString();
        Result<Project> other = Project::create(q);
        QVERIFY(other && other->setModel(modelNamed("theirs")) && other->save());
        Result<Project> project = Project::create(p);
        QVERIFY(project && project->setModel(modelNamed("ours")));
        const Result<void> refused = project->saveAs(q);
        QVERIFY(!refused);
        QCOMPARE(refused.error().code, ErrorCode::projectInUse);
        QCOMPARE(project->file(), p);
    }
    void notWhileATakeIsRecorded() {
        const QTemporaryDir folder;
        Result<Project> project = Project::create(folder.filePath("p.burin").toStdString());
        QVERIFY(project && project->setModel(fixture::model()));
        Result<Project::TakeWriter> writer = project->beginTake(fixture::takeInfo("take"));
        QVERIFY(writer);
        const Result<void> refused = project->saveAs(folder.filePath("q.burin").toStdString());
        QVERIFY(!refused);
        QCOMPARE(refused.error().code, ErrorCode::argumentInvalid);
        QVERIFY(!QFile::exists(folder.filePath("q.burin")));
    }
    void abandonedChangesAreGone() {
        const QTemporaryDir folder;
        const fs::path p = folder.filePath("p.burin").toStdString();
        {
            Result<Project> project = Project::create(p);
            QVERIFY(project && project->setModel(modelNamed("kept")) && project->save());
            QVERIFY(project->setModel(modelNamed("not wanted")));
            project->abandonChanges();
        }
        QCOMPARE(nameIn(p), std::string("kept"));
        QCOMPARE(filesIn(folder), QStringList{"p.burin"});
    }
    void leftWorkIsFoundOnceNobodyHasItOpen() {
        const QTemporaryDir folder;
        const fs::path place = folder.path().toStdString(), p = place / "p.burin";
        {
            Result<Project> project = Project::create(p);
            QVERIFY(project && project->setModel(modelNamed("left")));
            QVERIFY(leftWork(place).left.empty()); // another session works on it
            QVERIFY(leftWork(place).inUse);
        }
        const FoundWork found = leftWork(place);
        QVERIFY(!found.inUse);
        QCOMPARE(found.left.size(), std::size_t{1});
        QCOMPARE(found.left.front().file, p);
        QCOMPARE(nameIn(p), std::string("left"));
        QVERIFY(leftWork(place / "nowhere").left.empty());
    }
};

BURIN_TEST(TestSaveAs, QCoreApplication)

} // namespace burin::tst_save_as

#include "tst_save_as.moc"

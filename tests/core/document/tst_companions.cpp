// SPDX-FileCopyrightText: 2026 The Burin authors
// SPDX-License-Identifier: Apache-2.0
#include "core/base/file.h"
#include "core/document/database.h"
#include "core/document/project.h"
#include "core/document/project_change.h"
#include "core/document/working_copy.h"
#include "tests/core/document/dying_sessions.h"
#include "tests/test_program.h"

#include <QTemporaryDir>
#include <QtTest>
#include <fcntl.h>
#include <filesystem>
#include <sys/file.h>
#include <vector>

namespace burin::tst_companions {

using namespace burin::fixture;
namespace fs = std::filesystem;

/// Files that Burin keeps next to a project, atomic changes, and reading without changes.
class TestCompanions : public QObject {
    Q_OBJECT
private slots:
    /// A file of someone else at the name of one of Burin's own files must not be truncated, followed or removed.
    void filesOfOthersInTheWayStayAsTheyAre_data() {
        QTest::addColumn<QString>("companion");
        QTest::addColumn<bool>("symbolic");
        for (const char* companion : {".p.burin.lock", ".p.burin.working"}) {
            QTest::addRow("%s, a symbolic link", companion) << QString(companion) << true;
            QTest::addRow("%s, a hard link", companion) << QString(companion) << false;
        }
    }
    void filesOfOthersInTheWayStayAsTheyAre() {
        QFETCH(QString, companion);
        QFETCH(bool, symbolic);
        const QTemporaryDir folder;
        const fs::path file = fileIn(folder), notes = fileIn(folder, "notes.txt");
        QVERIFY(saveAs(file, "saved"));
        write(notes, "somebody's");
        const fs::path inTheWay = folder.filePath(companion).toStdString();
        if (symbolic)
            fs::create_symlink(notes, inTheWay);
        else
            fs::create_hard_link(notes, inTheWay);
        static_cast<void>(Project::open(file)); // whatever the outcome
        static_cast<void>(Project::create(file));
        QCOMPARE(*readFile(notes), std::string("somebody's"));
    }

    void lookingLeavesUnsavedWorkAsItIs() {
        const QTemporaryDir folder;
        const fs::path file = fileIn(folder);
        QVERIFY(saveAs(file, "saved"));
        QVERIFY(dieWith(file, "unsaved"));
        for (int time = 0; time < 2; ++time) {
            const Result<Project> project = Project::openForReading(file);
            QVERIFY(project && project->recovered() && project->readOnly());
            QCOMPARE(nameIn(*project), std::string("unsaved"));
        }
        { // two readers at once, and another session that continues with it meanwhile
            const Result<Project> one = Project::openForReading(file), other = Project::openForReading(file);
            QVERIFY(one && other && other->recovered());
            QCOMPARE(nameIn(*other), std::string("unsaved"));
            QVERIFY(Project::open(file));
            QCOMPARE(nameIn(*one), std::string("unsaved"));
        }
        Result<Project> project = Project::open(file);
        QVERIFY(project && project->recovered());
        QCOMPARE(nameIn(*project), std::string("unsaved"));
    }

    void lookingNeedsNoRoomOnTheDisk() {
        const QTemporaryDir folder;
        const fs::path file = fileIn(folder);
        QVERIFY(saveAs(file, "saved"));
        for (const char* name : {"saved", "unsaved"}) {
            QCOMPARE(inAnotherProcess([&] {
                         limitFileSize(0);
                         const Result<Project> project = Project::openForReading(file);
                         return project && nameIn(*project) == name ? 0 : 1;
                     }),
                     0);
            QVERIFY(dieWith(file, "unsaved"));
        }
    }

    void lookingLeavesNothingBehind() {
        const QTemporaryDir folder;
        const fs::path file = fileIn(folder);
        QVERIFY(saveAs(file, "saved"));
        QVERIFY(dieIdle(file));
        { QCOMPARE(nameIn(*Project::openForReading(file)), std::string("saved")); }
        QCOMPARE(namesIn(folder), QStringList{"p.burin"});
    }

    void aChangeThatIsNotSavedIsTakenBack() {
        const QTemporaryDir folder;
        const fs::path file = fileIn(folder);
        QVERIFY(saveAs(file, "saved"));
        QVERIFY(dieWith(file, "unsaved"));
        {
            Result<ProjectChange> change = ProjectChange::open(file);
            QVERIFY(change && (*change)->setModel(modelNamed("given up")));
        }
        QCOMPARE(namesIn(folder), QStringList{"p.burin"});
        QCOMPARE(nameInFile(file), std::string("unsaved")); // the content before the change is kept, in the file
    }

    /// The output file of a change is put in place together with it, or stays unchanged.
    void aChangeAndItsOutputAreAllOrNone() {
        const QTemporaryDir folder;
        const fs::path file = fileIn(folder), output = fileIn(folder, "program.ngc");
        QVERIFY(saveAs(file, "saved"));
        write(output, "old");
        {
            Result<ProjectChange> change = ProjectChange::open(file);
            std::vector<StagedFile> outputs;
            outputs.push_back(std::move(*StagedFile::containing(output, "new")));
            QVERIFY(change && (*change)->setModel(modelNamed("new")));
            fs::rename(file, fileIn(folder, "elsewhere.burin"));
            fs::create_directories(file / "in the way"); // the project can't be put in place
            QVERIFY(!change->save(outputs));
        }
        QCOMPARE(*readFile(output), std::string("old"));
        fs::remove_all(file);
        QCOMPARE(namesIn(folder), (QStringList{"elsewhere.burin", "program.ngc"}));
    }

    void anyNameOfAFileCanBeOpened() {
        const QTemporaryDir folder;
        const std::string name = std::string(239, 'n') + ".burin";
        const fs::path file = fileIn(folder, name.c_str());
        QVERIFY(saveAs(file, "saved"));
        QVERIFY(dieWith(file, "unsaved"));
        { QCOMPARE(nameInFile(file), std::string("unsaved")); }
        QVERIFY(saveAs(file, "saved again"));
        QCOMPARE(nameInFile(file), std::string("saved again"));
    }

    /// An older Burin named its files after the whole name, where that was possible.
    void workUnderAnOlderNameIsTakenUp() {
        const QTemporaryDir folder;
        const std::string name = std::string(230, 'n') + ".burin";
        const fs::path file = fileIn(folder, name.c_str());
        QVERIFY(saveAs(file, "saved"));
        QVERIFY(dieWith(file, "unsaved"));
        for (const char* ending : {"-wal", ""})
            fs::rename(WorkingCopy::pathBeside(file).string() + ending,
                       fileIn(folder, ("." + name + ".working").c_str()).string() + ending);
        QCOMPARE(nameInFile(file), std::string("unsaved"));
        const int lock = ::open(fileIn(folder, ("." + name + ".lock").c_str()).c_str(), O_RDWR | O_CREAT, 0600);
        QVERIFY(lock >= 0 && ::flock(lock, LOCK_EX) == 0);
        QCOMPARE(Project::open(file).error().code, ErrorCode::projectInUse);
        ::close(lock);
        QVERIFY(Project::open(file));
    }

    /// A copy that a full disk left incomplete is not kept under a name of its own.
    void aCopyWithoutContentGoes() {
        const QTemporaryDir folder;
        const fs::path file = fileIn(folder);
        QVERIFY(saveAs(file, "saved"));
        write(WorkingCopy::pathBeside(file), "");
        QCOMPARE(nameInFile(file), std::string("saved"));
        QCOMPARE(namesIn(folder), QStringList{"p.burin"});
    }

    /// Tables that differ from the version's schema, whose queries might never end, are never queried.
    void aForeignSchemaIsRefused_data() {
        QTest::addColumn<QString>("sql");
        QTest::newRow("an index over an expression") << "CREATE INDEX i ON take(length(hex(zeroblob(id))))";
        QTest::newRow("a column that is worked out")
            << "ALTER TABLE tool ADD COLUMN more AS (hex(zeroblob(400000000)))";
        QTest::newRow("a table more") << "CREATE TABLE more(id INTEGER PRIMARY KEY)";
        QTest::newRow("a table less") << "DROP TABLE import_note";
    }
    void aForeignSchemaIsRefused() {
        QFETCH(QString, sql);
        const QTemporaryDir folder;
        const fs::path file = fileIn(folder);
        QVERIFY(saveAs(file, "saved"));
        {
            Result<Database> database = Database::open(file, "", Database::Access::write);
            QVERIFY(database && database->execute("UPDATE document SET digest = NULL") &&
                    database->execute(sql.toUtf8().constData()));
        }
        const std::string content = *readFile(file);
        QCOMPARE(Project::open(file).error().code, ErrorCode::fileDamaged);
        QCOMPARE(Project::openForReading(file).error().code, ErrorCode::fileDamaged);
        QCOMPARE(*readFile(file), content);
        QCOMPARE(namesIn(folder), QStringList{"p.burin"});
    }
};

BURIN_TEST(TestCompanions, NoApplication)

} // namespace burin::tst_companions

#include "tst_companions.moc"

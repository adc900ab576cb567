// SPDX-FileCopyrightText: 2026 The Burin authors
// SPDX-License-Identifier: Apache-2.0
#include "core/base/file.h"
#include "core/document/database.h"
#include "core/document/project.h"
#include "core/document/working_copy.h"
#include "tests/core/document/dying_sessions.h"
#include "tests/test_program.h"

#include <QTemporaryDir>
#include <QtTest>
#include <filesystem>

namespace burin::tst_recovery {

using namespace burin::fixture;
namespace fs = std::filesystem;

class TestRecovery : public QObject {
    Q_OBJECT
private slots:
    void aKilledSessionIsTakenUpAgain() {
        const QTemporaryDir folder;
        const fs::path file = fileIn(folder);
        QVERIFY(saveAs(file, "saved"));
        QVERIFY(dieWith(file, "unsaved"));
        Result<Project> project = Project::open(file);
        QVERIFY(project);
        QVERIFY(project->recovered());
        QVERIFY(*project->unsaved());
        QCOMPARE(nameIn(*project), std::string("unsaved"));
        QVERIFY(project->save());
        *project = *Project::create(fileIn(folder, "other.burin"));
        Result<Project> again = Project::open(file);
        QVERIFY(again && !again->recovered());
        QCOMPARE(nameIn(*again), std::string("unsaved"));
    }

    void aProjectThatWasNeverSavedIsTakenUpAgain() {
        const QTemporaryDir folder;
        const fs::path file = fileIn(folder);
        QCOMPARE(fixture::inAnotherProcess([&] {
                     Result<Project> project = Project::create(file);
                     ::_exit(project && project->setModel(modelNamed("new")) ? 0 : 1);
                     return 1;
                 }),
                 0);
        QVERIFY(!fs::exists(file));
        Result<Project> project = Project::open(file);
        QVERIFY(project && project->recovered());
        QCOMPARE(nameIn(*project), std::string("new"));
    }

    void aReplacementThatWasKilledIsTakenUpAgain() {
        const QTemporaryDir folder;
        const fs::path file = fileIn(folder);
        QVERIFY(saveAs(file, "old"));
        QCOMPARE(fixture::inAnotherProcess([&] {
                     Result<Project> project = Project::create(file);
                     ::_exit(project && project->setModel(modelNamed("replacement")) ? 0 : 1);
                     return 1;
                 }),
                 0);
        Result<Project> project = Project::open(file);
        QVERIFY(project && project->recovered());
        QCOMPARE(nameIn(*project), std::string("replacement"));
    }

    void closingWithoutSavingKeepsTheWork() {
        const QTemporaryDir folder;
        const fs::path file = fileIn(folder);
        {
            Result<Project> project = Project::create(file);
            QVERIFY(project && project->setModel(modelNamed("kept")));
        }
        Result<Project> project = Project::open(file);
        QVERIFY(project && project->recovered());
        QCOMPARE(nameIn(*project), std::string("kept"));
    }

    void aSessionKilledWithoutChangesLeavesNothingToRecover() {
        const QTemporaryDir folder;
        const fs::path file = fileIn(folder);
        QVERIFY(saveAs(file, "saved"));
        QVERIFY(dieIdle(file));
        Result<Project> project = Project::open(file);
        QVERIFY(project && !project->recovered());
    }

    /// The user put another version of the file there meanwhile: both are kept.
    void workThatBelongsToAnotherFileIsKeptAside() {
        const QTemporaryDir folder;
        const fs::path file = fileIn(folder), backup = fileIn(folder, "backup.burin");
        QVERIFY(saveAs(backup, "backup"));
        QVERIFY(saveAs(file, "saved"));
        QVERIFY(dieWith(file, "unsaved"));
        fs::copy_file(backup, file, fs::copy_options::overwrite_existing);
        Result<Project> project = Project::open(file);
        QVERIFY(project);
        QVERIFY(!project->recovered());
        QCOMPARE(nameIn(*project), std::string("backup"));
        QCOMPARE(project->keptAside().filename().string(), std::string("p.kept-1.burin"));
        QCOMPARE(nameInFile(project->keptAside()), std::string("unsaved"));
    }

    void aNewProjectKeepsALeftoverAside() {
        const QTemporaryDir folder;
        const fs::path file = fileIn(folder);
        QVERIFY(saveAs(file, "saved"));
        QVERIFY(dieWith(file, "unsaved"));
        Result<Project> project = Project::create(file);
        QVERIFY(project);
        QCOMPARE(nameInFile(project->keptAside()), std::string("unsaved"));
    }

    void aLeftoverThatCantBeReadIsKeptAside() {
        const QTemporaryDir folder;
        const fs::path file = fileIn(folder);
        QVERIFY(saveAs(file, "saved"));
        write(WorkingCopy::pathBeside(file), std::string(5000, 'x'));
        Result<Project> project = Project::open(file);
        QVERIFY(project);
        QCOMPARE(nameIn(*project), std::string("saved"));
        QCOMPARE(*readFile(project->keptAside()), std::string(5000, 'x'));
    }

    /// A kill between the rename of a save and its record must not turn new work into old work.
    void aSaveWhoseNoteIsMissingIsUnderstood_data() {
        QTest::addColumn<int>("later");
        QTest::newRow("nothing was changed since") << 0;
        QTest::newRow("something was changed since") << 1;
    }
    void aSaveWhoseNoteIsMissingIsUnderstood() {
        QFETCH(int, later);
        const QTemporaryDir folder;
        const fs::path file = fileIn(folder);
        QVERIFY(saveAs(file, "first"));
        QCOMPARE(fixture::inAnotherProcess([&] {
                     Result<Project> project = Project::open(file);
                     if (!project || !project->setModel(modelNamed("second")) || !project->save()) return 1;
                     if (later == 1 && !project->setModel(modelNamed("third"))) return 2;
                     Result<Database> copy = Database::open(WorkingCopy::pathBeside(file), "", Database::Access::write);
                     return copy && copy->execute("UPDATE document SET next_save_id = save_id, save_id = x'00', "
                                                  "saved_changes = saved_changes - 1")
                                ? 0
                                : 3;
                 }),
                 0);
        Result<Project> project = Project::open(file);
        QVERIFY(project && project->keptAside().empty());
        QCOMPARE(project->recovered(), later == 1);
        QCOMPARE(nameIn(*project), std::string(later == 1 ? "third" : "second"));
        QCOMPARE(*project->unsaved(), later == 1);
    }

    void aDeletedFileComesBackFromItsWorkingCopy() {
        const QTemporaryDir folder;
        const fs::path file = fileIn(folder);
        QVERIFY(saveAs(file, "saved"));
        QVERIFY(dieIdle(file));
        fs::remove(file);
        for (int time = 0; time < 2; ++time) { // closing without saving must not lose the only copy
            Result<Project> project = Project::open(file);
            QVERIFY(project && project->recovered() && *project->unsaved());
            QCOMPARE(nameIn(*project), std::string("saved"));
        }
    }

    void aFileDamagedUnderASessionComesBackFromItsWorkingCopy() {
        const QTemporaryDir folder;
        const fs::path file = fileIn(folder);
        QVERIFY(saveAs(file, "saved"));
        QVERIFY(dieWith(file, "unsaved"));
        fs::resize_file(file, fs::file_size(file) / 2);
        Result<Project> project = Project::open(file);
        QVERIFY(project && project->recovered());
        QCOMPARE(nameIn(*project), std::string("unsaved"));
    }

    void aSecondProcessIsTurnedAway() {
        const QTemporaryDir folder;
        const fs::path file = fileIn(folder);
        QVERIFY(saveAs(file, "saved"));
        int toChild[2], toParent[2];
        QVERIFY(::pipe(toChild) == 0 && ::pipe(toParent) == 0);
        const pid_t owner = ::fork();
        if (owner == 0) {
            Result<Project> project = Project::open(file);
            char byte = project ? 'y' : 'n';
            if (::write(toParent[1], &byte, 1) == 1 && ::read(toChild[0], &byte, 1) == 1) ::_exit(0);
            ::_exit(1);
        }
        char byte = 0;
        QCOMPARE(::read(toParent[0], &byte, 1), ssize_t{1});
        QCOMPARE(byte, 'y');
        for (const Result<Project>& second : {Project::open(file), Project::create(file)}) {
            QVERIFY(!second);
            QCOMPARE(second.error().code, ErrorCode::projectInUse);
            QCOMPARE(second.error().subject, file.string());
            QCOMPARE(second.error().detail, "process " + std::to_string(owner));
        }
        { // reading needs no waiting, and sees the saved content
            const Result<Project> one = Project::openForReading(file), other = Project::openForReading(file);
            QVERIFY(one && other && one->readOnly() && !one->recovered());
            QCOMPARE(nameIn(*one), std::string("saved"));
            QCOMPARE(nameIn(*other), std::string("saved"));
        }
        QCOMPARE(::write(toChild[1], &byte, 1), ssize_t{1});
        ::waitpid(owner, nullptr, 0);
        QCOMPARE(nameInFile(file), std::string("saved")); // its lock ended with it
        for (const int end : {toChild[0], toChild[1], toParent[0], toParent[1]}) ::close(end);
    }

    void oneProcessOpensAProjectOnce() {
        const QTemporaryDir folder;
        const fs::path file = fileIn(folder);
        QVERIFY(saveAs(file, "saved"));
        fs::create_symlink(file, fileIn(folder, "link.burin"));
        Result<Project> first = Project::open(file);
        QVERIFY(first);
        QCOMPARE(Project::open(file).error().code, ErrorCode::projectInUse);
        QCOMPARE(Project::open(fileIn(folder, "link.burin")).error().code, ErrorCode::projectInUse);
    }

    void anotherKindOfFileIsNeverReplaced() {
        const QTemporaryDir folder;
        const fs::path file = fileIn(folder, "part.step");
        write(file, "ISO-10303-21;");
        const Result<Project> project = Project::create(file);
        QVERIFY(!project);
        QCOMPARE(project.error().code, ErrorCode::projectNotBurin);
        QCOMPARE(namesIn(folder), QStringList{"part.step"});
    }

    void whatAKilledSaveLeftIsCleanedUp() {
        const QTemporaryDir folder;
        const fs::path file = fileIn(folder);
        QVERIFY(saveAs(file, "saved"));
        write(temporaryBeside(file), "half a project");
        write(fileIn(folder, ".p.burin.notes.part"), "somebody else's");
        QCOMPARE(nameInFile(file), std::string("saved"));
        QCOMPARE(namesIn(folder), (QStringList{".p.burin.notes.part", "p.burin"}));
    }

    void aRecordingOutlivesItsProjectObject() {
        const QTemporaryDir folder;
        const fs::path file = fileIn(folder);
        QVERIFY(saveAs(file, "saved"));
        const std::vector<Sample> hand = fixture::handSamples(0, 200);
        {
            Result<Project> project = Project::open(file);
            QVERIFY(project);
            Result<Project::TakeWriter> writer = project->beginTake(fixture::takeInfo("t"));
            QVERIFY(writer && project->save());
            { const Project closed = std::move(*project); }
            QCOMPARE(Project::open(file).error().code, ErrorCode::projectInUse);
            QVERIFY(writer->append(hand) && writer->finish());
        }
        Result<Project> project = Project::open(file);
        QVERIFY(project && project->recovered());
        QVERIFY(fixture::identical(project->take(1)->samples, hand));
    }

    void whatMayNotBeReachedIsNotMissing() {
        const QTemporaryDir folder;
        const fs::path circle = fileIn(folder, "circle.burin");
        fs::create_symlink(circle, circle);
        QCOMPARE(Project::open(circle).error().code, ErrorCode::fileNotReadable);
    }

    void aMissingFolderIsNamed() {
        const QTemporaryDir folder;
        const fs::path file = fileIn(folder, "missing/p.burin");
        QCOMPARE(Project::open(file).error().code, ErrorCode::fileNotFound);
        QCOMPARE(Project::create(file).error().code, ErrorCode::fileNotWritable);
        QCOMPARE(Project::create(file).error().subject, file.string());
    }
};

BURIN_TEST(TestRecovery, NoApplication)

} // namespace burin::tst_recovery

#include "tst_recovery.moc"

// SPDX-FileCopyrightText: 2026 The Burin authors
// SPDX-License-Identifier: Apache-2.0
#include "core/base/file.h"

#include <QTemporaryDir>
#include <QtTest>

#include <cerrno>

using namespace burin;

class TestFile : public QObject {
    Q_OBJECT

    QTemporaryDir folder_;
    std::filesystem::path path(const char* name) const {
        return std::filesystem::path(folder_.path().toStdString()) / name;
    }
    QStringList files() const { return QDir(folder_.path()).entryList(QDir::Files | QDir::Hidden); }

private slots:
    void init() { folder_ = QTemporaryDir(); }

    void whatIsWrittenReadsBack() {
        const std::string content("first\0second\r\n\xff", 15);
        QVERIFY(writeFileAtomically(path("a"), content));
        QCOMPARE(*readFile(path("a")), content);
        QVERIFY(writeFileAtomically(path("a"), "shorter"));
        QCOMPARE(*readFile(path("a")), std::string("shorter"));
        QVERIFY(writeFileAtomically(path("empty"), ""));
        QCOMPARE(*readFile(path("empty")), std::string());
        QCOMPARE(files(), (QStringList{"a", "empty"})); // nothing is left beside them
    }

    void missingFilesAndFoldersAreErrors() {
        QVERIFY(readFile(path("nothing")).error().code == ErrorCode::fileNotFound);
        QVERIFY(readFile(path(".")).error().code == ErrorCode::fileNotReadable);
    }

    void aFailedWriteKeepsWhatStoodThere() {
        QVERIFY(writeFileAtomically(path("a"), "old"));
        QVERIFY(QDir(folder_.path()).mkdir("taken"));
        QVERIFY(QFile(folder_.path() + "/taken/inner").open(QIODevice::WriteOnly));
        const auto onFolder = writeFileAtomically(path("taken"), "new"); // a rename over a folder fails
        QVERIFY(!onFolder && onFolder.error().code == ErrorCode::fileNotWritable);
        const auto nowhere = writeFileAtomically(path("no/such/folder"), "new");
        QVERIFY(!nowhere && nowhere.error().code == ErrorCode::fileNotWritable);
        QCOMPARE(*readFile(path("a")), std::string("old"));
        QCOMPARE(files(), QStringList{"a"});
    }

    void aFileWrittenBesideTakesItsPlace() {
        QVERIFY(writeFileAtomically(path("a"), "old"));
        const auto beside = temporaryBeside(path("a"));
        QVERIFY(beside != temporaryBeside(path("a")));
        QVERIFY(beside.parent_path() == path("a").parent_path());
        QVERIFY(writeFileAtomically(beside, "new"));
        QVERIFY(replaceFile(beside, path("a")));
        QCOMPARE(*readFile(path("a")), std::string("new"));
        QCOMPARE(files(), QStringList{"a"});
        QVERIFY(!replaceFile(path("not there"), path("a")));
        QCOMPARE(*readFile(path("a")), std::string("new"));
    }

    void fullDisksAreToldFromMissingRights() {
        QVERIFY(writeError(path("a"), ENOSPC).code == ErrorCode::diskFull);
        QVERIFY(writeError(path("a"), EACCES).code == ErrorCode::fileNotWritable);
        QCOMPARE(writeError(path("a"), EACCES).subject, path("a").string());
    }
};

QTEST_APPLESS_MAIN(TestFile)
#include "tst_file.moc"

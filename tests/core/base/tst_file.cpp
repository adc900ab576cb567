// SPDX-FileCopyrightText: 2026 The Burin authors
// SPDX-License-Identifier: Apache-2.0
#include "core/base/clean_text.h"
#include "core/base/file.h"
#include "core/base/staged_file.h"
#include "tests/test_program.h"

#include <QTemporaryDir>
#include <QtTest>

#include <array>
#include <cerrno>
#include <sys/stat.h>
#include <sys/wait.h>
#include <thread>
#include <unistd.h>

namespace burin::tst_file {

namespace {

constexpr uid_t nobody = 65534;

/// While it exists, a test run by root, whom no permissions stop, runs as the user nobody.
class WithoutRoot {
public:
    WithoutRoot() : isRoot_(::geteuid() == 0), done_(!isRoot_ || ::seteuid(nobody) == 0) {}
    ~WithoutRoot() {
        if (isRoot_) (void)::seteuid(0);
    }
    WithoutRoot(const WithoutRoot&) = delete;
    WithoutRoot& operator=(const WithoutRoot&) = delete;
    bool done() const noexcept { return done_; }

private:
    bool isRoot_, done_;
};

/// Sets a folder's permissions, and restores them in the end so that it can be removed.
class WithRights {
public:
    WithRights(std::filesystem::path folder, std::filesystem::perms rights) : folder_(std::move(folder)) {
        std::filesystem::permissions(folder_, rights);
    }
    ~WithRights() { std::filesystem::permissions(folder_, std::filesystem::perms::owner_all); }
    WithRights(const WithRights&) = delete;
    WithRights& operator=(const WithRights&) = delete;

private:
    std::filesystem::path folder_;
};

} // namespace

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
        QCOMPARE(files(), (QStringList{"a", "empty"})); // no other file is left
    }

    void missingFilesAndFoldersAreErrors() {
        QVERIFY(readFile(path("nothing")).error().code == ErrorCode::fileNotFound);
        QVERIFY(readFile(path(".")).error().code == ErrorCode::fileNotReadable);
        QVERIFY(writeFileAtomically(path("a"), "content"));
        QVERIFY(readFile(path("a") / "b").error().code == ErrorCode::fileNotFound);
    }

    /// The error must direct the user to the permissions, not to the name.
    void whatMayNotBeReachedIsNotMissing() {
        std::filesystem::create_directory(path("closed"));
        QVERIFY(writeFileAtomically(path("closed/a"), "content"));
        const WithRights closed(path("closed"), std::filesystem::perms::none);
        const WithoutRoot user;
        if (!user.done()) QSKIP("root can't become another user here");
        const Result<std::string> found = readFile(path("closed/a"));
        QVERIFY(!found);
        QCOMPARE(found.error().code, ErrorCode::fileNotReadable);
        QCOMPARE(found.error().subject, path("closed/a").string());
        QCOMPARE(found.error().detail, std::string("Permission denied"));
    }

    void linksInACircleAreNotMissing() {
        std::filesystem::create_symlink(path("b"), path("a"));
        std::filesystem::create_symlink(path("a"), path("b"));
        const Result<std::string> found = readFile(path("a"));
        QVERIFY(!found);
        QCOMPARE(found.error().code, ErrorCode::fileNotReadable);
    }

    void aFaultWhileReadingIsTold() {
        if (!std::filesystem::exists("/proc/self/mem")) QSKIP("no /proc/self/mem");
        const Result<std::string> found = readFile("/proc/self/mem"); // address 0 is never mapped
        QVERIFY(!found);
        QCOMPARE(found.error().code, ErrorCode::fileNotReadable);
    }

    void aFileBeyondAllMemoryIsTold() {
        QVERIFY(writeFileAtomically(path("huge"), ""));
        std::error_code refused;
        std::filesystem::resize_file(path("huge"), std::uintmax_t{1} << 42, refused);
        if (refused) QSKIP("no file of 4 TiB on this file system");
        const Result<std::string> found = readFile(path("huge"));
        QVERIFY(!found);
        QCOMPARE(found.error().code, ErrorCode::outOfMemory);
        QCOMPARE(found.error().subject, path("huge").string());
        QVERIFY(found.error().place.starts_with("4398047 MB, ")); // 2^42 bytes
    }

    void whatHasNoSizeIsReadToItsEnd() {
        const std::string content(200'000, 'x'); // a pipe holds 65,536 bytes
        std::array<int, 2> ends{};
        QVERIFY(::pipe(ends.data()) == 0);
        std::thread writer([&] {
            for (std::size_t at = 0; at < content.size();) {
                const ssize_t written = ::write(ends[1], content.data() + at, content.size() - at);
                if (written <= 0) break;
                at += static_cast<std::size_t>(written);
            }
            ::close(ends[1]);
        });
        const Result<std::string> found = readFile("/dev/fd/" + std::to_string(ends[0]));
        writer.join();
        ::close(ends[0]);
        QVERIFY(found);
        QVERIFY(*found == content);
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

    /// Such a folder can't be flushed, but the renamed file is in it.
    void aFolderThatOneMayNotReadTakesFiles() {
        std::filesystem::create_directory(path("inbox"));
        QVERIFY(::geteuid() != 0 || (::chown(path("inbox").c_str(), nobody, nobody) == 0 &&
                                     ::chmod(folder_.path().toLocal8Bit().constData(), 0711) == 0));
        {
            const WithRights unreadable(path("inbox"),
                                        std::filesystem::perms::owner_write | std::filesystem::perms::owner_exec);
            const WithoutRoot user;
            if (!user.done()) QSKIP("root can't become another user here");
            const Result<void> written = writeFileAtomically(path("inbox/a"), "content");
            QVERIFY2(written, written ? "" : written.error().subject.c_str());
        }
        QCOMPARE(*readFile(path("inbox/a")), std::string("content"));
    }

    void rightsOfAReplacedFileStay() {
        QVERIFY(writeFileAtomically(path("a"), "old"));
        QVERIFY(::chmod(path("a").c_str(), 0640) == 0);
        QVERIFY(writeFileAtomically(path("a"), "new"));
        struct stat standing {};
        QVERIFY(::stat(path("a").c_str(), &standing) == 0);
        QCOMPARE(standing.st_mode & 07777U, 0640U);
    }

    void aProtectedFileIsNotReplaced() {
        QVERIFY(writeFileAtomically(path("a"), "old"));
        QVERIFY(::chmod(folder_.path().toLocal8Bit().constData(), 0777) == 0);
        QVERIFY(::chmod(path("a").c_str(), 0444) == 0);
        const WithoutRoot user;
        if (!user.done()) QSKIP("root can't become another user here");
        QCOMPARE(writeFileAtomically(path("a"), "new").error().code, ErrorCode::fileNotWritable);
        QCOMPARE(*readFile(path("a")), std::string("old"));
    }

    /// As with a shell's redirection the link stays, whether its target exists or not.
    void linksAreFollowed() {
        QVERIFY(writeFileAtomically(path("target"), "old"));
        std::filesystem::create_symlink("target", path("link"));
        std::filesystem::create_symlink(path("link"), path("further"));
        QVERIFY(writeFileAtomically(path("further"), "new"));
        QCOMPARE(*readFile(path("target")), std::string("new"));
        std::filesystem::create_symlink("missing", path("dangling"));
        QVERIFY(writeFileAtomically(path("dangling"), "made"));
        QCOMPARE(*readFile(path("missing")), std::string("made"));
        for (const char* link : {"link", "further", "dangling"}) QVERIFY(std::filesystem::is_symlink(path(link)));
        QCOMPARE(files().size(), qsizetype{5});
    }

    void whatIsNoRegularFileIsWrittenTo() {
        QVERIFY(::mkfifo(path("fifo").c_str(), 0600) == 0);
        std::string got;
        std::thread reader([&] {
            const Result<std::string> read = readFile(path("fifo"));
            if (read) got = *read;
        });
        const Result<void> sent = writeFileAtomically(path("fifo"), "content");
        reader.join();
        QVERIFY(sent);
        QCOMPARE(got, std::string("content"));
        QVERIFY(std::filesystem::is_fifo(path("fifo")));
        QCOMPARE(writeFileAtomically("/dev/full", "content").error().code, ErrorCode::diskFull);
        QVERIFY(std::filesystem::is_character_file("/dev/full"));
        QVERIFY(writeFileAtomically("/dev/null", "content"));
        std::array<int, 2> ends{};
        QVERIFY(::pipe(ends.data()) == 0);
        QVERIFY(writeFileAtomically("/proc/self/fd/" + std::to_string(ends[1]), "through a descriptor"));
        std::array<char, 64> bytes{};
        QCOMPARE(::read(ends[0], bytes.data(), bytes.size()), ssize_t{20});
        for (const int end : ends) ::close(end);
    }

    void severalFilesAreWrittenAllOrNone() {
        QVERIFY(writeFileAtomically(path("a"), "old"));
        const auto stageBoth = [&] {
            std::vector<StagedFile> staged;
            for (const char* name : {"a", "b"}) {
                Result<StagedFile> one = StagedFile::containing(path(name), "new");
                if (one) staged.push_back(std::move(*one));
            }
            return staged;
        };
        {
            std::vector<StagedFile> staged = stageBoth();
            std::filesystem::create_directories(path("b/in the way")); // a rename over it fails
            QVERIFY(!putInPlace(staged));
        }
        QCOMPARE(*readFile(path("a")), std::string("old"));
        QCOMPARE(files(), QStringList{"a"});
        std::filesystem::remove_all(path("b"));
        {
            std::vector<StagedFile> staged = stageBoth();
            QVERIFY(putInPlace(staged));
            QCOMPARE(*readFile(path("a")), std::string("new"));
            for (StagedFile& one : staged) QVERIFY(one.takeBack());
        }
        QCOMPARE(*readFile(path("a")), std::string("old"));
        QCOMPARE(files(), QStringList{"a"});
    }

    void whatAKilledProgramLeftIsRemoved() {
        const pid_t child = ::fork();
        if (child == 0) {
            const Result<StagedFile> left = StagedFile::containing(path("a"), "half");
            ::_exit(left ? 0 : 1);
        }
        int status = 1;
        ::waitpid(child, &status, 0);
        QCOMPARE(status, 0);
        QCOMPARE(files().size(), qsizetype{1});
        const Result<StagedFile> other = StagedFile::containing(path("a"), "under way"); // is not affected by the next
        QVERIFY(writeFileAtomically(path("a"), "content"));
        QCOMPARE(files().size(), qsizetype{2});
    }

    void anyNameCanBeWritten() {
        std::string umlauts = "x";
        while (umlauts.size() < 254) umlauts += "\u00e4";
        for (const std::string& name : {std::string(255, 'n'), umlauts}) {
            QVERIFY(writeFileAtomically(path(name.c_str()), "content"));
            QCOMPARE(*readFile(path(name.c_str())), std::string("content"));
        }
        QCOMPARE(files().size(), qsizetype{2});
    }

    void textFromOutsideIsMadeValid_data() {
        QTest::addColumn<QByteArray>("text");
        QTest::addColumn<QString>("clean");
        const QString no(QChar(0xFFFD));
        QTest::newRow("plain") << QByteArray("Teil 1") << QString("Teil 1");
        QTest::newRow("UTF-8") << QByteArray("Gehäuse 部品 🛠") << QString("Gehäuse 部品 🛠");
        QTest::newRow("Latin-1") << QByteArray("Geh\xE4use") << QString("Geh%1use").arg(no);
        QTest::newRow("cut off") << QByteArray("a\xF0\x9F") << "a" + no + no;
        QTest::newRow("too long a form") << QByteArray("\xC0\xAF") << no + no;
        QTest::newRow("surrogate") << QByteArray("\xED\xA0\x80") << no + no + no;
        QTest::newRow("escape sequence") << QByteArray("\x1B[2J") << no + "[2J";
        QTest::newRow("C1 control") << QByteArray("\xC2\x9B"
                                                  "31m")
                                    << no + "31m";
        QTest::newRow("reversed") << QByteArray("a\xE2\x80\xAE"
                                                "b")
                                  << "a" + no + "b";
        QTest::newRow("two lines") << QByteArray("a\nb") << QString("a b");
    }
    void textFromOutsideIsMadeValid() {
        QFETCH(QByteArray, text);
        QFETCH(QString, clean);
        QCOMPARE(QString::fromStdString(cleanLine(text.toStdString())), clean);
        QCOMPARE(cleanText("a\nb\x07"), std::string("a\nb\xEF\xBF\xBD"));
    }

    void fullDisksAreToldFromMissingRights() {
        QVERIFY(writeError(path("a"), ENOSPC).code == ErrorCode::diskFull);
        QVERIFY(writeError(path("a"), EACCES).code == ErrorCode::fileNotWritable);
        QVERIFY(writeError(path("a"), 0).detail.find("Success") == std::string::npos);
        QCOMPARE(writeError(path("a"), EACCES).subject, path("a").string());
    }
};

BURIN_TEST(TestFile, NoApplication)

} // namespace burin::tst_file

#include "tst_file.moc"

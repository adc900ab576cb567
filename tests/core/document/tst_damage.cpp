// SPDX-FileCopyrightText: 2026 The Burin authors
// SPDX-License-Identifier: Apache-2.0
#include "core/base/compression.h"
#include "core/base/file.h"
#include "core/document/database.h"
#include "core/document/project.h"
#include "core/document/sample_chunk.h"
#include "core/document/schema.h"
#include "tests/core/document/sample_project.h"
#include "tests/test_program.h"

#include <QTemporaryDir>
#include <QtTest>
#include <array>
#include <cmath>
#include <filesystem>
#include <fstream>
#include <random>

namespace burin::tst_damage {

namespace fs = std::filesystem;

namespace {

/// Everything that these projects contain.
struct Content {
    Model model;
    Take take;
};

Result<Content> contentOf(const fs::path& file) {
    Result<Project> project = Project::open(file);
    if (!project) return std::move(project).error();
    Result<Model> model = project->model();
    if (!model) return std::move(model).error();
    Result<Take> take = project->take(1);
    if (!take) return std::move(take).error();
    return Content{std::move(*model), std::move(*take)};
}

bool isTheOriginal(const Content& content) {
    const TakeInfo& info = content.take.info;
    const TakeInfo original = fixture::takeInfo("damaged");
    return fixture::identical(content.model, fixture::model()) &&
           fixture::identical(content.take.samples, fixture::handSamples(0, 300)) && info.name == original.name &&
           info.toolId == original.toolId && info.allowance == original.allowance &&
           info.startedUnixTime == original.startedUnixTime && info.stylus == original.stylus && info.complete;
}

bool isClear(const Error& error, const fs::path& file) {
    constexpr std::array codes{ErrorCode::projectNotBurin, ErrorCode::fileDamaged,     ErrorCode::fileFromNewerBurin,
                               ErrorCode::fileEmpty,       ErrorCode::fileNotReadable, ErrorCode::outOfMemory};
    return error.subject == file.string() && std::ranges::find(codes, error.code) != codes.end();
}

void write(const fs::path& file, const std::string& content) {
    std::ofstream(file, std::ios::binary | std::ios::trunc) << content;
}

/// A Zstandard frame (RFC 8878, 3.1.1) of `blocks` blocks, each 128 KiB of zeros in four bytes.
std::string frameOfZeros(std::uint32_t blocks) {
    constexpr std::uint32_t blockSize = 128U << 10U, repeated = 1;
    std::string frame("\x28\xb5\x2f\xfd\x80\x50", 6); // four bytes of content size, a window of 1 MiB
    const auto append = [&](std::uint32_t number, int bytes) {
        for (int i = 0; i < bytes; ++i) frame.push_back(static_cast<char>(number >> (8 * i) & 0xffU));
    };
    append(blocks * blockSize, 4);
    for (std::uint32_t i = 1; i <= blocks; ++i) {
        append(blockSize << 3U | repeated << 1U | (i == blocks ? 1U : 0U), 3);
        frame.push_back('\0');
    }
    return frame;
}

} // namespace

class TestDamage : public QObject {
    Q_OBJECT
private slots:
    void initTestCase() {
        const fs::path file = folder_.filePath("whole.burin").toStdString();
        Result<Project> project = Project::create(file);
        QVERIFY(project && project->setModel(fixture::model()));
        Result<Project::TakeWriter> writer = project->beginTake(fixture::takeInfo("damaged"));
        const std::vector<Sample> hand = fixture::handSamples(0, 300);
        for (std::size_t first = 0; first < hand.size(); first += 50)
            QVERIFY(writer->append(std::span(hand).subspan(first, 50)));
        QVERIFY(writer->finish() && project->save());
        whole_ = *readFile(file);
    }

    void theWholeFileIsRead() {
        const Result<Content> content = contentOf(placed(whole_));
        QVERIFY(content && isTheOriginal(*content));
    }

    /// Whatever single byte is damaged: the content is the original, or there is a clear error, but never different
    /// values.
    void aFlippedByteNeverPassesForAnotherValue_data() {
        QTest::addColumn<std::size_t>("low");
        QTest::addColumn<std::size_t>("high");
        QTest::addColumn<int>("trials");
        QTest::newRow("header") << std::size_t{0} << std::size_t{110} << 100;
        QTest::newRow("anywhere") << std::size_t{0} << whole_.size() << 140;
    }
    void aFlippedByteNeverPassesForAnotherValue() {
        QFETCH(std::size_t, low);
        QFETCH(std::size_t, high);
        QFETCH(int, trials);
        std::mt19937 random(5);
        int refused = 0;
        for (int trial = 0; trial < trials; ++trial) {
            std::string content = whole_;
            const std::size_t place = std::uniform_int_distribution<std::size_t>(low, high - 1)(random);
            content[place] = static_cast<char>(content[place] ^ std::uniform_int_distribution(1, 255)(random));
            const fs::path file = placed(content);
            const Result<Content> read = contentOf(file);
            QVERIFY2(read ? isTheOriginal(*read) : isClear(read.error(), file), qPrintable(QString::number(place)));
            if (!read) ++refused;
        }
        QVERIFY(refused > trials / 10);
    }

    void aTruncatedFileIsRefused() {
        for (std::size_t size = 1; size < whole_.size(); size += 1 + size / 3) {
            const fs::path file = placed(whole_.substr(0, size));
            const Result<Content> read = contentOf(file);
            QVERIFY(!read);
            QVERIFY(isClear(read.error(), file));
        }
    }

    void overwrittenIntervalsAreRefused() {
        std::mt19937 random(6);
        for (int trial = 0; trial < 40; ++trial) {
            std::string content = whole_;
            const std::size_t start = std::uniform_int_distribution<std::size_t>(0, content.size() - 2000)(random);
            for (std::size_t i = start; i < start + 2000; ++i)
                content[i] = static_cast<char>(std::uniform_int_distribution(0, 255)(random));
            const fs::path file = placed(content);
            const Result<Content> read = contentOf(file);
            QVERIFY(read ? isTheOriginal(*read) : isClear(read.error(), file));
        }
    }

    void whatIsNoProjectIsRefused_data() {
        QTest::addColumn<QByteArray>("content");
        QTest::addColumn<ErrorCode>("code");
        QTest::newRow("text") << QByteArray("ISO-10303-21;\nHEADER;\n") << ErrorCode::projectNotBurin;
        QTest::newRow("zeros") << QByteArray(5000, '\0') << ErrorCode::projectNotBurin;
        QTest::newRow("the name of SQLite and no more")
            << QByteArray("SQLite format 3\0", 16) << ErrorCode::projectNotBurin;
        QTest::newRow("nothing") << QByteArray() << ErrorCode::fileEmpty;
    }
    void whatIsNoProjectIsRefused() {
        QFETCH(QByteArray, content);
        QFETCH(ErrorCode, code);
        const fs::path file = placed(content.toStdString());
        const Result<Project> project = Project::open(file);
        QVERIFY(!project);
        QCOMPARE(project.error().code, code);
        QCOMPARE(project.error().subject, file.string());
        QCOMPARE(*readFile(file), content.toStdString());
    }

    void anotherProgramsDatabaseIsRefused() {
        const fs::path file = placed({});
        fs::remove(file);
        QVERIFY(Database::open(file, "", Database::Access::create)->execute("CREATE TABLE document(id)"));
        QCOMPARE(Project::open(file).error().code, ErrorCode::projectNotBurin);
    }

    void aFolderIsRefused() {
        const QTemporaryDir place;
        QCOMPARE(Project::open(place.path().toStdString()).error().code, ErrorCode::projectNotBurin);
    }

    void aProjectOfANewerBurinIsLeftAlone() {
        const fs::path file = placed(whole_);
        const int newer = projectVersion + 1;
        const std::string statement = "PRAGMA user_version = " + std::to_string(newer);
        QVERIFY(Database::open(file, "", Database::Access::write)->execute(statement.c_str()));
        const Result<Project> project = Project::open(file);
        QVERIFY(!project);
        QCOMPARE(project.error().code, ErrorCode::fileFromNewerBurin);
        QCOMPARE(project.error().detail, std::to_string(newer));
    }

    void aProjectWithoutATableIsDamaged() {
        const fs::path file = placed(whole_);
        QVERIFY(Database::open(file, "", Database::Access::write)
                    ->execute("PRAGMA foreign_keys = OFF; DROP TABLE sample_chunk; UPDATE document SET digest = NULL"));
        const Result<Content> read = contentOf(file);
        QVERIFY(!read);
        QCOMPARE(read.error().code, ErrorCode::fileDamaged);
    }

    /// A recording with a gap is not presented as a shorter one.
    void aMissingIntervalOfARecordingIsNamed() {
        const fs::path file = placed(whole_);
        QVERIFY(Database::open(file, "", Database::Access::write)
                    ->execute("DELETE FROM sample_chunk WHERE first = 100; UPDATE document SET digest = NULL"));
        const Result<Content> read = contentOf(file);
        QVERIFY(!read);
        QCOMPARE(read.error().code, ErrorCode::fileDamaged);
        QCOMPARE(read.error().place, std::string("take 1, sample 100"));
    }

    /// A session has room for eight guides, and copies what it gets.
    void moreGuidesThanASessionHasAreRefused() {
        const fs::path file =
            filledAndChanged("INSERT INTO guide SELECT setup, position + 100, json, curve FROM guide");
        const Result<Project> project = Project::openForReading(file);
        QVERIFY(project);
        const Result<KeptGuides> guides = project->guides();
        QVERIFY(!guides);
        QCOMPARE(guides.error().code, ErrorCode::fileDamaged);
        QCOMPARE(guides.error().place, std::string("guide 9"));
    }

    void anUndoneIntervalMayEndWhereNumbersDo() {
        const fs::path file = filledAndChanged("UPDATE undone_stretch SET first = 1 << 62, count = 1 << 62");
        const Result<Project> project = Project::openForReading(file);
        QVERIFY(project);
        const Result<std::vector<TakeInfo>> takes = project->takes();
        QVERIFY(takes);
        QCOMPARE(takes->front().undoneCount, fixture::offInFixture.count); // switched-off samples are in another table
        QCOMPARE(takes->back().undoneCount, std::uint64_t{0});
    }

    /// Distances from there overflow; a path used to crash on it.
    void aToolWhereNoMachineReachesIsDamage_data() {
        QTest::addColumn<double>("x");
        QTest::addColumn<double>("upright");
        QTest::newRow("the end of numbers") << 1e308 << 1.0;
        QTest::newRow("no number") << std::nan("") << 1.0;
        QTest::newRow("no axis") << 0.0 << 0.0;
    }
    void aToolWhereNoMachineReachesIsDamage() {
        QFETCH(double, x);
        QFETCH(double, upright);
        const fs::path file = placed(whole_);
        std::vector<Sample> samples = fixture::handSamples(100, 50); // the third chunk
        samples[7].proxy = {{x, 0.0, 0.0}, {0.0, 0.0, upright}};
        {
            Result<Database> database = Database::open(file, "", Database::Access::write);
            const std::string chunk = encodeSamples(samples);
            QVERIFY(run(*database, "UPDATE sample_chunk SET samples = ? WHERE first = 100", BlobView{chunk}));
            QVERIFY(database->execute("UPDATE document SET digest = NULL"));
        }
        const Result<Content> read = contentOf(file);
        QVERIFY(!read);
        QCOMPARE(read.error().code, ErrorCode::fileDamaged);
        QCOMPARE(read.error().place, std::string("take 1, sample 107"));
    }

    /// 64 MiB in 2 kB, a ratio that no description of a part reaches.
    void aPartThatClaimsMuchIsRefused() {
        const std::string packed = frameOfZeros(512);
        QVERIFY(decompress(packed, std::size_t{64} << 20U) == std::string(std::size_t{64} << 20U, '\0'));
        const fs::path file = filledAndChanged("");
        {
            Result<Database> database = Database::open(file, "", Database::Access::write);
            QVERIFY(run(*database, "UPDATE model SET brep = ?", BlobView{packed}));
        }
        const Result<Project> project = Project::openForReading(file);
        QVERIFY(project);
        QCOMPARE(project->model().error().code, ErrorCode::fileDamaged);
    }

    /// A project from someone else may contain triggers; they never run.
    void foreignTriggersNeverRun() {
        const fs::path file = placed(whole_);
        QVERIFY(Database::open(file, "", Database::Access::write)
                    ->execute("CREATE TRIGGER evil AFTER INSERT ON model BEGIN DELETE FROM body; END"));
        Result<Project> project = Project::open(file);
        QVERIFY(project && project->setModel(fixture::model()));
        QVERIFY(fixture::identical(*project->model(), fixture::model()));
    }

private:
    /// Writes `content` to a project file of its own.
    fs::path placed(const std::string& content) {
        fs::path file = folder_.filePath(QString::number(++number_) + ".burin").toStdString();
        write(file, content);
        return file;
    }

    /// A project with everything in it, changed by SQL.
    fs::path filledAndChanged(const std::string& sql) {
        fs::path file = folder_.filePath(QString::number(++number_) + ".burin").toStdString();
        if (!fixture::fillProject(file) || !Database::open(file, "", Database::Access::write)
                                                ->execute((sql + "; UPDATE document SET digest = NULL").c_str()))
            return {};
        return file;
    }

    QTemporaryDir folder_;
    std::string whole_;
    int number_ = 0;
};

BURIN_TEST(TestDamage, NoApplication)

} // namespace burin::tst_damage

#include "tst_damage.moc"

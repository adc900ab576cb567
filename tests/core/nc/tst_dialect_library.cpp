// SPDX-FileCopyrightText: 2026 The Burin authors
// SPDX-License-Identifier: Apache-2.0
#include "core/nc/dialect_library.h"
#include "core/nc/post.h"
#include "tests/places.h"
#include "tests/test_program.h"

#include <QCoreApplication>
#include <QFile>
#include <QTemporaryDir>
#include <QTest>

#include <filesystem>

namespace burin::tst_dialect_library {

namespace fs = std::filesystem;

namespace {

const QByteArray goodMetadata = R"({"id": "trace", "kind": "dialect", "name": "Trace", "version": "1.0",
    "interface_version": 5, "library": "trace.so", "file_suffix": "nc"})";

void write(const QString& file, const QByteArray& content) {
    QFile out(file);
    QVERIFY(out.open(QIODevice::WriteOnly));
    QCOMPARE(out.write(content), content.size());
}

fs::path path(const QString& text) {
    return fs::path(text.toStdString());
}

} // namespace

class TestDialectLibrary : public QObject {
    Q_OBJECT

private slots:
    void init() {
        folder_ = std::make_unique<QTemporaryDir>();
        QVERIFY(folder_->isValid());
        qputenv("BURIN_TEST_TRACE", traceFile().toLocal8Bit());
    }

    void aPluginIsDescribedWithoutRunningIt() {
        install("trace", goodMetadata, "libburin_test_dialect.so");
        const DialectList list = dialects(root());
        QVERIFY(list.faults.empty());
        const std::vector<DialectDescription>& found = list.known;
        QCOMPARE(found.size(), std::size_t{1});
        QCOMPARE(QString::fromStdString(found.front().id), "trace");
        QCOMPARE(QString::fromStdString(found.front().name), "Trace");
        QCOMPARE(QString::fromStdString(found.front().fileSuffix), "nc");
        QCOMPARE(found.front().interfaceVersion, 5);
        QVERIFY(!QFile::exists(traceFile()));
    }

    void aLoadedPluginWrites() {
        install("trace", goodMetadata, "libburin_test_dialect.so");
        auto post = loadDialect("trace", root());
        QVERIFY(post);
        QVERIFY(QFile::exists(traceFile())); // the trace works, so its absence elsewhere is significant
        NcProgram program;
        program.name = "hello";
        Progress progress;
        const auto text = writeProgram(program, MachineProfile{}, **post, progress);
        QVERIFY(text);
        QCOMPARE(QString::fromStdString(*text), "hello\n");
    }

    void anotherInterfaceVersionIsRefusedBeforeAnyCodeRuns() {
        QByteArray metadata = goodMetadata;
        metadata.replace("\"interface_version\": 5", "\"interface_version\": 6");
        install("trace", metadata, "libburin_test_dialect.so");
        const auto post = loadDialect("trace", root());
        QVERIFY(!post);
        QCOMPARE(post.error().code, ErrorCode::pluginIncompatible);
        QCOMPARE(QString::fromStdString(post.error().place), "6");
        QCOMPARE(QString::fromStdString(post.error().detail), "5");
        QVERIFY(!QFile::exists(traceFile()));
    }

    void invalidMetadataNamesItsFile_data() {
        QTest::addColumn<QByteArray>("from");
        QTest::addColumn<QByteArray>("to");
        QTest::newRow("not JSON") << QByteArray("{") << QByteArray("[");
        QTest::newRow("no id") << QByteArray("\"id\": \"trace\", ") << QByteArray();
        QTest::newRow("empty id") << QByteArray("\"id\": \"trace\"") << QByteArray("\"id\": \"\"");
        QTest::newRow("another kind") << QByteArray("\"dialect\"") << QByteArray("\"device\"");
        QTest::newRow("version is a text")
            << QByteArray("\"interface_version\": 5") << QByteArray("\"interface_version\": \"1\"");
        QTest::newRow("version is a fraction")
            << QByteArray("\"interface_version\": 5") << QByteArray("\"interface_version\": 1.5");
        QTest::newRow("version is ours in its lower 32 bits")
            << QByteArray("\"interface_version\": 5") << QByteArray("\"interface_version\": 5294967300");
        QTest::newRow("library outside its folder") << QByteArray("trace.so") << QByteArray("../trace.so");
        QTest::newRow("unknown key") << QByteArray("\"name\"") << QByteArray("\"nmae\": \"\", \"name\"");
    }
    void invalidMetadataNamesItsFile() {
        QFETCH(QByteArray, from);
        QFETCH(QByteArray, to);
        QByteArray metadata = goodMetadata;
        QVERIFY(metadata.contains(from));
        install("trace", metadata.replace(from, to), "libburin_test_dialect.so");
        const DialectList found = dialects(root());
        QVERIFY(found.known.empty());
        QCOMPARE(found.faults.size(), std::size_t{1});
        QCOMPARE(found.faults.front().code, ErrorCode::pluginInvalid);
        QVERIFY(QString::fromStdString(found.faults.front().subject).endsWith("trace/plugin.json"));
        QVERIFY(!loadDialect("trace", root()));
        QVERIFY(!QFile::exists(traceFile()));
    }

    void aMissingLibraryIsNamed() {
        install("trace", goodMetadata, {});
        const auto post = loadDialect("trace", root());
        QVERIFY(!post);
        QCOMPARE(post.error().code, ErrorCode::pluginInvalid);
        QVERIFY(QString::fromStdString(post.error().subject).endsWith("trace.so"));
    }

    void aLibraryWithoutTheEntryPointIsRefused() {
        install("trace", goodMetadata, "libburin_test_no_entry.so");
        const auto post = loadDialect("trace", root());
        QVERIFY(!post);
        QCOMPARE(post.error().code, ErrorCode::pluginInvalid);
        QVERIFY(QString::fromStdString(post.error().detail).contains("burinCreatePostProcessor"));
    }

    void anUnknownIdListsThoseThatExist() {
        install("trace", goodMetadata, "libburin_test_dialect.so");
        QByteArray second = goodMetadata;
        install("another", second.replace("\"trace\"", "\"another\""), "libburin_test_dialect.so");
        const auto post = loadDialect("fanuc", root());
        QVERIFY(!post);
        QCOMPARE(post.error().code, ErrorCode::dialectNotFound);
        QCOMPARE(QString::fromStdString(post.error().subject), "fanuc");
        QCOMPARE(QString::fromStdString(post.error().detail), "another trace");
    }

    void oneIdTwiceIsRefused() {
        install("trace", goodMetadata, {});
        install("copy", goodMetadata, {});
        const DialectList found = dialects(root());
        QCOMPARE(found.faults.size(), std::size_t{1});
        QCOMPARE(found.faults.front().code, ErrorCode::pluginInvalid);
    }

    void aMissingFolderIsAnError() {
        const DialectList found = dialects(root() / "nowhere");
        QCOMPARE(found.faults.size(), std::size_t{1});
        QCOMPARE(found.faults.front().code, ErrorCode::fileNotFound);
    }

private:
    QString traceFile() const { return folder_->filePath("trace.txt"); }
    fs::path root() const { return path(folder_->filePath("plugins")); }

    void install(const QString& name, const QByteArray& metadata, const QString& library) {
        const QString folder = folder_->filePath("plugins/" + name);
        fs::create_directories(path(folder));
        write(folder + "/plugin.json", metadata);
        if (!library.isEmpty())
            QVERIFY(QFile::copy(QString(BURIN_BUILD_DIRECTORY "/tests/") + library, folder + "/trace.so"));
    }

    std::unique_ptr<QTemporaryDir> folder_;
};

BURIN_TEST(TestDialectLibrary, QCoreApplication)

} // namespace burin::tst_dialect_library

#include "tst_dialect_library.moc"

// SPDX-FileCopyrightText: 2026 The Burin authors
// SPDX-License-Identifier: Apache-2.0
#include "core/document/file_kind.h"
#include "tests/places.h"
#include "tests/test_program.h"

#include <QCoreApplication>
#include <QFile>
#include <QTemporaryDir>
#include <QtTest>

#include <optional>
#include <sys/stat.h>

namespace burin::tst_file_kind {

/// Files in a folder of the user are distinguished by their content.
class TestFileKind : public QObject {
    Q_OBJECT

    QTemporaryDir folder_;

    std::filesystem::path write(const char* name, const QByteArray& content) const {
        QFile file(folder_.filePath(name));
        if (file.open(QIODevice::WriteOnly)) file.write(content);
        return file.fileName().toStdString();
    }

private slots:
    void contentDecides_data() {
        QTest::addColumn<QString>("name");
        QTest::addColumn<QByteArray>("content");
        QTest::addColumn<int>("kind"); // -1: projectNotBurin
        const int project = static_cast<int>(FileKind::project), program = static_cast<int>(FileKind::program),
                  model = static_cast<int>(FileKind::model), locations = static_cast<int>(FileKind::locations);
        const QByteArray database("SQLite format 3\0 and so on", 27);
        QTest::newRow("a project by another name") << "part.step" << database << project;
        QTest::newRow("a text named as a project") << "a.burin" << QByteArray("Dear Emil\n") << -1;
        QTest::newRow("a text named as a project, in capitals") << "a.BURIN" << QByteArray("Dear Emil\n") << -1;
        QTest::newRow("LinuxCNC") << "a.txt" << QByteArray("%\n(part)\nN10 G21 G90\nN20 T1 M6\nG1 X1.5 Y-2 F300\n%\n")
                                  << program;
        QTest::newRow("no spaces, parameters") << "a.nc"
                                               << QByteArray("G0X1Y2\n#1=3\nG1X#1F[2*3]\nX2\nX3\nX4\nX5\nX6\n"
                                                             "X7\nX8\nX9\nM30\n")
                                               << program;
        QTest::newRow("lower case, Windows") << "a.tap" << QByteArray("g21\r\ng0 x1\r\nm2\r\n") << program;
        QTest::newRow("lines that end in CR") << "a.nc" << QByteArray("G21\rG0 X1\rM2\r") << program;
        QTest::newRow("byte order mark") << "a.nc" << QByteArray("\xEF\xBB\xBFG21\nG0 X1\nM2\n") << program;
        QTest::newRow("blanks in numbers") << "a.nc" << QByteArray("G 2 1\nG0 X1 0 . 5\nM2\n") << program;
        QTest::newRow("Heidenhain") << "a.h" << QByteArray("0 BEGIN PGM A MM\n1 L X+1 FMAX\n") << program;
        QTest::newRow("a program named as a model") << "a.stl" << QByteArray("G21\nG0 X1\nM2\n") << program;
        QTest::newRow("cutter locations")
            << "a.txt" << QByteArray("PARTNO A\nFEDRAT/100,MMPM\nGOTO/0,0,5\nFINI\n") << locations;
        QTest::newRow("a letter") << "a.txt" << QByteArray("Dear Emil,\nG1 is what I mean.\n") << model;
        QTest::newRow("numbers") << "a.csv" << QByteArray("X1\nX2\nX3\n") << model;
        QTest::newRow("STEP") << "a.nc" << QByteArray("ISO-10303-21;\nHEADER;\n") << model;
        QTest::newRow("STL") << "a.nc" << QByteArray("solid a\nfacet normal 0 0 1\n") << model;
        QTest::newRow("binary") << "a.nc" << QByteArray("G21\nG0 X1\n\0\0\0", 14) << model;
        QTest::newRow("PDF") << "a.pdf" << QByteArray("%PDF-1.4\n1 0 obj\n<< /Type /Page >>\nendobj\n") << model;
    }
    void contentDecides() {
        QFETCH(QString, name);
        QFETCH(QByteArray, content);
        QFETCH(int, kind);
        const Result<FileKind> found = fileKind(write(qPrintable(name), content));
        if (kind < 0) {
            QVERIFY(!found);
            QCOMPARE(found.error().code, ErrorCode::projectNotBurin);
            return;
        }
        QVERIFY(found);
        QCOMPARE(static_cast<int>(*found), kind);
    }

    /// A program is long: the end of what is looked at cuts a line in two.
    void aLongProgramIsOne() {
        QByteArray text("G21\n");
        for (int i = 0; i < 20000; ++i) text += "G1 X" + QByteArray::number(i) + ".123 (a comment of some length)\n";
        const Result<FileKind> found = fileKind(write("long.ngc", text));
        QVERIFY(found);
        QCOMPARE(*found, FileKind::program);
    }

    void everyFormerProjectIsOne() {
        for (const char* version : {"v1", "v2", "v3", "v4", "v5", "v6", "v7", "v8", "v9", "v10", "v11", "v12", "v13"}) {
            const QDir folder(QStringLiteral(BURIN_FIXTURES "/projects/") + version);
            const QStringList files = folder.entryList({"*.burin"}, QDir::Files);
            QVERIFY(!files.isEmpty());
            const Result<FileKind> found = fileKind(folder.filePath(files.front()).toStdString());
            QVERIFY(found);
            QCOMPARE(*found, FileKind::project);
        }
    }

    void whatIsNoFileIsSaid() {
        const auto errorOf = [](const std::filesystem::path& file) {
            const Result<FileKind> kind = fileKind(file);
            return kind ? std::optional<ErrorCode>() : kind.error().code;
        };
        QCOMPARE(errorOf(write("empty.step", {})), ErrorCode::fileEmpty);
        QCOMPARE(errorOf(write("empty.burin", {})), ErrorCode::fileEmpty);
        QCOMPARE(errorOf(folder_.path().toStdString()), ErrorCode::fileNotReadable);
        QCOMPARE(errorOf(folder_.filePath("none.step").toStdString()), ErrorCode::fileNotFound);
        const QByteArray pipe = folder_.filePath("pipe.burin").toLocal8Bit();
        QCOMPARE(::mkfifo(pipe.constData(), 0600), 0);
        QCOMPARE(errorOf(pipe.toStdString()), ErrorCode::fileNotReadable); // and does not wait for a writer
        // Work that was never saved has no file, but a copy next to its name.
        const Result<FileKind> unsaved = fileKind(folder_.filePath("none.burin").toStdString());
        QVERIFY(unsaved);
        QCOMPARE(*unsaved, FileKind::project);
    }
};

BURIN_TEST(TestFileKind, QCoreApplication)

} // namespace burin::tst_file_kind

#include "tst_file_kind.moc"

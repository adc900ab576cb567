// SPDX-FileCopyrightText: 2026 The Burin authors
// SPDX-License-Identifier: Apache-2.0
#include "cad_test.h"

#include "core/base/file.h"
#include "tests/test_program.h"

#include <QCoreApplication>
#include <QTemporaryDir>
#include <QtTest>

#include <random>
#include <sys/stat.h>
#include <unistd.h>

namespace burin::tst_broken_files {

using namespace burin::test;

namespace fs = std::filesystem;

class BrokenFiles : public QObject {
    Q_OBJECT

private:
    QTemporaryDir folder_;

    fs::path write(const std::string& name, const std::string& content) {
        const fs::path file = fs::path(folder_.path().toStdString()) / name;
        if (!writeFileAtomically(file, content)) qFatal("no place to write");
        return file;
    }
    static std::string contentOf(const std::string& name) { return std::move(readFile(modelFile(name))).value(); }

    static void verifyRefused(const fs::path& file, const std::vector<ErrorCode>& fitting) {
        const Result<Model> model = import(file);
        QVERIFY(!model);
        const Error& error = model.error();
        QVERIFY2(std::find(fitting.begin(), fitting.end(), error.code) != fitting.end(), describe(error).c_str());
        QVERIFY(error.subject.find(file.filename().string()) != std::string::npos);
        QVERIFY(errorClass(error.code) == ErrorClass::badInput);
    }

private slots:
    void missingFileFolderAndDevice() {
        verifyRefused(fs::path(folder_.path().toStdString()) / "missing.step", {ErrorCode::fileNotFound});
        const fs::path folder = fs::path(folder_.path().toStdString()) / "folder.step";
        fs::create_directory(folder);
        verifyRefused(folder, {ErrorCode::fileNotReadable});
        const fs::path pipe = fs::path(folder_.path().toStdString()) / "pipe.step";
        QCOMPARE(::mkfifo(pipe.c_str(), 0600), 0);
        verifyRefused(pipe, {ErrorCode::fileNotReadable}); // would block for ever
    }

    void unreadableFile() {
        if (::geteuid() == 0) QSKIP("root may read everything");
        const fs::path file = write("locked.step", "x");
        fs::permissions(file, fs::perms::none);
        verifyRefused(file, {ErrorCode::fileNotReadable});
    }

    void emptyFile_data() {
        QTest::addColumn<QByteArray>("content");
        QTest::newRow("no byte") << QByteArray();
        QTest::newRow("space alone") << QByteArray(" \n\t \r\n");
    }
    void emptyFile() {
        QFETCH(QByteArray, content);
        verifyRefused(write("empty.step", content.toStdString()), {ErrorCode::fileEmpty});
    }

    void anotherKindOfFile_data() {
        QTest::addColumn<QByteArray>("content");
        QTest::newRow("text") << QByteArray("solid advice is hard to come by\nand this is none\n");
        QTest::newRow("one byte") << QByteArray("x");
        QTest::newRow("zip") << QByteArray("PK\3\4 and more of it").repeated(100);
        QTest::newRow("zeros") << QByteArray(5000, '\0');
        std::mt19937 random(7);
        QByteArray noise;
        for (int i = 0; i < 20000; ++i) noise.append(static_cast<char>(random()));
        QTest::newRow("random bytes") << noise;
    }
    void anotherKindOfFile() {
        QFETCH(QByteArray, content);
        verifyRefused(write("other.step", content.toStdString()), {ErrorCode::fileFormatUnknown});
    }

    void truncatedFile_data() {
        QTest::addColumn<QString>("file");
        QTest::addColumn<double>("part");
        for (const char* file :
             {"tet.step", "featuretype.step", "cube.iges", "cube.brep", "shared-edge.stl", "pocket-test.stl"})
            for (const double part : {0.999, 0.9, 0.5, 0.2})
                QTest::newRow(qPrintable(QString("%1 cut at %2").arg(file).arg(part))) << QString(file) << part;
    }
    void truncatedFile() {
        QFETCH(QString, file);
        QFETCH(double, part);
        const std::string whole = contentOf(file.toStdString());
        const auto size = static_cast<std::size_t>(part * static_cast<double>(whole.size()));
        verifyRefused(write("cut-" + file.toStdString(), whole.substr(0, size)),
                      {ErrorCode::fileDamaged, ErrorCode::modelHasNoSolid});
    }

    void damagedInTheMiddle_data() {
        QTest::addColumn<QString>("file");
        QTest::addColumn<int>("seed");
        for (const char* file :
             {"tet.step", "mayo-332.stp", "cube.iges", "cube.brep", "shared-edge.stl", "pocket-test.stl"})
            for (int seed = 0; seed < 4; ++seed)
                QTest::newRow(qPrintable(QString("%1, seed %2").arg(file).arg(seed))) << QString(file) << seed;
    }
    void damagedInTheMiddle() {
        // Whatever OpenCASCADE does with it, even a crash or a hang: the caller gets a model or an error.
        QFETCH(QString, file);
        QFETCH(int, seed);
        std::string content = contentOf(file.toStdString());
        std::mt19937 random(static_cast<unsigned>(seed));
        for (int i = 0; i < 20; ++i) content[random() % content.size()] = static_cast<char>('0' + random() % 10);
        ImportOptions quick = options();
        quick.limits.seconds = 5.0;
        Progress progress;
        const Result<Model> model = importModel(write("damaged", content), quick, progress);
        if (!model)
            QVERIFY(errorClass(model.error().code) == ErrorClass::badInput);
        else
            QVERIFY(!model->bodies.empty());
    }

    void partsOfNoSensibleSize_data() {
        QTest::addColumn<QString>("side"); // of a tetrahedron, as written in the file
        QTest::addColumn<bool>("refused");
        QTest::addColumn<QString>("said");
        QTest::newRow("beyond any figure") << "1e300" << true << "1e+300 mm";
        QTest::newRow("2 km") << "2000000" << true << "2e+06 mm";
        QTest::newRow("20 m") << "20000" << false << "2e+04 mm";
        QTest::newRow("10 m") << "10000" << false << "";
        QTest::newRow("1 mm") << "1" << false << "";
        QTest::newRow("in metres") << "0.05" << false << "0.05 mm";
        QTest::newRow("too small for a float") << "1e-30" << false << "1e-30 mm";
    }
    void partsOfNoSensibleSize() {
        QFETCH(QString, side);
        QFETCH(bool, refused);
        QFETCH(QString, said);
        const std::array<std::array<int, 3>, 4> faces{{{0, 2, 1}, {0, 1, 3}, {0, 3, 2}, {1, 2, 3}}};
        QString text = "solid a\n";
        for (const std::array<int, 3>& face : faces) {
            text += "facet normal 0 0 1\nouter loop\n";
            for (const int corner : face) {
                QStringList place{"0", "0", "0"};
                if (corner > 0) place[corner - 1] = side;
                text += "vertex " + place.join(' ') + "\n";
            }
            text += "endloop\nendfacet\n";
        }
        const Result<Model> model = import(write("size.stl", (text + "endsolid a\n").toStdString()));
        QCOMPARE(!model, refused);
        if (!model) {
            QCOMPARE(model.error().code, ErrorCode::modelTooLarge);
            QCOMPARE(QString::fromStdString(model.error().place), said);
            return;
        }
        QStringList warnings;
        for (const ImportNote& note : model->notes)
            if (note.kind == ImportNote::Kind::warning) warnings << QString::fromStdString(note.text);
        QCOMPARE(warnings.size(), said.isEmpty() ? 0 : 1);
        if (!said.isEmpty()) QVERIFY2(warnings.first().contains(said), qPrintable(warnings.first()));
    }

    void contentDecidesNotTheSuffix_data() {
        QTest::addColumn<QString>("file");
        QTest::addColumn<QString>("name");
        QTest::addColumn<QString>("format");
        QTest::newRow("STEP named STL") << "tet.step"
                                        << "a.stl"
                                        << "STEP AP203";
        QTest::newRow("STL named STEP") << "pocket-test.stl"
                                        << "b.step"
                                        << "STL ASCII";
        QTest::newRow("IGES without a suffix") << "cube.iges"
                                               << "c"
                                               << "IGES";
        QTest::newRow("BREP named IGES, in a name with spaces and umlauts") << "cube.brep"
                                                                            << "Würfel neu.igs"
                                                                            << "BREP";
    }
    void contentDecidesNotTheSuffix() {
        QFETCH(QString, file);
        QFETCH(QString, name);
        QFETCH(QString, format);
        const Result<Model> model = import(write(name.toStdString(), contentOf(file.toStdString())));
        QVERIFY2(model, model ? "" : describe(model.error()).c_str());
        QCOMPARE(model->format, format.toStdString());
    }

    void whatFollowsBehindTheTrianglesIsLeftOut() {
        const Result<Model> model = import(write("long.stl", contentOf("shared-edge.stl") + "a note of some program"));
        QVERIFY(model);
        QCOMPARE(model->volume(), 2.0);
        QVERIFY(hasNote(*model, ImportNote::Kind::warning));
    }

    void binaryBrepIsRead() {
        // Model::brep is OpenCASCADE's binary form: written to a file it can be imported again.
        const Result<Model> first = import(modelFile("lower-leg-fork.step"));
        QVERIFY(first);
        const Result<Model> again = import(write("again.brep", first->brep));
        QVERIFY2(again, again ? "" : describe(again.error()).c_str());
        QVERIFY(std::abs(again->volume() - first->volume()) < 1e-6);
        verifyRefused(write("cut.brep", first->brep.substr(0, first->brep.size() / 2)), {ErrorCode::fileDamaged});
    }

    void wiresAloneAreNoSolid() {
        // The last line of a BREP file names the root among its numbered shapes: with another number one of its wires,
        // edges or vertices becomes the whole model.
        const std::string content = contentOf("cube.brep");
        const std::size_t tail = content.rfind("\n+");
        QVERIFY(tail != std::string::npos);
        bool refused = false;
        for (int shape = 3; shape < 34 && !refused; ++shape) {
            const Result<Model> model =
                import(write("wires.brep", content.substr(0, tail) + "\n+" + std::to_string(shape) + " 0 \n"));
            refused = !model && model.error().code == ErrorCode::modelHasNoSolid && !model.error().place.empty();
        }
        QVERIFY(refused);
    }
};

BURIN_TEST(BrokenFiles, QCoreApplication)

} // namespace burin::tst_broken_files

#include "tst_broken_files.moc"

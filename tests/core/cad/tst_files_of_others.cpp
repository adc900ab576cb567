// SPDX-FileCopyrightText: 2026 The Burin authors
// SPDX-License-Identifier: Apache-2.0
// Files of other programs that used to be refused, or were read without any message.
#include "cad_test.h"

#include "core/base/file.h"
#include "tests/test_program.h"

#include <QCoreApplication>
#include <QTemporaryDir>
#include <QtTest>

#include <algorithm>
#include <cmath>

namespace burin::tst_files_of_others {

using namespace burin::test;

class FilesOfOthers : public QObject {
    Q_OBJECT

private:
    QTemporaryDir folder_;

    static std::filesystem::path given(const char* name) { return modelFile("of-others") / name; }
    std::filesystem::path write(const std::string& name, const std::string& content) {
        const std::filesystem::path file = std::filesystem::path(folder_.path().toStdString()) / name;
        if (!writeFileAtomically(file, content)) qFatal("no place to write");
        return file;
    }
    static bool warns(const Model& model, const char* words) {
        return std::ranges::any_of(model.notes, [&](const ImportNote& note) {
            return note.kind == ImportNote::Kind::warning && note.text.find(words) != std::string::npos;
        });
    }

private slots:
    void whatIsWholeIsRead_data() {
        QTest::addColumn<QString>("file");
        QTest::addColumn<double>("volume"); // mm³, from the lengths in the file
        QTest::newRow("BREP with DRAW's flag") << "b01-drawable-flag-behind-root.brep" << 1000.0;
        QTest::newRow("IGES, Ctrl-Z at its end") << "i01-ctrl-z-at-end.igs" << 1000.0;
        QTest::newRow("IGES behind a comment") << "i07-comment-first.igs" << 1000.0;
        QTest::newRow("IGES, each face by itself") << "loose-faces-box.igs" << 24000.0;
        QTest::newRow("STEP behind a comment") << "t10f-blank-and-comment-first.stp" << 1000.0;
        QTest::newRow("STEP, name in Latin-1") << "t06b-name-latin1.stp" << 1000.0;
        QTest::newRow("STL without endsolid") << "s15-no-endsolid.stl" << 1000.0;
        QTest::newRow("STL, name in GBK") << "s16b-name-gbk.stl" << 1000.0;
        QTest::newRow("STL of 20 µm") << "s14b-20-micrometre.stl" << 8e-6;
    }
    void whatIsWholeIsRead() {
        QFETCH(QString, file);
        QFETCH(double, volume);
        const Result<Model> model = import(given(qPrintable(file)));
        QVERIFY2(model, model ? "" : describe(model.error()).c_str());
        QVERIFY2(std::abs(model->volume() / volume - 1.0) < 1e-6, std::to_string(model->volume()).c_str());
    }

    /// Its seam has an error of 1e-15.
    void aValidWasherIsMeshed() {
        const Result<Model> model = import(given("t15-1-turned-washer-seam-noise.stp"));
        QVERIFY2(model, model ? "" : describe(model.error()).c_str());
        QCOMPARE(model->bodies.size(), std::size_t{1});
        QCOMPARE(model->bodies[0].openEdges, std::size_t{0});
        const double meshed = signedVolume(model->bodies[0].mesh);
        QVERIFY2(std::abs(meshed - model->volume()) <= model->meshChord * model->bodies[0].area,
                 std::to_string(meshed).c_str());
    }

    void whatPadsAnEndIsNoDamage_data() {
        QTest::addColumn<QString>("file");
        QTest::addColumn<QByteArray>("padding");
        for (const char* file : {"tet.step", "cube.iges", "cube.brep"}) {
            QTest::addRow("%s, Ctrl-Z", file) << file << QByteArray("\x1A");
            QTest::addRow("%s, zeros", file) << file << QByteArray(512, '\0');
            QTest::addRow("%s, blank lines", file) << file << QByteArray("\r\n \r\n\t\n");
        }
    }
    void whatPadsAnEndIsNoDamage() {
        QFETCH(QString, file);
        QFETCH(QByteArray, padding);
        const std::string content = std::move(readFile(modelFile(file.toStdString()))).value();
        const Result<Model> plain = import(modelFile(file.toStdString()));
        const Result<Model> padded = import(write("padded-" + file.toStdString(), content + padding.toStdString()));
        QVERIFY2(plain && padded, padded ? "" : describe(padded.error()).c_str());
        QCOMPARE(padded->volume(), plain->volume());
    }

    void whatIsDoubtfulIsSaid() {
        const Result<Model> open = import(given("s15-no-endsolid.stl"));
        QVERIFY(open && warns(*open, "endsolid"));
        const Result<Model> plate = import(given("s17-flat-plate-no-volume.stl"));
        QVERIFY(plate && warns(*plate, "no volume"));
        const Result<Model> speck = import(given("s14b-20-micrometre.stl"));
        QVERIFY(speck && warns(*speck, "unit") && !warns(*speck, "no volume"));
    }

    /// The file contains a box and one additional face.
    void facesOutsideOfASolidAreCounted() {
        const Result<Model> model = import(given("loose-faces-box.igs"));
        QVERIFY(model && model->bodies.size() == 1);
        QVERIFY(warns(*model, "1 face outside"));
    }

    /// An assembly of a plate of 6000 mm³ and a block of 1000 mm³, each in a file of its own.
    void anAssemblyReadsTheFilesBesideIt() {
        const Result<Model> whole = import(given("external/assembly.stp"));
        QVERIFY2(whole, whole ? "" : describe(whole.error()).c_str());
        QVERIFY(std::abs(whole->volume() - 7000.0) < 1e-6 && !hasNote(*whole, ImportNote::Kind::warning));

        const auto copied = [&](const char* name) {
            return write(name, std::move(readFile(given("external") / name)).value());
        };
        const std::filesystem::path assembly = copied("assembly.stp");
        const Result<Model> alone = import(assembly);
        QVERIFY(!alone && alone.error().code == ErrorCode::modelHasNoSolid);
        QCOMPARE(alone.error().detail, std::string("part-block.stp, part-plate.stp"));

        copied("part-plate.stp");
        const Result<Model> half = import(assembly);
        QVERIFY2(half, half ? "" : describe(half.error()).c_str());
        QVERIFY(std::abs(half->volume() - 6000.0) < 1e-6);
        QVERIFY(warns(*half, "part-block.stp") && !warns(*half, "part-plate.stp"));
    }

    void anAssemblyReadsNothingElsewhere() {
        const std::string assembly = std::move(readFile(given("external/assembly.stp"))).value();
        const auto refersTo = [&](std::string text, const std::string& name) {
            const std::string plate = "part-plate.stp";
            for (std::size_t at = 0; (at = text.find(plate, at)) != std::string::npos; at += name.size())
                text.replace(at, plate.size(), name);
            return text;
        };
        const std::string there = (given("external") / "part-plate.stp").string();
        const Result<Model> elsewhere = import(write("elsewhere.stp", refersTo(assembly, there)));
        QVERIFY(!elsewhere && elsewhere.error().code == ErrorCode::modelHasNoSolid);
        QCOMPARE(elsewhere.error().detail, there);
        const Result<Model> circle = import(write("circle.stp", refersTo(assembly, "circle.stp")));
        QVERIFY(!circle && circle.error().code == ErrorCode::fileDamaged);
    }

    void whatCannotBeReadIsNamed() {
        const Result<Model> empty = import(given("s05b-binary-zero-triangles.stl"));
        QVERIFY(!empty && empty.error().code == ErrorCode::modelHasNoSolid);
        QCOMPARE(empty.error().place, std::string("no triangles"));
        const Result<Model> tessellated = import(given("t03-tessellated-only.stp"));
        QVERIFY(!tessellated && tessellated.error().code == ErrorCode::modelHasNoSolid);
        QVERIFY2(tessellated.error().place.find("tessellation") != std::string::npos,
                 describe(tessellated.error()).c_str());
        const Result<Model> far = import(given("s13b-far-1e6.stl"));
        QVERIFY(!far && far.error().code == ErrorCode::modelTooLarge);
        QVERIFY2(far.error().place != far.error().detail, far.error().place.c_str());
    }
};

BURIN_TEST(FilesOfOthers, QCoreApplication)

} // namespace burin::tst_files_of_others

#include "tst_files_of_others.moc"

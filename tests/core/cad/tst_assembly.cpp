// SPDX-FileCopyrightText: 2026 The Burin authors
// SPDX-License-Identifier: Apache-2.0
// Assemblies and units of STEP files, written here by OpenCASCADE with known names, placements, colours and lengths.
#include "assembly_file.h"
#include "cad_test.h"
#include "core/cad/body_path.h"
#include "core/cad/file_unit.h"
#include "tests/long_run.h"
#include "tests/test_program.h"

#include <QCoreApplication>
#include <QElapsedTimer>
#include <QTemporaryDir>
#include <QtTest>

#include <atomic>
#include <cmath>
#include <numbers>
#include <thread>

namespace burin::tst_assembly {

using namespace burin::test;

namespace {

const double boltVolume = 40.0 * std::numbers::pi; // ⌀ 4 × 10

std::vector<std::string> pathsOf(const Model& model) {
    std::vector<std::string> paths;
    for (const Body& body : model.bodies) paths.push_back(body.name);
    return paths;
}

const Body& bodyAt(const Model& model, const std::string& path) {
    const std::vector<std::size_t> bodies = bodiesNamed(model, path);
    if (bodies.size() != 1) qFatal("no body, or several: %s", path.c_str());
    return model.bodies[bodies.front()];
}

bool tells(const Model& model, ImportNote::Kind kind, const std::string& words) {
    return std::ranges::any_of(model.notes, [&](const ImportNote& note) {
        return note.kind == kind && note.text.find(words) != std::string::npos;
    });
}

Result<Model> importIn(const std::filesystem::path& file, double unit) {
    ImportOptions asked = options();
    asked.unitInstead = unit;
    Progress progress;
    return importModel(file, asked, progress);
}

} // namespace

class TestAssembly : public QObject {
    Q_OBJECT

private:
    QTemporaryDir folder_;
    std::string in(const char* name) const { return folder_.filePath(name).toStdString(); }

private slots:
    void namesAndInstancesMakePaths() {
        QVERIFY(writeVice(in("vice.step")));
        const Result<Model> model = import(in("vice.step"));
        QVERIFY2(model, model ? "" : describe(model.error()).c_str());
        const std::vector<std::string> expected{"Vice/Plate⁄Base",    "Vice/Jaws:1/Bolt:1", "Vice/Jaws:1/Bolt:2",
                                                "Vice/Jaws:2/Bolt:1", "Vice/Jaws:2/Bolt:2", "Vice/Stops/Stops 1",
                                                "Vice/Stops/Stops 2", "Vice/Bolt"};
        std::string found;
        for (const std::string& path : pathsOf(*model)) found += path + " | ";
        QVERIFY2(pathsOf(*model) == expected, found.c_str());
        // Each instance is where its assemblies put it.
        for (const auto& [path, x] : {std::pair{"Vice/Jaws:1/Bolt:1", 0.0},
                                      {"Vice/Jaws:1/Bolt:2", 20.0},
                                      {"Vice/Jaws:2/Bolt:1", 100.0},
                                      {"Vice/Jaws:2/Bolt:2", 120.0},
                                      {"Vice/Bolt", 200.0}}) {
            const Body& bolt = bodyAt(*model, path);
            QVERIFY(glm::length(bolt.box.centre() - glm::dvec3(x, 0.0, 5.0)) < 1e-3);
            QVERIFY(std::abs(bolt.volume / boltVolume - 1.0) < 1e-6);
            QVERIFY(std::abs(signedVolume(bolt.mesh) - boltVolume) < model->meshChord * bolt.area);
            QVERIFY(glm::length(boundingBox(bolt.mesh).low - bolt.box.low) < 2.0 * model->meshChord);
            QVERIFY(glm::length(boundingBox(bolt.mesh).high - bolt.box.high) < 2.0 * model->meshChord);
        }
        QVERIFY(std::abs(model->volume() - (6000.0 + 27.0 + 64.0 + 5.0 * boltVolume)) < 1e-3);
        QCOMPARE(bodiesNamed(*model, "Vice/Jaws:2"), (std::vector<std::size_t>{3, 4}));
        QCOMPARE(bodiesNamed(*model, "Vice").size(), std::size_t{8});
        // The same when it is read again.
        QCOMPARE(pathsOf(*import(in("vice.step"))), expected);
    }

    void coloursAreKeptAndWhatIsLostIsReported() {
        QVERIFY(writeVice(in("vice.step")));
        const Result<Model> model = import(in("vice.step"));
        QVERIFY(model);
        QVERIFY(bodyAt(*model, "Vice/Bolt").colour == BodyColour({255, 0, 0}));
        QVERIFY(bodyAt(*model, "Vice/Jaws:2/Bolt:2").colour == BodyColour({255, 0, 0}));
        QVERIFY(bodyAt(*model, "Vice/Plate⁄Base").colour == BodyColour({0, 255, 0}));
        QVERIFY(!bodyAt(*model, "Vice/Stops/Stops 1").colour);
        QVERIFY(tells(*model, ImportNote::Kind::leftOut, "1 face has a colour of its own"));
        QVERIFY(tells(*model, ImportNote::Kind::leftOut, "Layers were not imported (number of layers: 1)"));
        // A file that has nothing of the kind causes no such note.
        QVERIFY(!hasNote(*import(modelFile("red-cube-blue-cylinder.step")), ImportNote::Kind::leftOut));
    }

    /// A cube of 1 inch, so stated, has 16.387064 cm³; read as mm it has 1 mm³.
    void aStatedUnitCanBeReplaced() {
        AssemblyFile cube;
        cube.part(BRepPrimAPI_MakeBox(25.4, 25.4, 25.4).Shape(), "Cube");
        QVERIFY(cube.write(in("inch.step"), "INCH"));
        const Result<Model> stated = import(in("inch.step"));
        QVERIFY2(stated, stated ? "" : describe(stated.error()).c_str());
        QCOMPARE(stated->lengthUnit, std::string("inch"));
        QVERIFY(!unitReplaced(*stated) && std::abs(stated->volume() - 16387.064) < 1e-6);
        const Result<Model> asMm = importIn(in("inch.step"), 1.0);
        QVERIFY2(asMm, asMm ? "" : describe(asMm.error()).c_str());
        QVERIFY(std::abs(asMm->volume() - 1.0) < 1e-9 && std::abs(asMm->bodies[0].area - 6.0) < 1e-9);
        QCOMPARE(asMm->lengthUnit, std::string("inch"));
        QCOMPARE(asMm->unitScale, 1.0);
        QVERIFY(unitReplaced(*asMm));
        QVERIFY(glm::length(sizeInUnit(*asMm, asMm->statedUnit) - glm::dvec3(25.4)) < 1e-6);
        QVERIFY(
            tells(*asMm, ImportNote::Kind::unit, "The file states the unit inch (25.4 mm); 1 unit = 1 mm was used"));
        QVERIFY(!tells(*asMm, ImportNote::Kind::unit, "converted"));
        // Its exact surface is in the new unit as well: the middle is half an edge from the faces.
        const std::vector<double> distance = distances(*asMm, {glm::dvec3(0.5)});
        QVERIFY(distance.size() == 1 && std::abs(distance[0] + 0.5) < 1e-9);
        // Read again in the unit of before, and in the stated one.
        const ImportOptions again = importOptionsAsBefore(*asMm);
        QVERIFY(again.unitInstead == 1.0);
        QVERIFY(!importOptionsAsBefore(*stated).unitInstead);
        QVERIFY(!unitReplaced(*importIn(in("inch.step"), 25.4)));
    }

    /// The cubes of 10 mm; a mesh that states no unit, too.
    void everyFormatHasAUnitToChoose() {
        for (const char* file : {"cube.iges", "cube.brep"}) {
            const Result<Model> model = importIn(modelFile(file), 25.4);
            QVERIFY2(model, file);
            QVERIFY(std::abs(model->volume() / std::pow(254.0, 3.0) - 1.0) < 1e-9);
            QVERIFY(unitReplaced(*model) && glm::length(model->box().size() - glm::dvec3(254.0)) < 1e-5);
            QVERIFY(std::abs(signedVolume(model->bodies[0].mesh) / model->volume() - 1.0) < 1e-9);
        }
        const Result<Model> mesh = importIn(modelFile("pocket-test.stl"), 10.0);
        QVERIFY(mesh && std::abs(mesh->volume() / 167.2e6 - 1.0) < 1e-9);
    }

    /// Also while the file is being parsed, which reports nothing.
    void aLargeAssemblyIsCancelled() {
        const int blocks = testing::inLongRun(290, 25); // 20 MB, 2 MB
        QVERIFY(writeBlocks(in("blocks.step"), blocks));
        Progress progress;
        std::atomic<bool> stop = false;
        QElapsedTimer sinceCancel;
        std::thread canceller([&] {
            for (int i = 0; i < 100 && !stop && progress.fraction() < 0.05; ++i)
                std::this_thread::sleep_for(std::chrono::milliseconds(20));
            sinceCancel.start();
            progress.cancel();
        });
        const Result<Model> model = importModel(in("blocks.step"), options(), progress);
        stop = true;
        canceller.join();
        QVERIFY(!model);
        QCOMPARE(model.error().code, ErrorCode::cancelled);
        QVERIFY(sinceCancel.elapsed() < 1000);
    }

    /// Each block has the volume of the closed formula.
    void manyBodiesAreRead() {
        const int blocks = testing::inLongRun(290, 8);
        QVERIFY(writeBlocks(in("blocks.step"), blocks));
        const Result<Model> model = import(in("blocks.step"));
        QVERIFY2(model, model ? "" : describe(model.error()).c_str());
        QCOMPARE(model->bodies.size(), static_cast<std::size_t>(blocks));
        QVERIFY(std::abs(model->volume() / (blocks * roundedVolume) - 1.0) < 1e-6);
        QCOMPARE(model->bodies.back().name, "Blocks/Block:" + std::to_string(blocks));
    }
};

BURIN_TEST(TestAssembly, QCoreApplication)

} // namespace burin::tst_assembly

#include "tst_assembly.moc"

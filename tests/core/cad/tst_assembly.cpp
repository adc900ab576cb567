// SPDX-FileCopyrightText: 2026 The Burin authors
// SPDX-License-Identifier: Apache-2.0
// Assemblies and units of STEP files, written here by OpenCASCADE with known names, placements, colours and lengths.
#include "assembly_file.h"
#include "cad_test.h"
#include "core/cad/body_path.h"
#include "core/cad/file_unit.h"
#include "core/cad/reader/reader.h"
#include "core/cad/worker_process.h"
#include "tests/long_run.h"
#include "tests/test_program.h"

#include <QCoreApplication>
#include <QDir>
#include <QTemporaryDir>
#include <QtTest>

#include <algorithm>
#include <atomic>
#include <cerrno>
#include <cmath>
#include <numbers>
#include <sys/wait.h>
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

/// The triangles of a body whose faces have a colour, as a mesh.
TriangleMesh colouredPart(const Body& body, const std::array<std::uint8_t, 3>& colour) {
    TriangleMesh part;
    part.vertices = body.mesh.vertices;
    for (const ColouredTriangles& run : body.faceColours)
        if (run.colour == colour)
            part.triangles.insert(part.triangles.end(), body.mesh.triangles.begin() + run.first,
                                  body.mesh.triangles.begin() + run.first + run.count);
    return part;
}

/// Whether the import program has reported something.
bool hasImportBegun(const Progress& progress) {
    return *progress.step().text.text != '\0';
}

/// Whether this process has a child process, running or not yet waited for.
bool hasChild() {
    return ::waitpid(-1, nullptr, WNOHANG) != -1 || errno != ECHILD;
}

/// A prism on a regular polygon of radius 100 mm and height 1 mm; its sides are red and blue in turn.
bool writeColouredPrism(const std::string& file, int sides) {
    BRepBuilderAPI_MakePolygon polygon;
    for (int i = 0; i < sides; ++i) {
        const double angle = 2.0 * std::numbers::pi * i / sides;
        polygon.Add(gp_Pnt(100.0 * std::cos(angle), 100.0 * std::sin(angle), 0.0));
    }
    polygon.Close();
    BRepPrimAPI_MakePrism prism(BRepBuilderAPI_MakeFace(polygon.Wire()).Shape(), gp_Vec(0.0, 0.0, 1.0));
    AssemblyFile drum;
    const TDF_Label part = drum.part(prism.Shape(), "Drum");
    int side = 0;
    for (TopExp_Explorer edges(polygon.Wire(), TopAbs_EDGE); edges.More(); edges.Next())
        for (const TopoDS_Shape& face : prism.Generated(edges.Current()))
            drum.colourFace(part, face, side++ % 2 == 0 ? Quantity_NOC_RED : Quantity_NOC_BLUE1);
    return drum.write(file);
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
        QVERIFY(!tells(*model, ImportNote::Kind::leftOut, "colour"));
        QVERIFY(tells(*model, ImportNote::Kind::leftOut, "Layers were not imported (number of layers: 1)"));
        // A file that has nothing of the kind causes no such note.
        QVERIFY(!hasNote(*import(modelFile("red-cube-blue-cylinder.step")), ImportNote::Kind::leftOut));
    }

    /// The face of the plate at x = 0, which is 30 × 5 mm, is blue; no other.
    void aFaceKeepsItsColour() {
        QVERIFY(writeVice(in("vice.step")));
        const Result<Model> model = import(in("vice.step"));
        QVERIFY(model);
        const TriangleMesh blue = colouredPart(bodyAt(*model, "Vice/Plate⁄Base"), {0, 0, 255});
        QVERIFY(std::abs(surfaceArea(blue) - 150.0) < 1e-9);
        for (const auto& triangle : blue.triangles)
            for (const std::uint32_t corner : triangle) QVERIFY(std::abs(blue.vertices[corner].x) < 1e-9);
        for (const Body& body : model->bodies)
            QCOMPARE(body.faceColours.size(), std::size_t{body.name == "Vice/Plate⁄Base" ? 1U : 0U});
    }

    /// Two instances of a part with one red face, the second in green: the face moves along and stays red.
    void everyInstanceHasTheColoursOfItsPart() {
        const TopoDS_Shape block = BRepPrimAPI_MakeBox(20.0, 10.0, 5.0).Shape();
        AssemblyFile file;
        const TDF_Label part = file.part(block, "Block"), whole = file.assembly("Pair");
        TopExp_Explorer last(block, TopAbs_FACE);
        for (int i = 0; i < 5; ++i) last.Next(); // the last of six: z = 5
        file.colourFace(part, last.Current(), Quantity_NOC_RED);
        file.add(whole, part, 0.0);
        file.add(whole, part, 100.0);
        QVERIFY(file.write(in("pair.step")));
        const Result<Model> model = import(in("pair.step"));
        QVERIFY2(model, model ? "" : describe(model.error()).c_str());
        QCOMPARE(model->bodies.size(), std::size_t{2});
        for (const Body& body : model->bodies) {
            QVERIFY(!body.colour);
            TriangleMesh red = colouredPart(body, {255, 0, 0});
            QVERIFY(std::abs(surfaceArea(red) - 200.0) < 1e-9);
            const double start = body.name == "Pair/Block:2" ? 100.0 : 0.0;
            for (const auto& triangle : red.triangles)
                for (const std::uint32_t corner : triangle) {
                    QVERIFY(std::abs(red.vertices[corner].z - 5.0) < 1e-9);
                    QVERIFY(red.vertices[corner].x > start - 1e-9 && red.vertices[corner].x < start + 20.0 + 1e-9);
                }
        }
    }

    /// Where every face has a colour, that of most is the body's: five yellow faces of a cube and one red one.
    void theColourOfMostFacesIsThatOfTheBody() {
        const TopoDS_Shape cube = BRepPrimAPI_MakeBox(10.0, 10.0, 10.0).Shape();
        AssemblyFile file;
        const TDF_Label part = file.part(cube, "Cube");
        file.colour(part, Quantity_NOC_GREEN); // is seen nowhere
        int face = 0;
        for (TopExp_Explorer faces(cube, TopAbs_FACE); faces.More(); faces.Next())
            file.colourFace(part, faces.Current(), face++ == 2 ? Quantity_NOC_RED : Quantity_NOC_YELLOW);
        QVERIFY(file.write(in("cube.step")));
        const Result<Model> model = import(in("cube.step"));
        QVERIFY2(model, model ? "" : describe(model.error()).c_str());
        QVERIFY(model->bodies.front().colour == BodyColour({255, 255, 0}));
        QVERIFY(std::abs(surfaceArea(colouredPart(model->bodies.front(), {255, 0, 0})) - 100.0) < 1e-9);
        QCOMPARE(model->bodies.front().faceColours.size(), std::size_t{1});
    }

    /// Half of the sides of a prism are red, half blue; a side is 200 sin(180°/n) mm long and 1 mm high.
    void manyFacesKeepTheirColours() {
        constexpr int sides = 200;
        QVERIFY(writeColouredPrism(in("drum.step"), sides));
        const Result<Model> model = import(in("drum.step"));
        QVERIFY2(model, model ? "" : describe(model.error()).c_str());
        const Body& drum = model->bodies.front();
        QCOMPARE(drum.faceCount, static_cast<std::size_t>(sides + 2));
        QVERIFY(!drum.colour);
        const double half = 0.5 * sides * 200.0 * std::sin(std::numbers::pi / sides);
        QVERIFY(std::abs(surfaceArea(colouredPart(drum, {255, 0, 0})) / half - 1.0) < 1e-6);
        QVERIFY(std::abs(surfaceArea(colouredPart(drum, {0, 0, 255})) / half - 1.0) < 1e-6);
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

    /// While the text is read, while shapes are converted, and while they are meshed: the import program is gone when
    /// the call returns, and it leaves no file.
    void aLargeAssemblyIsCancelled() {
        QVERIFY(writeBlocks(in("blocks.step"), testing::inLongRun(290, 4))); // 20 MB, 0.3 MB
        const QStringList before = QDir(folder_.path()).entryList(QDir::Files);
        for (const double reached : {0.0, 0.15, 0.55}) {
            Progress progress;
            std::atomic<bool> stop = false;
            std::thread canceller([&] {
                while (!stop && !(progress.fraction() >= reached && hasImportBegun(progress)))
                    std::this_thread::sleep_for(std::chrono::milliseconds(1));
                progress.cancel();
            });
            const Result<Model> model = importModel(in("blocks.step"), options(), progress);
            const bool child = hasChild();
            stop = true;
            canceller.join();
            QVERIFY(!model);
            QCOMPARE(model.error().code, ErrorCode::cancelled);
            QVERIFY(!child);
            QCOMPARE(QDir(folder_.path()).entryList(QDir::Files), before);
        }
    }

    /// As the window and the command line receive it: fractions grow to the end, and each step names itself.
    void progressGrowsStepByStep() {
        QVERIFY(writeBlocks(in("blocks.step"), 4));
        Result<WorkerProcess> process = WorkerProcess::start(ReadRequest{in("blocks.step")}, options(), "blocks");
        QVERIFY(process);
        std::vector<double> fractions;
        std::vector<ImportStage> stages;
        while (!process->finished()) {
            process->advance();
            const WorkerProgress& now = process->progress();
            if (fractions.empty() || now.fraction != fractions.back()) fractions.push_back(now.fraction);
            if (stages.empty() || now.stage != stages.back()) stages.push_back(now.stage);
            std::this_thread::sleep_for(std::chrono::milliseconds(1));
        }
        QVERIFY(std::holds_alternative<Model>(process->takeAnswer()));
        QVERIFY(std::ranges::is_sorted(fractions) && std::ranges::is_sorted(stages));
        QVERIFY2(fractions.size() >= 10, qPrintable(QString::number(fractions.size())));
        QVERIFY(fractions.front() < 0.1 && fractions.back() > 0.99);
        QVERIFY(std::ranges::count(stages, ImportStage::converting) == 1 &&
                std::ranges::count(stages, ImportStage::meshing) == 1);
    }

    /// Amounts that can be counted by hand: the size of the file, eight solids.
    void everyStepStatesItsAmounts() {
        QVERIFY(writeBlocks(in("blocks.step"), 8));
        const double size = 1e-6 * static_cast<double>(std::filesystem::file_size(in("blocks.step")));
        std::vector<WorkerProgress> told;
        ReaderReports reports{[](double) {}, [](const ModelPreview&) {}, {}};
        reports.stage = [&](ImportStage stage, double done, double total) {
            told.push_back({0.0, stage, done, total});
        };
        QVERIFY(readModel(ReadRequest{in("blocks.step"), 0.1}, reports));
        std::vector<double> read, meshed;
        for (const WorkerProgress& each : told) {
            if (each.stage == ImportStage::reading) read.push_back(each.done);
            if (each.stage == ImportStage::meshing) meshed.push_back(each.done);
            if (each.stage == ImportStage::reading) QVERIFY(std::abs(each.total - size) < 1e-9);
            if (each.stage >= ImportStage::checking) QCOMPARE(each.total, 8.0);
        }
        QVERIFY(read.size() > 3 && read.front() == 0.0 && std::ranges::is_sorted(read) && read.back() < size);
        QCOMPARE(meshed, (std::vector<double>{1, 2, 3, 4, 5, 6, 7, 8}));
        QVERIFY(std::ranges::is_sorted(told, {}, &WorkerProgress::stage));
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

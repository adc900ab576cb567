// SPDX-FileCopyrightText: 2026 The Burin authors
// SPDX-License-Identifier: Apache-2.0
#include "cad_test.h"
#include "core/cad/import_formats.h"
#include "tests/test_program.h"

#include <QCoreApplication>
#include <QtTest>

#include <algorithm>
#include <cmath>
#include <tuple>

namespace burin::tst_models {

using namespace burin::test;

namespace {

/// The values of tests/fixtures/models/README.md for a file; lengths in mm for B-rep files, in the file's unit for STL.
struct Expected {
    const char* file;
    const char* format;
    const char* unit;
    double scale;
    std::size_t bodies;
    glm::dvec3 low, size;
    double volume;
    bool closed;
};

const double pi = 3.14159265358979323846;

const std::vector<Expected> table{
    {"mouse-cover.step", "STEP AP242", "m", 1000.0, 1, {31.9, -49.541, 0.0}, {80.0, 131.18, 29.477}, 52723.33, true},
    {"featuretype.step", "STEP AP214", "inch", 25.4, 1, {-63.5, -31.75, 0.0}, {127.0, 63.5, 34.925}, 190447.66, true},
    {"lower-leg-fork.step", "STEP AP214", "mm", 1.0, 1, {-13.5, -8.392, -167.5}, {13.5, 16.784, 62.5}, 4184.14, true},
    {"red-cube-blue-cylinder.step",
     "STEP AP214",
     "m",
     1000.0,
     2,
     {-10.0, 0.0, 0.0},
     {25.0, 10.0, 10.0},
     1000.0 + 250.0 * pi,
     true},
    {"mayo-332.stp", "STEP AP214", "mm", 1.0, 3, {-10.0, -10.0, 0.0}, {20.0, 20.0, 100.0}, 31510.17, true},
    {"tet.step", "STEP AP203", "cm", 10.0, 1, {-10.0, -10.0, -10.0}, {20.0, 20.0, 20.0}, 8000.0 / 3.0, true},
    {"cube.iges", "IGES", "mm", 1.0, 1, {0.0, 0.0, 0.0}, {10.0, 10.0, 10.0}, 1000.0, true},
    {"cube.brep", "BREP", "mm", 1.0, 1, {0.0, 0.0, 0.0}, {10.0, 10.0, 10.0}, 1000.0, true},
    {"mouse-cover.stl", "STL binary", "none", 1.0, 1, {31.9, -49.541, 0.0}, {80.0, 131.18, 29.476}, 52717.62, true},
    {"mouse-shell-top.stl",
     "STL binary",
     "none",
     1.0,
     1,
     {-29.881, -57.353, 13.4},
     {61.421, 98.357, 21.094},
     9210.12,
     true},
    {"utah-teapot.stl",
     "STL binary",
     "none",
     1.0,
     1,
     {-8.1639, -5.3698, 0.0},
     {17.5763, 10.927, 8.5715},
     526.5074,
     true},
    {"featuretype.stl", "STL binary", "none", 1.0, 1, {-2.5, -1.25, 0.0}, {5.0, 2.5, 1.375}, 11.627733, false},
    {"angle-block.stl",
     "STL binary",
     "none",
     1.0,
     1,
     {-0.66929, 0.0, -1.35198},
     {1.33858, 1.0, 1.35198},
     1.1455225,
     false},
    {"pocket-test.stl", "STL ASCII", "none", 1.0, 1, {-50.0, -50.0, 0.0}, {100.0, 100.0, 18.0}, 167200.0, true},
    {"shared-edge.stl", "STL binary", "none", 1.0, 1, {-0.5, -0.5, -0.5}, {2.0, 2.0, 1.0}, 2.0, true},
};

constexpr std::string_view freeformCover = "mouse-cover.step";

/// Imported only once, because that takes seconds.
const Result<Model>& importedFreeformCover() {
    static const Result<Model> model = import(modelFile(std::string(freeformCover)));
    return model;
}

double apart(const glm::dvec3& a, const glm::dvec3& b) {
    return glm::length(a - b);
}

const Body& bodyNamed(const Model& model, const std::string& name) {
    for (const Body& body : model.bodies)
        if (body.name == name) return body;
    static const Body missing;
    return missing;
}

} // namespace

class Models : public QObject {
    Q_OBJECT

private slots:
    /// The formats in the file dialog are exactly those that can be read.
    void everyFormatIsOfferedAndRead() {
        const std::vector<std::string_view> offered = importSuffixes();
        for (const Expected& expected : table) {
            const std::string_view file(expected.file);
            const std::string_view suffix = file.substr(file.rfind('.') + 1);
            QVERIFY2(std::ranges::find(offered, suffix) != offered.end(), expected.file);
        }
        std::apply(
            [](auto... formats) {
                // The formats that tst_mesh_formats.cpp writes and reads, in all variants.
                static constexpr std::array<std::string_view, 5> written{"3MF", "AMF", "PLY", "OFF", "OBJ"};
                const auto isRead = [](std::string_view name) {
                    return std::ranges::find(written, name) != written.end() ||
                           std::ranges::any_of(table, [&](const Expected& one) {
                               return std::string_view(one.format).starts_with(name);
                           });
                };
                QVERIFY((isRead(formats.name) && ...));
            },
            ImportFormats());
    }
    void figuresAreThoseOfTheTable_data() {
        QTest::addColumn<int>("row");
        for (std::size_t row = 0; row < table.size(); ++row) QTest::newRow(table[row].file) << static_cast<int>(row);
    }
    void figuresAreThoseOfTheTable() {
        QFETCH(int, row);
        const Expected& expected = table[static_cast<std::size_t>(row)];
        const Result<Model> model =
            expected.file == freeformCover ? importedFreeformCover() : import(modelFile(expected.file));
        QVERIFY2(model, model ? "" : describe(model.error()).c_str());
        QCOMPARE(model->format, std::string(expected.format));
        QCOMPARE(model->lengthUnit, std::string(expected.unit));
        QVERIFY(std::abs(model->unitScale / expected.scale - 1.0) < 1e-12);
        QCOMPARE(model->bodies.size(), expected.bodies);
        QVERIFY(apart(model->box().low, expected.low) < 1e-3);
        QVERIFY(apart(model->box().size(), expected.size) < 2e-3);
        QVERIFY(std::abs(model->volume() / expected.volume - 1.0) < 2e-6);
        QCOMPARE(hasNote(*model, ImportNote::Kind::warning) && !expected.closed, !expected.closed);
        for (const Body& body : model->bodies) {
            QVERIFY(!body.name.empty());
            QVERIFY(body.area > 0.0);
            QCOMPARE(body.openEdges == 0, expected.closed);
            QCOMPARE(countOpenEdges(body.mesh), body.openEdges);
            QVERIFY(std::abs(signedVolume(body.mesh) / body.volume - 1.0) < 5e-3);
            QVERIFY(apart(boundingBox(body.mesh).low, body.box.low) < 0.02);
            QVERIFY(apart(boundingBox(body.mesh).high, body.box.high) < 0.02);
        }
        const bool brepFile = model->lengthUnit != "none";
        QCOMPARE(model->brep.empty(), !brepFile);
        QCOMPARE(model->meshChord, brepFile ? 0.005 : 0.0);
    }

    void areaOfACubeIsExact() {
        for (const char* file : {"cube.iges", "cube.brep"}) {
            const Result<Model> model = import(modelFile(file));
            QVERIFY(model);
            QVERIFY(std::abs(model->bodies[0].area - 600.0) < 1e-6);
            QCOMPARE(model->bodies[0].faceCount, std::size_t{6});
        }
    }

    void facesThatTheMesherLeavesOutAreFilled() {
        // The plane faces that OpenCASCADE 7.6 leaves empty are at z = 1.1 and 3.6 (README, Traps): without them the
        // mesh's volume would be too small. The CAD system's own mesh of this part is the reference.
        const Result<Model>& model = importedFreeformCover();
        const Result<Model> witness = import(modelFile("mouse-cover.stl"));
        QVERIFY(model && witness);
        QVERIFY(hasNote(*model, ImportNote::Kind::healing));
        QCOMPARE(model->bodies[0].openEdges, std::size_t{0});
        QVERIFY(std::abs(signedVolume(model->bodies[0].mesh) / signedVolume(witness->bodies[0].mesh) - 1.0) < 5e-4);
        QVERIFY(std::abs(surfaceArea(model->bodies[0].mesh) / surfaceArea(witness->bodies[0].mesh) - 1.0) < 1e-3);
    }

    void bodiesKeepNamesAndColours() {
        const Result<Model> model = import(modelFile("red-cube-blue-cylinder.step"));
        QVERIFY(model);
        const Body &cube = bodyNamed(*model, "red_cube"), &cylinder = bodyNamed(*model, "blue_cylinder");
        QVERIFY(std::abs(cube.volume - 1000.0) < 1e-6);
        QVERIFY(std::abs(cylinder.volume - 250.0 * pi) < 1e-6);
        QVERIFY(cube.colour && cylinder.colour);
        QVERIFY((*cube.colour)[0] > (*cube.colour)[2]);
        QVERIFY((*cylinder.colour)[2] > (*cylinder.colour)[0]);
    }

    void placementsOfAnAssemblyAreApplied() {
        // Part 3 is the shape of Part 2 at another location: half a ball of radius 3, minus a shaft.
        const Result<Model> model = import(modelFile("mayo-332.stp"));
        QVERIFY(model);
        const Body &second = bodyNamed(*model, "Root/Part 2"), &third = bodyNamed(*model, "Root/Part 3");
        QVERIFY(std::abs(second.volume - third.volume) < 1e-6);
        QVERIFY(std::abs(second.box.low.z) < 1e-6);
        QVERIFY(std::abs(third.box.high.z - 100.0) < 1e-6);
    }

    void blocksOfATextFileAreBodies() {
        const Result<Model> model = import(modelFile("multibody.stl"));
        QVERIFY(model);
        QCOMPARE(model->bodies.size(), std::size_t{2});
        QVERIFY(apart(model->box().size(), {0.636, 1.088, 0.340}) < 2e-3);
        // The orientations of their triangles are inconsistent: they are corrected, and that is reported.
        QVERIFY(hasNote(*model, ImportNote::Kind::healing));
        for (const Body& body : model->bodies) {
            QCOMPARE(body.openEdges, std::size_t{0});
            QVERIFY(body.volume > 0.0);
        }
    }

    void piecesThatOverlapAreSaid() {
        const Result<Model> model = import(modelFile("mouse-shell-top.stl"));
        QVERIFY(model);
        bool said = false;
        for (const ImportNote& note : model->notes) said = said || note.text.find("20 pieces") != std::string::npos;
        QVERIFY(said);
    }

    void unitOfAnStlFileScalesIt() {
        Progress progress;
        ImportOptions inches = options();
        inches.fileUnit = 25.4;
        const Result<Model> model = importModel(modelFile("featuretype.stl"), inches, progress);
        QVERIFY(model);
        QCOMPARE(model->unitScale, 25.4);
        QVERIFY(std::abs(model->volume() / 190544.5 - 1.0) < 1e-5); // README
        QVERIFY(apart(model->box().size(), {127.0, 63.5, 34.925}) < 1e-3);
    }

    void looseTrianglesAreNoSolid() {
        const Result<Model> model = import(modelFile("soup.stl"));
        QVERIFY(!model);
        QVERIFY(model.error().code == ErrorCode::modelHasNoSolid);
        QCOMPARE(model.error().place, std::string("100 triangles with 300 open edges"));
    }
};

BURIN_TEST(Models, QCoreApplication)

} // namespace burin::tst_models

#include "tst_models.moc"

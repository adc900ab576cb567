// SPDX-FileCopyrightText: 2026 The Burin authors
// SPDX-License-Identifier: Apache-2.0
#include "core/base/file.h"
#include "core/base/units.h"
#include "core/setup/material_change.h"
#include "core/setup/setup.h"
#include "tests/core/volume/shapes.h"
#include "tests/test_program.h"

#include <QCoreApplication>
#include <QTemporaryDir>
#include <QtTest>

namespace burin::tst_embedding {

using namespace burin::test;

namespace {

Body body(const std::string& name, TriangleMesh mesh) {
    Body result;
    result.name = name;
    result.box = boundingBox(mesh);
    result.volume = signedVolume(mesh);
    result.openEdges = countOpenEdges(mesh);
    result.mesh = std::move(mesh);
    return result;
}

Model model(std::vector<Body> bodies) {
    Model result;
    result.sourceFile = "part.step";
    result.bodies = std::move(bodies);
    return result;
}

Setup withVoxel(double voxel, double margin) {
    Setup setup;
    setup.voxel = voxel;
    setup.marginLow = setup.marginHigh = glm::dvec3(margin);
    setup.stockMaterial = "test-wax";
    return setup;
}

Result<EmbeddedSetup> embedIn(const Model& part, const Setup& setup) {
    Progress progress;
    return embed(part, setup, {}, progress);
}

} // namespace

class TestEmbedding : public QObject {
    Q_OBJECT

    QTemporaryDir folder_;

private slots:
    void initTestCase() {
        QVERIFY(folder_.isValid());
        QVERIFY(QDir(folder_.path()).mkpath("burin/materials"));
        qputenv("XDG_DATA_HOME", folder_.path().toUtf8());
        for (const char* id : {"test-wax", "test-metal"}) {
            Property material;
            material.id = material.name = id;
            material.values[std::string(specificCuttingEnergy)] = {1.0, "J/mm^3", "a test", true};
            QVERIFY(writeFileAtomically((folder_.path() + "/burin/materials/" + id + ".json").toStdString(),
                                        toJson(material)));
        }
    }

    void stockIsThePartsBoxWithItsMargins() {
        Setup wanted = withVoxel(0.5, 2.0);
        wanted.marginHigh = {1, 2, 3};
        const auto setup = placeStock(model({body("Block", boxMesh({0, 10, -5}, {20, 30, 5}))}), wanted);
        QVERIFY(setup);
        QVERIFY(setup->stock.low == glm::dvec3(-2, 8, -7));
        QVERIFY(setup->stock.high == glm::dvec3(21, 32, 8));
        QVERIFY(setup->workOffset == glm::dvec3(9.5, 20, 8));
    }

    void aBoxOnVoxelFacesIsEmbeddedExactly() {
        const Model part = model({body("Block", boxMesh({0, 0, 0}, {20, 10, 7.25}))});
        const Setup setup = *placeStock(part, withVoxel(0.5, 2.0));
        const auto embedded = embedIn(part, setup);
        QVERIFY(embedded);
        QCOMPARE(embedded->partVolume, 20 * 10 * 7.25);
        QCOMPARE(embedded->stockVolume, 24 * 14 * 11.25 - 20 * 10 * 7.25);
        const RunVolume& volume = embedded->workpiece;
        QCOMPARE(volume.grid().voxelsPerLine(), 23); // 11.25 mm are 22.5 voxels
        QCOMPARE(volume.amounts().units[airProperty], std::uint64_t{48 * 28 * 128});
        const Property& protectedPart = volume.properties()[embedded->bodyProperties.at(0)];
        QCOMPARE(protectedPart.id, std::string("test-wax (Block)"));
        QVERIFY(volume.properties().isProtected(embedded->bodyProperties[0]));
        QVERIFY(!volume.properties().isProtected(embedded->stockProperty));
        QVERIFY(embedded->findings.empty());
        // Stock, part, stock, overhang: their ends in mm.
        const auto line = volume.line({24, 14});
        std::vector<double> ends;
        for (const Segment segment : line) ends.push_back(volume.grid().toMillimetres(segment.end()));
        QVERIFY((ends == std::vector<double>{0.0, 7.25, 9.25, 9.5}));
    }

    void aSphereKeepsItsVolume() {
        const Model part = model({body("Ball", sphereMesh({3, 4, 5}, 10.0, 200))});
        const auto embedded = embedIn(part, *placeStock(part, withVoxel(0.5, 1.3)));
        QVERIFY(embedded);
        const double exact = 4.0 / 3.0 * pi * 1000.0;
        QVERIFY(std::abs(embedded->partVolume - exact) < 0.002 * exact);
        const double box = 22.6 * 22.6 * 22.6;
        QVERIFY(std::abs(embedded->partVolume + embedded->stockVolume - box) < 0.01 * box);
    }

    void bodiesHaveMaterialsOfTheirOwnAndTheLaterWins() {
        const Model part =
            model({body("Foot", boxMesh({0, 0, 0}, {10, 10, 4})), body("Foot", boxMesh({0, 0, 2}, {10, 10, 8}))});
        Setup setup = *placeStock(part, withVoxel(1.0, 1.0));
        setup.bodyMaterials = {"", "test-metal"};
        const auto embedded = embedIn(part, setup);
        QVERIFY(embedded);
        const RunAmounts& amounts = embedded->workpiece.amounts();
        QCOMPARE(amounts.units[embedded->bodyProperties[0]], std::uint64_t{200 * 256});
        QCOMPARE(amounts.units[embedded->bodyProperties[1]], std::uint64_t{600 * 256});
        QCOMPARE(embedded->workpiece.properties()[embedded->bodyProperties[1]].id, std::string("test-metal (Foot)"));
        QCOMPARE(embedded->findings.size(), std::size_t{1});
        QVERIFY(embedded->findings[0].kind == EmbeddingFinding::Kind::overlappingBodies);
        QCOMPARE(embedded->findings[0].volume, 200.0);
    }

    void bodiesOfOneNameAndMaterialAreToldApart() {
        const Model part =
            model({body("Pin", boxMesh({0, 0, 0}, {2, 2, 2})), body("Pin", boxMesh({4, 0, 0}, {6, 2, 2}))});
        const auto embedded = embedIn(part, *placeStock(part, withVoxel(1.0, 1.0)));
        QVERIFY(embedded);
        QCOMPARE(embedded->workpiece.properties()[embedded->bodyProperties[1]].id, std::string("test-wax (Pin) 2"));
        QVERIFY(embedded->findings.empty());
    }

    void anOpenBodyIsFilledWithAFindingThatNamesItAndThePlace() {
        TriangleMesh open = boxMesh({0, 0, 0}, {10, 10, 10});
        open.triangles.erase(open.triangles.begin() + 2, open.triangles.begin() + 4); // the top
        const Model part = model({body("Sound", boxMesh({20, 0, 0}, {30, 10, 10})), body("Torn", open)});
        for (const RunAxis axis : {RunAxis::x, RunAxis::y, RunAxis::z}) {
            Setup setup = *placeStock(part, withVoxel(0.5, 1.0));
            setup.runs = axis;
            const auto embedded = embedIn(part, setup);
            QVERIFY(embedded);
            QCOMPARE(embedded->partVolume, 2000.0);
            QCOMPARE(embedded->findings.size(), std::size_t{1});
            const EmbeddingFinding& finding = embedded->findings[0];
            QCOMPARE(finding.body, std::string("Torn"));
            QCOMPARE(finding.openEdges, std::size_t{4});
            QCOMPARE(finding.rims, std::size_t{1});
            // Lines along x and y miss the opening.
            QVERIFY(finding.kind ==
                    (axis == RunAxis::z ? EmbeddingFinding::Kind::openSurface : EmbeddingFinding::Kind::unseenOpening));
            if (axis != RunAxis::z) continue;
            QCOMPARE(finding.count, std::size_t{400}); // all lines of the body
            QVERIFY(finding.place.low == glm::dvec3(0.0) && finding.place.high == glm::dvec3(10.0));
        }
    }

    /// Each kind of fault, in a body of its own, is reported once, for that body and no other.
    void everyDoubtIsTold() {
        using Kind = EmbeddingFinding::Kind;
        TriangleMesh slit = boxMesh({0, 0, 0}, {4, 4, 4}); // open between two scanlines, 1.5 and 2.5 mm
        slit.triangles.push_back({0, 1, static_cast<std::uint32_t>(slit.vertices.size())});
        slit.vertices.emplace_back(2.0, 1e-3, -1.0);
        TriangleMesh turned = boxMesh({10, 0, 0}, {14, 4, 4});
        std::swap(turned.triangles[2][0], turned.triangles[2][1]);
        TriangleMesh inwards = boxMesh({20, 0, 0}, {24, 4, 4});
        append(inwards, boxMesh({25, 0, 0}, {26, 4, 4}));
        for (std::size_t i = 12; i < 24; ++i) std::swap(inwards.triangles[i][0], inwards.triangles[i][1]);
        TriangleMesh shells = boxMesh({30, 0, 0}, {34, 4, 4});
        append(shells, boxMesh({32, 2, 2}, {36, 4, 4}));
        TriangleMesh twice = boxMesh({40, 0, 0}, {44, 4, 4});
        twice.triangles.push_back(twice.triangles[0]);
        const Model part =
            model({body("slit", slit), body("turned", turned), body("inwards", inwards), body("shells", shells),
                   body("twice", twice), body("tiny", boxMesh({50.1, 0.1, 0.1}, {50.2, 0.2, 0.2})),
                   body("sound", boxMesh({60, 0, 0}, {64, 4, 4}))});
        const auto embedded = embedIn(part, *placeStock(part, withVoxel(1.0, 1.0)));
        QVERIFY(embedded);
        std::vector<std::pair<std::string, Kind>> told;
        for (const EmbeddingFinding& finding : embedded->findings) told.emplace_back(finding.body, finding.kind);
        const std::vector<std::pair<std::string, Kind>> wanted{
            {"slit", Kind::unseenOpening},       {"turned", Kind::turnedFaces},       {"inwards", Kind::insideOut},
            {"shells", Kind::overlappingShells}, {"twice", Kind::duplicateTriangles}, {"tiny", Kind::tooSmall}};
        for (const auto& [name, kind] : told) qInfo("%s: %d", name.c_str(), static_cast<int>(kind));
        QVERIFY(told == wanted);
    }

    void everyRunAxisKeepsStockAndPart() {
        const Model part = model({body("Block", boxMesh({0, 0, 0}, {20, 10, 7.25}))});
        for (const RunAxis axis : {RunAxis::x, RunAxis::y}) {
            Setup setup = *placeStock(part, withVoxel(0.5, 2.25));
            setup.runs = axis;
            const auto embedded = embedIn(part, setup);
            QVERIFY(embedded);
            QVERIFY(embedded->workpiece.grid().axis() == axis);
            // Perpendicular to the runs a face is moved to the nearest voxel face: 7.25 mm from 2.25 mm are 4.5 to 19
            // voxels, whose lower end is a tie.
            QVERIFY(std::abs(embedded->partVolume - 20 * 10 * 7.25) <= 20 * 10 * 0.25);
            QVERIFY(std::abs(embedded->partVolume + embedded->stockVolume - 24.5 * 14.5 * 11.75) <= 24.5 * 14.5 * 0.25);
        }
    }

    void aPartBeyondItsStockIsAnError() {
        const Model part = model({body("Block", boxMesh({0, 0, 0}, {10, 10, 10}))});
        Setup setup = *placeStock(part, withVoxel(0.5, 1.0));
        setup.stock.high.z = 9.0;
        const auto embedded = embedIn(part, setup);
        QVERIFY(!embedded);
        QVERIFY(embedded.error().code == ErrorCode::partOutsideStock);
        QCOMPARE(embedded.error().place, std::string("1.000 mm"));
    }

    void wrongSetupsAreErrors_data() {
        QTest::addColumn<double>("voxel");
        QTest::addColumn<double>("margin");
        QTest::newRow("no voxel") << 0.0 << 1.0;
        QTest::newRow("voxel below 0") << -0.5 << 1.0;
        QTest::newRow("voxel not a number") << std::nan("") << 1.0;
        QTest::newRow("margin below 0") << 0.5 << -1.0;
        QTest::newRow("margin without end") << 0.5 << HUGE_VAL;
    }
    void wrongSetupsAreErrors() {
        QFETCH(double, voxel);
        QFETCH(double, margin);
        const auto setup = placeStock(model({body("Block", boxMesh({0, 0, 0}, {1, 1, 1}))}), withVoxel(voxel, margin));
        QVERIFY(!setup && setup.error().code == ErrorCode::stockInvalid);
    }

    void gridsThatAreTooLargeAreRefusedBeforeTheyAreMade() {
        const Model part = model({body("Block", boxMesh({0, 0, 0}, {300, 300, 30}))});
        const auto axis = embedIn(part, *placeStock(part, withVoxel(0.001, 1.0)));
        QVERIFY(!axis && axis.error().code == ErrorCode::volumeTooLarge);
        QCOMPARE(axis.error().subject, std::string("302000 voxels on one axis"));
        const auto memory = embeddingSize(*placeStock(part, withVoxel(0.0095, 1.0)));
        if (memory) QSKIP("this machine has room for the largest grid");
        QVERIFY(memory.error().code == ErrorCode::volumeTooLarge);
        QVERIFY(memory.error().place.ends_with(" MB"));
    }

    void anUnknownMaterialNamesThoseThatExist() {
        const Model part = model({body("Block", boxMesh({0, 0, 0}, {1, 1, 1}))});
        Setup setup = *placeStock(part, withVoxel(0.5, 1.0));
        setup.stockMaterial = "unobtainium";
        const auto embedded = embedIn(part, setup);
        QVERIFY(!embedded && embedded.error().code == ErrorCode::nameUnknown);
        QCOMPARE(embedded.error().place, std::string("unobtainium"));
        QVERIFY(embedded.error().detail.find("test-metal, test-wax") != std::string::npos);
    }

    void cancellingEndsEmbedding() {
        const Model part = model({body("Block", boxMesh({0, 0, 0}, {10, 10, 10}))});
        Progress progress;
        progress.cancel();
        const auto embedded = embed(part, *placeStock(part, withVoxel(0.5, 1.0)), {}, progress);
        QVERIFY(!embedded && embedded.error().code == ErrorCode::cancelled);
    }

    /// The same as embedding again, but with the cuts made so far.
    void anotherMaterialKeepsTheWorkpiece() {
        const Model part = model({body("block", boxMesh({0, 0, 0}, {10, 8, 6}))});
        Setup wax = withVoxel(0.5, 2.0);
        wax = *placeStock(part, wax);
        Result<EmbeddedSetup> embedded = embedIn(part, wax);
        QVERIFY(embedded);
        Setup metal = wax;
        metal.stockMaterial = "test-metal";
        Result<EmbeddedSetup> anew = embedIn(part, metal);
        QVERIFY(anew);
        for (EmbeddedSetup* each : {&*embedded, &*anew}) {
            RunAmounts removed;
            QCOMPARE(each->workpiece.removeSpan({9, 7}, 0, 2000, removed), Removal::removed);
        }
        const Result<EmbeddedSetup> changed = withMaterials(*embedded, part, metal, {});
        QVERIFY(changed);
        QCOMPARE(changed->stockProperty, anew->stockProperty);
        QCOMPARE(changed->bodyProperties, anew->bodyProperties);
        QCOMPARE(changed->partVolume, anew->partVolume);
        QCOMPARE(changed->stockVolume, anew->stockVolume);
        const PropertyList &list = changed->workpiece.properties(), &expected = anew->workpiece.properties();
        QCOMPARE(list.size(), expected.size());
        for (int i = 0; i < list.size(); ++i)
            QCOMPARE(list[static_cast<PropertyIndex>(i)].id, expected[static_cast<PropertyIndex>(i)].id);
        QCOMPARE(list[changed->stockProperty].id, std::string("test-metal"));
        QCOMPARE(changed->workpiece.amounts(), anew->workpiece.amounts());
        const Grid& grid = changed->workpiece.grid();
        for (LineIndex line; line.v < grid.lineCountV(); ++line.v)
            for (line.u = 0; line.u < grid.lineCountU(); ++line.u)
                QVERIFY(std::ranges::equal(changed->workpiece.line(line), anew->workpiece.line(line)));

        metal.stockMaterial = "no-such-thing";
        const Result<EmbeddedSetup> unknown = withMaterials(*embedded, part, metal, {});
        QVERIFY(!unknown);
        QCOMPARE(unknown.error().code, ErrorCode::nameUnknown);
    }
};

BURIN_TEST(TestEmbedding, QCoreApplication)

} // namespace burin::tst_embedding

#include "tst_embedding.moc"

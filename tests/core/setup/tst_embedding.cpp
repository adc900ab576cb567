// SPDX-FileCopyrightText: 2026 The Burin authors
// SPDX-License-Identifier: Apache-2.0
#include "core/base/file.h"
#include "core/base/units.h"
#include "core/setup/setup.h"
#include "tests/core/volume/shapes.h"

#include <QTemporaryDir>
#include <QtTest>

using namespace burin;
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
        QVERIFY(embedded->warnings.empty());
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
        QCOMPARE(embedded->warnings.size(), std::size_t{1});
        QVERIFY(embedded->warnings[0].find("200.000 mm³") != std::string::npos);
    }

    void bodiesOfOneNameAndMaterialAreToldApart() {
        const Model part =
            model({body("Pin", boxMesh({0, 0, 0}, {2, 2, 2})), body("Pin", boxMesh({4, 0, 0}, {6, 2, 2}))});
        const auto embedded = embedIn(part, *placeStock(part, withVoxel(1.0, 1.0)));
        QVERIFY(embedded);
        QCOMPARE(embedded->workpiece.properties()[embedded->bodyProperties[1]].id, std::string("test-wax (Pin) 2"));
        QVERIFY(embedded->warnings.empty());
    }

    void anOpenBodyIsFilledWithAWarningThatNamesItAndThePlace() {
        TriangleMesh open = boxMesh({0, 0, 0}, {10, 10, 10});
        open.triangles.erase(open.triangles.begin() + 2, open.triangles.begin() + 4); // the top
        const Model part = model({body("Sound", boxMesh({20, 0, 0}, {30, 10, 10})), body("Torn", open)});
        for (const RunAxis axis : {RunAxis::x, RunAxis::y, RunAxis::z}) {
            Setup setup = *placeStock(part, withVoxel(0.5, 1.0));
            setup.runs = axis;
            const auto embedded = embedIn(part, setup);
            QVERIFY(embedded);
            QCOMPARE(embedded->partVolume, 2000.0);
            QCOMPARE(embedded->warnings.size(), std::size_t{1});
            const std::string& warning = embedded->warnings[0];
            QVERIFY(warning.starts_with("Torn: the surface is open at 4 edges (1 rim)"));
            if (axis == RunAxis::z)
                QVERIFY(warning.ends_with(" a guess, between (0.000, 0.000, 0.000) and (10.000, 10.000, 10.000) mm"));
        }
    }

    void everyRunAxisKeepsStockAndPart() {
        const Model part = model({body("Block", boxMesh({0, 0, 0}, {20, 10, 7.25}))});
        for (const RunAxis axis : {RunAxis::x, RunAxis::y}) {
            Setup setup = *placeStock(part, withVoxel(0.5, 2.25));
            setup.runs = axis;
            const auto embedded = embedIn(part, setup);
            QVERIFY(embedded);
            QVERIFY(embedded->workpiece.grid().axis() == axis);
            // Across the runs a face lies on the voxel face that is nearest to it: 7.25 mm from 2.25 mm are 4.5 to 19
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
};

QTEST_GUILESS_MAIN(TestEmbedding)
#include "tst_embedding.moc"

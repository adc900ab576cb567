// SPDX-FileCopyrightText: 2026 The Burin authors
// SPDX-License-Identifier: Apache-2.0
#include "core/setup/formula.h"
#include "core/setup/material_region.h"
#include "tests/core/setup/stock_bodies.h"
#include "tests/test_program.h"

#include <QCoreApplication>
#include <QtTest>

#include <cmath>

namespace burin::tst_material_regions {

using namespace burin::test;

namespace {

MaterialRegion layer(const std::string& name, const std::string& material, int axis, double from, double to) {
    MaterialRegion region;
    region.name = name;
    region.material = material;
    region.axis = axis;
    region.from = from;
    region.to = to;
    return region;
}

MaterialRegion graded(MaterialRegion region, const std::string& formula, int bands) {
    region.grade.emplace();
    region.grade->formula = formula;
    region.grade->entries = bands;
    return region;
}

Model block() {
    return modelOf({bodyOf("Block", boxMesh({0, 0, 0}, {10, 8, 4}))});
}

/// From 0 to 20, 16, 12 mm.
Setup stockOf(std::vector<MaterialRegion> regions, RunAxis runs = RunAxis::z) {
    Setup setup = setupOf(0.5, 0.0);
    setup.stated = true;
    setup.stock = {glm::dvec3(0.0), {20, 16, 12}};
    setup.regions = std::move(regions);
    setup.runs = runs;
    return setup;
}

/// The specific cutting energy of the material at a point.
double energyAt(const RunVolume& volume, const glm::dvec3& place) {
    const std::string id = materialAt(volume, place);
    for (int i = 1; i < volume.properties().size(); ++i)
        if (const Property& property = volume.properties()[static_cast<PropertyIndex>(i)]; property.id == id)
            return property.valueOr(specificCuttingEnergy, 0.0);
    return 0.0;
}

} // namespace

class TestMaterialRegions : public QObject {
    Q_OBJECT

private slots:
    void formulasAreReadAsTheyAreWritten() {
        for (const auto& [text, value] :
             {std::pair("0.4 + 0.02 * Z", 0.46), std::pair("x^2 - Y", -1.0),
              std::pair("sqrt(X*X + Y*Y + Z*Z)", std::sqrt(14.0)), std::pair("X < Y ? 5 : 6", 5.0)})
            QCOMPARE(Formula::parse(text)->at({1.0, 2.0, 3.0}), value);
        for (const char* text : {"", "  ", "1 +", "W", "sin(", "2 2", "X = 3 Y"}) QVERIFY2(!Formula::parse(text), text);
        QVERIFY(!Formula::parse(std::string(Formula::longest + 1, '1')));
        QVERIFY(!std::isfinite(Formula::parse("1 / (Z - 3)")->at({1.0, 2.0, 3.0})));
        QVERIFY(!std::isfinite(Formula::parse("sqrt(-X)")->at({1.0, 2.0, 3.0})));
    }

    void layersLieBetweenTheirPlanes_data() {
        QTest::addColumn<int>("runs");
        QTest::newRow("runs along x") << 0;
        QTest::newRow("runs along y") << 1;
        QTest::newRow("runs along z") << 2;
    }
    void layersLieBetweenTheirPlanes() {
        QFETCH(int, runs);
        const Setup setup = stockOf({layer("Bottom", "beech", 2, -1e9, 6.0), layer("Side", "foam", 0, 15.0, 17.5)},
                                    static_cast<RunAxis>(runs));
        const auto made = embedded(block(), setup);
        QVERIFY(made);
        const RunVolume& workpiece = made->workpiece;
        QCOMPARE(volumeOf(workpiece, "foam"), 2.5 * 16.0 * 12.0); // the later region takes precedence
        QCOMPARE(volumeOf(workpiece, "beech"), 17.5 * 16.0 * 6.0 - 10.0 * 8.0 * 4.0);
        QCOMPARE(volumeOf(workpiece, "metal"), 17.5 * 16.0 * 6.0);
        QCOMPARE(volumeOf(workpiece, "metal (Block)"), 320.0);
        QCOMPARE(materialAt(workpiece, {16.2, 3.2, 3.2}), std::string("foam"));
        QCOMPARE(made->stockVolume, 20.0 * 16.0 * 12.0 - 320.0);
    }

    /// Along the runs a plane is exact to 1/256 voxel.
    void aPlaneWithinAVoxelIsKept() {
        const auto made = embedded(block(), stockOf({layer("Top", "beech", 2, 9.3, 1e9)}));
        QVERIFY(made);
        QVERIFY(std::abs(volumeOf(made->workpiece, "beech") - 2.7 * 20.0 * 16.0) <= 20.0 * 16.0 * 0.5 / 256.0);
    }

    void insertsHaveThePlaceBeforeLayers() {
        const Model model = modelOf({block().bodies[0], bodyOf("Pin", boxMesh({12, 4, 2}, {14, 6, 10}))});
        Setup setup = stockOf({layer("Bottom", "beech", 2, 0.0, 6.0)});
        setup.roles = {BodyRole::part, BodyRole::insert};
        setup.bodyMaterials = {"", "brass"};
        const auto made = embedded(model, setup);
        QVERIFY(made);
        QCOMPARE(volumeOf(made->workpiece, "brass"), 32.0);
        QCOMPARE(volumeOf(made->workpiece, "beech"), 20.0 * 16.0 * 6.0 - 320.0 - 16.0);
    }

    void gradedPlacesAreWithinTheStatedError_data() {
        QTest::addColumn<QString>("formula");
        QTest::addColumn<int>("bands");
        QTest::newRow("along the runs") << "0.1 + 0.02 * Z" << 8;
        QTest::newRow("across them") << "0.1 + 0.01 * X" << 5;
        QTest::newRow("all three") << "0.05 + 0.001 * (X * Y + Z ^ 2)" << 12;
        QTest::newRow("round") << "0.02 + 0.004 * sqrt((X - 10) ^ 2 + (Y - 8) ^ 2)" << 24;
        QTest::newRow("one band") << "1 + X" << 1;
    }
    void gradedPlacesAreWithinTheStatedError() {
        QFETCH(QString, formula);
        QFETCH(int, bands);
        const MaterialRegion region = graded(layer("Graded", "foam", 2, 5.0, 12.0), formula.toStdString(), bands);
        const auto made = embedded(block(), stockOf({region}));
        QVERIFY(made);
        QCOMPARE(made->gradings.size(), std::size_t{1});
        const RegionGrading& grading = made->gradings[0];
        QCOMPARE(grading.bands, bands);
        QVERIFY(std::abs(grading.error - 0.5 * (grading.high - grading.low) / bands) < 1e-12);
        const Formula exact = *Formula::parse(formula.toStdString());
        double worst = 0.0;
        for (double z = 5.001; z < 12.0; z += 0.37)
            for (int y = 0; y < 32; ++y)
                for (int x = 0; x < 40; ++x) { // on the scanlines' centres
                    const glm::dvec3 place(0.5 * x + 0.25, 0.5 * y + 0.25, z);
                    worst = std::max(worst, std::abs(energyAt(made->workpiece, place) - exact.at(place)));
                }
        QVERIFY2(worst <= grading.error * 1.001 + (grading.high - grading.low) * 1e-3,
                 qPrintable(QString::number(worst / grading.error)));
        QVERIFY(worst > 0.5 * grading.error);
    }

    void tablesAreGradedEvenlyBetweenTheirLines() {
        MaterialRegion region = layer("Skin", "foam", 1, 4.0, 16.0);
        region.grade.emplace();
        region.grade->axis = 1;
        region.grade->table = {{4.0, 0.2}, {8.0, 0.4}, {16.0, 0.1}};
        region.grade->entries = 10;
        const auto made = embedded(block(), stockOf({region}));
        QVERIFY(made);
        QCOMPARE(made->gradings[0].low, 0.1);
        QCOMPARE(made->gradings[0].high, 0.4);
        for (int y = 8; y < 32; ++y) {
            const double at = 0.5 * y + 0.25;
            const double exact = at <= 8.0 ? 0.2 + 0.05 * (at - 4.0) : 0.4 - 0.0375 * (at - 8.0);
            QVERIFY(std::abs(energyAt(made->workpiece, {15.0, at, 10.0}) - exact) <= made->gradings[0].error + 1e-9);
        }
    }

    void whatIsWrongWithALayerIsSaid_data() {
        QTest::addColumn<std::vector<MaterialRegion>>("regions");
        QTest::addColumn<QString>("what");
        using Regions = std::vector<MaterialRegion>;
        const MaterialRegion sound = layer("A", "foam", 2, 2.0, 8.0);
        QTest::newRow("planes the wrong way") << Regions{layer("A", "foam", 2, 8.0, 2.0)} << "8 to 2 mm";
        QTest::newRow("twice one name") << Regions{sound, sound} << "name";
        QTest::newRow("division by zero") << Regions{graded(sound, "1 / (Z - 4)", 8)} << "1 / (Z - 4)";
        QTest::newRow("no number") << Regions{graded(sound, "1 + log(X - 3)", 8)} << "1 + log(X - 3)";
        QTest::newRow("no formula") << Regions{graded(sound, "1 +", 8)} << "1 +";
        QTest::newRow("a constant") << Regions{graded(sound, "0.3", 8)} << "0.3";
        QTest::newRow("negative energy") << Regions{graded(sound, "Z - 5", 8)} << "-3";
        QTest::newRow("too many bands") << Regions{graded(sound, "Z", maximumGrades + 1)} << "25 bands";
        MaterialRegion unknown = graded(sound, "Z", 4);
        unknown.grade->value = "colour";
        QTest::newRow("no such value") << Regions{unknown} << "colour";
        MaterialRegion falling = sound;
        falling.grade.emplace();
        falling.grade->table = {{4.0, 1.0}, {3.0, 2.0}};
        QTest::newRow("a table that falls back") << Regions{falling} << "table at 3 mm";
    }
    void whatIsWrongWithALayerIsSaid() {
        QFETCH(std::vector<MaterialRegion>, regions);
        QFETCH(QString, what);
        const auto refused = embedded(block(), stockOf(regions));
        QVERIFY(!refused);
        QCOMPARE(refused.error().code, ErrorCode::argumentInvalid);
        QCOMPARE(QString::fromStdString(refused.error().place), what);
    }

    void aDivisionByZeroIsToldWithItsPlace() {
        const auto refused = embedded(block(), stockOf({graded(layer("A", "foam", 2, 2.0, 8.0), "1 / (Z - 4)", 8)}));
        QVERIFY(refused.error().detail.find("Z4 mm") != std::string::npos);
    }

    /// A recorded sample has room for 8 machinable materials.
    void tooManyMaterialsAreRefused() {
        std::vector<MaterialRegion> regions;
        for (int i = 0; i < 8; ++i)
            regions.push_back(graded(layer("L" + std::to_string(i), "foam", 2, i, i + 1.0), "1 + Z", 2));
        const auto refused = embedded(block(), stockOf(regions));
        QVERIFY(!refused && refused.error().code == ErrorCode::argumentInvalid);
    }

    void volumesAndMassesAddUp() {
        const Setup setup =
            stockOf({layer("Bottom", "beech", 2, 0.0, 6.0), graded(layer("Top", "foam", 2, 6.0, 12.0), "1 + Z", 6)});
        const auto made = embedded(block(), setup);
        QVERIFY(made);
        const std::vector<MaterialAmount> amounts = materialAmounts(*made);
        double volume = 0.0;
        for (const MaterialAmount& amount : amounts) {
            volume += amount.volume;
            QVERIFY(amount.mass);
            if (amount.id == "beech") QCOMPARE(*amount.mass, (20.0 * 16.0 * 6.0 - 320.0) * 0.7e-3);
            if (amount.id == "foam (Top)") {
                QCOMPARE(amount.volume, 20.0 * 16.0 * 6.0);
                QVERIFY(std::abs(*amount.mass - 0.192) < 1e-9);
            }
        }
        QVERIFY(std::abs(volume - 20.0 * 16.0 * 12.0) < 1e-6);
        QCOMPARE(amounts.size(), std::size_t{4});
    }
};

BURIN_TEST(TestMaterialRegions, QCoreApplication)

} // namespace burin::tst_material_regions

#include "tst_material_regions.moc"

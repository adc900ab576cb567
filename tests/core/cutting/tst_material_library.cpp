// SPDX-FileCopyrightText: 2026 The Burin authors
// SPDX-License-Identifier: Apache-2.0
#include "core/cutting/material_library.h"

#include "core/cutting/cutting_force.h"
#include "core/tool/tool.h"
#include "tests/test_program.h"

#include <QCoreApplication>
#include <QTemporaryDir>
#include <QtTest>

#include <cmath>
#include <set>

namespace burin::tst_material_library {

namespace {

Property wax() {
    return loadMaterial("machinable-wax").value();
}

} // namespace

class TestMaterialLibrary : public QObject {
    Q_OBJECT

    QTemporaryDir folder_;

private slots:
    void initTestCase() {
        QVERIFY(folder_.isValid());
        qputenv("XDG_DATA_HOME", folder_.path().toUtf8());
    }

    /// The materials promised by the issue and README.
    void theStarterLibraryHoldsWhatIsPromised() {
        const std::vector<std::string> ids = materialIds();
        for (const char* id : {"aluminium-2007", "aluminium-6061", "aluminium-7075", "steel-s235jr", "steel-1045",
                               "stainless-304", "titanium-6al4v", "brass-cuzn39pb3", "machinable-wax", "abs", "pom",
                               "acrylic", "mdf", "beech", "oak", "tooling-board", "pu-foam"})
            QVERIFY2(std::ranges::find(ids, id) != ids.end(), id);
    }

    /// A file that could not be read again would lose the material.
    void whatCouldNotBeReadAgainIsNotWritten() {
        Property material = copyOf(loadMaterial("oak").value(), "our-oak", "Our oak");
        QVERIFY(saveMaterial(material, false));
        Property damaged = material;
        damaged.values["hardness"] = {30.0, "N/mm^2", "", true}; // no source
        const auto refused = saveMaterial(damaged, true);
        QVERIFY(!refused);
        QCOMPARE(refused.error().place, std::string("values.hardness.source"));
        QVERIFY(toJson(loadMaterial("our-oak").value()) == toJson(material));
        QVERIFY(removeMaterial("our-oak"));
    }

    void everyNumberHasItsSource_data() {
        QTest::addColumn<QString>("id");
        for (const std::string& id : materialIds()) QTest::newRow(id.c_str()) << QString::fromStdString(id);
    }
    void everyNumberHasItsSource() {
        QFETCH(QString, id);
        const Property material = loadMaterial(id.toStdString()).value();
        QVERIFY(checkMaterial(material, material.id));
        QVERIFY(material.values.contains(density));
        for (const auto& [name, value] : material.values) {
            QVERIFY2(value.source.size() >= 15, name.c_str());
            QVERIFY2(value.value > 0.0, name.c_str());
        }
    }

    /// Where a material states both, K is the value of Kienzle's law at some chip thickness from 0.02 to 0.3 mm.
    void energyAndKienzleAgree_data() { everyNumberHasItsSource_data(); }
    void energyAndKienzleAgree() {
        QFETCH(QString, id);
        const Property material = loadMaterial(id.toStdString()).value();
        if (!material.values.contains(kienzleForce)) return;
        const auto law = [&](double chip) {
            return material.valueOr(kienzleForce, 0.0) * std::pow(chip, -material.valueOr(kienzleExponent, 0.0)) /
                   1000.0;
        };
        const double energy = material.valueOr(specificCuttingEnergy, 0.0);
        QVERIFY2(energy <= 1.01 * law(0.02) && energy >= 0.75 * law(0.3), qPrintable(QString::number(energy)));
    }

    /// An order that is generally accepted in workshops.
    void harderToCutComesBehind() {
        double before = 0.0;
        for (const char* id :
             {"pu-foam", "machinable-wax", "beech", "aluminium-6061", "steel-s235jr", "steel-1045", "stainless-304"}) {
            const double energy = loadMaterial(id)->valueOr(specificCuttingEnergy, 0.0);
            QVERIFY2(energy > before, id);
            before = energy;
        }
        before = 1e9;
        for (const char* id : {"beech", "aluminium-6061", "steel-s235jr", "stainless-304", "titanium-6al4v"}) {
            const double speed = loadMaterial(id)->valueOr(surfaceSpeed, 0.0);
            QVERIFY2(speed < before, id);
            before = speed;
        }
    }

    void aCopyIsOnesOwn() {
        const Property copy = copyOf(wax(), "my-wax", "My wax");
        const auto file = saveMaterial(copy, false);
        QVERIFY(file);
        QVERIFY(QString::fromStdString(file->string()).startsWith(folder_.path()));
        const Property again = loadMaterial("my-wax").value();
        QCOMPARE(again.name, std::string("My wax"));
        QVERIFY(again.values.at(std::string(density)).source.starts_with("copy of machinable-wax: "));
        QVERIFY(!isShippedMaterial("my-wax") && isShippedMaterial("machinable-wax"));
        QCOMPARE(saveMaterial(copy, false).error().code, ErrorCode::argumentInvalid);
        QVERIFY(saveMaterial(copy, true));
        QVERIFY(removeMaterial("my-wax"));
        QCOMPARE(loadMaterial("my-wax").error().code, ErrorCode::nameUnknown);
        QCOMPARE(removeMaterial("machinable-wax").error().code, ErrorCode::argumentInvalid);
    }

    void whatCantBeMilledIsRefused_data() {
        QTest::addColumn<QString>("name");
        QTest::addColumn<double>("value");
        QTest::addColumn<QString>("unit");
        QTest::newRow("no energy") << "specific_cutting_energy" << std::nan("") << "J/mm^3";
        QTest::newRow("energy of nothing") << "specific_cutting_energy" << 0.0 << "J/mm^3";
        QTest::newRow("energy below nothing") << "specific_cutting_energy" << -1.0 << "J/mm^3";
        QTest::newRow("energy in another unit") << "specific_cutting_energy" << 60.0 << "MJ/m^3";
        QTest::newRow("half of Kienzle's law") << "kienzle_kc11" << 700.0 << "N/mm^2";
        QTest::newRow("no speed") << "surface_speed" << 0.0 << "m/min";
        QTest::newRow("a chip thicker than the tool") << "chip_load_per_diameter" << 1.5 << "1";
    }
    void whatCantBeMilledIsRefused() {
        QFETCH(QString, name);
        QFETCH(double, value);
        QFETCH(QString, unit);
        Property material = wax();
        material.id = "mine";
        material.values[name.toStdString()] = {value, unit.toStdString(), "a test", true};
        const auto refused = saveMaterial(material, false);
        QVERIFY(!refused);
        QCOMPARE(refused.error().code, ErrorCode::resourceInvalid);
        QVERIFY(!std::filesystem::exists(folder_.path().toStdString() + "/burin/materials/mine.json"));
    }

    void withoutForceNothingIsFelt() {
        Property material = wax();
        material.id = "mine";
        material.values.erase(std::string(specificCuttingEnergy));
        const auto refused = saveMaterial(material, false);
        QVERIFY(!refused);
        QCOMPARE(refused.error().place, std::string("specific_cutting_energy"));
    }
};

BURIN_TEST(TestMaterialLibrary, QCoreApplication)

} // namespace burin::tst_material_library

#include "tst_material_library.moc"

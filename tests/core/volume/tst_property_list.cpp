// SPDX-FileCopyrightText: 2026 The Burin authors
// SPDX-License-Identifier: Apache-2.0
#include "core/base/file.h"
#include "core/volume/runs/grid.h"
#include "core/volume/runs/property_list.h"
#include "tests/test_program.h"

#include <QTemporaryDir>
#include <QtTest>

#include <clocale>
#include <cmath>

namespace burin::tst_property_list {

namespace {

Property metal() {
    Property property;
    property.id = "metal";
    property.name = "Metal “x”";
    property.colour = {1, 2, 255};
    property.machinability = Machinability::isProtected;
    property.values["specific_cutting_energy"] = {0.7, "J/mm^3", "Handbook, table 3", false};
    property.values["something_new"] = {-1.25e-7, "1", "nobody", true};
    return property;
}

} // namespace

class TestPropertyList : public QObject {
    Q_OBJECT

private slots:
    void airStandsFirst() {
        const PropertyList list;
        QCOMPARE(list.size(), 1);
        QCOMPARE(list[airProperty].id, std::string("air"));
        QVERIFY(!list.isProtected(airProperty));
    }

    void entriesKeepTheirProtection() {
        PropertyList list;
        Property property;
        property.id = "stock";
        const PropertyIndex stock = *list.add(property);
        const PropertyIndex body = *list.add(metal());
        QVERIFY(!list.isProtected(stock));
        QVERIFY(list.isProtected(body));
        QVERIFY(list.add(metal()).error().code == ErrorCode::argumentInvalid);
    }

    void machinableAndAllEntriesAreLimited() {
        PropertyList list;
        Property property;
        for (int i = 0; i < maximumMachinableMaterials; ++i) {
            property.id = "m" + std::to_string(i);
            QVERIFY(list.add(property));
        }
        property.id = "one more";
        QVERIFY(!list.add(property));
        property.base = "m3"; // grades of a material are recorded as the material, but a cut has to distinguish them
        for (int i = maximumMachinableMaterials; i < maximumMachinableProperties; ++i) {
            property.id = "g" + std::to_string(i);
            QVERIFY(list.add(property));
        }
        property.id = "one grade more";
        QVERIFY(!list.add(property));
        property.base.clear();
        property.machinability = Machinability::isProtected;
        for (int i = maximumMachinableProperties; i < 255; ++i) {
            property.id = "p" + std::to_string(i);
            QVERIFY(list.add(property));
        }
        QCOMPARE(list.size(), 256);
        property.id = "one too many";
        QVERIFY(!list.add(property));
    }

    void gradesKnowTheirMaterial() {
        PropertyList list;
        Property stock, grade;
        stock.id = grade.base = "stock";
        grade.id = "grade";
        QVERIFY(list.add(grade).error().code == ErrorCode::argumentInvalid); // not in the list yet
        const PropertyIndex stockEntry = *list.add(stock), gradeEntry = *list.add(grade);
        QCOMPARE(list.baseOf(gradeEntry), stockEntry);
        QCOMPARE(list.baseOf(stockEntry), stockEntry);
        QCOMPARE(list.baseOf(airProperty), airProperty);
        grade.id = "grade of a grade";
        grade.base = "grade";
        QVERIFY(!list.add(grade));
        grade.id = "other";
        grade.base = "air";
        QVERIFY(!list.add(grade));
        grade.base = "stock";
        grade.machinability = Machinability::isProtected;
        QVERIFY(!list.add(grade));
        grade.name = "Grade";
        QCOMPARE(propertyFromJson(toJson(grade), "grade.json")->base, std::string("stock"));
    }

    void aMaterialReadsBackAsItWasWritten() {
        const Property written = metal();
        const auto read = propertyFromJson(toJson(written), "metal.json");
        QVERIFY(read);
        QCOMPARE(read->id, written.id);
        QCOMPARE(read->name, written.name);
        QVERIFY(read->colour == written.colour);
        QVERIFY(read->machinability == written.machinability);
        QCOMPARE(read->values.size(), written.values.size());
        for (const auto& [name, value] : written.values) {
            const NamedValue& back = read->values.at(name);
            QVERIFY(back.value == value.value && back.unit == value.unit && back.source == value.source &&
                    back.estimate == value.estimate);
        }
        QCOMPARE(read->valueOr(specificCuttingEnergy, 3.0), 0.7);
        QCOMPARE(read->valueOr(density, 3.0), 3.0);
    }

    void numbersDoNotDependOnTheLocale() {
        if (std::setlocale(LC_ALL, "de_DE.UTF-8") == nullptr) QSKIP("no locale with a decimal comma here");
        const std::string text = toJson(metal());
        const auto read = propertyFromJson(text, "metal.json");
        std::setlocale(LC_ALL, "C");
        QVERIFY(text.find("0.7") != std::string::npos);
        QCOMPARE(read->valueOr(specificCuttingEnergy, 0.0), 0.7);
    }

    void faultsNameTheKey_data() {
        QTest::addColumn<QString>("text");
        QTest::addColumn<QString>("key");
        const QString good =
            R"({"id":"a","name":"A","colour":[1,2,3],"machinability":"machinable","values":{"k":{"value":1,"unit":"1","source":"s"}}})";
        const auto row = [&](const char* name, const char* from, const char* to, const char* key) {
            QTest::newRow(name) << QString(good).replace(from, to) << key;
        };
        row("unknown key", R"("id")", R"("weight":1,"id")", "weight");
        row("missing key", R"("name":"A",)", "", "name");
        row("wrong type", R"("name":"A")", R"("name":5)", "name");
        row("empty id", R"("id":"a")", R"("id":"")", "id");
        row("colour out of range", "[1,2,3]", "[1,2,256]", "colour[2]");
        row("colour of four", "[1,2,3]", "[1,2,3,4]", "colour");
        row("unknown machinability", R"("machinable")", R"("soft")", "machinability");
        row("number as text", R"("value":1)", R"("value":"1")", "values.k.value");
        row("unknown key of a value", R"("value":1)", R"("value":1,"error":2)", "values.k.error");
        row("value without source", R"(,"source":"s")", "", "values.k.source");
        row("value of an unknown estimate", R"("value":1)", R"("value":1,"estimate":1)", "values.k.estimate");
        row("values as a list", R"({"k":{"value":1,"unit":"1","source":"s"}})", "[]", "values");
        row("not an object at all", good.toUtf8().constData(), "[]", "");
        row("not JSON", R"("id":"a")", "x", "line 1, column 2");
    }
    void faultsNameTheKey() {
        QFETCH(QString, text);
        QFETCH(QString, key);
        const auto read = propertyFromJson(text.toStdString(), "a.json");
        QVERIFY(!read);
        QVERIFY(read.error().code == ErrorCode::resourceInvalid);
        QCOMPARE(read.error().subject, std::string("a.json"));
        QCOMPARE(QString::fromStdString(read.error().place), key);
        QVERIFY(!read.error().detail.empty());
    }

    void theUsersMaterialsAreFound() {
        const QTemporaryDir folder;
        const QString materials = folder.path() + "/burin/materials";
        QVERIFY(QDir(folder.path()).mkpath("burin/materials"));
        qputenv("XDG_DATA_HOME", folder.path().toUtf8());
        QVERIFY(writeFileAtomically((materials + "/metal.json").toStdString(), toJson(metal())));
        QVERIFY(writeFileAtomically((materials + "/renamed.json").toStdString(), toJson(metal())));
        QCOMPARE(loadMaterial("metal")->id, std::string("metal"));
        const auto ids = materialIds();
        QVERIFY(std::ranges::find(ids, "metal") != ids.end());
        QVERIFY(std::ranges::is_sorted(ids));
        QCOMPARE(loadMaterial("renamed").error().place, std::string("id"));
        QVERIFY(loadMaterial("nothing").error().code == ErrorCode::nameUnknown);
        QVERIFY(loadMaterial("../materials/metal").error().code == ErrorCode::nameUnknown);
        QVERIFY(loadMaterial("").error().code == ErrorCode::nameUnknown);
    }
};

BURIN_TEST(TestPropertyList, NoApplication)

} // namespace burin::tst_property_list

#include "tst_property_list.moc"

// SPDX-FileCopyrightText: 2026 The Burin authors
// SPDX-License-Identifier: Apache-2.0
#include "core/cutting/material_file.h"
#include "tests/test_program.h"

#include <QCoreApplication>
#include <QtTest>

#include <cmath>

namespace burin::tst_material_file {

namespace {

/// In the form that FreeCAD 1.0 writes.
const std::string yamlCard = R"card(---
General:
  UUID: "00000000-0000-4000-8000-000000000001"
  Author: "A. Miller"
  License: "CC-BY-3.0"
  Name: "Shop bronze (soft)"
  Description: >-
    Two lines
    of words: with a colon.
Models:
  Density:
    UUID: '454661e5-265b-4320-8e6f-fcf6223ac3af'
    Density: '8800 kg/m^3'
  Machinability:
    UUID: '9d81fcb2-bf81-48e3-bb57-d45ecf380096'
#a remark
    SurfaceSpeedHSS: '40 m/min'
    SurfaceSpeedCarbide: '3000 mm/s'
    UnitCuttingForce: '780 MPa'
    ChipThicknessExponent: 0.25
  Hardness:
    Hardness: "90"
    HardnessUnits: "HB"
)card";

/// In the form up to 0.20.
const std::string sectionCard = R"card(; Old bronze
; (c) nobody

[FCMat]
Name = Old bronze
Density = 8.8 g/cm^3
SurfaceSpeedHSS = 131.2335958 ft/min
Kp = 1.6 cm^3/s
)card";

double valueOf(const ReadMaterial& read, std::string_view name) {
    return read.material.valueOr(name, std::nan(""));
}

std::string replaced(std::string text, const std::string& what, const std::string& with) {
    text.replace(text.find(what), what.size(), with);
    return text;
}

} // namespace

class TestMaterialFile : public QObject {
    Q_OBJECT

private slots:
    void aCardOfTodayIsRead() {
        const auto read = materialFromText(yamlCard, "bronze.FCMat");
        QVERIFY(read);
        QCOMPARE(read->format, std::string("FreeCAD"));
        QCOMPARE(read->material.id, std::string("shop-bronze-soft"));
        QCOMPARE(read->material.name, std::string("Shop bronze (soft)"));
        QCOMPARE(valueOf(*read, surfaceSpeed), 180.0); // 3 m/s
        QCOMPARE(valueOf(*read, "surface_speed_hss"), 40.0);
        QCOMPARE(valueOf(*read, kienzleForce), 780.0);
        QCOMPARE(valueOf(*read, kienzleExponent), 0.25);
        QVERIFY(std::abs(valueOf(*read, density) - 8.8) < 1e-12);
        QCOMPARE(read->material.values.at("hardness").unit, std::string("HB"));
        // 780 / 0.05^0.25 = 1649.5 N/mm²
        QVERIFY(std::abs(valueOf(*read, specificCuttingEnergy) - 1.6495) < 1e-3);
        QVERIFY(read->material.values.at(std::string(kienzleForce)).source.find("A. Miller") != std::string::npos);
        QVERIFY(!read->material.values.at(std::string(kienzleForce)).estimate);
        // The card contains neither: default values are used and reported.
        for (const std::string_view name : {radialForceRatio, chipLoadPerDiameter, plungeFeedRatio}) {
            QVERIFY(read->material.values.at(std::string(name)).estimate);
            QVERIFY(std::ranges::any_of(read->notes,
                                        [&](const std::string& note) { return note.find(name) != std::string::npos; }));
        }
    }

    void aCardOfEarlierIsRead() {
        const auto read = materialFromText(sectionCard, "bronze.FCMat", "my-bronze");
        QVERIFY(read);
        QCOMPARE(read->material.id, std::string("my-bronze"));
        QVERIFY(std::abs(valueOf(*read, surfaceSpeed) - 40.0) < 1e-6);
        QCOMPARE(valueOf(*read, density), 8.8);
        QCOMPARE(valueOf(*read, specificCuttingEnergy), 1.6);
        QVERIFY(read->material.values.at(std::string(specificCuttingEnergy)).estimate);
    }

    void ownMaterialsComeBackAsTheyWere() {
        for (const std::string& id : materialIds()) {
            const Property material = loadMaterial(id).value();
            const auto read = materialFromText(toJson(material), id);
            QVERIFY2(read, id.c_str());
            QCOMPARE(read->format, std::string("Burin"));
            QCOMPARE(toJson(read->material), toJson(material));
            QVERIFY(read->notes.empty());
        }
    }

    void whatIsWrongIsSaidWithItsPlace_data() {
        QTest::addColumn<QString>("text");
        QTest::addColumn<int>("code");
        QTest::addColumn<QString>("place");
        const auto row = [](const char* name, const std::string& text, ErrorCode code, const char* place) {
            QTest::newRow(name) << QString::fromStdString(text) << static_cast<int>(code) << QString::fromLatin1(place);
        };
        row("nothing", "  \n", ErrorCode::fileEmpty, "");
        row("words", "milk, bread and eggs", ErrorCode::fileFormatUnknown, "");
        row("other YAML", "a: 1\nb: 2\n", ErrorCode::fileFormatUnknown, "");
        row("broken YAML", yamlCard + "\n - [ : \n", ErrorCode::resourceInvalid, "line 25");
        row("broken JSON", "{\"id\": ", ErrorCode::resourceInvalid, "");
        row("a line without =", sectionCard + "rubbish\n", ErrorCode::resourceInvalid, "line 9");
        row("no name", replaced(sectionCard, "Name = Old bronze", "Nom = Bronze"), ErrorCode::resourceInvalid, "Name");
        row("no force", replaced(sectionCard, "Kp = 1.6 cm^3/s", ""), ErrorCode::resourceInvalid,
            "specific_cutting_energy");
        row("a word for a number", replaced(yamlCard, "780 MPa", "much"), ErrorCode::resourceInvalid,
            "UnitCuttingForce");
        row("another unit", replaced(yamlCard, "780 MPa", "780 psi"), ErrorCode::resourceInvalid, "UnitCuttingForce");
        row("negative", replaced(yamlCard, "780 MPa", "-780 MPa"), ErrorCode::resourceInvalid, "kienzle_kc11");
        row("half of the law", replaced(yamlCard, "    ChipThicknessExponent: 0.25\n", ""), ErrorCode::resourceInvalid,
            "kienzle_mc");
        row("nested for ever", std::string(100'000, '['), ErrorCode::fileFormatUnknown, "");
        row("a sequence of sequences", std::string(3000, '-').replace(1, 0, " "), ErrorCode::fileFormatUnknown, "");
    }
    void whatIsWrongIsSaidWithItsPlace() {
        QFETCH(QString, text);
        QFETCH(int, code);
        QFETCH(QString, place);
        const auto refused = materialFromText(text.toStdString(), "card");
        QVERIFY(!refused);
        QCOMPARE(static_cast<int>(refused.error().code), code);
        if (!place.isEmpty()) QCOMPARE(QString::fromStdString(refused.error().place), place);
    }
};

BURIN_TEST(TestMaterialFile, QCoreApplication)

} // namespace burin::tst_material_file

#include "tst_material_file.moc"

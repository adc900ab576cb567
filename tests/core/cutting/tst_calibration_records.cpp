// SPDX-FileCopyrightText: 2026 The Burin authors
// SPDX-License-Identifier: Apache-2.0
#include "core/cutting/calibration_records.h"
#include "tests/test_program.h"

#include <QtTest>

namespace burin::tst_calibration_records {

namespace {

const std::string heading =
    "material,force_x_n,force_y_n,force_z_n,axis_x,axis_y,axis_z,feed_x,feed_y,feed_z,spindle_speed_1_min,diameter_mm,"
    "teeth,axial_depth_mm,radial_depth_mm,feed_mm_min";
const std::string good = "wax,-4.5,0.25,1,0,0,2,1,0,0,12000,6,2,1.5,3,900";

/// The row with its n-th value (from 0) replaced.
std::string with(std::size_t place, const std::string& value) {
    QStringList fields = QString::fromStdString(good).split(',');
    fields[static_cast<qsizetype>(place)] = QString::fromStdString(value);
    return fields.join(',').toStdString();
}

std::string table(const std::string& rows) {
    return heading + "\n" + rows + "\n";
}

} // namespace

class CalibrationRecordsTest : public QObject {
    Q_OBJECT
private slots:
    void aRowIsReadAsItStands() {
        const auto records =
            parseForceRecords("\xEF\xBB\xBF# bench 2\r\n" + heading + "\r\n\r\n" + good + "\r\n", "f.csv");
        QVERIFY(records.hasValue());
        QCOMPARE(records->size(), std::size_t{1});
        const ForceRecord& record = records->front();
        QCOMPARE(record.line, std::size_t{4});
        QCOMPARE(record.material, std::string("wax"));
        QVERIFY(record.force == glm::dvec3(-4.5, 0.25, 1.0));
        QVERIFY(record.axis == glm::dvec3(0.0, 0.0, 1.0));
        QVERIFY(record.feedDirection == glm::dvec3(1.0, 0.0, 0.0));
        QCOMPARE(record.teeth, 2);
        QVERIFY(record.immersion == Immersion::unknown);
        // By hand: 1.5 · 3 · 900 / 60 mm³/s; pi · 6 · 200 mm/s; 900 / 24,000 mm; half immersion is a quarter of a
        // revolution, whose mean chip is 2 / pi of the feed per tooth.
        QCOMPARE(record.removalRate(), 67.5);
        QCOMPARE(record.toolEdgeSpeed(), 3.14159265358979323846 * 1200.0);
        QCOMPARE(record.feedPerTooth(), 0.0375);
        QCOMPARE(record.meanChipThickness(), 0.0375 * 2.0 / 3.14159265358979323846);
    }

    void columnsComeInAnyOrderWithNotesBetween() {
        const auto records = parseForceRecords(
            "note,cut,teeth,material,removal_rate_mm3_s,feed_mm_min,force_z_n,force_y_n,force_x_n,axis_x,axis_y,axis_z,"
            "feed_x,feed_y,feed_z,spindle_speed_1_min,diameter_mm,axial_depth_mm,radial_depth_mm,immersion,note_2\n"
            "\"warm, new tool\",a,3,wax,12.5,900,3,2,1,0,0,1,0,1,0,12000,6,1,6,slot,\n",
            "f.csv");
        QVERIFY2(records.hasValue(), records ? "" : records.error().place.c_str());
        const ForceRecord& record = records->front();
        QVERIFY(record.force == glm::dvec3(1.0, 2.0, 3.0));
        QCOMPARE(record.teeth, 3);
        QCOMPARE(record.removalRate(), 12.5);
        QVERIFY(record.immersion == Immersion::slot);
    }

    void samplesOfOneCutAreOneRecordWithTheirMean() {
        const std::string name = heading + ",cut\n";
        const auto records = parseForceRecords(name + with(1, "-4") + ",a\n" + good + ",\n" + with(1, "-6") + ",a\n" +
                                                   with(1, "-8") + ",a\n" + good + ",\n",
                                               "f.csv");
        QVERIFY(records.hasValue());
        QCOMPARE(records->size(), std::size_t{3});
        QCOMPARE(records->front().samples, std::size_t{3});
        QCOMPARE(records->front().force.x, -6.0);
        const auto mixed = parseForceRecords(name + good + ",a\n" + with(15, "800") + ",a\n", "f.csv");
        QVERIFY(!mixed.hasValue());
        QCOMPARE(mixed.error().place, std::string("line 3, column cut"));
        QVERIFY(mixed.error().detail.find("line 2") != std::string::npos);
    }

    /// Errors of every broken table name the line and column and say what to write.
    void whatIsBrokenIsNamed_data() {
        QTest::addColumn<QByteArray>("text");
        QTest::addColumn<QByteArray>("place");
        QTest::addColumn<QByteArray>("word");
        const auto row = [](const char* name, const std::string& text, const char* place, const char* word) {
            QTest::newRow(name) << QByteArray::fromStdString(text) << QByteArray(place) << QByteArray(word);
        };
        row("no number", table(good + "\n" + with(3, "much")), "line 3, column force_z_n", "decimal point");
        row("a value that is missing", table(with(1, "")), "line 2, column force_x_n", "missing");
        row("not finite", table(with(2, "inf")), "line 2, column force_y_n", "number");
        row("decimal comma", table(with(1, "-4,5")), "line 2, column 17", "decimal points");
        row("a row that is short", table("wax,1,2"), "line 2, column 4", "16");
        row("no diameter", table(with(11, "0")), "line 2, column diameter_mm", "above 0");
        row("spindle stands", table(with(10, "0")), "line 2, column spindle_speed_1_min", "above 0");
        row("negative depth", table(with(13, "-1")), "line 2, column axial_depth_mm", "range");
        row("half a tooth", table(with(12, "1.5")), "line 2, column teeth", "whole");
        row("no tooth", table(with(12, "0")), "line 2, column teeth", "range");
        row("wider than the tool", table(with(14, "6.5")), "line 2, column radial_depth_mm", "diameter");
        row("no axis", table(with(6, "0")), "line 2, column axis_x", "length");
        row("no feed direction", table(with(7, "0")), "line 2, column feed_x", "direction");
        row("a name that leads away", table(with(0, "../wax")), "line 2, column material", "id");
        row("no name", table(with(0, "")), "line 2, column material", "id");
        row("open quote", table("\"wax,1"), "line 2, column text", "quotation");
        row("a side that is none", heading + ",immersion\n" + good + ",left\n", "line 2, column immersion", "up");
        row("a slot that is none", heading + ",immersion\n" + good + ",slot\n", "line 2, column immersion",
            "up or down");
        row("semicolons", "material;force_x_n\nwax;1\n", "line 1, column heading", "commas");
        row("a column that is missing", heading.substr(0, heading.rfind(',')) + "\n", "line 1, column feed_mm_min",
            "missing");
        row("a column that nobody knows", heading + ",force_n\n", "line 1, column \"force_n\"", "note");
        row("a column twice", heading + ",teeth\n", "line 1, column teeth", "twice");
        row("Latin-1", table("\xB5" + good), "line 2, column text", "UTF-8");
        row("no row", heading + "\n", "records", "no row");
    }
    void whatIsBrokenIsNamed() {
        QFETCH(QByteArray, text);
        QFETCH(QByteArray, place);
        QFETCH(QByteArray, word);
        const auto records = parseForceRecords(text.toStdString(), "f.csv");
        QVERIFY(!records.hasValue());
        QVERIFY(records.error().code == ErrorCode::resourceInvalid);
        QCOMPARE(records.error().subject, std::string("f.csv"));
        QCOMPARE(QByteArray::fromStdString(records.error().place), place);
        QVERIFY2(records.error().detail.find(word.toStdString()) != std::string::npos, records.error().detail.c_str());
    }

    void anEmptyFileIsEmpty() {
        QVERIFY(parseForceRecords("", "f.csv").error().code == ErrorCode::fileEmpty);
        QVERIFY(parseForceRecords("# nothing\n\n", "f.csv").error().code == ErrorCode::fileEmpty);
    }
};

BURIN_TEST(CalibrationRecordsTest, NoApplication)

} // namespace burin::tst_calibration_records

#include "tst_calibration_records.moc"

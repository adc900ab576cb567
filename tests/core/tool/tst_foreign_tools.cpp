// SPDX-FileCopyrightText: 2026 The Burin authors
// SPDX-License-Identifier: Apache-2.0
#include "core/base/units.h"
#include "core/tool/tool_exchange.h"
#include "core/tool/tool_library.h"
#include "tests/places.h"
#include "tests/test_program.h"

#include <QCoreApplication>
#include <QDir>
#include <QFile>
#include <QTemporaryDir>
#include <QtTest>

#include <algorithm>

namespace burin::tst_foreign_tools {

namespace {

Tool lender() {
    return loadTool("flat-6").value();
}

const ReadTool* named(const ReadTools& read, const std::string& name) {
    const auto found = std::ranges::find(read.tools, name, [](const ReadTool& tool) { return tool.tool.name; });
    return found == read.tools.end() ? nullptr : &*found;
}

Result<ReadTools> readText(const std::string& text, double unit = 1.0) {
    return toolsFromText(text, "library", lender(), unit);
}

bool tells(const std::vector<std::string>& notes, const char* part) {
    return std::ranges::any_of(notes, [&](const std::string& note) { return note.find(part) != std::string::npos; });
}

std::vector<Tool> shipped() {
    std::vector<Tool> tools;
    for (const std::string& id : toolIds()) tools.push_back(loadTool(id).value());
    return tools;
}

bool sameHolder(const Cutter& one, const Cutter& other) {
    return std::ranges::equal(one.holder, other.holder, [](const HolderSegment& a, const HolderSegment& b) {
        return std::abs(a.length - b.length) < 1e-9 && std::abs(a.lowerDiameter - b.lowerDiameter) < 1e-9 &&
               std::abs(a.upperDiameter - b.upperDiameter) < 1e-9;
    });
}

} // namespace

/// Tools of other programs. The libraries are as those programs write them, made without Burin's code.
class TestForeignTools : public QObject {
    Q_OBJECT
private slots:
    /// Packed by Python's zipfile, with Fusion's keys.
    void aFusionLibraryIsRead() {
        const auto read = toolsFromFile(BURIN_FIXTURES "/tools/fusion.tools", lender(), 1.0);
        QVERIFY(read);
        QCOMPARE(read->tools.size(), std::size_t{6});
        const ReadTool* ball = named(*read, "Ball 3 mm long");
        QVERIFY(ball);
        QCOMPARE(ball->tool.cutter.type, CutterType::ball);
        QCOMPARE(ball->tool.number, 7);
        QCOMPARE(ball->tool.cutter.diameter, 3.0);
        QCOMPARE(ball->tool.cutter.cornerRadius, 1.5);
        QCOMPARE(ball->tool.cutter.fluteLength, 12.0);
        QCOMPARE(ball->tool.cutter.stickOut, 25.0);
        QCOMPARE(ball->tool.cutter.shankDiameter, 3.175);
        QCOMPARE(ball->tool.cutter.holder.size(), std::size_t{2});
        QCOMPARE(ball->tool.cutter.holder[0].upperDiameter, 16.0);
        QVERIFY(!tells(ball->notes, "holder"));
        QCOMPARE(ball->tool.presets.size(), std::size_t{1});
        QVERIFY(ball->tool.source.find("Acme") != std::string::npos);
        // No such file contains the maximum depth of cut: that of the template tool is used, which is reported, and not
        // the flute length.
        QCOMPARE(ball->tool.maximumDepthOfCut, std::min(12.0, lender().maximumDepthOfCut));
        QVERIFY(lender().maximumDepthOfCut < 12.0 && tells(ball->notes, "Limits and strength"));

        const ReadTool* flat = named(*read, "1/4\" flat");
        QVERIFY(flat);
        QVERIFY(std::abs(flat->tool.cutter.diameter - 6.35) < 1e-12 && flat->tool.fluteCount == 3);
        QVERIFY(std::abs(flat->tool.cutter.stickOut - 38.1) < 1e-12);
        QVERIFY(tells(flat->notes, "No holder"));
        QCOMPARE(named(*read, "Bull 10 R2")->tool.cutter.cornerRadius, 2.0);
        QVERIFY(std::abs(named(*read, "Drill 5")->tool.cutter.taperAngle - 59.0 * pi / 180.0) < 1e-12);
        const Cutter& chamfer = named(*read, "Chamfer 90")->tool.cutter;
        QVERIFY(chamfer.tipDiameter == 0.5 && std::abs(chamfer.taperAngle - pi / 4.0) < 1e-12);
        const Cutter& taper = named(*read, "Taper 3 deg")->tool.cutter; // its DC is that of the tip
        QVERIFY(taper.tipDiameter == 2.0 && std::abs(taper.diameter - 2.0 - 20.0 * std::tan(pi / 60.0)) < 1e-12);
        QCOMPARE(taper.shankDiameter, 7.0);

        QCOMPARE(read->leftOut.size(), std::size_t{3});
        QVERIFY(tells(read->leftOut, "Dovetail 12") && tells(read->leftOut, "ER20 holder") &&
                tells(read->leftOut, "No diameter"));
    }

    /// Everything that Fusion's form can express is read back, for every tool that Burin is shipped with.
    void fusionGivesBackWhatItTook() {
        const std::vector<Tool> tools = shipped();
        const auto written = fusionLibrary(tools);
        QVERIFY(written && written->text.starts_with("PK"));
        const auto read = readText(written->text);
        QVERIFY(read);
        std::size_t compared = 0;
        for (const Tool& tool : tools) {
            const ReadTool* back = named(*read, tool.name);
            if (back == nullptr) {
                QVERIFY2(tells(written->notes, tool.id.c_str()), tool.id.c_str());
                continue;
            }
            ++compared;
            const Cutter &one = tool.cutter, &other = back->tool.cutter;
            QCOMPARE(other.type, one.type);
            QVERIFY2(std::abs(other.diameter - one.diameter) < 1e-9, tool.id.c_str());
            QVERIFY2(std::abs(other.cornerRadius - one.cornerRadius) < 1e-9, tool.id.c_str());
            QVERIFY(std::abs(other.fluteLength - one.fluteLength) < 1e-9);
            QVERIFY(std::abs(other.stickOut - one.stickOut) < 1e-9);
            QVERIFY(std::abs(other.shankDiameter - one.shankDiameter) < 1e-9);
            QVERIFY(std::abs(other.tipDiameter - one.tipDiameter) < 1e-9);
            QVERIFY(std::abs(other.taperAngle - one.taperAngle) < 1e-9);
            QVERIFY2(sameHolder(one, other), tool.id.c_str());
            QVERIFY(back->tool.number == tool.number && back->tool.fluteCount == tool.fluteCount);
        }
        QVERIFY2(compared >= 50, qPrintable(QString::number(compared)));
    }

    void aCamoticsTableIsRead() {
        const std::string table = R"({
            "1": {"units": "metric", "shape": "cylindrical", "length": 20, "diameter": 6, "description": "Flat 6"},
            "2": {"units": "imperial", "shape": "ballnose", "length": 1, "diameter": 0.25, "description": ""},
            "3": {"units": "metric", "shape": "conical", "length": 10, "diameter": 20, "description": "V 90"},
            "4": {"units": "metric", "shape": "snubnose", "length": 5, "diameter": 6, "snub_diameter": 1},
            "5": {"units": "metric", "shape": "spheroid", "length": 5, "diameter": 6}})";
        for (const std::string& text : {table, R"({"units": "metric", "files": [], "tools": )" + table + "}"}) {
            const auto read = readText(text);
            QVERIFY(read);
            QCOMPARE(read->tools.size(), std::size_t{4});
            QCOMPARE(named(*read, "Flat 6")->tool.cutter.fluteLength, 20.0);
            const ReadTool* ball = named(*read, "Tool 2");
            QVERIFY(ball && ball->tool.number == 2 && std::abs(ball->tool.cutter.diameter - 6.35) < 1e-12);
            QCOMPARE(ball->tool.cutter.type, CutterType::ball);
            QVERIFY(std::abs(named(*read, "V 90")->tool.cutter.taperAngle - pi / 4.0) < 1e-12); // 10 mm wide over 10 mm
            QVERIFY(named(*read, "Tool 4")->tool.cutter.tipDiameter == 1.0);
            QVERIFY(tells(read->leftOut, "T5"));
        }
    }

    void camoticsGivesBackWhatItTook() {
        std::vector<Tool> tools{loadTool("flat-6").value(), loadTool("ball-6").value()};
        const auto written = camoticsTable(tools);
        QVERIFY(written);
        const auto read = readText(written->text);
        QVERIFY(read && read->tools.size() == 2);
        for (const Tool& tool : tools) {
            const ReadTool* back = named(*read, tool.name);
            QVERIFY(back && back->tool.number == tool.number && back->tool.cutter.type == tool.cutter.type);
            QVERIFY(back->tool.cutter.diameter == tool.cutter.diameter &&
                    back->tool.cutter.fluteLength == tool.cutter.fluteLength);
        }
        tools.push_back(tools.front());
        QCOMPARE(camoticsTable(tools).error().code, ErrorCode::argumentInvalid);
        QCOMPARE(camoticsTable({loadTool("lollipop-6").value()}).error().code, ErrorCode::notSupported);
    }

    /// Numbers, diameters and names; the form is that of the template tool. For a machine in inches, if that is stated.
    void aLinuxcncTableIsRead() {
        const std::string table =
            "; my tools\nT1 P1 Z0.511 D0.125 ;1/8 inch\n\nT16 P16 D0.5 Z-0.1\nT3 P3 Z0 ;no diameter\n";
        const auto read = readText(table, millimetresPerInch);
        QVERIFY(read);
        QCOMPARE(read->tools.size(), std::size_t{2});
        QVERIFY(std::abs(named(*read, "1/8 inch")->tool.cutter.diameter - 3.175) < 1e-12);
        QCOMPARE(named(*read, "Tool 16")->tool.number, 16);
        QVERIFY(tells(read->leftOut, "T3"));
        const auto own = linuxcncTable({loadTool("ball-6").value()}, 1.0);
        const auto back = readText(own->text);
        QVERIFY(back && back->tools.front().tool.cutter.diameter == 6.0 &&
                back->tools.front().tool.number == loadTool("ball-6").value().number);
    }

    void aFreecadLibraryFindsItsBits() {
        const QTemporaryDir folder;
        QVERIFY(QDir(folder.path()).mkpath("Library") && QDir(folder.path()).mkpath("Bit"));
        const auto write = [&](const char* name, const QByteArray& text) {
            QFile file(folder.filePath(name));
            return file.open(QIODevice::WriteOnly) && file.write(text) == text.size();
        };
        QVERIFY(write("Bit/5mm.fctb", R"({"version": 2, "name": "5mm Endmill", "shape": "endmill.fcstd",
            "parameter": {"Diameter": "5.0000 mm", "CuttingEdgeHeight": "30 mm", "ShankDiameter": "5 mm",
            "Length": "50 mm"}, "attribute": {}})"));
        QVERIFY(write("Library/own.fctl", R"({"version": 1, "tools": [{"nr": 12, "path": "5mm.fctb"},
            {"nr": 2, "path": "gone.fctb"}]})"));
        const auto read = toolsFromFile(folder.filePath("Library/own.fctl").toStdString(), lender(), 1.0);
        QVERIFY(read);
        QCOMPARE(read->tools.size(), std::size_t{1});
        QCOMPARE(read->tools.front().tool.number, 12);
        QCOMPARE(read->tools.front().tool.cutter.diameter, 5.0);
        QVERIFY(tells(read->leftOut, "gone.fctb"));
    }

    /// A name that occurs twice belongs to two tools.
    void idsAreUnique() {
        const auto read =
            readText(R"({"1": {"shape": "cylindrical", "length": 9, "diameter": 3, "description": "End mill"},
            "2": {"shape": "cylindrical", "length": 9, "diameter": 4, "description": "End mill"}})");
        QVERIFY(read && read->tools.size() == 2);
        QVERIFY(read->tools[0].tool.id != read->tools[1].tool.id);
    }

    void whatIsNoLibraryIsRefused_data() {
        QTest::addColumn<QByteArray>("text");
        QTest::newRow("empty") << QByteArray();
        QTest::newRow("nothing in it") << QByteArray(R"({"data": [], "version": 36})");
        QTest::newRow("not tools") << QByteArray(R"({"data": [1, "a", null, {"type": 5, "geometry": []}]})");
        QTest::newRow("no archive") << QByteArray("PK\x03\x04 and then nothing");
        QTest::newRow("huge numbers") << QByteArray(
            R"({"data": [{"type": "drill", "geometry": {"DC": 1e300, "LCF": 1e308, "NOF": 1e99, "TA": 1e9}}]})");
        QTest::newRow("sizes below 0") << QByteArray(
            R"({"1": {"shape": "snubnose", "length": -1, "diameter": -6, "snub_diameter": 9}})");
        QTest::newRow("text where numbers belong")
            << QByteArray(R"({"data": [{"type": "drill", "geometry": {"DC": "6 mm"}, "holder": {"segments": [7]}}]})");
        QTest::newRow("a table without tools") << QByteArray("T0 P0 D0\n");
    }
    void whatIsNoLibraryIsRefused() {
        QFETCH(QByteArray, text);
        const auto read = readText(text.toStdString());
        QVERIFY(!read);
        QVERIFY(!read.error().subject.empty());
    }
};

BURIN_TEST(TestForeignTools, QCoreApplication)

} // namespace burin::tst_foreign_tools

#include "tst_foreign_tools.moc"

// SPDX-FileCopyrightText: 2026 The Burin authors
// SPDX-License-Identifier: Apache-2.0
#include "core/base/units.h"
#include "core/tool/tool_exchange.h"
#include "core/tool/tool_library.h"
#include "tests/test_program.h"

#include <QCoreApplication>
#include <QDir>
#include <QFile>
#include <QJsonArray>
#include <QJsonDocument>
#include <QJsonObject>
#include <QTemporaryDir>
#include <QtTest>

#include <algorithm>
#include <cmath>

namespace burin::tst_foreign_presets {

namespace {

Tool lender() {
    return loadTool("flat-6").value();
}

/// A tool with a preset for a material, and one for any that states only what it has to.
Tool withPresets(const char* like) {
    Tool tool = copyOf(loadTool(like).value(), std::string("own-") + like, std::string("Own ") + like);
    CuttingPreset rough;
    rough.name = "Rough";
    rough.material = "aluminium-6061";
    rough.spindleSpeed = 12'000.0;
    rough.feed = 1080.0;
    rough.plungeFeed = 216.0;
    rough.stepDown = 1.5;
    rough.stepOver = 2.0;
    rough.coolant = Coolant::flood;
    CuttingPreset any;
    any.name = "Any";
    any.spindleSpeed = 9000.0;
    any.chipLoad = 0.02;
    tool.presets = {rough, any};
    return tool;
}

bool near(double one, double other) {
    return std::abs(one - other) < 1e-6;
}
bool sameFeeds(const CuttingPreset& one, const CuttingPreset& other, int flutes) {
    return one.name == other.name && one.material == other.material && near(one.spindleSpeed, other.spindleSpeed) &&
           near(feedOf(one, flutes), feedOf(other, flutes)) && near(one.plungeFeed, other.plungeFeed);
}
bool sameSteps(const CuttingPreset& one, const CuttingPreset& other) {
    return near(one.stepDown, other.stepDown) && near(one.stepOver, other.stepOver) && one.coolant == other.coolant;
}

bool says(const std::vector<std::string>& notes, const char* part) {
    return std::ranges::any_of(notes, [&](const std::string& note) { return note.find(part) != std::string::npos; });
}

Result<ReadTools> readText(const std::string& text) {
    return toolsFromText(text, "library", lender(), 1.0);
}

/// A Fusion library with one end mill of 1/4 inch.
std::string fusionInInches(const std::string& preset) {
    return R"({"data": [{"type": "flat end mill", "unit": "inches", "description": "Inch",
        "geometry": {"DC": 0.25, "LCF": 0.75, "LB": 1.5, "SFDM": 0.25, "NOF": 3}, "post-process": {"number": 2},
        "start-values": {"presets": [)" +
           preset + "]}}], \"version\": 36}";
}

std::string bitWith(const std::string& presets) {
    return R"({"version": 2, "name": "5mm", "shape": "endmill.fcstd", "shape-type": "Endmill",
        "parameter": {"Diameter": "5 mm", "CuttingEdgeHeight": "15 mm", "Flutes": 2, "ShankDiameter": "5 mm"},
        "attribute": {}, "presets": [)" +
           presets + "]}";
}

std::string contentOf(const QString& file) {
    QFile content(file);
    return content.open(QIODevice::ReadOnly) ? content.readAll().toStdString() : std::string();
}

} // namespace

/// Presets of other programs, and libraries of FreeCAD that are written.
class TestForeignPresets : public QObject {
    Q_OBJECT
private slots:
    /// What Fusion's form can express is everything.
    void fusionGivesPresetsBack() {
        const Tool tool = withPresets("flat-6");
        const auto written = fusionLibrary({tool});
        QVERIFY(written);
        const auto read = readText(written->text);
        QVERIFY(read && read->tools.size() == 1);
        const ReadTool& back = read->tools.front();
        QCOMPARE(back.tool.presets.size(), std::size_t{2});
        for (std::size_t i = 0; i < 2; ++i)
            QVERIFY(sameFeeds(back.tool.presets[i], tool.presets[i], 3) &&
                    sameSteps(back.tool.presets[i], tool.presets[i]));
        QVERIFY(!says(back.notes, "reset"));
    }

    /// 30 in/min are 762 mm/min, 0.01 in are 0.254 mm. The material is named as a user of Fusion types it.
    void fusionPresetsHaveTheUnitOfTheirTool() {
        const auto read = readText(fusionInInches(
            R"({"name": "A", "n": 8000, "v_f": 30, "v_f_plunge": 10, "f_z": 9, "stepdown": 0.01, "stepover": 0.02,
                "use-stepover": false, "tool-coolant": "through tool", "v_f_ramp": 5,
                "material": {"category": "all", "query": "Aluminium 6061"}},
               {"name": "A", "n": 8000, "f_z": 0.001, "material": {"category": "all", "query": ""}},
               {"n": 5000, "f_n": 0.002, "material": {"category": "steel", "query": ""}})"));
        QVERIFY(read);
        const ReadTool& tool = read->tools.front();
        QCOMPARE(tool.tool.presets.size(), std::size_t{3});
        const CuttingPreset& first = tool.tool.presets[0];
        QVERIFY(near(first.feed, 762.0) && near(first.plungeFeed, 254.0) && near(first.stepDown, 0.254));
        QVERIFY(first.chipLoad == 0.0 && first.stepOver == 0.0 && !first.coolant);
        QCOMPARE(first.material, std::string("aluminium-6061"));
        QVERIFY(says(tool.notes, "through tool") && says(tool.notes, "ramps"));
        const CuttingPreset& second = tool.tool.presets[1];
        QCOMPARE(second.name, std::string("A 2"));
        QVERIFY(second.material.empty() && near(second.chipLoad, 0.0254) && near(feedOf(second, 3), 8000 * 3 * 0.0254));
        const CuttingPreset& third = tool.tool.presets[2];
        QVERIFY(near(third.feed, 5000 * 0.0508));
        QCOMPARE(third.material, std::string("steel")); // no such material: kept, and reported
        QVERIFY(says(tool.notes, "\"steel\""));
    }

    /// A preset without sense is left out with a note; the tool stays.
    void presetsOutOfRangeAreLeftOut() {
        const auto read = readText(fusionInInches(
            R"({"name": "no speed", "v_f": 30}, {"name": "no feed", "n": 8000}, {"name": "huge", "n": 1e9, "v_f": 1e300},
               {"name": "deep", "n": 8000, "v_f": 30, "stepdown": 5, "stepover": 0.2}, 7, null)"));
        QVERIFY(read);
        const ReadTool& tool = read->tools.front();
        QCOMPARE(tool.tool.presets.size(), std::size_t{1});
        QCOMPARE(tool.tool.presets[0].name, std::string("deep"));
        QVERIFY(tool.tool.presets[0].stepDown == 0.0 && tool.tool.presets[0].stepOver == 0.0);
        for (const char* part : {"\"no speed\" was left out", "\"no feed\" was left out", "\"huge\" was left out",
                                 "step-down of 127 mm", "step-over of 5.08 mm"})
            QVERIFY2(says(tool.notes, part), part);
    }

    /// As FreeCAD writes them: m/min and mm per tooth. n = 1000 · 150 / (pi · 5), feed = n · 2 · 0.03.
    void freecadPresetsAreRead() {
        const auto read = toolFromText(
            bitWith(
                R"({"name": "alu", "material_hint": {"uuid": "u-1", "name": "Aluminium 6061"}, "op_type_hint": "profile",
                "surface_speed": 150.0, "chipload": 0.03, "vert_feed_ratio": 0.33, "notes": "loud"},
               {"name": null, "material_hint": null, "op_type_hint": null, "surface_speed": 100.0, "chipload": 0.02,
                "vert_feed_ratio": 0.33, "notes": null},
               {"name": "no speed", "material_hint": null, "surface_speed": null, "chipload": 0.02})"),
            "5mm.fctb", lender());
        QVERIFY(read);
        QCOMPARE(read->tool.presets.size(), std::size_t{2});
        const double turns = 150'000.0 / (std::acos(-1.0) * 5.0);
        const CuttingPreset& alu = read->tool.presets[0];
        QVERIFY(near(alu.spindleSpeed, turns) && alu.chipLoad == 0.03);
        QVERIFY(std::abs(alu.plungeFeed - 0.33 * turns * 2 * 0.03) < 1e-4);
        QCOMPARE(alu.material, std::string("aluminium-6061"));
        QCOMPARE(read->tool.presets[1].name, std::string("Preset"));
        QVERIFY(says(read->notes, "profile") && says(read->notes, "remarks") && says(read->notes, "\"no speed\""));
    }

    void freecadGivesFeedsBack() {
        const Tool tool = withPresets("flat-6");
        const auto written = freecadBit(tool);
        QVERIFY(written && says(written->notes, "Step-down"));
        const auto back = toolFromText(written->text, "own.fctb", lender());
        QVERIFY(back && back->tool.presets.size() == 2);
        for (std::size_t i = 0; i < 2; ++i) QVERIFY(sameFeeds(back->tool.presets[i], tool.presets[i], 3));
    }

    void otherFormatsReportLostPresets() {
        const Tool tool = withPresets("flat-6");
        for (const auto& written : {linuxcncTable({tool}, 1.0), camoticsTable({tool})})
            QVERIFY(written && says(written->notes, "Presets of feeds and speeds"));
        QVERIFY(!says(linuxcncTable({lender()}, 1.0)->notes, "Presets"));
    }

    /// A tool that is lent for missing values does not lend its feeds.
    void presetsAreNotLent() {
        const Tool like = withPresets("flat-6");
        QVERIFY(toolsFromText("T1 P1 D3 ;x\n", "t", like, 1.0)->tools.front().tool.presets.empty());
        QVERIFY(toolFromText(bitWith(""), "b", like)->tool.presets.empty());
        QVERIFY(toolsFromText(fusionInInches(""), "f", like, 1.0)->tools.front().tool.presets.empty());
        QVERIFY(toolsFromText(R"({"1": {"shape": "cylindrical", "length": 9, "diameter": 3, "description": "x"}})", "c",
                              like, 1.0)
                    ->tools.front()
                    .tool.presets.empty());
    }

    void aFreecadLibraryComesBack_data() {
        QTest::addColumn<QString>("library");
        QTest::addColumn<QString>("bits");
        QTest::newRow("FreeCAD's folders") << "Library/mine.fctl"
                                           << "Bit";
        QTest::newRow("any folder") << "out/mine.fctl"
                                    << "out/Bit";
    }
    /// Written with its bits, and read by the reader of FreeCAD's own libraries: each tool with a shape that bits have
    /// is the same again; what bits don't hold is that of the tool that is lent.
    void aFreecadLibraryComesBack() {
        QFETCH(QString, library);
        QFETCH(QString, bits);
        const QTemporaryDir folder;
        const std::string file = folder.filePath(library).toStdString();
        std::vector<Tool> tools;
        for (const char* like : {"flat-6", "ball-6", "bull-10-r2", "drill-5", "lollipop-6"}) {
            tools.push_back(withPresets(like));
            tools.back().number = 20 + static_cast<int>(tools.size());
            for (CuttingPreset& preset : tools.back().presets) preset.stepDown = preset.stepOver = 0.0;
        }
        const auto written = toolsFor(file, "", tools, 1.0);
        QVERIFY(written);
        QCOMPARE(written->files.size(), std::size_t{4});
        QVERIFY(says(written->notes, "lollipop-6"));
        QCOMPARE(says(written->notes, "folder Library"), library.startsWith("out"));
        QVERIFY(writeTools(file, *written));
        QCOMPARE(QDir(folder.filePath(bits)).entryList(QDir::Files).size(), 4);
        const QJsonObject json =
            QJsonDocument::fromJson(QByteArray::fromStdString(contentOf(folder.filePath(library)))).object();
        QVERIFY(json["version"] == 1 && json["label"] == "mine" && json["tools"].toArray().size() == 4);
        QCOMPARE(json["tools"][0]["nr"].toInt(), 21);
        QCOMPARE(json["tools"][0]["path"].toString(), QString("own-flat-6.fctb"));
        for (std::size_t i = 0; i < 4; ++i) {
            const Tool& tool = tools[i];
            const auto read = toolsFromFile(file, tool, 1.0);
            QVERIFY(read && read->leftOut.empty() && read->tools.size() == 4);
            Tool back = read->tools[i].tool;
            QCOMPARE(back.presets.size(), std::size_t{2});
            for (std::size_t k = 0; k < 2; ++k) QVERIFY(sameFeeds(back.presets[k], tool.presets[k], tool.fluteCount));
            // The bit has no id, no source and no coolant; angles are written in degrees.
            back.presets = tool.presets;
            back.id = tool.id;
            back.source = tool.source;
            back.sources = tool.sources;
            QVERIFY(std::abs(back.cutter.taperAngle - tool.cutter.taperAngle) < 1e-9);
            back.cutter.taperAngle = tool.cutter.taperAngle;
            QVERIFY2(toJson(back) == toJson(tool), (toJson(back) + toJson(tool)).c_str());
        }
    }

    /// Bits that another library uses are kept; those of the library that is written again are replaced.
    void bitsOfOthersAreKept() {
        const QTemporaryDir folder;
        const std::string file = folder.filePath("mine.fctl").toStdString();
        QVERIFY(QDir(folder.path()).mkpath("Bit"));
        QFile other(folder.filePath("Bit/own-flat-6.fctb"));
        QVERIFY(other.open(QIODevice::WriteOnly) && other.write("another's") > 0);
        other.close();
        Tool tool = withPresets("flat-6");
        for (int i = 0; i < 2; ++i) {
            tool.cutter.fluteLength -= 1.0; // the second time it has changed
            const auto written = freecadLibrary(file, {tool});
            QVERIFY(written && writeTools(file, *written));
            QCOMPARE(contentOf(other.fileName()), std::string("another's"));
            QCOMPARE(QDir(folder.filePath("Bit")).entryList(QDir::Files),
                     (QStringList{"own-flat-6-2.fctb", "own-flat-6.fctb"}));
            QCOMPARE(toolsFromFile(file, lender(), 1.0)->tools.front().tool.cutter.fluteLength,
                     tool.cutter.fluteLength);
        }
        QCOMPARE(freecadLibrary(file, {tool, tool}).error().code, ErrorCode::argumentInvalid);
        QCOMPARE(freecadLibrary(file, {loadTool("lollipop-6").value()}).error().code, ErrorCode::notSupported);
    }
};

BURIN_TEST(TestForeignPresets, QCoreApplication)

} // namespace burin::tst_foreign_presets

#include "tst_foreign_presets.moc"

// SPDX-FileCopyrightText: 2026 The Burin authors
// SPDX-License-Identifier: Apache-2.0
#include "core/tool/tool.h"
#include "core/tool/tool_library.h"
#include "tests/test_program.h"

#include <QTemporaryDir>
#include <QtTest>

namespace burin::tst_cutting_preset {

namespace {

Tool withPresets(std::vector<CuttingPreset> presets) {
    Tool tool = copyOf(loadTool("flat-6").value(), "own-6", "Own 6");
    tool.presets = std::move(presets);
    return tool;
}

CuttingPreset preset(const char* name, const char* material, double speed = 12'000.0) {
    CuttingPreset made;
    made.name = name;
    made.material = material;
    made.spindleSpeed = speed;
    made.feed = 800.0;
    return made;
}

} // namespace

/// Presets of feeds and speeds: their file form, their limits, and which of them applies.
class TestCuttingPreset : public QObject {
    Q_OBJECT
    QTemporaryDir userData_;

private slots:
    void initTestCase() { qputenv("XDG_DATA_HOME", userData_.path().toUtf8()); }

    /// Every value, those that are not stated as well, comes back; a tool without presets has no key of them, so that
    /// an older Burin reads it.
    void theFileGivesThemBack() {
        CuttingPreset whole = preset("Schruppen in Öl", "aluminium-6061", 12'345.5);
        whole.plungeFeed = 210.25;
        whole.stepDown = 1.5;
        whole.stepOver = 2.25;
        whole.coolant = Coolant::mist;
        CuttingPreset byTooth = preset("any", "");
        byTooth.feed = 0.0;
        byTooth.chipLoad = 0.0125;
        const Tool tool = withPresets({whole, byTooth});
        const std::string text = toJson(tool);
        for (const char* key :
             {"\"presets\"", "\"spindle_speed_rpm\": 12345.5", "\"feed_mm_per_min\": 800.0", "\"chip_load_mm\": 0.0125",
              "\"plunge_feed_mm_per_min\": 210.25", "\"step_down_mm\": 1.5", "\"step_over_mm\": 2.25",
              "\"coolant\": \"mist\"", "\"material\": \"aluminium-6061\""})
            QVERIFY2(text.find(key) != std::string::npos, key);
        const Result<Tool> back = toolFromJson(text, "own");
        QVERIFY2(back, back ? "" : (back.error().place + " " + back.error().detail).c_str());
        QCOMPARE(back->presets, tool.presets);
        QCOMPARE(feedOf(byTooth, 3), 12'000.0 * 3 * 0.0125);
        QVERIFY(toJson(withPresets({})).find("presets") == std::string::npos);
        QVERIFY(saveTool(tool, false) && loadTool("own-6")->presets == tool.presets);
    }

    void valuesOutOfRangeAreNamed_data() {
        QTest::addColumn<QByteArray>("preset");
        QTest::addColumn<QByteArray>("key");
        const QByteArray start = R"({"name": "a", "spindle_speed_rpm": 9000)";
        QTest::newRow("no speed") << QByteArray(R"({"name": "a", "feed_mm_per_min": 5})")
                                  << QByteArray("spindle_speed_rpm");
        QTest::newRow("speed") << QByteArray(R"({"name": "a", "spindle_speed_rpm": 2e6, "feed_mm_per_min": 5})")
                               << QByteArray("spindle_speed_rpm");
        QTest::newRow("neither feed") << start + "}" << QByteArray("feed_mm_per_min");
        QTest::newRow("both feeds") << start + R"(, "feed_mm_per_min": 5, "chip_load_mm": 0.1})"
                                    << QByteArray("feed_mm_per_min");
        QTest::newRow("feed below 0") << start + R"(, "feed_mm_per_min": -5})" << QByteArray("feed_mm_per_min");
        QTest::newRow("chip load") << start + R"(, "chip_load_mm": 11})" << QByteArray("chip_load_mm");
        QTest::newRow("step-down") << start + R"(, "feed_mm_per_min": 5, "step_down_mm": 9.5})"
                                   << QByteArray("step_down_mm"); // the tool cuts 9 mm deep
        QTest::newRow("step-over") << start + R"(, "feed_mm_per_min": 5, "step_over_mm": 3.1})"
                                   << QByteArray("step_over_mm"); // of 6 mm
        QTest::newRow("coolant") << start + R"(, "feed_mm_per_min": 5, "coolant": "oil"})" << QByteArray("coolant");
        QTest::newRow("material") << start + R"(, "feed_mm_per_min": 5, "material": "../x"})" << QByteArray("material");
        QTest::newRow("unknown key") << start + R"(, "feed_mm_per_min": 5, "feed": 5})" << QByteArray("feed");
        QTest::newRow("twice") << start + R"(, "feed_mm_per_min": 5}, {"name": "a", "spindle_speed_rpm": 1, )" +
                                      R"("feed_mm_per_min": 5})"
                               << QByteArray("name");
    }
    void valuesOutOfRangeAreNamed() {
        QFETCH(QByteArray, preset);
        QFETCH(QByteArray, key);
        std::string text = toJson(withPresets({}));
        text.insert(text.find("\"cutter\""), "\"presets\": [" + preset.toStdString() + "],\n  ");
        const Result<Tool> read = toolFromJson(text, "own.json");
        QVERIFY(!read);
        QCOMPARE(read.error().code, ErrorCode::resourceInvalid);
        QVERIFY2(read.error().place.starts_with("presets[") && read.error().place.ends_with("]." + key.toStdString()),
                 read.error().place.c_str());
    }

    /// The material itself, then what it is a grade of, then any; the first of several.
    void theMaterialsPresetStandsBeforeTheOneForAny() {
        const Tool tool = withPresets({preset("first of all", ""), preset("oak", "oak"), preset("oak again", "oak"),
                                       preset("layer", "oak-dense"), preset("second of all", "")});
        QCOMPARE(presetFor(tool, "oak", "")->name, std::string("oak"));
        QCOMPARE(presetFor(tool, "oak-dense", "oak")->name, std::string("layer"));
        QCOMPARE(presetFor(tool, "oak-light", "oak")->name, std::string("oak"));
        QCOMPARE(presetFor(tool, "brass", "")->name, std::string("first of all"));
        QVERIFY(presetFor(withPresets({preset("oak", "oak")}), "brass", "") == nullptr);
        QCOMPARE(freePresetName(tool.presets, "oak"), std::string("oak 2"));
        QCOMPARE(freePresetName(tool.presets, "pine"), std::string("pine"));
    }
};

BURIN_TEST(TestCuttingPreset, QCoreApplication)

} // namespace burin::tst_cutting_preset

#include "tst_cutting_preset.moc"

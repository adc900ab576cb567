// SPDX-FileCopyrightText: 2026 The Burin authors
// SPDX-License-Identifier: Apache-2.0
#include "core/base/file.h"
#include "core/base/resource_folder.h"
#include "core/tool/tool.h"
#include "tests/core/tool/fixed_tools.h"
#include "tests/test_program.h"

#include <QTemporaryDir>
#include <QtTest>

#include <algorithm>
#include <filesystem>
#include <vector>

namespace burin::tst_tool {

namespace {

Tool exampleTool() {
    Tool tool;
    tool.id = "bull-8";
    tool.name = "Bull-nose end mill 8 mm";
    tool.number = 12;
    tool.fluteCount = 3;
    tool.centreCutting = false;
    tool.maximumDepthOfCut = 9.5;
    tool.maximumSpindleSpeed = 30000.0;
    tool.source = "measured";
    tool.cutter = {CutterType::bullNose, 8.0, 1.25, 20.0, 7.6, 41.0, {{28.0, 28.0, 18.0}, {28.0, 40.0, 10.0}}};
    return tool;
}

} // namespace

class ToolTest : public QObject {
    Q_OBJECT

    QTemporaryDir userData_;

private slots:
    void initTestCase() { qputenv("XDG_DATA_HOME", userData_.path().toUtf8()); }

    void everyShippedToolIsValid() {
        const std::vector<std::string> ids = toolIds();
        QVERIFY(ids.size() >= 8);
        for (const std::string& id : ids) {
            const Result<Tool> tool = loadTool(id);
            QVERIFY2(tool.hasValue(), tool ? "" : (id + ": " + tool.error().place + " " + tool.error().detail).c_str());
            QCOMPARE(tool->id, id);
            QVERIFY(validate(*tool).hasValue());
            QVERIFY(!tool->source.empty());
            QVERIFY2(!tool->cutter.holder.empty(), id.c_str());
        }
    }

    void shippedToolsHaveNumbersOfTheirOwn() {
        std::vector<int> numbers;
        for (const std::string& id : toolIds()) numbers.push_back(loadTool(id)->number);
        std::ranges::sort(numbers);
        QVERIFY(std::ranges::adjacent_find(numbers) == numbers.end());
    }

    void theDemosBallIsSixAcrossWithARelievedShank() {
        const Result<Tool> tool = loadTool("ball-6");
        QVERIFY(tool.hasValue());
        QCOMPARE(tool->cutter.diameter, 6.0);
        QCOMPARE(tool->cutter.cornerRadius, 3.0);
        QVERIFY(tool->cutter.shankDiameter < tool->cutter.diameter);
        QCOMPARE(loadTool("ball-1")->cutter.radius(), 0.5); // the paper's figure 13(b)
    }

    void textReadsBackAsTheSameTool() {
        const Tool tool = exampleTool();
        const Result<Tool> back = toolFromJson(toJson(tool), "memory");
        QVERIFY(back.hasValue());
        QCOMPARE(toJson(*back), toJson(tool));
        QCOMPARE(back->cutter.cornerRadius, 1.25);
        QCOMPARE(back->cutter.holder.size(), std::size_t{2});
        QCOMPARE(back->cutter.holder[1].upperDiameter, 40.0);
        QVERIFY(back->cutter.type == CutterType::bullNose);
        QVERIFY(!back->centreCutting);
    }

    void aBrokenFileNamesItsKey_data() {
        QTest::addColumn<QString>("from");
        QTest::addColumn<QString>("to");
        QTest::addColumn<QString>("key");
        QTest::newRow("unknown key") << R"("number")"
                                     << R"("colour": 1, "number")"
                                     << "colour";
        QTest::newRow("unknown nested key") << R"("diameter_mm")"
                                            << R"("coating": 1, "diameter_mm")"
                                            << "cutter.coating";
        QTest::newRow("missing key") << R"("flute_count": 3,)"
                                     << ""
                                     << "flute_count";
        QTest::newRow("text for a number") << R"("diameter_mm": 8.0)"
                                           << R"("diameter_mm": "8")"
                                           << "cutter.diameter_mm";
        QTest::newRow("fraction of a flute") << R"("flute_count": 3)"
                                             << R"("flute_count": 2.5)"
                                             << "flute_count";
        QTest::newRow("tool 0") << R"("number": 12)"
                                << R"("number": 0)"
                                << "number";
        QTest::newRow("no diameter") << R"("diameter_mm": 8.0)"
                                     << R"("diameter_mm": 0)"
                                     << "cutter.diameter_mm";
        QTest::newRow("metres") << R"("diameter_mm": 8.0)"
                                << R"("diameter_mm": 8000)"
                                << "cutter.diameter_mm";
        QTest::newRow("unknown type") << R"("bull_nose")"
                                      << R"("laser")"
                                      << "cutter.type";
        QTest::newRow("corner too large") << R"("corner_radius_mm": 1.25)"
                                          << R"("corner_radius_mm": 4)"
                                          << "cutter.corner_radius_mm";
        QTest::newRow("flutes beyond the holder") << R"("stick_out_mm": 41.0)"
                                                  << R"("stick_out_mm": 19)"
                                                  << "cutter.stick_out_mm";
        QTest::newRow("deeper than the flutes") << R"("maximum_depth_of_cut_mm": 9.5)"
                                                << R"("maximum_depth_of_cut_mm": 21)"
                                                << "maximum_depth_of_cut_mm";
        QTest::newRow("empty holder segment") << R"("length_mm": 10.0)"
                                              << R"("length_mm": 0)"
                                              << "cutter.holder[1].length_mm";
        QTest::newRow("key twice") << R"("number": 12)"
                                   << R"("number": 12, "number": 13)"
                                   << "number";
        QTest::newRow("not JSON") << R"("number": 12)"
                                  << R"("number": )"
                                  << "line 4, column 13";
    }
    void aBrokenFileNamesItsKey() {
        QFETCH(QString, from);
        QFETCH(QString, to);
        QFETCH(QString, key);
        QString text = QString::fromStdString(toJson(exampleTool()));
        QVERIFY2(text.contains(from), qPrintable(text));
        const Result<Tool> tool = toolFromJson(text.replace(from, to).toStdString(), "bad.json");
        QVERIFY(!tool.hasValue());
        QVERIFY(tool.error().code == ErrorCode::resourceInvalid);
        QCOMPARE(tool.error().subject, std::string("bad.json"));
        QCOMPARE(QString::fromStdString(tool.error().place), key);
        QVERIFY(!tool.error().detail.empty());
    }

    void anUnknownToolNamesThoseThereAre() {
        for (const char* id : {"ball-7", "", "../tools/ball-6", "/etc/passwd"}) {
            const Result<Tool> tool = loadTool(id);
            QVERIFY(!tool.hasValue());
            QVERIFY(tool.error().code == ErrorCode::nameUnknown);
            QCOMPARE(tool.error().subject, std::string("tool"));
            QCOMPARE(tool.error().place, std::string(id));
            QVERIFY(tool.error().detail.find("ball-6") != std::string::npos);
        }
    }

    void theUsersToolsComeFirst() {
        const std::filesystem::path folder = userResourceDirectory(toolResource);
        std::filesystem::create_directories(folder);
        Tool own = exampleTool();
        QVERIFY(writeFileAtomically(folder / "bull-8.json", toJson(own)).hasValue());
        own.id = "ball-6";
        QVERIFY(writeFileAtomically(folder / "ball-6.json", toJson(own)).hasValue());
        QVERIFY(std::ranges::count(toolIds(), "bull-8") == 1);
        QVERIFY(std::ranges::count(toolIds(), "ball-6") == 1);
        QCOMPARE(loadTool("ball-6")->source, std::string("measured"));
        QVERIFY(writeFileAtomically(folder / "renamed.json", toJson(own)).hasValue());
        QCOMPARE(loadTool("renamed").error().place, std::string("id"));
        std::filesystem::remove_all(folder);
    }

    void aSolidStaysInItsProfileBetweenItsCorners() {
        Cutter cutter = cutters::scraper();
        QVERIFY(validateSolid(cutter) && validateSolid(cutters::scraper(0.7, 20.0)));
        const double wide = 0.5 * cutter.diameter;
        const std::vector<ProfileElement> waist{{wide, 0.0, 0.0, false},  {wide, 20.0, 0.0, false},
                                                {3.0, 20.0, 0.0, false},  {3.0, 30.0, 0.0, false},
                                                {wide, 30.0, 0.0, false}, {wide, 60.0, 0.0, false}};
        const std::vector<ProfileElement> dent{
            {wide, 0.0, 0.0, false}, {wide - 0.01, 30.0, 0.0, false}, {wide, 60.0, 0.0, false}};
        for (const std::vector<ProfileElement>& narrowed : {waist, dent}) { // the corners are at 0 and 60
            cutter.profile = narrowed;
            const Result<void> checked = validateSolid(cutter);
            QVERIFY(!checked && checked.error().subject == "cutter.flutes_mesh");
        }
    }

    void theStackOfPiecesHasNoGap() {
        for (const std::string& id : toolIds()) {
            const Cutter cutter = loadTool(id)->cutter;
            const std::vector<RevolvedPiece> stack = pieces(cutter);
            const std::size_t flutes = flutePieces(cutter).size();
            QCOMPARE(stack.size(), flutes + 1 + cutter.holder.size());
            for (std::size_t i = 0; i < stack.size(); ++i)
                QVERIFY(sectionOf(cutter, i) == (i < flutes    ? ToolSection::flutes
                                                 : i == flutes ? ToolSection::shank
                                                               : ToolSection::holder));
            QCOMPARE(stack.front().bottom, 0.0);
            for (std::size_t i = 1; i < stack.size(); ++i) QCOMPARE(stack[i].bottom, stack[i - 1].top);
            QCOMPARE(stack.back().top, cutter.length());
        }
        Cutter stub = exampleTool().cutter;
        stub.stickOut = stub.fluteLength; // the flutes reach the holder: no shank
        QCOMPARE(pieces(stub).size(), stub.holder.size() + 1);
        QCOMPARE(pieces(stub)[1].bottomRadius, 14.0);
    }
};

BURIN_TEST(ToolTest, NoApplication)

} // namespace burin::tst_tool

#include "tst_tool.moc"

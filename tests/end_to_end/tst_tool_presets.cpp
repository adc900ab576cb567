// SPDX-FileCopyrightText: 2026 The Burin authors
// SPDX-License-Identifier: Apache-2.0
#include "program_run.h"

#include "tests/test_program.h"

#include <QCoreApplication>
#include <QDir>
#include <QJsonArray>
#include <QRegularExpression>
#include <QTemporaryDir>
#include <QTest>

#include <set>

namespace burin::tst_tool_presets {

/// Presets of feeds and speeds and tool libraries by the command line, as far as the program that is posted.
class ToolPresetsTest : public QObject {
    Q_OBJECT
private slots:
    void initTestCase() { qputenv("XDG_DATA_HOME", folder_.path().toUtf8()); }

    void presetsAreEnteredChangedAndDeleted() {
        (void)answer({"tools", "copy", "flat-6", "shop-6"});
        const QJsonObject made =
            answer({"tools", "preset", "shop-6", "Rough", "--material", "aluminium-6061", "--speed", "9000", "--feed",
                    "777", "--plunge-feed", "111", "--step-down", "0.25"});
        QCOMPARE(made["presets"].toArray().size(), 1);
        (void)answer({"tools", "preset", "shop-6", "Any", "--speed", "5000", "--feed-per-tooth", "0.01", "--coolant",
                      "mist", "--first"});
        QJsonArray presets = answer({"tools", "show", "shop-6"})["presets"].toArray();
        QCOMPARE(presets.size(), 2);
        QCOMPARE(presets[0].toObject()["name"].toString(), QString("Any"));
        QCOMPARE(presets[0].toObject()["chip_load_mm"].toDouble(), 0.01);
        QCOMPARE(presets[0].toObject()["coolant"].toString(), QString("mist"));
        QVERIFY(!presets[0].toObject().contains("material"));
        QCOMPARE(presets[1].toObject()["feed_mm_per_min"].toDouble(), 777.0);
        QCOMPARE(presets[1].toObject()["material"].toString(), QString("aluminium-6061"));
        (void)answer({"tools", "preset", "shop-6", "Any", "--feed", "400"});
        presets = answer({"tools", "show", "shop-6"})["presets"].toArray();
        QCOMPARE(presets[0].toObject()["feed_mm_per_min"].toDouble(), 400.0);
        QVERIFY(!presets[0].toObject().contains("chip_load_mm"));
        (void)answer({"tools", "preset", "shop-6", "Any", "--remove"});
        QCOMPARE(answer({"tools", "show", "shop-6"})["presets"].toArray().size(), 1);
    }

    /// Levels of 0.25 mm through the 4 mm above the cube, program zero on top of the stock, 9,000 1/min, 777 mm/min,
    /// and 111 mm/min downwards; without the preset other values. The machine's own limits are higher.
    void theProgramHasThePresetsValues() {
        QCOMPARE(runBurin({"embed", BURIN_FIXTURES "/models/cube.brep", "-o", in("p.burin"), "--voxel", "0.5",
                           "--margin", "4", "--material", "aluminium-6061"})
                     .status,
                 0);
        for (const char* tool : {"flat-6", "shop-6"}) {
            const QString project = in(tool) + ".burin";
            QVERIFY(QFile::copy(in("p.burin"), project));
            const ProgramRun pass = runBurin({"path", project, "new", "--pass", "face", "--tool", tool});
            QVERIFY2(pass.status == 0, pass.messages.constData());
            const ProgramRun post = runBurin({"post", project, "-o", in(tool) + ".ngc"});
            QVERIFY2(post.status == 0, post.messages.constData());
        }
        const QString program = contentOf(in("shop-6.ngc")), table = contentOf(in("flat-6.ngc"));
        QCOMPARE(valuesOf(program, "S(\\d+)"), (std::set<double>{9000.0}));
        QVERIFY(!valuesOf(table, "S(\\d+)").contains(9000.0));
        const std::set<double> feeds = valuesOf(program, "F([\\d.]+)");
        QVERIFY2(feeds.contains(777.0) && *feeds.rbegin() == 777.0, qPrintable(program.left(1500)));
        QVERIFY(!valuesOf(table, "F([\\d.]+)").contains(777.0));
        const std::set<double> levels = levelsOf(program);
        for (int i = 1; i <= 16; ++i) QVERIFY2(levels.contains(-0.25 * i), qPrintable(QString::number(-0.25 * i)));
        QVERIFY(!levelsOf(table).contains(-0.25));
    }

    void toolsFormLibraries() {
        (void)answer({"tools", "new-library", "Werk 2"});
        (void)answer({"tools", "--library", "Werk 2", "copy", "ball-6", "werk-ball"});
        QCOMPARE(listed("Werk 2"), QStringList{"werk-ball"});
        (void)answer({"tools", "move", "shop-6", "--library", "Werk 2"});
        QCOMPARE(listed("Werk 2"), (QStringList{"shop-6", "werk-ball"}));
        QVERIFY(!listed("mine").contains("shop-6") && listed("all").contains("shop-6"));
        QVERIFY(listed("starter").contains("ball-6") && !listed("starter").contains("shop-6"));
        const QJsonArray copies = answer({"tools", "move", "flat-6", "--copy", "--library", "mine"})["tools"].toArray();
        QCOMPARE(copies[0].toString(), QString("flat-6-copy"));
        (void)answer({"tools", "rename-library", "Werk 2", "Werk 3"});
        bool counted = false;
        for (const QJsonValue& each : answer({"tools", "libraries"})["libraries"].toArray())
            counted = counted || (each["name"] == "Werk 3" && each["tools"].toArray().size() == 2);
        QVERIFY(counted);
        // The tool is still that of the project above.
        QVERIFY(runBurin({"post", in("shop-6.burin"), "-o", in("again.ngc")}).status == 0);
        const ProgramRun refused = runBurin({"tools", "remove-library", "Werk 3"});
        QVERIFY(refused.status == 2 && refused.messages.contains("--with-tools"));
        QCOMPARE(listed("Werk 3").size(), 2);
        (void)answer({"tools", "remove-library", "Werk 3", "--with-tools"});
        QVERIFY(!listed("all").contains("shop-6") && !listed("all").contains("werk-ball"));
        QVERIFY(runBurin({"post", in("shop-6.burin"), "-o", in("again.ngc")}).status ==
                0); // the project keeps its tool
    }

    /// A file becomes a library of its name; that is written for FreeCAD and read again.
    void aLibraryGoesToFreecadAndComesBack() {
        const QString fusion = QStringLiteral(BURIN_FIXTURES "/tools/fusion.tools");
        QCOMPARE(answer({"tools", "import", fusion, "--dry-run"})["library"].toString(), QString("fusion"));
        QVERIFY(runBurin({"tools", "--library", "fusion", "list"}).status == 2); // it was not made
        (void)answer({"tools", "import", fusion});
        QCOMPARE(listed("fusion").size(), 6);
        QVERIFY(QDir(folder_.path()).mkpath("cam/Library"));
        const QString file = in("cam/Library/shop.fctl");
        const QJsonObject written = answer({"tools", "export", "--library", "fusion", "-o", file});
        QCOMPARE(written["bits"].toArray().size(), 5); // no bit is tapered
        QCOMPARE(QDir(in("cam/Bit")).entryList(QDir::Files).size(), 5);
        const ProgramRun twice = runBurin({"tools", "import", file, "--library", "Back"});
        QVERIFY(twice.status == 2 && twice.messages.contains("--replace")); // the tools are there, and nothing is made
        QVERIFY(runBurin({"tools", "--library", "Back", "list"}).status == 2);
        const QJsonObject one = answer({"tools", "show", "ball-3-mm-long"});
        (void)answer({"tools", "remove-library", "fusion", "--with-tools"});
        (void)answer({"tools", "import", file, "--library", "Back"});
        QCOMPARE(listed("Back").size(), 5);
        const QJsonObject other = answer({"tools", "show", "ball-3-mm-long"});
        QCOMPARE(other["number"], one["number"]);
        for (const char* key : {"type", "diameter_mm", "corner_radius_mm", "flute_length_mm", "shank_diameter_mm"})
            QCOMPARE(other["cutter"][key], one["cutter"][key]);
        QCOMPARE(one["presets"][0]["feed_mm_per_min"].toDouble(), 600.0);
        QCOMPARE(other["presets"][0]["spindle_speed_rpm"].toDouble(), 12000.0);
        QCOMPARE(other["presets"][0]["chip_load_mm"].toDouble(), 0.025); // 600 / (12,000 · 2)
    }

    void badInputIsRefusedInOneSentence_data() {
        QTest::addColumn<QStringList>("arguments");
        QTest::addColumn<QString>("words");
        const auto preset = [](const QStringList& values) {
            return QStringList{"tools", "preset", "own-6", "p", "--speed", "9000", "--feed", "5"} + values;
        };
        QTest::newRow("a shipped tool") << QStringList{"tools",   "preset", "flat-6", "p",
                                                       "--speed", "9000",   "--feed", "5"}
                                        << "flat-6";
        QTest::newRow("no speed") << QStringList{"tools", "preset", "own-6", "p", "--feed", "5"} << "spindle_speed_rpm";
        QTest::newRow("no feed") << QStringList{"tools", "preset", "own-6", "p", "--speed", "9000"}
                                 << "feed_mm_per_min";
        QTest::newRow("a speed out of range")
            << QStringList{"tools", "preset", "own-6", "p", "--speed", "0.5", "--feed", "5"}
            << "\"0.5\" of \"presets[0].spindle_speed_rpm\"";
        QTest::newRow("a deep level") << preset({"--step-down", "10"}) << "step_down_mm";
        QTest::newRow("a wide step") << preset({"--step-over", "4"}) << "step_over_mm";
        QTest::newRow("no such material") << preset({"--material", "unobtainium"}) << "unobtainium";
        QTest::newRow("no such preset") << QStringList{"tools", "preset", "own-6", "q", "--remove"} << "preset";
        QTest::newRow("no such library") << QStringList{"tools", "--library", "nowhere", "list"} << "nowhere";
        QTest::newRow("not in the library") << QStringList{"tools", "--library", "mine", "show", "ball-6"} << "ball-6";
        QTest::newRow("a reserved name") << QStringList{"tools", "new-library", "all"} << "all";
        QTest::newRow("a shipped tool is moved")
            << QStringList{"tools", "move", "flat-6", "--library", "mine"} << "--copy";
        QTest::newRow("into the starter library")
            << QStringList{"tools", "move", "own-6", "--library", "starter"} << "starter";
        QTest::newRow("no library stated") << QStringList{"tools", "move", "own-6"} << "library";
    }
    void badInputIsRefusedInOneSentence() {
        QFETCH(QStringList, arguments);
        QFETCH(QString, words);
        if (runBurin({"tools", "show", "own-6"}).status != 0) (void)answer({"tools", "copy", "flat-6", "own-6"});
        const QByteArray before = runBurin({"tools", "show", "own-6"}).output;
        const ProgramRun run = runBurin(arguments);
        QVERIFY2(run.status == 2 || run.status == 3, run.messages.constData());
        QVERIFY2(QString::fromUtf8(run.messages).contains(words), run.messages);
        QCOMPARE(run.messages.count('\n'), 1);
        QCOMPARE(runBurin({"tools", "show", "own-6"}).output, before);
    }

private:
    QString in(const char* name) const { return folder_.filePath(QString::fromLatin1(name)); }
    QString in(const QString& name) const { return folder_.filePath(name); }
    static QJsonObject answer(const QStringList& arguments) {
        const ProgramRun run = runBurin(arguments + QStringList{"--json"});
        if (run.status != 0) qWarning("%s", run.messages.constData());
        return run.json();
    }
    static QStringList listed(const QString& library) {
        QStringList ids;
        for (const QJsonValue& each : answer({"tools", "list", "--library", library})["tools"].toArray())
            ids << each["id"].toString();
        return ids;
    }
    static std::set<double> valuesOf(const QString& program, const char* word) {
        std::set<double> values;
        auto found = QRegularExpression(QString::fromLatin1(word)).globalMatch(withoutComments(program));
        while (found.hasNext()) values.insert(found.next().captured(1).toDouble());
        return values;
    }
    static QString withoutComments(QString program) {
        return program.remove(QRegularExpression("\\([^)]*\\)|;[^\\n]*"));
    }
    /// The heights at which the program cuts sideways: XY moves at feed after a height was set.
    static std::set<double> levelsOf(const QString& program) {
        std::set<double> levels;
        double z = 0.0;
        const QRegularExpression height("Z(-?[\\d.]+)"), motion("G0?([0-3])(?!\\d)");
        int mode = 0;
        for (const QString& line : withoutComments(program).split('\n')) {
            if (const auto found = motion.match(line); found.hasMatch()) mode = found.captured(1).toInt();
            const auto found = height.match(line);
            if (found.hasMatch()) z = found.captured(1).toDouble();
            if (mode > 0 && !found.hasMatch() && (line.contains('X') || line.contains('Y'))) levels.insert(z);
        }
        return levels;
    }

    QTemporaryDir folder_;
};

BURIN_TEST(ToolPresetsTest, QCoreApplication)

} // namespace burin::tst_tool_presets

#include "tst_tool_presets.moc"

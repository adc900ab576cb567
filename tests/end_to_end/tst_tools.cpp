// SPDX-FileCopyrightText: 2026 The Burin authors
// SPDX-License-Identifier: Apache-2.0
#include "program_run.h"

#include "tests/core/geometry/shapes.h"
#include "tests/places.h"
#include "tests/stl_text.h"
#include "tests/test_program.h"

#include <QCoreApplication>
#include <QDir>
#include <QFile>
#include <QJsonArray>
#include <QJsonDocument>
#include <QJsonObject>
#include <QProcess>
#include <QRegularExpression>
#include <QStandardPaths>
#include <QTemporaryDir>
#include <QTest>

#include <cmath>

namespace burin::tst_tools {

namespace {

QByteArray bar(const glm::dvec3& low, const glm::dvec3& high) {
    return testing::stlText(shapes::box(low, high));
}

} // namespace

/// The user's own tools, from files, from other tools and from models.
class ToolsTest : public QObject {
    Q_OBJECT
private slots:
    void initTestCase() {
        qputenv("XDG_DATA_HOME", folder_.path().toUtf8());
        flutes_ = write("bar.stl", bar({-3.0, -4.0, -5.0}, {3.0, 4.0, 15.0}));
    }

    /// The expected value is from Pythagoras: a rotating bar of 6 × 8 mm sweeps a cylinder of 10 mm.
    void aBarCutsAsTheCylinderThatItSweeps() {
        const QJsonObject made = answer({"tools", "shape", "bar", flutes_, "--like", "flat-10", "--number", "31"});
        QCOMPARE(made["diameter_mm"].toDouble(), 10.0);
        QCOMPARE(made["flute_length_mm"].toDouble(), 20.0);
        QCOMPARE(made["lift_mm"].toDouble(), 5.0);
        QVERIFY(made["excess_mm"].toDouble() < 1e-6);
        const QJsonObject shown = answer({"tools", "show", "bar"});
        QCOMPARE(shown["number"].toInt(), 31);
        QCOMPARE(shown["cutter"].toObject()["profile"].toArray().size(), 2);
        // It mills like the flat end mill with these dimensions: the same volume, to the last run unit.
        QJsonObject flat = answer({"tools", "show", "flat-10"}), cutter = flat["cutter"].toObject();
        for (const char* length : {"flute_length_mm", "stick_out_mm", "shank_diameter_mm"})
            cutter[length] = shown["cutter"].toObject()[length];
        flat["id"] = "long-flat";
        flat["cutter"] = cutter;
        const QString file = write("long-flat.json", QJsonDocument(flat).toJson());
        QCOMPARE(runBurin({"tools", "add", file}).status, 0);
        QCOMPARE(removedWith("bar"), removedWith("long-flat"));
    }

    void aShankOfItsOwn() {
        const QString shank = write("shank.stl", bar({-2.0, -2.0, 15.0}, {2.0, 2.0, 45.0}));
        (void)answer({"tools", "shape", "shanked", flutes_, "--shank", shank, "--like", "flat-10"});
        const QJsonObject cutter = answer({"tools", "show", "shanked"})["cutter"].toObject();
        QVERIFY(std::abs(cutter["shank_diameter_mm"].toDouble() - std::sqrt(32.0)) < 1e-9);
        QCOMPARE(cutter["stick_out_mm"].toDouble(), 50.0);
    }

    void toolsAreListedCopiedAndRemoved() {
        (void)answer({"tools", "copy", "ball-6", "my-ball", "--name", "My ball"});
        QSet<QString> own;
        const QJsonObject list = answer({"tools", "list"});
        for (const QJsonValue& each : list["tools"].toArray())
            if (each.toObject()["own"].toBool()) own << each.toObject()["id"].toString();
        QVERIFY(own.contains("my-ball") && !own.contains("ball-6"));
        // A program cannot contain two tools with the same number.
        QMap<int, int> numbers;
        for (const QJsonValue& each : list["tools"].toArray()) ++numbers[each.toObject()["number"].toInt()];
        QCOMPARE(numbers[answer({"tools", "show", "my-ball"})["number"].toInt()], 1);
        const QString file = write("again.json", runBurin({"tools", "show", "my-ball"}).output);
        QCOMPARE(runBurin({"tools", "remove", "my-ball"}).status, 0);
        QCOMPARE(runBurin({"tools", "add", file}).status, 0);
        QCOMPARE(runBurin({"tools", "remove", "my-ball"}).status, 0);
    }

    /// LinuxCNC's own interpreter reads every tool of the table, with its diameter in the machine's unit.
    void linuxcncReadsTheTable_data() {
        QTest::addColumn<QString>("units");
        QTest::newRow("mm") << "mm";
        QTest::newRow("inch") << "inch";
    }
    void linuxcncReadsTheTable() {
        if (QStandardPaths::findExecutable("rs274").isEmpty())
            QSKIP("rs274 (package linuxcnc-uspace) is not installed");
        QFETCH(QString, units);
        const QString table = folder_.filePath("tools.tbl");
        QStringList ids;
        QByteArray program = units == "inch" ? "G20\n" : "G21\n";
        QStringList wanted;
        const QJsonObject list = answer({"tools", "list"});
        for (const QJsonValue& each : list["tools"].toArray()) {
            const QJsonObject tool = each.toObject();
            if (tool["own"].toBool()) continue;
            ids << tool["id"].toString();
            const QString number = QString::number(tool["number"].toInt());
            program += "T" + number.toLatin1() + " M6\n(DEBUG,#5400 #5410)\n";
            wanted << QString("%1.000000 %2")
                          .arg(number)
                          .arg(tool["diameter_mm"].toDouble() / (units == "inch" ? 25.4 : 1.0), 0, 'f', 6);
        }
        QVERIFY(ids.size() >= 60);
        (void)answer(QStringList{"tools", "export"} + ids + QStringList{"-o", table, "--units", units});
        QProcess interpreter;
        interpreter.setStandardInputFile(QProcess::nullDevice());
        interpreter.start("rs274", {"-g", "-t", table, write("all.ngc", program + "M2\n")});
        QVERIFY(interpreter.waitForFinished() && interpreter.exitCode() == 0);
        QStringList told;
        static const QRegularExpression message("MESSAGE\\(\"([^\"]*)\"\\)");
        auto found = message.globalMatch(QString::fromLocal8Bit(interpreter.readAllStandardOutput()));
        while (found.hasNext()) told << found.next().captured(1);
        QCOMPARE(told, wanted);
    }

    /// A tool bit as written by FreeCAD 1.0; notes say what it lacks.
    void aToolBitOfFreecadIsRead() {
        const QString file = write("bit.fctb", R"({"version": 2, "name": "Bull 8", "shape": "bullnose.fcstd",
            "shape-type": "Bullnose", "attribute": {"Flutes": "4", "Units": "Imperial"},
            "parameter": {"CuttingEdgeHeight": "0.5 in", "Diameter": "8.0000 mm", "Length": "50.00 mm",
            "ShankDiameter": "10 mm", "CornerRadius": "1.5 mm"}})");
        const QJsonObject added = answer({"tools", "add", file});
        QCOMPARE(added["id"].toString(), QString("bull-8"));
        QVERIFY(!added["notes"].toArray().isEmpty());
        const QJsonObject tool = answer({"tools", "show", "bull-8"}), cutter = tool["cutter"].toObject();
        QCOMPARE(tool["source"].toString(), QString("FreeCAD tool bit bit.fctb")); // without the folder it came from
        QCOMPARE(tool["flute_count"].toInt(), 4);
        QCOMPARE(cutter["type"].toString(), QString("bull_nose"));
        QCOMPARE(cutter["corner_radius_mm"].toDouble(), 1.5);
        QCOMPARE(cutter["flute_length_mm"].toDouble(), 12.7);
        QCOMPARE(cutter["shank_diameter_mm"].toDouble(), 10.0);
        QVERIFY(cutter["stick_out_mm"].toDouble() <= 50.0);
    }

    /// Everything that a tool bit can represent is restored.
    void aToolBitComesBack_data() {
        QTest::addColumn<QString>("id");
        for (const char* id : {"flat-6", "ball-6", "bull-10-r2", "drill-6.8", "chamfer-6"}) QTest::newRow(id) << id;
    }
    void aToolBitComesBack() {
        QFETCH(QString, id);
        const QString file = folder_.filePath("back.fctb");
        (void)answer({"tools", "export", id, "-o", file});
        const QJsonObject added = answer({"tools", "add", file, "--replace"});
        const QJsonObject before = answer({"tools", "show", id}),
                          after = answer({"tools", "show", added["id"].toString()});
        QCOMPARE(after["flute_count"], before["flute_count"]);
        QCOMPARE(after["name"], before["name"]);
        for (const char* key : {"type", "diameter_mm", "corner_radius_mm", "tip_diameter_mm", "taper_angle_deg",
                                "flute_length_mm", "shank_diameter_mm"})
            QCOMPARE(after["cutter"].toObject()[key], before["cutter"].toObject()[key]);
    }

    /// A library of another program: all tools that Burin can represent are imported, each with notes on assumed
    /// values; the others are listed.
    void aFusionLibraryIsImportedWholeOrNotAtAll() {
        const QString library = QStringLiteral(BURIN_FIXTURES "/tools/fusion.tools");
        const auto own = [this] {
            QStringList ids;
            for (const QJsonValue& each : answer({"tools", "list"})["tools"].toArray())
                if (each["own"].toBool()) ids << each["id"].toString();
            return ids;
        };
        const QStringList before = own();
        const QJsonObject tried = answer({"tools", "import", library, "--dry-run"});
        QCOMPARE(tried["tools"].toArray().size(), 6);
        QCOMPARE(tried["left_out"].toArray().size(), 3);
        QCOMPARE(own(), before);
        (void)answer({"tools", "import", library, "--like", "ball-6"});
        QCOMPARE(own().size(), before.size() + 6);
        const QJsonObject ball = answer({"tools", "show", "ball-3-mm-long"});
        QCOMPARE(ball["number"].toInt(), 7);
        QCOMPARE(ball["cutter"].toObject()["diameter_mm"].toDouble(), 3.0);
        // A shipped tool is not replaced by an imported one with its ID.
        QVERIFY(own().contains("bull-10-r2-2") && !own().contains("bull-10-r2"));
        // An ID that exists already stops the import of all tools.
        QCOMPARE(runBurin({"tools", "remove", "taper-3-deg"}).status, 0);
        const ProgramRun again = runBurin({"tools", "import", library});
        QVERIFY(again.status == 2 && again.messages.contains("--replace") && again.messages.count('\n') == 1);
        QVERIFY(!own().contains("taper-3-deg"));
        (void)answer({"tools", "import", library, "--replace"});
        QVERIFY(own().contains("taper-3-deg"));
        // The tools are exported again, for users of that program.
        const QString packed = folder_.filePath("own.tools");
        (void)answer(QStringList{"tools", "export"} + own() + QStringList{"-o", packed});
        QVERIFY(QFileInfo(packed).size() > 100);
        for (const QString& id : own())
            if (!before.contains(id)) QCOMPARE(runBurin({"tools", "remove", id}).status, 0);
    }

    void badInputIsRefusedInOneSentence_data() {
        QTest::addColumn<QStringList>("arguments");
        QTest::addColumn<QString>("words");
        TriangleMesh holed = shapes::box({-3.0, -4.0, 0.0}, {3.0, 4.0, 15.0});
        holed.triangles.pop_back();
        const QString open = write("open.stl", testing::stlText(holed));
        const QString wide = write("wide.stl", bar({-9.0, -9.0, 0.0}, {9.0, 9.0, 45.0}));
        const QString low = write("low.stl", bar({-1.0, -1.0, -9.0}, {1.0, 1.0, 2.0}));
        const auto shape = [](const QString& id, const QString& file) {
            return QStringList{"tools", "shape", id, file, "--like", "flat-10"};
        };
        QTest::newRow("a hole") << shape("x", open) << "open.stl";
        QTest::newRow("no file") << shape("x", "nothing.stl") << "nothing.stl";
        QTest::newRow("a shipped id") << shape("ball-6", flutes_) << "ball-6";
        QTest::newRow("no id") << shape("../x", flutes_) << "../x";
        QTest::newRow("a wide shank") << shape("x", flutes_) + QStringList{"--shank", wide} << "shank";
        QTest::newRow("a short shank") << shape("x", flutes_) + QStringList{"--shank", low} << "shank";
        QTest::newRow("no such tool") << QStringList{"tools", "show", "wand"} << "wand";
        const auto bit = [&](const char* name, const QByteArray& form, const QByteArray& parameters) {
            return QStringList{
                "tools", "add",
                write(name, R"({"name": "x", "shape": ")" + form + R"(", "parameter": {)" + parameters + "}}")};
        };
        QTest::newRow("a bit of another form") << bit("dovetail.fctb", "dovetail.fcstd", "") << "dovetail";
        QTest::newRow("a bit without diameter") << bit("none.fctb", "endmill.fcstd", "") << "Diameter";
        QTest::newRow("a unit that is none")
            << bit("unit.fctb", "endmill.fcstd", R"("Diameter": "5 furlong")") << "furlong";
        QTest::newRow("a form that no bit has")
            << QStringList{"tools", "export", "lollipop-6", "-o", folder_.filePath("x.fctb")} << "lollipop-6";
        QTest::newRow("two in one bit") << QStringList{"tools",  "export", "flat-6",
                                                       "ball-6", "-o",     folder_.filePath("x.fctb")}
                                        << "*.tbl";
        QTest::newRow("no archive") << QStringList{"tools", "import", write("broken.tools", "PK\x03\x04 no")}
                                    << "broken";
        QTest::newRow("an empty library")
            << QStringList{"tools", "import", write("empty.json", R"({"data": []})")} << "holds none";
        QTest::newRow("another ending") << QStringList{"tools", "export", "flat-6", "-o", folder_.filePath("x.txt")}
                                        << "x.txt";
        QTest::newRow("a shipped one stays") << QStringList{"tools", "remove", "ball-6"} << "ball-6";
    }
    void badInputIsRefusedInOneSentence() {
        QFETCH(QStringList, arguments);
        QFETCH(QString, words);
        const ProgramRun run = runBurin(arguments);
        QVERIFY(run.status == 2 || run.status == 3);
        QVERIFY2(QString::fromUtf8(run.messages).contains(words), run.messages);
        QCOMPARE(run.messages.count('\n'), 1);
        QVERIFY(!QFile::exists(folder_.filePath("burin/tools/x.json")));
        QVERIFY(!QFile::exists(folder_.filePath("x.fctb")));
    }

private:
    QString write(const char* name, const QByteArray& text) const {
        QFile file(folder_.filePath(name));
        if (file.open(QIODevice::WriteOnly)) file.write(text);
        return file.fileName();
    }
    static QJsonObject answer(const QStringList& arguments) {
        const ProgramRun run = runBurin(arguments + QStringList{"--json"});
        if (run.status != 0) qWarning("%s", run.messages.constData());
        return QJsonDocument::fromJson(run.output).object();
    }
    /// The volume, mm³, that a virtual operator removes from a block with a tool.
    double removedWith(const char* tool) const {
        const QString project = folder_.filePath(QString(tool) + ".burin");
        const QString model = BURIN_FIXTURES "/models/red-cube-blue-cylinder.step";
        if (answer({"embed", model, "-o", project, "--voxel", "0.5", "--margin", "4"}).isEmpty()) return -1.0;
        const QJsonObject milled = answer({"mill", project, "--tool", tool, "--fast"});
        return milled.isEmpty() ? -2.0 : milled["removed_mm3"].toDouble();
    }

    QTemporaryDir folder_;
    QString flutes_;
};

BURIN_TEST(ToolsTest, QCoreApplication)

} // namespace burin::tst_tools

#include "tst_tools.moc"

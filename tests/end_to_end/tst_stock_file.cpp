// SPDX-FileCopyrightText: 2026 The Burin authors
// SPDX-License-Identifier: Apache-2.0
#include "program_run.h"
#include "tests/test_program.h"

#include <QCoreApplication>
#include <QFile>
#include <QJsonArray>
#include <QTemporaryDir>
#include <QTest>

#include <algorithm>
#include <cmath>

namespace burin::tst_stock_file {

namespace {

constexpr int countX = 60, countY = 50, countZ = 40;
constexpr double edge = 0.5; // mm

/// A value for each voxel, in a pattern that has only short runs along each axis.
QByteArray pattern() {
    QByteArray values;
    for (int z = 0; z < countZ; ++z)
        for (int y = 0; y < countY; ++y)
            for (int x = 0; x < countX; ++x) values.append(static_cast<char>((x * 7 + y * 13 + z * 29) / 16 % 4 * 10));
    return values;
}

QByteArray dataOf(const QString& nrrd) {
    QFile file(nrrd);
    if (!file.open(QIODevice::ReadOnly)) return {};
    const QByteArray all = file.readAll();
    return all.mid(all.indexOf("\n\n") + 2);
}

} // namespace

/// A stock described by a file: scans, castings, the result of another clamping.
class StockFileTest : public QObject {
    Q_OBJECT
private slots:
    void initTestCase() {
        qputenv("XDG_DATA_HOME", folder_.path().toUtf8());
        write("ct.nrrd", "NRRD0004\ntype: uint8\ndimension: 3\nspace dimension: 3\nsizes: 60 50 40\nspacings: 0.5 0.5 "
                         "0.5\nspace units: \"mm\" \"mm\" \"mm\"\nencoding: raw\n\n" +
                             pattern());
        write("table.json", R"({"entries": [{"value": 0, "material": null}, {"value": 10, "material": "beech"},
            {"value": 20, "material": "machinable-wax"}, {"value": 30, "material": "pu-foam"}]})");
    }

    /// Chen & Yang 2004, section 2: voxels with a property each are imported, milled and exported.
    void voxelsAreLosslessWhereNothingWasMilled() {
        QCOMPARE(embed({"--free-carving", "--stock-file", in("ct.nrrd"), "--stock-table", in("table.json")}), 0);
        QCOMPARE(exported(), pattern()); // before milling: every voxel
        QCOMPARE(runBurin({"mill", in("p.burin"), "--fast", "--seconds", "6"}).status, 0);
        const QByteArray before = pattern(), after = exported();
        int changed = 0, deepest = countZ;
        for (int i = 0; i < before.size(); ++i) {
            if (after[i] == before[i]) continue;
            QCOMPARE(after[i], char(0)); // never another material
            ++changed;
            deepest = std::min(deepest, i / (countX * countY));
        }
        QVERIFY(changed > 1000);
        // The lowest position of the tool's tip in the recording.
        QVERIFY(std::abs(deepest * edge - lowestTip()) <= edge);
    }

    /// A cube of 10 mm in a larger block that represents a casting; the volumes are closed formulas.
    void aPartIsMilledFromASolidOfAnotherFile() {
        QCOMPARE(runBurin({"embed", "-o", in("block.burin"), "--free-carving", "--stock-box", "-2,-3,0,13,14,12",
                           "--material", "oak", "--voxel", "0.25"})
                     .status,
                 0);
        for (const char* name : {"block.stl", "block.srle"})
            QCOMPARE(runBurin({"volume", "export", in("block.burin"), "--stock", "-o", in(name)}).status, 0);
        for (const char* name : {"block.stl", "block.srle"}) {
            const QJsonObject answer = embedded(
                {BURIN_FIXTURES "/models/cube.brep", "--voxel", "0.25", "--material", "oak", "--stock-file", in(name)});
            QVERIFY(std::abs(answer["part_volume_mm3"].toDouble() / 1000.0 - 1.0) < 1e-3);
            // The edges of an exported surface are bevelled by the voxels.
            QVERIFY(std::abs(answer["stock_volume_mm3"].toDouble() / (15.0 * 17.0 * 12.0 - 1000.0) - 1.0) < 5e-3);
            QCOMPARE(answer["stock_form"].toString(), QString("file"));
        }
    }

    void badInputIsRefusedInOneSentence_data() {
        QTest::addColumn<QStringList>("arguments");
        QTest::addColumn<QString>("words");
        const auto row = [](const char* name, const QStringList& arguments, const char* words) {
            QTest::newRow(name) << arguments << QString::fromLatin1(words);
        };
        write("few.json", R"({"entries": [{"value": 0, "material": null}, {"value": 10, "material": "beech"}]})");
        write("air.json", R"({"entries": [{"from": 0, "to": 255, "material": null}]})");
        write("soft.json", R"({"entries": [{"from": 0, "to": 255, "material": {"id": "mist", "name": "Mist",
            "colour": [1, 2, 3], "machinability": "machinable", "values": {}}}]})");
        write("noise.bin", "no model, and no volume either");
        row("no table", {"--stock-file", in("ct.nrrd")}, "--stock-table");
        row("a value without an entry", {"--stock-file", in("ct.nrrd"), "--stock-table", in("few.json")}, "\"20\"");
        row("nothing but air", {"--stock-file", in("ct.nrrd"), "--stock-table", in("air.json")}, "air all over");
        row("a material without K", {"--stock-file", in("ct.nrrd"), "--stock-table", in("soft.json")}, "mist");
        row("no file", {"--stock-file", in("none.nrrd")}, "none.nrrd");
        row("another kind of file", {"--stock-file", in("noise.bin")}, "no format that Burin reads");
        row("form without a file", {"--stock", "file"}, "--stock-file");
    }
    void badInputIsRefusedInOneSentence() {
        QFETCH(QStringList, arguments);
        QFETCH(QString, words);
        const QString project = in("bad.burin");
        const ProgramRun run = runBurin(QStringList{"embed", "-o", project, "--free-carving"} + arguments);
        QVERIFY(run.status == 2 || run.status == 3);
        QVERIFY2(QString::fromUtf8(run.messages).contains(words), run.messages);
        QCOMPARE(run.messages.count('\n'), 1);
        QVERIFY(!QFile::exists(project));
    }

private:
    QString in(const char* name) const { return folder_.filePath(name); }
    void write(const char* name, const QByteArray& content) {
        QFile file(in(name));
        QVERIFY(file.open(QIODevice::WriteOnly));
        QCOMPARE(file.write(content), content.size());
    }
    int embed(const QStringList& arguments) {
        return runBurin(QStringList{"embed", "-o", in("p.burin"), "--replace"} + arguments).status;
    }
    QJsonObject embedded(const QStringList& arguments) {
        const ProgramRun run = runBurin(QStringList{"embed", "-o", in("p.burin"), "--replace", "--json"} + arguments);
        if (run.status != 0) qWarning("%s", run.messages.constData());
        return run.json();
    }
    /// The exported voxels as values of the imported array, converted by their materials.
    QByteArray exported() {
        if (runBurin({"volume", "export", in("p.burin"), "-o", in("out.nrrd")}).status != 0) return {};
        QByteArray values = dataOf(in("out.nrrd"));
        for (char& value : values) value = static_cast<char>(value * 10); // the table has the order of the entries
        return values;
    }
    double lowestTip() {
        const ProgramRun table = runBurin({"path", in("p.burin"), "take", "1", "-o", in("take.csv")});
        if (table.status != 0) qWarning("%s", table.messages.constData());
        QFile file(in("take.csv"));
        if (!file.open(QIODevice::ReadOnly)) return 0.0;
        double lowest = 1e9;
        qsizetype column = -1;
        for (const QByteArray& line : file.readAll().split('\n')) {
            const QList<QByteArray> cells = line.split(',');
            if (column < 0)
                column = cells.indexOf("tool_z_mm");
            else if (column < cells.size())
                lowest = std::min(lowest, cells[column].toDouble());
        }
        return lowest;
    }
    QTemporaryDir folder_;
};

BURIN_TEST(StockFileTest, QCoreApplication)

} // namespace burin::tst_stock_file

#include "tst_stock_file.moc"

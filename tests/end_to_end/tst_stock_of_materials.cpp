// SPDX-FileCopyrightText: 2026 The Burin authors
// SPDX-License-Identifier: Apache-2.0
#include "program_run.h"
#include "tests/test_program.h"

#include <QCoreApplication>
#include <QDir>
#include <QFile>
#include <QJsonArray>
#include <QTemporaryDir>
#include <QTest>

#include <array>
#include <cmath>
#include <set>

namespace burin::tst_stock_of_materials {

namespace {

/// Two solids: a cube of 10 mm and a cylinder of 10 mm diameter and length.
const QString model = BURIN_FIXTURES "/models/red-cube-blue-cylinder.step";

double volumeOf(const QJsonObject& answer, const QString& id) {
    for (const QJsonValue& each : answer["materials"].toArray())
        if (each.toObject()["id"].toString() == id) return each.toObject()["volume_mm3"].toDouble();
    return -1.0;
}

} // namespace

/// A job with a stock of several materials, from the command line to the program.
class StockOfMaterialsTest : public QObject {
    Q_OBJECT
private slots:
    void initTestCase() { qputenv("XDG_DATA_HOME", folder_.path().toUtf8()); }

    void volumesAreThoseOfTheSolids_data() {
        QTest::addColumn<QString>("box");
        for (int phase = 0; phase < 8; ++phase) { // with the grid offset by half a voxel or not, along each axis
            const auto corner = [phase](int axis, double at) {
                return QString::number(at - ((phase >> axis & 1) != 0 ? 0.025 : 0.0));
            };
            QStringList corners;
            for (const auto& [x, y, z] : {std::array{-11.0, -1.0, -1.0}, std::array{16.0, 11.0, 11.0}})
                corners << corner(0, x) << corner(1, y) << corner(2, z);
            QTest::addRow("phase %d", phase) << corners.join(',');
        }
    }
    /// The oracle is OpenCASCADE's volumes of the solids; 0.2 % at a voxel of a two-hundredth of the shortest edge. A
    /// layer ends at the centre of a voxel, so each of its planes may be off by half a voxel.
    void volumesAreThoseOfTheSolids() {
        QFETCH(QString, box);
        const QJsonObject answer =
            embedded({"--voxel", "0.05", "--stock-box", box, "--role", "blue_cylinder=insert", "--body-material",
                      "blue_cylinder=brass-cuzn39pb3", "--layer", "Top=oak,z,10,", "--layer", "Left=pu-foam,x,,-10"});
        const QStringList corners = box.split(',');
        const auto at = [&](int place) { return corners[place].toDouble(); };
        const double pi = std::acos(-1.0), cylinder = pi * 25.0 * 10.0;
        QVERIFY2(std::abs(volumeOf(answer, "brass-cuzn39pb3") / cylinder - 1.0) < 0.002,
                 qPrintable(QString::number(volumeOf(answer, "brass-cuzn39pb3"))));
        QVERIFY(std::abs(volumeOf(answer, "aluminium-6061 (red_cube)") / 1000.0 - 1.0) < 0.002);
        // 27 × 12 × 12 mm; foam where X < -10, and in the remaining part oak where Z > 10.
        const double half = 0.025 * 1.001, foamed = -10.0 - at(0), topped = at(5) - 10.0, oak = at(3) + 10.0;
        QVERIFY(std::abs(volumeOf(answer, "pu-foam") - foamed * 144.0) <= half * 144.0);
        QVERIFY(std::abs(volumeOf(answer, "oak") - oak * 12.0 * topped) <= half * 12.0 * (oak + topped));
        double sum = 0.0;
        for (const QJsonValue& each : answer["materials"].toArray()) sum += each.toObject()["volume_mm3"].toDouble();
        QVERIFY(std::abs(sum / (27.0 * 12.0 * 12.0) - 1.0) < 1e-4);
    }

    /// The program changes its feed at the borders, and the same job gives the same text.
    void theProgramIsFedByMaterial() {
        QByteArray first;
        for (const char* name : {"one.burin", "two.burin"}) {
            const QString project = folder_.filePath(name);
            embedded({"--voxel", "0.5", "--margin", "4", "--role", "blue_cylinder=insert", "--body-material",
                      "blue_cylinder=brass-cuzn39pb3", "--layer", "Foam=pu-foam,x,,-3", "--grade",
                      "Foam:specific_cutting_energy=0.01+0.001*(Z+5)"},
                     project);
            QCOMPARE(runBurin({"mill", project, "--fast"}).status, 0);
            QCOMPARE(runBurin({"path", project, "new"}).status, 0);
            const QString program = folder_.filePath("program.ngc");
            QFile::remove(program);
            const ProgramRun posted = runBurin({"post", project, "-o", program, "--override", "a test of feeds"});
            QVERIFY2(posted.status == 0, posted.messages);
            const QByteArray text = contentOf(program).toUtf8();
            QVERIFY(text.contains("Brass CuZn39Pb3"));
            std::set<QByteArray> feeds;
            for (const QByteArray& line : text.split('\n'))
                if (const auto at = line.indexOf('F'); at >= 0 && line.startsWith('G')) feeds.insert(line.mid(at));
            QVERIFY(feeds.size() >= 3);
            if (first.isEmpty()) first = text;
            QVERIFY2(text == first, "the same job posted another text");
        }
    }

    void badInputIsRefusedInOneSentence_data() {
        QTest::addColumn<QStringList>("arguments");
        QTest::addColumn<QString>("words");
        const auto row = [](const char* name, const QStringList& arguments, const char* words) {
            QTest::newRow(name) << arguments << QString::fromLatin1(words);
        };
        row("no part", {"--role", "red_cube=insert", "--role", "blue_cylinder=ignored"}, "role is part");
        row("no such body", {"--role", "red=insert"}, "red_cube");
        row("no such role", {"--role", "red_cube=cutter"}, "protected-insert");
        row("no such material", {"--layer", "A=unobtainium,z,5,"}, "unobtainium");
        row("division by zero", {"--layer", "A=oak,z,5,", "--grade", "A:density=1/(Z-7)"}, "1/(Z-7)");
        row("no formula", {"--layer", "A=oak,z,5,", "--grade", "A:density=1/("}, "1/(");
        row("no such layer", {"--grade", "B:density=Z"}, "B");
        row("no such value", {"--layer", "A=oak,z,5,", "--grade", "A:taste=Z"}, "taste");
        row("planes the wrong way", {"--layer", "A=oak,z,5,1"}, "5 to 1 mm");
        row("a stock of solids without one", {"--stock", "solids"}, "role stock");
        row("a flat box", {"--stock-box", "0,0,0,10,10,0"}, "second corner");
        row("a part out of a round stock", {"--stock-cylinder", "0,5,5,1,0,0,5,40"}, "reaches out");
    }
    void badInputIsRefusedInOneSentence() {
        QFETCH(QStringList, arguments);
        QFETCH(QString, words);
        const QString project = folder_.filePath("bad.burin");
        const ProgramRun run = runBurin(QStringList{"embed", model, "-o", project, "--voxel", "0.5"} + arguments);
        QVERIFY(run.status == 2 || run.status == 3);
        QVERIFY2(QString::fromUtf8(run.messages).contains(words), run.messages);
        QCOMPARE(run.messages.count('\n'), 1);
        QVERIFY(!QFile::exists(project));
    }

    /// Figure 13b of the paper.
    void freeCarvingSaysThatNothingPushesBack() {
        const QString project = folder_.filePath("free.burin");
        const ProgramRun run = runBurin({"embed", "-o", project, "--free-carving", "--stock-box", "0,0,0,40,30,20",
                                         "--material", "machinable-wax", "--voxel", "0.5"});
        QCOMPARE(run.status, 0);
        QVERIFY2(run.output.contains("nothing pushes the tool back"), run.output);
        QCOMPARE(runBurin({"mill", project, "--fast", "--seconds", "5"}).status, 0);
        QVERIFY(runBurin({"embed", "-o", folder_.filePath("none.burin")}).status == 2);
    }

private:
    QJsonObject embedded(const QStringList& arguments, QString project = {}) {
        if (project.isEmpty()) project = folder_.filePath("p.burin");
        const ProgramRun run = runBurin(QStringList{"embed", model, "-o", project, "--replace", "--json"} + arguments);
        if (run.status != 0) qWarning("%s", run.messages.constData());
        return run.json();
    }
    QTemporaryDir folder_;
};

BURIN_TEST(StockOfMaterialsTest, QCoreApplication)

} // namespace burin::tst_stock_of_materials

#include "tst_stock_of_materials.moc"

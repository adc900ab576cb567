// SPDX-FileCopyrightText: 2026 The Burin authors
// SPDX-License-Identifier: Apache-2.0
#include "plate_with_holes.h"
#include "program_run.h"

#include "core/base/csv.h"
#include "core/base/units.h"
#include "tests/test_program.h"

#include <QCoreApplication>
#include <QJsonArray>
#include <QRegularExpression>
#include <QSet>
#include <QTemporaryDir>
#include <QTest>

#include <algorithm>
#include <cmath>

namespace burin::tst_faces {

using namespace burin::test;

/// The faces of a plate made with OpenCASCADE, after a program that is deliberately wrong on one of them.
class FacesTest : public QObject {
    Q_OBJECT
private slots:
    /// A plate of 80 x 50 x 12 mm with a round pocket of 20 mm, 6 mm deep, in its middle; 1 mm of stock around it.
    void initTestCase() {
        QVERIFY(writePlate(in("plate.brep").toStdString(), {{40.0, 25.0, 20.0, 6.0, 13.0}}, {}));
        QCOMPARE(runBurin({"embed", in("plate.brep"), "-o", in("p.burin"), "--voxel", "0.5", "--margin", "1"}).status,
                 0);
        // The program zero is the middle of the stock's top, so the floor of the pocket is at Z-7. A cutter of 10 mm on
        // a circle of 3 mm stays 2 mm away from the wall, and is 0.3 mm too deep.
        QFile program(in("deep.ngc"));
        QVERIFY(program.open(QIODevice::WriteOnly));
        program.write("G21 G90 G17 G94 G54\nT1 M6\nM3 S9000\nG0 X3 Y0\nZ5\n");
        for (const char* depth : {"-2", "-4", "-6", "-7.3"})
            program.write(QByteArray("G1 Z") + depth + " F200\nG3 X3 Y0 I-3 J0 F400\n");
        program.write("G1 X0 Y0\nG0 Z20\nM30\n");
    }

    void oneFaceAloneIsGouged() {
        const ProgramRun run = verify({"--faces", "--json"});
        QVERIFY2(run.status == 1, run.messages.constData()); // because of the gouge
        const QJsonArray faces = run.json()["faces"].toArray();
        QCOMPARE(faces.size(), 8);
        const QJsonObject worst = faces[0].toObject();
        QCOMPARE(worst["kind"].toString(), QStringLiteral("plane"));
        near(worst["area_mm2"], 100.0 * pi, 1e-3);
        near(worst["gouge_max_mm"], 0.3, 0.002);
        near(worst["gouge_place_mm"][2], 6.0, 0.01); // on the floor, in the frame of the setup
        QVERIFY(worst["gouge"].toDouble() > 0.0);    // the track of the tip alone is marked
        QSet<int> numbers;
        int planes = 0, cylinders = 0;
        for (const QJsonValue& each : faces) {
            const QJsonObject face = each.toObject();
            numbers.insert(face["face"].toInt());
            ++(face["kind"].toString() == "cylinder" ? cylinders : planes);
            if (face["samples"].toInt() > 0)
                near(face["in_tolerance"].toDouble() + face["gouge"].toDouble() + face["excess"].toDouble() +
                         face["unreachable"].toDouble(),
                     1.0, 1e-9);
            if (face["face"] == worst["face"]) continue;
            near(face["gouge_max_mm"], 0.0, 0.0);
            QVERIFY(face["gouge_place_mm"].isNull());
            if (face["kind"].toString() != "cylinder") continue;
            near(face["diameter_mm"], 20.0, 1e-9);
            near(face["area_mm2"], 120.0 * pi, 1e-3);
            near(face["excess_max_mm"], 2.0, 0.5); // stock left at the wall, with voxels of 0.5 mm
            near(face["in_tolerance"], 0.0, 0.02);
        }
        QCOMPARE(numbers.size(), 8);
        QVERIFY(numbers.contains(1) && numbers.contains(8));
        QCOMPARE(planes, 7);
        QCOMPARE(cylinders, 1);
    }

    /// 1 mm of stock stays on the sides: with that as the allowance they are in tolerance.
    void whatIsMeantToStayIsInTolerance() {
        for (const auto& [allowance, share] : {std::pair("0", 0.0), std::pair("1", 1.0)}) {
            const QJsonArray faces = verify({"--faces", "--json", "--allowance", allowance}).json()["faces"].toArray();
            int sides = 0;
            for (const QJsonValue& each : faces) {
                const QJsonObject face = each.toObject();
                const double area = face["area_mm2"].toDouble();
                if (std::abs(area - 960.0) > 1e-3 && std::abs(area - 600.0) > 1e-3) continue;
                ++sides;
                near(face["in_tolerance"], share, 0.03);
            }
            QCOMPARE(sides, 4);
        }
    }

    void textAndTableSayTheSame() {
        const ProgramRun run = verify({"--face-table", in("faces.csv")});
        QCOMPARE(run.status, 1);
        const QStringList lines = QString::fromUtf8(run.output).split('\n').filter(QRegularExpression("^face +\\d"));
        QCOMPARE(lines.size(), 8);
        QVERIFY2(lines[0].contains("gouge  0.300 mm") && lines[0].endsWith("Plane"), qPrintable(lines[0]));
        QCOMPARE(lines.filter(QStringLiteral("Cylinder, Ø 20.000")).size(), 1);
        const std::string table = contentOf(in("faces.csv")).toStdString();
        std::string_view rest = table;
        const auto names = csvFields(takeLine(rest)).value();
        QCOMPARE(names[5], std::string("gouge_max_mm"));
        const auto first = csvFields(takeLine(rest)).value();
        QVERIFY(lines[0].contains(QStringLiteral("face %1 ").arg(QString::fromStdString(first[0]), 4)));
        near(std::stod(first[5]), 0.3, 0.002);
        QCOMPARE(std::ranges::count(rest, '\n'), 7);
    }

    void anInputIsNeverReplaced() {
        const QString before = contentOf(in("deep.ngc"));
        const ProgramRun refused = verify({"--face-table", in("deep.ngc")});
        QCOMPARE(refused.status, 2);
        QVERIFY2(refused.messages.contains("--face-table"), refused.messages.constData());
        QCOMPARE(contentOf(in("deep.ngc")), before);
    }

private:
    QString in(const char* name) const { return folder_.filePath(name); }
    ProgramRun verify(const QStringList& further) const {
        return runBurin(
            QStringList{"verify", in("deep.ngc"), "--project", in("p.burin"), "--tool", "flat-10", "--excess", "0"} +
            further);
    }
    static void near(const QJsonValue& value, double wanted, double within) {
        QVERIFY2(std::abs(value.toDouble(1e9) - wanted) <= within,
                 qPrintable(QString("%1 instead of %2").arg(value.toDouble(1e9), 0, 'g', 10).arg(wanted, 0, 'g', 10)));
    }

    QTemporaryDir folder_;
};

BURIN_TEST(FacesTest, QCoreApplication)

} // namespace burin::tst_faces

#include "tst_faces.moc"

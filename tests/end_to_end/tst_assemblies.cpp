// SPDX-FileCopyrightText: 2026 The Burin authors
// SPDX-License-Identifier: Apache-2.0
#include "program_run.h"
#include "tests/test_program.h"

#include <QCoreApplication>
#include <QJsonArray>
#include <QTemporaryDir>
#include <QTest>

#include <cmath>

namespace burin::tst_assemblies {

namespace {

/// The assembly "Root" of three parts (README there).
const QString assembly = BURIN_FIXTURES "/models/mayo-332.stp";
/// States inches: 127 x 63.5 x 34.925 mm, which are 5 x 2.5 x 1.375 inches.
const QString inches = BURIN_FIXTURES "/models/featuretype.step";

double volumeOf(const QJsonObject& model) {
    return model["volume_mm3"].toDouble();
}

} // namespace

/// Assemblies and units on the command line.
class AssembliesTest : public QObject {
    Q_OBJECT
    QTemporaryDir folder_;
    QString in(const QString& name) const { return folder_.filePath(name); }

private slots:
    void theTreeIsListed() {
        const ProgramRun run = runBurin({"import", assembly});
        QVERIFY2(run.status == 0, run.messages.constData());
        QVERIFY2(run.output.contains("\n  assembly Root: 3 bodies, "), run.output.constData());
        for (const char* part : {"Part 1", "Part 2", "Part 3"})
            QVERIFY2(run.output.contains(QByteArray("\n    body     ") + part + ": "), run.output.constData());
        const QJsonObject model = runBurin({"import", assembly, "--json"}).json();
        const QJsonObject root = model["assemblies"].toArray()[0].toObject();
        QCOMPARE(root["path"].toString(), QString("Root"));
        QCOMPARE(root["bodies"].toInt(), 3);
        QCOMPARE(root["volume_mm3"].toDouble(), volumeOf(model));
        QCOMPARE(model["bodies"].toArray()[1].toObject()["name"].toString(), QString("Root/Part 2"));
    }

    void aRoleIsThatOfAWholeAssembly() {
        const QStringList embed{"embed", assembly, "-o", in("a.burin"), "--voxel", "0.5", "--json"};
        const QJsonObject one = runBurin(embed + QStringList{"--role", "Root=ignored", "--role", "Root/Part 1=part",
                                                             "--colour", "Root=#3070c0"})
                                    .json();
        const QJsonObject roles = one["roles"].toObject();
        QCOMPARE(roles["Root/Part 1"].toString(), QString("part"));
        QCOMPARE(roles["Root/Part 2"].toString(), QString("ignored"));
        QCOMPARE(roles["Root/Part 3"].toString(), QString("ignored"));
        const QJsonArray bodies =
            runBurin({"info", in("a.burin"), "--json"}).json()["model"].toObject()["bodies"].toArray();
        for (const QJsonValue& body : bodies) QCOMPARE(body.toObject()["colour"].toArray(), (QJsonArray{48, 112, 192}));
        const ProgramRun info = runBurin({"info", in("a.burin")});
        QVERIFY2(info.output.contains("assembly Root: 3 bodies"), info.output.constData());
        QVERIFY2(info.output.contains("role     Root/Part 3: ignored"), info.output.constData());
        const ProgramRun wrong = runBurin(embed + QStringList{"--role", "Roof=fixture"});
        QVERIFY2(wrong.status != 0 && wrong.messages.contains("Roof"), wrong.messages.constData());
    }

    /// The volume is that of the stated size, divided by the cube of the units' ratio.
    void aUnitIsReplacedAndStays() {
        const double stated = volumeOf(runBurin({"import", inches, "--json"}).json());
        const ProgramRun text = runBurin({"import", inches, "--unit", "mm"});
        QVERIFY2(text.output.contains("unit mm"), text.output.constData());
        QVERIFY2(text.output.contains("stated   unit inch: 127.000 x 63.500 x 34.925 mm"), text.output.constData());
        QCOMPARE(
            runBurin({"embed", inches, "-o", in("u.burin"), "--voxel", "0.05", "--margin", "1", "--unit", "mm"}).status,
            0);
        const auto model = [this] { return runBurin({"info", in("u.burin"), "--json"}).json()["model"].toObject(); };
        QVERIFY(std::abs(volumeOf(model()) * std::pow(25.4, 3.0) / stated - 1.0) < 1e-6);
        QCOMPARE(model()["unit_scale_mm"].toDouble(), 1.0);
        QCOMPARE(model()["stated_unit_scale_mm"].toDouble(), 25.4);
        QCOMPARE(model()["unit"].toString(), QString("inch"));
        const ProgramRun same = runBurin({"setup", in("u.burin"), "--update-part", inches});
        QVERIFY2(same.messages.contains("the part has not changed"), same.messages.constData());
        // Without a file it is the one of before.
        const ProgramRun again = runBurin({"setup", in("u.burin"), "--unit", "cm"});
        QVERIFY2(again.status == 0, again.messages.constData());
        QVERIFY(std::abs(volumeOf(model()) * std::pow(2.54, 3.0) / stated - 1.0) < 1e-6);
        QCOMPARE(runBurin({"setup", in("u.burin"), "--unit", "stated"}).status, 0);
        QVERIFY(std::abs(volumeOf(model()) / stated - 1.0) < 1e-9);
        QVERIFY(model()["size_in_stated_unit_mm"].isNull());
    }

    void aUnitThatIsNoneIsRefused() {
        const ProgramRun run = runBurin({"import", inches, "--unit", "cubit"});
        QVERIFY(run.status != 0);
        QVERIFY2(run.messages.contains("cubit") && run.messages.count('\n') == 1, run.messages.constData());
    }
};

BURIN_TEST(AssembliesTest, QCoreApplication)

} // namespace burin::tst_assemblies

#include "tst_assemblies.moc"

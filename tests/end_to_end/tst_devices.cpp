// SPDX-FileCopyrightText: 2026 The Burin authors
// SPDX-License-Identifier: Apache-2.0
#include "core/document/project.h"
#include "program_run.h"
#include "tests/test_program.h"

#include <QCoreApplication>
#include <QDir>
#include <QJsonArray>
#include <QTemporaryDir>
#include <QTest>

namespace burin::tst_devices {

/// A vendor's device used from the command line, with a stand-in for the vendor's library.
class DevicesTest : public QObject {
    Q_OBJECT
    QTemporaryDir folder_;
    QString in(const QString& name) const { return folder_.filePath(name); }

private slots:
    void initTestCase() {
        QVERIFY(QDir().mkpath(in("config")));
        QFile file(in("config/Default Device.config"));
        QVERIFY(file.open(QIODevice::WriteOnly));
        qputenv("GTDD_HOME", folder_.path().toUtf8());
        qputenv("OH_SDK_BASE", BURIN_BUILD_DIRECTORY "/stand-ins/openhaptics");
        qputenv("BURIN_STAND_IN_TOUCH", "1");
    }

    void itIsListedWithItsLimits() {
        const ProgramRun run = runBurin({"devices", "--json"});
        QCOMPARE(run.status, 0);
        const QJsonArray devices = run.json()["devices"].toArray();
        QCOMPARE(devices.size(), 2);
        const QJsonObject touch = devices[1].toObject();
        QCOMPARE(touch["id"].toString(), QString("openhaptics:Default Device"));
        QCOMPARE(touch["limits"]["force_max_n"]["value"].toDouble(), 3.3);
        QVERIFY(touch["self_paced"].toBool());
        for (const QJsonValue& driver : run.json()["drivers"].toArray())
            if (driver["id"] == "force_dimension") QVERIFY(driver["fault"].toString().contains("libdrd.so"));
    }

    void itIsTested() {
        const ProgramRun run = runBurin(
            {"devices", "--test", "openhaptics:Default Device", "--seconds", "2.5", "--force", "0.5", "--json"});
        QVERIFY2(run.status == 0, run.messages.constData());
        const QJsonObject test = run.json()["test"].toObject();
        QVERIFY(test["readings"].toInt() > 100);
        QCOMPARE(test["buttons_pressed"].toInt(), 1);
        QCOMPARE(test["force_max_n"].toDouble(), 0.5);
        QVERIFY(std::abs(test["position_max_mm"][0].toDouble() - 10.0) < 0.1);
        QVERIFY(std::abs(test["position_min_mm"][1].toDouble() + 10.0) < 0.1);
        const ProgramRun text = runBurin({"devices", "--test", "3D Systems: Default Device", "--seconds", "1"});
        QVERIFY2(text.output.contains("Hz") && text.output.contains("Buttons pressed: 1"), text.output.constData());
    }

    void whatItMayNotDoIsRefused() {
        const ProgramRun much = runBurin({"devices", "--test", "3D Systems: Default Device", "--force", "1"});
        QCOMPARE(much.status, 2);
        QVERIFY2(much.messages.contains("0.66"), much.messages.constData());
        QCOMPARE(runBurin({"devices", "--test", "no such device"}).status, 2);
        QCOMPARE(runBurin({"devices", "--force", "1"}).status, 2);
        const ProgramRun mouse = runBurin({"devices", "--test", "simulated", "--seconds", "0.5"});
        QCOMPARE(mouse.status, 0);
    }

    void itMills() {
        QCOMPARE(runBurin({"embed", BURIN_FIXTURES "/models/cube.brep", "-o", in("p.burin"), "--voxel", "1", "--margin",
                           "5"})
                     .status,
                 0);
        const ProgramRun run = runBurin({"mill", in("p.burin"), "--stylus", "device:3D Systems: Default Device",
                                         "--tool", "ball-6", "--seconds", "2", "--felt", "0.25", "--json"});
        QVERIFY2(run.status == 0, run.messages.constData());
        QVERIFY2(run.output.contains("\"samples\""), run.output.constData());
        QCOMPARE(run.json()["felt"].toObject()["gain"].toDouble(), 0.25);
        QCOMPARE(run.json()["guides"].toInt(), 0);
    }

    /// The device moves along a circle through a plane that is stored as a guide.
    void theProjectsGuidesHoldIt() {
        const std::string file = in("p.burin").toStdString();
        Guide plane;
        plane.on = true;
        plane.direction = {1.0, 0.0, 0.0};
        {
            Result<Project> project = Project::open(file);
            QVERIFY(project.hasValue());
            const Result<Take> before = project->take(1);
            QVERIFY(before.hasValue());
            plane.point = before->samples.front().stylusTip;
            KeptGuides kept;
            kept.guides = {plane};
            QVERIFY(project->setGuides(kept).hasValue());
            QVERIFY(project->save().hasValue());
        }
        const QStringList mill{"mill",      in("p.burin"), "--stylus", "device:3D Systems: Default Device",
                               "--seconds", "2",           "--json"};
        const ProgramRun held = runBurin(mill), free = runBurin(QStringList(mill) << "--no-guides");
        QVERIFY2(held.status == 0, held.messages.constData());
        QCOMPARE(held.json()["guides"].toInt(), 1);
        QCOMPARE(free.json()["guides"].toInt(), 0);
        const Result<Project> project = Project::open(file);
        QVERIFY(project.hasValue());
        // The number of ticks in which the tool was nearer to the plane than the device.
        const auto heldSamples = [&](std::int64_t take) {
            const Result<Take> recorded = project->take(take);
            std::size_t count = 0;
            if (!recorded) return count;
            for (const Sample& sample : recorded->samples) {
                const double tool = std::abs(sample.proxy.tip.x - plane.point.x);
                const double hand = std::abs(sample.stylusTip.x - plane.point.x);
                if ((sample.flags & sampleOnGuide) != 0 && tool < hand - 0.01) ++count;
            }
            return count;
        };
        QVERIFY2(heldSamples(2) > 100, qPrintable(QString::number(heldSamples(2))));
        QCOMPARE(heldSamples(3), std::size_t{0});
    }
};

BURIN_TEST(DevicesTest, QCoreApplication)

} // namespace burin::tst_devices

#include "tst_devices.moc"

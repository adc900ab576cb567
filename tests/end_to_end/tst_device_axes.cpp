// SPDX-FileCopyrightText: 2026 The Burin authors
// SPDX-License-Identifier: Apache-2.0
#include "program_run.h"
#include "tests/plugins/spacenav_daemon.h"
#include "tests/test_program.h"

#include <QCoreApplication>
#include <QDir>
#include <QJsonArray>
#include <QTemporaryDir>
#include <QTest>

#include <chrono>
#include <cmath>
#include <thread>

namespace burin::tst_device_axes {

/// The axes of a 3D mouse, assigned and calibrated from the command line, with a stand-in for spacenavd.
class DeviceAxesTest : public QObject {
    Q_OBJECT
    QTemporaryDir folder_;
    static constexpr const char* mouse = "spacenav:daemon";

    static QJsonObject axis(const ProgramRun& run, int number) {
        return run.json()["map"].toObject()["axes"].toArray()[number - 1].toObject();
    }
    /// The daemon takes the connection out of its queue afterwards: a full one would block the next program.
    static ProgramRun map(test::SpacenavDaemon& daemon, const QStringList& more = {}) {
        ProgramRun run = runBurin(QStringList{"devices", "--map", mouse, "--json"} + more);
        daemon.accept();
        return run;
    }

private slots:
    void initTestCase() {
        qputenv("SPNAV_SOCKET", folder_.filePath("spnav.sock").toUtf8());
        qputenv("XDG_CONFIG_HOME", folder_.filePath("config").toUtf8());
    }

    void anAssignmentIsKept() {
        test::SpacenavDaemon daemon(folder_.filePath("spnav.sock"));
        const ProgramRun first = map(daemon);
        QVERIFY2(first.status == 0, first.messages.constData());
        QVERIFY(first.json()["usual"].toBool());
        QCOMPARE(first.json()["map"].toObject()["axes"].toArray().size(), 6);
        QCOMPARE(axis(first, 1)["motion"].toString(), QString("x"));
        const ProgramRun changed = map(daemon, {"--axis", "1=z,reversed,gain=0.5,dead=0.1", "--axis", "3=none",
                                                "--button", "1=undo", "--button", "2=mill"});
        QVERIFY2(changed.status == 0, changed.messages.constData());
        const ProgramRun again = map(daemon);
        QVERIFY(!again.json()["usual"].toBool());
        QCOMPARE(axis(again, 1)["motion"].toString(), QString("z"));
        QVERIFY(axis(again, 1)["reversed"].toBool());
        QCOMPARE(axis(again, 1)["gain"].toDouble(), 0.5);
        QCOMPARE(axis(again, 1)["dead_zone"].toDouble(), 0.1);
        QCOMPARE(axis(again, 2), axis(first, 2)); // not named
        QCOMPARE(axis(again, 3)["motion"].toString(), QString("none"));
        QCOMPARE(again.json()["map"].toObject()["buttons"].toArray()[1].toString(), QString("mill"));
        const ProgramRun text = runBurin({"devices", "--map", mouse});
        daemon.accept();
        QVERIFY2(text.output.contains("1 right: Z, up, reversed; gain 0.50; dead zone 10.0 %"),
                 text.output.constData());
        QVERIFY2(text.output.contains("button 1: undo"), text.output.constData());
        const ProgramRun usual = map(daemon, {"--usual"});
        QVERIFY(usual.json()["usual"].toBool() && map(daemon).json()["usual"].toBool());
        QCOMPARE(axis(usual, 1), axis(first, 1));
    }

    void whatCannotBeIsRefusedAndChangesNothing_data() {
        QTest::addColumn<QStringList>("arguments");
        QTest::addColumn<QByteArray>("names");
        QTest::newRow("no such axis") << QStringList{"--axis", "9=x"} << QByteArray("from 1 to 6");
        QTest::newRow("no such motion") << QStringList{"--axis", "1=w"} << QByteArray("none, x, y, z, a, b, c");
        QTest::newRow("no number") << QStringList{"--axis", "1=x,gain=much"} << QByteArray("1=x,gain=much");
        QTest::newRow("too much") << QStringList{"--axis", "1=x,gain=99"} << QByteArray("0.05");
        QTest::newRow("no such button") << QStringList{"--button", "40=undo"} << QByteArray("from 1 to 32");
        QTest::newRow("no such action") << QStringList{"--button", "1=jump"} << QByteArray("mill, lift");
        QTest::newRow("nothing mills") << QStringList{"--button", "1=undo"} << QByteArray("that mills");
    }
    void whatCannotBeIsRefusedAndChangesNothing() {
        QFETCH(QStringList, arguments);
        QFETCH(QByteArray, names);
        test::SpacenavDaemon daemon(folder_.filePath("spnav.sock"));
        const ProgramRun run = map(daemon, arguments);
        QCOMPARE(run.status, 2);
        QVERIFY2((run.output + run.messages).contains(names), (run.output + run.messages).constData());
        QVERIFY(map(daemon).json()["usual"].toBool());
    }

    /// Noise of two readings, at rest off the centre; then 60 % to both sides.
    void aCalibrationIsMeasuredAndKept() {
        test::SpacenavDaemon daemon(folder_.filePath("spnav.sock"));
        std::thread hand([&daemon] {
            using namespace std::chrono_literals;
            daemon.accept();
            for (int i = 0; i < 90; ++i) { // 1.8 s
                daemon.send({0, i % 2 == 0 ? 40 : 60, 0, 0, 0, 0, 0, 16});
                std::this_thread::sleep_for(20ms);
            }
            std::this_thread::sleep_for(600ms);
            for (const int x : {100, 300, 0, -100, -300, 0}) {
                daemon.send({0, x, 0, 0, 0, 0, 0, 16});
                std::this_thread::sleep_for(40ms);
            }
        });
        const ProgramRun run = runBurin({"devices", "--calibrate", mouse, "--motion-seconds", "2", "--json"});
        hand.join();
        QVERIFY2(run.status == 0, run.messages.constData());
        QVERIFY(run.messages.contains("at rest") && run.messages.contains("both of its ends"));
        const QJsonObject seen = run.json()["measured"].toArray()[0].toObject();
        const double rest = seen["rest"].toDouble(), noise = seen["noise"].toDouble();
        QVERIFY2(std::abs(rest - 0.1) < 0.01 && std::abs(noise - 0.02) < 0.005, run.output.constData());
        QVERIFY(std::abs(seen["low"].toDouble() + 0.6) < 0.002 && std::abs(seen["high"].toDouble() - 0.6) < 0.002);
        const ProgramRun kept = map(daemon);
        QVERIFY(std::abs(axis(kept, 1)["rest"].toDouble() - rest) < 1e-9);
        QCOMPARE(axis(kept, 1)["low"].toDouble(), seen["low"].toDouble());
        const double range = seen["high"].toDouble() - rest; // the smaller side
        QVERIFY(std::abs(axis(kept, 1)["dead_zone"].toDouble() - 3.0 * noise / range) < 1e-6);
        QCOMPARE(axis(kept, 2)["low"].toDouble(), -1.0); // was not moved
        QVERIFY(map(daemon, {"--usual"}).json()["usual"].toBool());
    }

    void aDeviceThatIsNotThereIsNamed() {
        const ProgramRun run = runBurin({"devices", "--calibrate", mouse});
        QCOMPARE(run.status, 2);
        QVERIFY(run.messages.contains(mouse));
        QCOMPARE(runBurin({"devices", "--axis", "1=x"}).status, 2);
    }
};

BURIN_TEST(DeviceAxesTest, QCoreApplication)

} // namespace burin::tst_device_axes

#include "tst_device_axes.moc"

// SPDX-FileCopyrightText: 2026 The Burin authors
// SPDX-License-Identifier: Apache-2.0
#include "program_run.h"
#include "tests/test_program.h"

#include <QCoreApplication>
#include <QJsonArray>
#include <QTemporaryDir>
#include <QTest>

#include <cmath>

namespace burin::tst_pad_assist {

/// A gamepad that vibrates, used from the command line: a plugin of the user's, with a hand that presses it down.
class PadAssistTest : public QObject {
    Q_OBJECT
    QTemporaryDir folder_;
    QString in(const QString& name) const { return folder_.filePath(name); }

    /// The greatest contact, load, push and ceiling that the pad was asked to show.
    QList<double> shown() const {
        QList<double> values;
        for (const QString& value : contentOf(in("log")).simplified().split(' ')) values << value.toDouble();
        return values.size() == 4 ? values : QList<double>{-1.0, -1.0, -1.0, -1.0};
    }
    ProgramRun mill(const QStringList& more) const {
        return runBurin(QStringList{"mill", in("p.burin"), "--stylus", "device:Stand-in pad", "--tool", "ball-6",
                                    "--seconds", "3", "--json"} +
                        more);
    }

private slots:
    void initTestCase() {
        qputenv("XDG_DATA_HOME", BURIN_BUILD_DIRECTORY "/stand-ins/data");
        qputenv("XDG_CONFIG_HOME", in("config").toUtf8());
        qputenv("BURIN_STAND_IN_PAD_LOG", in("log").toUtf8());
    }

    void whatItCanDoIsListed() {
        const ProgramRun run = runBurin({"devices", "--json"});
        QCOMPARE(run.status, 0);
        QJsonObject pad;
        for (const QJsonValue& device : run.json()["devices"].toArray())
            if (device["id"] == "assist_pad:pad") pad = device["assist"].toObject();
        QCOMPARE(pad["rumble"].toBool(), true);
        QCOMPARE(pad["force_axes"].toInt(-1), 0);
        QCOMPARE(pad["permitted"].toBool(), true);
        QVERIFY(runBurin({"devices"}).output.contains("assist: vibrates"));
    }

    void itIsTestedWithinTheCeiling() {
        const QStringList test{"devices", "--test", "assist_pad:pad", "--seconds", "2", "--json"};
        const ProgramRun run = runBurin(QStringList(test) << "--assist"
                                                          << "0.4");
        QVERIFY2(run.status == 0, run.messages.constData());
        const double most = run.json()["test"].toObject()["assist_max"].toDouble();
        QVERIFY2(most > 0.3 && most <= 0.4, qPrintable(QString::number(most)));
        QVERIFY(std::abs(shown()[2] - most) < 1e-5);
        QCOMPARE(shown()[3], 0.4);
        const ProgramRun silent = runBurin(test);
        QCOMPARE(silent.json()["test"].toObject()["assist_max"].toDouble(), 0.0);
        QCOMPARE(shown()[3], 0.0);
    }

    void whatItMayNotDoIsRefused() {
        QCOMPARE(runBurin({"devices", "--test", "assist_pad:pad", "--assist", "1.5"}).status, 2);
        QCOMPARE(runBurin({"devices", "--assist", "0.5"}).status, 2);
        const ProgramRun mouse = runBurin({"devices", "--test", "simulated", "--assist", "0.5"});
        QCOMPARE(mouse.status, 2);
        QVERIFY2(mouse.messages.contains("test strength"), mouse.messages.constData());
    }

    /// The hand presses into the part: the strong motor shows it, within the ceiling.
    void itMills() {
        QCOMPARE(runBurin({"embed", BURIN_FIXTURES "/models/cube.brep", "-o", in("p.burin"), "--voxel", "1", "--margin",
                           "5"})
                     .status,
                 0);
        const ProgramRun usual = mill({});
        QVERIFY2(usual.status == 0, usual.messages.constData());
        QCOMPARE(usual.json()["assist"].toDouble(), 0.3);
        QVERIFY2(shown()[0] > 0.15 && shown()[0] <= 0.3 && shown()[3] == 0.3, qPrintable(contentOf(in("log"))));
        QVERIFY(shown()[1] > 0.0 && shown()[1] <= 0.3); // it cuts on its way
        const ProgramRun little = mill({"--assist", "0.1"});
        QVERIFY2(little.status == 0, little.messages.constData());
        QVERIFY2(shown()[0] > 0.05 && shown()[0] <= 0.1 && shown()[3] == 0.1, qPrintable(contentOf(in("log"))));
        const ProgramRun off = mill({"--assist", "0"});
        QVERIFY2(off.status == 0, off.messages.constData());
        QCOMPARE(shown(), (QList<double>{0.0, 0.0, 0.0, 0.0}));
        const ProgramRun planned = runBurin({"mill", in("p.burin"), "--tool", "ball-6", "--assist", "0.5"});
        QCOMPARE(planned.status, 2);
        QVERIFY2(planned.messages.contains("--assist"), planned.messages.constData());
    }
};

BURIN_TEST(PadAssistTest, QCoreApplication)

} // namespace burin::tst_pad_assist

#include "tst_pad_assist.moc"

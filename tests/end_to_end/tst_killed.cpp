// SPDX-FileCopyrightText: 2026 The Burin authors
// SPDX-License-Identifier: Apache-2.0
#include "program_run.h"

#include "tests/long_run.h"
#include "tests/places.h"
#include "tests/test_program.h"

#include <QCoreApplication>
#include <QElapsedTimer>
#include <QFile>
#include <QJsonArray>
#include <QTemporaryDir>
#include <QTest>

#include <chrono>
#include <csignal>

namespace burin::tst_killed {

/// A recording is ended by SIGKILL from outside, at a moment that Burin cannot know.
class KilledTest : public QObject {
    Q_OBJECT
private slots:
    void keepsAllButTheLast100Milliseconds_data();
    void keepsAllButTheLast100Milliseconds();
};

namespace {

double unixTime() {
    return std::chrono::duration<double>(std::chrono::system_clock::now().time_since_epoch()).count();
}

} // namespace

void KilledTest::keepsAllButTheLast100Milliseconds_data() {
    QTest::addColumn<int>("milliseconds"); // of recording before the kill
    QTest::newRow("in the middle of a pass") << 2150;
    if (!burin::testing::longRun()) return;
    QTest::newRow("early") << 700;
    QTest::newRow("later") << 3333;
}

void KilledTest::keepsAllButTheLast100Milliseconds() {
    QFETCH(int, milliseconds);
    QTemporaryDir folder;
    const QString project = folder.filePath("pocket.burin");
    QCOMPARE(runBurin({"embed", BURIN_FIXTURES "/models/pocket-test.stl", "-o", project, "--voxel", "1", "--material",
                       "tooling-board"})
                 .status,
             0);
    QProcess mill;
    mill.start(burinProgram(), {"mill", project, "--realtime", "--tool", "ball-6"});
    QVERIFY(mill.waitForStarted());
    // Recording begins when the take appears in the working copy; until then the clearance field of the part is built.
    double begun = 0.0;
    QElapsedTimer patience;
    patience.start();
    const QString journal = folder.filePath(".pocket.burin.working-wal");
    qint64 quiet = QFile(journal).size();
    while (begun == 0.0 && patience.elapsed() < 60'000) {
        QTest::qWait(5);
        const qint64 size = QFile(journal).size();
        if (size > quiet && size > 100'000) begun = unixTime();
    }
    QVERIFY(begun > 0.0);
    QTest::qWait(milliseconds);
    ::kill(static_cast<pid_t>(mill.processId()), SIGKILL);
    const double killed = unixTime();
    mill.waitForFinished();

    const ProgramRun run = runBurin({"info", project, "--json"});
    QVERIFY2(run.status == 0, run.messages.constData());
    const QJsonObject info = run.json();
    QVERIFY(info["recovered"].toBool());
    const QJsonArray takes = info["takes"].toArray();
    QCOMPARE(takes.size(), 1);
    const QJsonObject take = takes[0].toObject();
    QCOMPARE(take["complete"].toBool(), false);
    const double kept = take["started_unix_s"].toDouble() + take["duration_s"].toDouble();
    QVERIFY2(killed - kept <= 0.1, qPrintable(QString("%1 s are missing").arg(killed - kept)));
    QVERIFY(take["samples"].toInteger() > milliseconds / 2);

    // Reading does not save: until a command writes, the file is as it was. Then the recovered work is continued.
    QCOMPARE(runBurin({"info", project, "--json"}).json()["recovered"].toBool(), true);
    QCOMPARE(runBurin({"path", project, "new"}).status, 0);
    const QJsonObject saved = runBurin({"info", project, "--json"}).json();
    QCOMPARE(saved["recovered"].toBool(), false);
    QCOMPARE(saved["samples"].toInteger(), take["samples"].toInteger());
}

BURIN_TEST(KilledTest, QCoreApplication)

} // namespace burin::tst_killed

#include "tst_killed.moc"

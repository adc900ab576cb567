// SPDX-FileCopyrightText: 2026 The Burin authors
// SPDX-License-Identifier: Apache-2.0
#include "tests/faults/fault_run.h"
#include "tests/long_run.h"
#include "tests/test_program.h"

#include <QCoreApplication>
#include <QTemporaryDir>
#include <QTest>

#include <algorithm>
#include <array>
#include <atomic>
#include <mutex>
#include <thread>
#include <vector>

namespace burin::tst_points {

/// Runs each command with each of its calls that change a file failing, in each way. README.md has the rules.
class PointsTest : public QObject {
    Q_OBJECT
private slots:
    void initTestCase();
    void everyFaultLeavesAllOrNothing_data();
    void everyFaultLeavesAllOrNothing();

private:
    QTemporaryDir folder_;
};

namespace {

constexpr std::array kinds{"EIO", "ENOSPC", "SHORT", "EINTR", "KILL"};
constexpr std::uint64_t pointsOfKind = 2; // per command, in the usual run

struct Point {
    std::uint64_t at;
    const char* kind;
};

/// Every call for every kind of fault, or some evenly spread calls for each kind, between those of the other kinds.
std::vector<Point> pointsOf(std::uint64_t calls) {
    const std::uint64_t share = std::max<std::uint64_t>(calls / pointsOfKind, 1);
    const std::uint64_t step = burin::testing::inLongRun<std::uint64_t>(1, share);
    std::vector<Point> points;
    for (std::size_t kind = 0; kind < kinds.size(); ++kind)
        for (std::uint64_t at = 1 + kind * step / kinds.size(); at <= calls; at += step)
            points.push_back({at, kinds[kind]});
    return points;
}

} // namespace

void PointsTest::initTestCase() {
    QCOMPARE(prepareFolder(folder_.filePath("before")), QString());
    QCOMPARE(prepareEarlierFolder(folder_.filePath("earlier")), QString());
}

void PointsTest::everyFaultLeavesAllOrNothing_data() {
    QTest::addColumn<int>("command");
    const QList<FaultCommand> commands = faultCommands();
    for (int i = 0; i < commands.size(); ++i) QTest::newRow(commands[i].name) << i;
}

void PointsTest::everyFaultLeavesAllOrNothing() {
    QFETCH(int, command);
    const FaultCommand asked = faultCommands()[command];
    const QString before = folder_.filePath(asked.earlier ? "earlier" : "before"), clean = folder_.filePath("work-0");
    copyFolder(before, clean);
    const FaultRun run = runWithFault(asked, clean, 0, {});
    QVERIFY2(run.status == 0, run.messages.constData());
    const Expected expected{filesIn(before), filesIn(clean), contentOfProject(before + "/p.burin"),
                            contentOfProject(clean + "/p.burin")};
    QVERIFY(expected.projectBefore.sound && expected.projectAfter.sound);

    const std::vector<Point> points = pointsOf(run.calls);
    std::atomic<std::size_t> next{0};
    std::mutex mutex;
    QStringList findings;
    const auto work = [&](int worker) {
        const QString folder = folder_.filePath(QString("work-%1").arg(worker));
        for (std::size_t i = next++; i < points.size(); i = next++) {
            copyFolder(before, folder);
            const FaultRun faulty = runWithFault(asked, folder, points[i].at, points[i].kind);
            const QString wrong = judge(asked, folder, faulty, expected);
            const std::lock_guard guard(mutex);
            if (!wrong.isEmpty()) findings << QString("%1 at %2: %3").arg(points[i].kind).arg(points[i].at).arg(wrong);
        }
    };
    {
        std::jthread other(work, 1);
        work(0);
    }
    qInfo("%s: %zu points, %lld failures", asked.name, points.size(), static_cast<long long>(findings.size()));
    QVERIFY2(findings.isEmpty(), qPrintable(findings.join('\n')));
}

BURIN_TEST(PointsTest, QCoreApplication)

} // namespace burin::tst_points

#include "tst_points.moc"

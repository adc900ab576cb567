// SPDX-FileCopyrightText: 2026 The Burin authors
// SPDX-License-Identifier: Apache-2.0
#include "core/haptics/loop/flight_recorder.h"
#include "tests/oracles/system_watch.h"
#include "tests/test_program.h"

#include <QDir>
#include <QFile>
#include <QTemporaryDir>
#include <QtTest>

#include <thread>

namespace burin::tst_flight_recorder {

namespace {

struct Nobody final : TickSink {
    AtEdge edge() noexcept override { return AtEdge::tick; }
    void tick(const Sample&, const TickTiming&) noexcept override { ++ticks; }
    int ticks = 0;
};

FlightSettings settingsIn(const QTemporaryDir& folder) {
    FlightSettings settings;
    settings.folder = std::filesystem::path(folder.path().toStdString()) / "flights";
    settings.device = "a stylus\nof two lines";
    return settings;
}

/// Feeds ticks whose values identify them.
void feed(FlightRecorder& recorder, std::uint64_t from, std::uint64_t count, TickFault lastFault = TickFault::none) {
    for (std::uint64_t i = 0; i < count; ++i) {
        Sample sample;
        sample.tick = from + i;
        sample.time = 0.001 * static_cast<double>(from + i);
        sample.force.x = static_cast<double>(from + i);
        TickTiming timing;
        timing.period = 0.001;
        timing.over = static_cast<std::int64_t>(1'000'000 * (from + i));
        timing.interval = 1'000'000;
        timing.reading.pose.position.x = 0.5 * static_cast<double>(from + i);
        timing.reading.valid = true;
        if (i + 1 == count) timing.fault = lastFault;
        recorder.tick(sample, timing);
    }
}

std::optional<FlightReport> reportOf(FlightRecorder& recorder) {
    for (int i = 0; i < 4000; ++i) {
        if (auto report = recorder.take()) return report;
        std::this_thread::sleep_for(std::chrono::milliseconds(5));
    }
    return std::nullopt;
}

struct Record {
    QStringList comments, columns;
    std::vector<QStringList> rows;
    QString at(std::size_t row, const char* column) const { return rows[row][columns.indexOf(QLatin1String(column))]; }
};

Record read(const std::filesystem::path& path) {
    Record record;
    QFile file(QString::fromStdString(path.string()));
    if (!file.open(QIODevice::ReadOnly)) return record;
    for (const QByteArray& line : file.readAll().split('\n')) {
        if (line.startsWith('#'))
            record.comments << QString::fromUtf8(line);
        else if (record.columns.isEmpty())
            record.columns = QString::fromUtf8(line).split(',');
        else if (!line.isEmpty())
            record.rows.push_back(QString::fromUtf8(line).split(','));
    }
    return record;
}

} // namespace

/// The last two seconds before a fault, written to the disk.
class TestFlightRecorder : public QObject {
    Q_OBJECT
private slots:
    void aFaultLeavesTheLastTwoSeconds() {
        QTemporaryDir folder;
        Nobody sink;
        FlightRecorder recorder(settingsIn(folder), sink);
        feed(recorder, 0, 5000, TickFault::tooFast);
        QVERIFY(recorder.writing());
        const auto report = reportOf(recorder);
        QVERIFY(report);
        QVERIFY(!recorder.take());
        QCOMPARE(report->fault, TickFault::tooFast);
        const Record record = read(report->file);
        QVERIFY(record.comments.contains(QStringLiteral("# fault: too-fast")));
        QVERIFY(record.comments.contains(QStringLiteral("# device: a stylus of two lines")));
        QCOMPARE(record.rows.size(), std::size_t{2000});
        for (std::size_t i = 0; i < record.rows.size(); ++i) {
            QCOMPARE(record.rows[i].size(), record.columns.size());
            QCOMPARE(record.at(i, "tick").toInt(), 3000 + int(i)); // in order, none missing
            QCOMPARE(record.at(i, "force_x_n").toDouble(), 3000.0 + double(i));
            QCOMPARE(record.at(i, "reading_x_mm").toDouble(), 0.5 * (3000.0 + double(i)));
            QCOMPARE(record.at(i, "interval_us").toDouble(), 1000.0);
        }
        QCOMPARE(record.at(1999, "fault"), QStringLiteral("too-fast"));
        QCOMPARE(record.at(1998, "fault"), QStringLiteral("none"));
        QCOMPARE(sink.ticks, 5000); // the sink behind the recorder receives all
    }

    void aDeadLoopLeavesWhatItHad() {
        QTemporaryDir folder;
        Nobody sink;
        FlightRecorder recorder(settingsIn(folder), sink);
        feed(recorder, 0, 7);
        recorder.loopDied();
        const auto report = reportOf(recorder);
        QVERIFY(report);
        QCOMPARE(report->fault, TickFault::dead);
        QCOMPARE(read(report->file).rows.size(), std::size_t{7});
    }

    void onlySomeAreKept() {
        QTemporaryDir folder;
        Nobody sink;
        FlightSettings settings = settingsIn(folder);
        settings.keep = 3;
        std::filesystem::path last;
        FlightRecorder recorder(settings, sink);
        for (int i = 0; i < 5; ++i) {
            feed(recorder, 0, 10, TickFault::stalled);
            const auto report = reportOf(recorder);
            QVERIFY(report && std::filesystem::exists(report->file));
            last = report->file;
        }
        const QStringList left = QDir(QString::fromStdString(settings.folder.string())).entryList(QDir::Files);
        QCOMPARE(left.size(), 3);
        QCOMPARE(left.last(), QString::fromStdString(last.filename().string()));
    }

    void aFolderThatCannotBeWrittenIsNoFile() {
        QTemporaryDir folder;
        Nobody sink;
        FlightSettings settings = settingsIn(folder);
        QFile inTheWay(QString::fromStdString(settings.folder.string()));
        QVERIFY(inTheWay.open(QIODevice::WriteOnly));
        FlightRecorder recorder(settings, sink);
        feed(recorder, 0, 10, TickFault::stalled);
        const auto report = reportOf(recorder);
        QVERIFY(report);
        QVERIFY(report->file.empty());
    }

    void whatWasTriggeredIsWrittenBeforeItEnds() {
        QTemporaryDir folder;
        Nobody sink;
        const FlightSettings settings = settingsIn(folder);
        {
            FlightRecorder recorder(settings, sink);
            feed(recorder, 0, 10, TickFault::damaged);
        }
        QCOMPARE(QDir(QString::fromStdString(settings.folder.string())).entryList(QDir::Files).size(), 1);
    }

    /// Ticks continue, at any speed, while records are written: each record is in order and complete.
    void ticksGoOnWhileARecordIsWritten() {
        QTemporaryDir folder;
        Nobody sink;
        FlightRecorder recorder(settingsIn(folder), sink);
        std::jthread loop([&](const std::stop_token& stop) {
            for (std::uint64_t tick = 0; !stop.stop_requested(); tick += 50) {
                feed(recorder, tick, 50, tick % 5000 == 0 ? TickFault::damaged : TickFault::none);
                std::this_thread::sleep_for(std::chrono::microseconds(200));
            }
        });
        for (int i = 0; i < 4; ++i) {
            const auto report = reportOf(recorder);
            QVERIFY(report && !report->file.empty());
            if (!std::filesystem::exists(report->file)) continue;
            const Record record = read(report->file);
            QVERIFY(!record.rows.empty());
            for (std::size_t row = 1; row < record.rows.size(); ++row) {
                const qlonglong tick = record.at(row, "tick").toLongLong();
                QVERIFY(tick > record.at(row - 1, "tick").toLongLong());
                QCOMPARE(record.at(row, "force_x_n").toDouble(), double(tick));
            }
        }
    }

    void aTickAsksNothingOfTheSystem() {
        tests::SystemWatch watch;
        if (!watch.counts()) QSKIP("neither this kernel nor a build with sanitizers can count");
        QTemporaryDir folder;
        Nobody sink;
        FlightRecorder recorder(settingsIn(folder), sink);
        feed(recorder, 0, 3000);
        watch.begin();
        feed(recorder, 3000, 500, TickFault::tooFast);
        const tests::SystemUse cost = watch.end();
        QCOMPARE(cost.allocations + cost.releases + cost.locks + cost.systemCalls, std::uint64_t{0});
    }
};

BURIN_TEST(TestFlightRecorder, NoApplication)

} // namespace burin::tst_flight_recorder

#include "tst_flight_recorder.moc"

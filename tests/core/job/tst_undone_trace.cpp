// SPDX-FileCopyrightText: 2026 The Burin authors
// SPDX-License-Identifier: Apache-2.0
#include "core/haptics/trace/trace_stylus.h"
#include "core/job/milling.h"
#include "core/job/take_trace.h"
#include "core/volume/operations/fingerprint.h"
#include "tests/core/job/session_stage.h"
#include "tests/test_program.h"

#include <QTemporaryDir>
#include <QtTest>

#include <algorithm>

/// Traces in which strokes are undone and redone.
namespace burin::tst_undone_trace {

using namespace burin::test;
namespace fs = std::filesystem;

namespace {

std::uint64_t hashOf(Stage& stage) {
    return fingerprint(stage.milling.embedded.workpiece.snapshot());
}

/// A session played from its trace, on another workpiece.
struct Played {
    explicit Played(const fs::path& file, const SessionTrace& trace, Pace pace = Pace::fast) : stage(file) {
        TraceStylus stylus(trace.readings, trace.began ? trace.began->stylus : StrokeHand().description());
        TakeRequest request;
        request.name = "again";
        request.replayed = &trace;
        request.pace = pace;
        if (trace.began) {
            request.mapping = trace.began->mapping;
            request.period = trace.began->period;
            request.cutsOnButton = trace.began->cutsOnButton;
            request.felt = trace.began->felt;
            request.stock = trace.began->stock;
        }
        const std::atomic<bool> stop{false};
        outcome = recordTake(stage.project, stage.milling, ToolBounds::borrowing(*stage.field), stylus, request, stop);
    }
    Take take() const { return *stage.project.take(outcome->take); }

    Stage stage;
    Result<TakeOutcome> outcome = TakeOutcome{};
};

std::size_t changesOf(const SessionTrace& trace, bool undone) {
    return static_cast<std::size_t>(std::ranges::count_if(trace.changes, [&](const TimedChange& timed) {
        const auto* const change = std::get_if<WorkpieceChange>(&timed.change);
        return change != nullptr && change->undone == undone;
    }));
}

/// A session in one take: three strokes, of which two are undone and one redone, then another one that is undone while
/// it is being milled, and a last one.
struct Recorded {
    explicit Recorded(const QTemporaryDir& folder, const StockLayer& layer = {})
        : trace(folder.filePath("trace.csv").toStdString()), stage(folder.filePath("p.burin").toStdString()) {
        SessionRequest request = handRequest();
        request.trace = trace;
        request.takeName = "undone";
        request.stock = layer;
        const auto session = stage.begin(request);
        good = session && millStrokes(stage, *session, 3) && session->undoStroke() && session->undoStroke() &&
               session->redoStroke();
        stage.hand.mill(1);
        SessionState state;
        good = good && await([&] { return session->newest(state) && state.cutting && state.removalRate > 0.0; }) &&
               session->undoStroke() && await([&] { return stage.hand.done() == 4; }) &&
               millStrokes(stage, *session, 1);
        if (good && layer.distance > 0.0) good = session->setStockLayer(!layer.on).hasValue();
        good = good && millStrokes(stage, *session, 1) && session->end();
        if (good) take = *stage.project.take(session->take());
    }

    fs::path trace;
    Stage stage;
    Take take;
    bool good = false;
};

} // namespace

class TestUndoneTrace : public QObject {
    Q_OBJECT
private slots:
    /// The workpiece is the same to the bit, and so is every force that was given.
    void aSessionWithUndoneStrokesPlaysTheSame_data() {
        QTest::addColumn<int>("pace");
        QTest::addColumn<double>("distance");
        QTest::newRow("as fast as possible") << static_cast<int>(Pace::fast) << 0.0;
        QTest::newRow("in real time") << static_cast<int>(Pace::realtime) << 0.0;
        QTest::newRow("kept from the stock") << static_cast<int>(Pace::fast) << 0.5;
    }
    void aSessionWithUndoneStrokesPlaysTheSame() {
        QFETCH(int, pace);
        QFETCH(double, distance);
        const QTemporaryDir folder;
        Recorded original(folder, {distance, distance > 0.0});
        QVERIFY(original.good);
        const auto trace = readSessionTrace(original.trace);
        QVERIFY(trace && trace->began);
        QCOMPARE(changesOf(*trace, true), std::size_t{3});
        QCOMPARE(changesOf(*trace, false), std::size_t{1});
        QCOMPARE(trace->began->stock.distance, distance);

        Played played(folder.filePath("q.burin").toStdString(), *trace, static_cast<Pace>(pace));
        QVERIFY(played.outcome);
        const Take take = played.take();
        QCOMPARE(take.samples.size(), original.take.samples.size());
        QVERIFY(take.undone == original.take.undone);
        QVERIFY(take.undone.size() >= 2);
        bool withheld = false; // in real time, on a loaded machine
        for (std::size_t i = 0; i < take.samples.size(); ++i) {
            const Sample &one = take.samples[i], &other = original.take.samples[i];
            QCOMPARE(one.proxy.tip, other.proxy.tip);
            QCOMPARE(one.cuttingForce, other.cuttingForce);
            // A force that came too late was not sent, and limits of rate and energy count from what was sent.
            withheld = withheld || ((one.flags | other.flags) & sampleForceLate) != 0;
            if (withheld) continue;
            QCOMPARE(one.force, other.force);
            QCOMPARE(one.flags, other.flags);
        }
        QCOMPARE(hashOf(played.stage), hashOf(original.stage));
        QCOMPARE(removedUnits(take), removedUnits(original.take));
        QVERIFY(std::abs(played.outcome->removed - played.outcome->drop) < 1e-6);
    }

    /// A stroke from before the trace is not in it: playing it says so, and keeps what was recorded until there.
    void aStrokeFromBeforeTheTraceIsRefused() {
        const QTemporaryDir folder;
        const fs::path file = folder.filePath("trace.csv").toStdString();
        {
            Stage stage(folder.filePath("p.burin").toStdString());
            SessionRequest request = handRequest();
            request.takeName = "before";
            const auto first = stage.begin(request);
            QVERIFY(first && millStrokes(stage, *first, 1) && first->end());
            request.takeName = "traced";
            request.trace = file;
            const auto second = stage.begin(request);
            QVERIFY(second && second->undoStroke() && millStrokes(stage, *second, 1) && second->end());
        }
        const auto trace = readSessionTrace(file);
        QVERIFY(trace);
        Played played(folder.filePath("q.burin").toStdString(), *trace);
        QVERIFY(!played.outcome);
        QCOMPARE(played.outcome.error().code, ErrorCode::traceInvalid);
        QVERIFY(played.outcome.error().place.starts_with("reading "));
    }

    /// The trace of a take mills what counts of the take, although it has the motion of the undone strokes, too.
    void theTraceOfATakeUndoesItsStrokes() {
        const QTemporaryDir folder;
        Recorded original(folder);
        QVERIFY(original.good);
        const fs::path file = folder.filePath("take.csv").toStdString();
        const TakeOutline outline{original.take.info, original.take.undone};
        QVERIFY(
            writeTakeTrace(file, outline, [&](const SampleVisitor& visit) { return visit(original.take.samples); }));
        const auto trace = readSessionTrace(file);
        QVERIFY(trace && !trace->began);
        QCOMPARE(trace->readings.size(), original.take.samples.size());
        QVERIFY(changesOf(*trace, true) >= 2);
        Played played(folder.filePath("q.burin").toStdString(), *trace);
        QVERIFY(played.outcome);
        QCOMPARE(hashOf(played.stage), hashOf(original.stage));
        QCOMPARE(removedUnits(played.take()), removedUnits(original.take));
    }

    /// An interval that begins within a stroke, as where one punched in, is passed through without cutting. Counted by
    /// hand: six samples with the spindle on, of which the last four don't count.
    void anIntervalWithinAStrokeDoesNotCut() {
        std::vector<Sample> samples(8);
        for (std::size_t i = 0; i < samples.size(); ++i) {
            samples[i].time = 0.001 * static_cast<double>(i);
            if (i < 1 || i > 6) samples[i].flags = sampleSpindleOff;
        }
        TakeOutline take;
        take.info.sampleCount = samples.size();
        take.undone = {{3, 4}};
        const QTemporaryDir folder;
        const fs::path file = folder.filePath("take.csv").toStdString();
        QVERIFY(writeTakeTrace(file, take, [&](const SampleVisitor& visit) { return visit(samples); }));
        const auto trace = readSessionTrace(file);
        QVERIFY(trace);
        std::vector<std::pair<std::size_t, bool>> spindle;
        for (const TimedChange& change : trace->changes) {
            QVERIFY(std::holds_alternative<SpindleRelease>(change.change));
            spindle.emplace_back(change.tick, std::get<SpindleRelease>(change.change).released);
        }
        QCOMPARE(spindle, (std::vector<std::pair<std::size_t, bool>>{{0, false}, {1, true}, {3, false}}));
        QCOMPARE(trace->readings[5].period, 0.001);
    }
};

BURIN_TEST(TestUndoneTrace, QCoreApplication)

} // namespace burin::tst_undone_trace

#include "tst_undone_trace.moc"

// SPDX-FileCopyrightText: 2026 The Burin authors
// SPDX-License-Identifier: Apache-2.0
#include "core/haptics/trace/trace_stylus.h"
#include "core/job/milling.h"
#include "core/job/touched_stock.h"
#include "core/job/traced_bounds.h"
#include "core/volume/operations/fingerprint.h"
#include "tests/core/document/processes.h"
#include "tests/core/job/part_milling.h"
#include "tests/core/job/session_stage.h"
#include "tests/test_program.h"

#include <QTemporaryDir>
#include <QtTest>

#include <algorithm>

/// Traces of sessions as the window runs them: several takes in one session, layers that are switched, strokes undone.
namespace burin::tst_session_trace {

using namespace burin::test;
namespace fs = std::filesystem;

namespace {

constexpr std::size_t jawLayer = 1, travelLayer = 2, stockLayer = 3;

Obstacle jaw(bool on) {
    Obstacle obstacle;
    obstacle.name = "jaw";
    obstacle.shape = Box{{-12.0, 2.0, 0.0}, {-1.0, 12.0, 14.0}};
    obstacle.on = on;
    return obstacle;
}

/// A part in its block, with a jaw beside it.
struct TraceStage {
    explicit TraceStage(const fs::path& file, bool jawOn) : project(*Project::create(file)) {
        milling.obstacles = {jaw(jawOn)};
        if (!project.setModel(*milling.model) || !project.setSetup(milling.setup) ||
            !project.setObstacles(milling.obstacles))
            std::abort();
    }
    /// As the window makes them: growing, with a travel that sessions switch, and the stock.
    ToolBounds windowBounds() {
        Progress progress;
        Result<ToolBounds> bounds =
            ToolBounds::grow(milling, lent(milling.part), milling.tool, AxisMode{},
                             surroundingsOf(milling, TravelPlacement{}, AxisMode{}), 10.0, {}, progress);
        if (!bounds) std::abort();
        Result<TouchableStock> stock = TouchableStock::of(*milling.model, milling.setup, progress);
        if (!stock) std::abort();
        bounds->addStock(std::make_shared<const TouchableStock>(std::move(*stock)));
        return std::move(*bounds);
    }
    std::uint64_t hash() { return fingerprint(milling.embedded.workpiece.snapshot()); }

    Project project;
    MillingContext milling = partMilling(sessionTool());
    StrokeHand hand;
    StrokeHistory strokes;
};

bool millSome(TraceStage& stage, MillingSession& session, int strokes) {
    const int wanted = stage.hand.done() + strokes;
    stage.hand.mill(strokes);
    SessionState state;
    return await([&] { return session.newest(state), stage.hand.done() >= wanted; });
}

bool waitTicks(MillingSession& session, std::uint64_t ticks) {
    SessionState state;
    if (!await([&] { return session.newest(state); })) return false;
    const std::uint64_t end = state.ticks + ticks;
    return await([&] { return session.newest(state), state.ticks >= end; });
}

SessionRequest tracedRequest(const fs::path& trace) {
    SessionRequest request = handRequest();
    request.trace = trace;
    request.traceRequired = false;
    request.stock = {0.5, true};
    request.gains = {150.0, 0.4};
    return request;
}

/// A session with two takes, in which everything is done that the window can do to a step.
bool work(TraceStage& stage, MillingSession& session) {
    return session.setLayer(stockLayer, true) && waitTicks(session, 30) && session.setLayer(travelLayer, false) &&
           session.setLayer(jawLayer, true) && session.startRecording("one") && millSome(stage, session, 3) &&
           session.undoStroke() && session.undoStroke() && session.redoStroke() && session.stopRecording() &&
           waitTicks(session, 30) && session.setLayer(jawLayer, false) && session.setStockLayer(false) &&
           session.startRecording("two") && millSome(stage, session, 2) && session.stopRecording() &&
           waitTicks(session, 30);
}

/// The ticks at which takes begin in a trace.
std::vector<std::size_t> beginnings(const SessionTrace& trace) {
    std::vector<std::size_t> ticks;
    for (const TimedChange& timed : trace.changes)
        if (std::holds_alternative<TakeBegin>(timed.change)) ticks.push_back(timed.tick);
    return ticks;
}

Result<Take> played(TraceStage& stage, const SessionTrace& trace) {
    Progress progress;
    TravelPlacement off;
    off.on = false; // as the project says after the session
    const Result<ToolBounds> bounds = boundsAsTraced(stage.milling, trace.began->axis, off, 0.5, trace, progress);
    if (!bounds) return bounds.error();
    TraceStylus stylus(trace.readings, trace.began->stylus);
    TakeRequest request;
    request.name = "again";
    request.replayed = &trace;
    request.mapping = trace.began->mapping;
    request.period = trace.began->period;
    request.cutsOnButton = trace.began->cutsOnButton;
    request.felt = trace.began->felt;
    request.stock = trace.began->stock;
    request.gains = trace.began->gains;
    const std::atomic<bool> stop{false};
    const Result<TakeOutcome> outcome = recordTake(stage.project, stage.milling, *bounds, stylus, request, stop);
    if (!outcome) return outcome.error();
    return stage.project.take(outcome->take);
}

} // namespace

class TestSessionTrace : public QObject {
    Q_OBJECT
private slots:
    /// The workpiece is the same to the bit, and so is every force that was given, in both takes. The fixture is stored
    /// switched the other way meanwhile.
    void aSessionOfTheWindowPlaysTheSame() {
        const QTemporaryDir folder;
        const fs::path file = folder.filePath("trace.csv").toStdString();
        TraceStage live(folder.filePath("p.burin").toStdString(), false);
        {
            const ToolBounds bounds = live.windowBounds();
            QCOMPARE(bounds.layers().size(), std::size_t{4});
            const auto session =
                MillingSession::begin(live.project, live.milling, bounds, live.hand, live.strokes, tracedRequest(file));
            QVERIFY(session && work(live, **session));
            QVERIFY(!fs::exists(file)); // until it is complete
            QVERIFY((*session)->end());
        }
        const auto trace = readSessionTrace(file);
        QVERIFY(trace && trace->began);
        QCOMPARE(trace->began->gains, (GainLimits{150.0, 0.4}));
        QCOMPARE(trace->began->tool, std::string("ball-4"));
        QCOMPARE(trace->began->layers.size(), std::size_t{4});

        TraceStage again(folder.filePath("q.burin").toStdString(), true);
        const Result<Take> take = played(again, *trace);
        QVERIFY(take);
        QCOMPARE(again.hash(), live.hash());
        const std::vector<std::size_t> begins = beginnings(*trace);
        QCOMPARE(begins.size(), std::size_t{2});
        std::size_t compared = 0, felt = 0;
        for (std::size_t k = 0; k < begins.size(); ++k) {
            const Result<Take> original = live.project.take(static_cast<std::int64_t>(k + 1));
            QVERIFY(original && take->samples.size() >= begins[k] + original->samples.size());
            for (std::size_t i = 0; i < original->samples.size(); ++i) {
                const Sample &one = original->samples[i], &other = take->samples[begins[k] + i];
                QCOMPARE(other.proxy.tip, one.proxy.tip);
                QCOMPARE(other.cuttingForce, one.cuttingForce);
                if ((one.flags & sampleForceLate) != 0) continue;
                QCOMPARE(other.force, one.force);
                ++compared;
                if (glm::length(one.force) > 0.01) ++felt;
            }
        }
        QVERIFY(compared > 300 && felt > 50);
    }

    /// Another project has no layer that the trace switches.
    void otherSurroundingsAreRefused() {
        const QTemporaryDir folder;
        const fs::path file = folder.filePath("trace.csv").toStdString();
        TraceStage live(folder.filePath("p.burin").toStdString(), true);
        const ToolBounds bounds = live.windowBounds();
        const auto session =
            MillingSession::begin(live.project, live.milling, bounds, live.hand, live.strokes, tracedRequest(file));
        QVERIFY(session && (*session)->setLayer(jawLayer, false) && waitTicks(**session, 20) && (*session)->end());
        const auto trace = readSessionTrace(file);
        QVERIFY(trace);
        Progress progress;
        live.milling.obstacles.front().name = "another jaw";
        const Result<ToolBounds> other = boundsAsTraced(live.milling, AxisMode{}, {}, 0.5, *trace, progress);
        QVERIFY(!other);
        QCOMPARE(other.error().code, ErrorCode::argumentInvalid);
    }

    /// A disk that takes no more of the trace says so once, and milling goes on; nothing is left of the file.
    void aFullDiskEndsTheTraceAlone() {
        BURIN_SKIP_WHERE_FORKED_CHILDREN_HAVE_NO_THREADS();
        const QTemporaryDir folder;
        const int outcome = fixture::inAnotherProcess([&] {
            const fs::path file = folder.filePath("trace.csv").toStdString();
            Stage stage(folder.filePath("p.burin").toStdString());
            SessionRequest request = handRequest();
            request.trace = file;
            request.traceRequired = false;
            const auto session = stage.begin(request);
            if (!session) return 2;
            fixture::limitFileSize(8 * 1024);
            SessionState state;
            std::optional<Error> fault;
            if (!await([&] { return (fault = session->takeFault()).has_value(); })) return 3;
            fixture::limitFileSize(RLIM_INFINITY);
            if (fault->code != ErrorCode::traceEnded || fault->subject != file.string()) return 4;
            if (fault->detail != "the disk is full") return 5;
            if (!session->startRecording("goes on") || !millStrokes(stage, *session, 1)) return 6;
            if (!session->stopRecording() || session->takeFault() || session->ended()) return 7;
            if (!session->end()) return 8;
            const auto left = std::ranges::count_if(fs::directory_iterator(file.parent_path()), [](const auto& entry) {
                return entry.path().filename().string().find("trace") != std::string::npos;
            });
            return left == 0 ? 0 : 9;
        });
        QCOMPARE(outcome, 0);
    }

    /// A folder that does not exist: the session begins without its trace.
    void aTraceThatCannotBeginDoesNotKeepFromMilling() {
        const QTemporaryDir folder;
        Stage stage(folder.filePath("p.burin").toStdString());
        SessionRequest request = handRequest();
        request.trace = folder.filePath("missing/trace.csv").toStdString();
        QVERIFY(!stage.begin(request));
        request.traceRequired = false;
        const auto session = stage.begin(request);
        QVERIFY(session);
        const std::optional<Error> fault = session->takeFault();
        QVERIFY(fault && fault->code == ErrorCode::traceEnded && !session->takeFault());
        QVERIFY(session->startRecording("goes on") && millStrokes(stage, *session, 1) && session->end());
    }
};

BURIN_TEST(TestSessionTrace, NoApplication)

} // namespace burin::tst_session_trace

#include "tst_session_trace.moc"

// SPDX-FileCopyrightText: 2026 The Burin authors
// SPDX-License-Identifier: Apache-2.0
#include "core/job/job_paths.h"
#include "core/job/milling.h"
#include "core/job/milling_session.h"
#include "core/job/recorded_cuts.h"
#include "tests/core/job/part_milling.h"
#include "tests/core/job/session_stage.h"
#include "tests/test_program.h"

#include <QTemporaryDir>
#include <QtTest>

#include <thread>

namespace burin::tst_milling_session {

using namespace burin::test;
namespace fs = std::filesystem;

namespace {

using namespace std::chrono_literals;

fs::path fileIn(const QTemporaryDir& folder) {
    return folder.filePath("p.burin").toStdString();
}

/// The workpiece as the loop shows it at present.
Lines shown(MillingSession& session) {
    WorkpieceView view;
    for (int views = 0; views < 2;) // the first one may have been requested before
        if (session.newestView(view))
            ++views;
        else
            std::this_thread::sleep_for(1ms);
    return linesOf(view.workpiece);
}

/// The workpiece computed again from the recordings: as a command reads them, and as the window does, which gets them
/// from another thread. Empty if these differ.
Lines replayed(const Project& project) {
    MillingContext milling = blockMilling(), handedOver = blockMilling();
    Progress progress;
    const auto work = recordedWork(project, false);
    if (!work || !replayTakes(project, milling, progress) || !replayTakes(*work, handedOver, progress)) return {};
    Lines lines = linesOf(milling.embedded.workpiece);
    return lines == linesOf(handedOver.embedded.workpiece) ? lines : Lines{};
}

/// The workpiece that a second program computes from the project on the disk.
Lines replayed(const fs::path& file) {
    const Result<Project> project = Project::open(file);
    return project ? replayed(*project) : Lines{};
}

} // namespace

class TestMillingSession : public QObject {
    Q_OBJECT
private slots:
    /// The recording is what the loop did to the workpiece, and gives the same when the project is opened.
    void theRecordingIsWhatHappened_data() {
        QTest::addColumn<bool>("onButton");
        QTest::newRow("always cutting") << false;
        QTest::newRow("with the button") << true;
    }
    void theRecordingIsWhatHappened() {
        QFETCH(bool, onButton);
        const QTemporaryDir folder;
        Lines workpiece;
        {
            Stage stage(fileIn(folder), 4);
            stage.hand.mill(4);
            const std::uint64_t before = stage.units();
            SessionRequest request = handRequest(Pace::fast);
            request.cutsOnButton = onButton;
            request.takeName = "four strokes";
            const auto session = stage.begin(request);
            QVERIFY(session && await([&] { return session->ended(); }));
            const Result<LoopStatistics> loop = session->end();
            QVERIFY(loop && stage.hand.closed());
            const Result<Take> take = stage.project.take(session->take());
            QVERIFY(take && take->info.complete && contiguous(*take));
            QCOMPARE(take->info.name, std::string("four strokes"));
            QCOMPARE(take->samples.size(), std::size_t{loop->ticks});
            QCOMPARE(removedUnits(*take), before - stage.units());
            QVERIFY(stage.units() < before);
            // Each press is a stroke; without a button the whole take is a single stroke.
            QCOMPARE(stage.strokes.count(), std::size_t{onButton ? 4u : 1u});
            if (!onButton) QCOMPARE(stage.strokes.newest().count, std::uint64_t{take->samples.size()});
            workpiece = stage.workpiece();
            QVERIFY(stage.project.save());
        }
        QVERIFY(workpiece == replayed(fileIn(folder)));
    }

    /// With its button up a tool follows the hand through stock; it cuts only with the button down.
    void aHoveringToolIsNeverHeldByStock() {
        const QTemporaryDir folder;
        Stage stage(fileIn(folder), 3);
        stage.hand.mill(3);
        SessionRequest request = handRequest(Pace::fast);
        request.takeName = "hovering";
        const auto session = stage.begin(request);
        QVERIFY(session && await([&] { return session->ended(); }) && session->end());
        const Result<Take> take = stage.project.take(session->take());
        QVERIFY(take);
        std::size_t hovering = 0;
        for (const Sample& sample : take->samples) {
            QCOMPARE((sample.flags & sampleSpindleOff) != 0, (sample.buttons & 1u) == 0);
            if ((sample.buttons & 1u) != 0) continue;
            ++hovering;
            QVERIFY(glm::length(sample.proxy.tip - sample.stylusTip) < 1e-9);
            for (const RemovedMaterial& removed : sample.removed) QCOMPARE(removed.units, std::uint64_t{0});
        }
        QVERIFY(hovering >= std::size_t{3 * StrokeHand::backTicks});
        // None of its positions becomes part of a path.
        Progress progress;
        StoredPath stored = *standardPath(stage.project, stage.milling.tool.id);
        stored.edits.clear();
        const Result<EvaluatedPath> path = evaluateStored(stage.project, stage.milling, stored, progress);
        QVERIFY(path);
        QCOMPARE(path->path.points.size(), take->samples.size() - hovering);
        for (const PathPoint& point : path->path.points)
            QVERIFY(!(take->samples[static_cast<std::size_t>(point.sample)].flags & sampleSpindleOff));
    }

    void whatIsNotRecordedIsNotCut() {
        const QTemporaryDir folder;
        Stage stage(fileIn(folder));
        const Lines before = stage.workpiece();
        const auto session = stage.begin(handRequest());
        QVERIFY(session && millStrokes(stage, *session, 2));
        SessionState state;
        QVERIFY(await([&] { return session->newest(state); }));
        QVERIFY(!state.recording && !state.cutting && state.ticks > 100);
        QCOMPARE(session->take(), std::int64_t{0});
        QVERIFY(shown(*session) == before);
        QCOMPARE(session->stopRecording().error().code, ErrorCode::argumentInvalid);
        QVERIFY(session->end() && stage.strokes.count() == 0);
        QVERIFY(stage.workpiece() == before);
        QVERIFY(stage.project.takes()->empty());
        QCOMPARE(session->startRecording("late").error().code, ErrorCode::argumentInvalid);
    }

    /// Several takes in one session, each starting at tick 0, without loss where they meet.
    void takesFollowOneAnother() {
        const QTemporaryDir folder;
        {
            Stage stage(fileIn(folder));
            const std::uint64_t before = stage.units();
            const auto session = stage.begin(handRequest());
            std::uint64_t removed = 0;
            for (const char* name : {"one", "two", "three"}) {
                QVERIFY(session->startRecording(name));
                QCOMPARE(session->startRecording("at once").error().code, ErrorCode::argumentInvalid);
                SessionState state;
                QVERIFY(await([&] { return session->newest(state) && state.recording; }));
                QCOMPARE(state.take, session->take());
                QVERIFY(millStrokes(stage, *session, 1));
                stage.hand.mill(1); // the recording stops during this one
                std::this_thread::sleep_for(20ms);
                QVERIFY(session->stopRecording());
                const Result<Take> take = stage.project.take(session->take());
                QVERIFY(take && take->info.complete && contiguous(*take));
                QCOMPARE(take->info.name, std::string(name));
                removed += removedUnits(*take);
                QVERIFY(await([&] { return stage.hand.done() % 2 == 0; }));
            }
            QVERIFY(session->end());
            QCOMPARE(removed, before - stage.units());
            QVERIFY(stage.workpiece() == replayed(stage.project));
        }
    }

    /// Requests that arrive faster than the ticks are all fulfilled, one after the other.
    void aTakeThatIsStoppedAtOnceIsWhole() {
        const QTemporaryDir folder;
        Stage stage(fileIn(folder));
        SessionRequest request = handRequest();
        request.takeName = "short";
        const auto session = stage.begin(request);
        QVERIFY(session && session->stopRecording());
        for (int i = 0; i < 5; ++i) QVERIFY(session->startRecording("again") && session->stopRecording());
        QVERIFY(session->startRecording("ended"));
        QVERIFY(session->end());
        const Result<std::vector<TakeInfo>> takes = stage.project.takes();
        QVERIFY(takes && takes->size() == 7);
        for (const TakeInfo& take : *takes) QVERIFY(take.complete);
        QVERIFY(stage.workpiece() == replayed(stage.project));
    }

    /// Undo restores, bit for bit, the state before the stroke; redo that after it; during the recording and after it.
    void strokesAreTakenBackAndComeAgain() {
        const QTemporaryDir folder;
        Lines last;
        {
            Stage stage(fileIn(folder));
            const std::uint64_t before = stage.units();
            const auto session = stage.begin(handRequest());
            QCOMPARE(session->undoStroke().error().code, ErrorCode::argumentInvalid);
            QVERIFY(session->startRecording("take"));
            std::vector<Lines> states{stage.workpiece()};
            for (int i = 0; i < 3; ++i) {
                QVERIFY(millStrokes(stage, *session, 1));
                states.push_back(shown(*session));
                QVERIFY(states[states.size() - 2] != states.back());
            }
            QCOMPARE(stage.strokes.count(), std::size_t{3});
            QVERIFY(session->undoStroke());
            QVERIFY(shown(*session) == states[2]);
            QVERIFY(session->undoStroke());
            QVERIFY(shown(*session) == states[1]);
            QVERIFY(session->redoStroke());
            QVERIFY(shown(*session) == states[2]);
            QVERIFY(session->redoStroke());
            QVERIFY(shown(*session) == states[3]);
            QCOMPARE(session->redoStroke().error().code, ErrorCode::argumentInvalid);
            QVERIFY(session->undoStroke() && session->undoStroke());
            // Another stroke instead: the undone stroke can't be redone any more.
            QVERIFY(millStrokes(stage, *session, 1));
            QVERIFY(await([&] { return session->undoStroke().hasValue(); }));
            QVERIFY(shown(*session) == states[1]);
            QVERIFY(millStrokes(stage, *session, 1));
            QCOMPARE(session->redoStroke().error().code, ErrorCode::argumentInvalid);
            const Lines after = shown(*session);
            QVERIFY(session->stopRecording());

            const Result<Take> take = stage.project.take(session->take());
            QVERIFY(take && contiguous(*take)); // nothing was erased
            QCOMPARE(take->undone.size(), std::size_t{3});
            for (const SampleRange& range : take->undone)
                for (std::uint64_t i = range.first; i < range.first + range.count; ++i)
                    QVERIFY(!(take->samples[i].flags & sampleSpindleOff));

            QVERIFY(session->end());
            QVERIFY(stage.workpiece() == after);
            QCOMPARE(removedUnits(*take), before - stage.units());
            // After the session, with its own functions and with the history.
            QVERIFY(session->undoStroke());
            QVERIFY(stage.workpiece() == states[1]);
            QVERIFY(stage.strokes.undo(stage.project, stage.milling.embedded.workpiece));
            QVERIFY(stage.workpiece() == states[0]);
            QVERIFY(stage.strokes.redo(stage.project, stage.milling.embedded.workpiece));
            last = stage.workpiece();
            QVERIFY(last == states[1]);
            QVERIFY(stage.project.save());
        }
        QVERIFY(last == replayed(fileIn(folder)));
    }

    /// Undo while the button is down ends the stroke there; further motion with the button down is another stroke.
    void aStrokeUnderWayIsTakenBack() {
        const QTemporaryDir folder;
        Lines last;
        {
            Stage stage(fileIn(folder));
            const Lines before = stage.workpiece();
            const auto session = stage.begin(handRequest());
            QVERIFY(session->startRecording("take"));
            stage.hand.mill(1);
            SessionState state;
            QVERIFY(await([&] { return session->newest(state) && state.removalRate > 0.0; }));
            QVERIFY(session->undoStroke());
            QVERIFY(await([&] { return stage.hand.done() == 1; }));
            QVERIFY(session->end());
            const Result<Take> take = stage.project.take(session->take());
            QVERIFY(take && contiguous(*take));
            QCOMPARE(take->undone.size(), std::size_t{1});
            while (stage.strokes.canUndo())
                QVERIFY(stage.strokes.undo(stage.project, stage.milling.embedded.workpiece));
            QVERIFY(stage.workpiece() == before);
            while (stage.strokes.canRedo())
                if (!stage.strokes.redo(stage.project, stage.milling.embedded.workpiece)) break;
            last = stage.workpiece();
            QVERIFY(stage.project.save());
        }
        QVERIFY(last == replayed(fileIn(folder)));
    }

    /// At most the promised number of strokes is kept; older ones stay milled, and the newer ones are still exact.
    void onlyTheNewestStrokesCanBeTakenBack() {
        const QTemporaryDir folder;
        constexpr int strokes = int{StrokeHistory::maximum} + 5;
        Stage stage(fileIn(folder), strokes);
        stage.hand.mill(strokes);
        SessionRequest request = handRequest(Pace::realtime);
        request.ticksPerEdge = 20;
        request.takeName = "many";
        const auto session = stage.begin(request);
        SessionState state;
        QVERIFY(await([&] { return session->newest(state), session->ended(); }) && session->end());
        QCOMPARE(stage.strokes.count(), StrokeHistory::maximum);
        for (std::size_t i = 0; i < StrokeHistory::maximum; ++i) QVERIFY(session->undoStroke());
        QVERIFY(!stage.strokes.canUndo());
        QVERIFY(stage.workpiece() == replayed(stage.project));
        for (std::size_t i = 0; i < StrokeHistory::maximum; ++i) QVERIFY(session->redoStroke());
        QVERIFY(stage.workpiece() == replayed(stage.project));
    }

    /// Views, path and figures of a running session.
    void whatIsToBeSeenFollowsTheTool() {
        const QTemporaryDir folder;
        Stage stage(fileIn(folder));
        const auto session = stage.begin(handRequest());
        QVERIFY(shown(*session) == stage.workpiece()); // nothing is being cut
        WorkpieceView view;
        QVERIFY(session->startRecording("take"));
        const auto start = std::chrono::steady_clock::now();
        QVERIFY(millStrokes(stage, *session, 2));
        std::optional<std::chrono::steady_clock::time_point> cut;
        QVERIFY(await([&] { return session->newestView(view) && (cut = view.oldestCut).has_value(); }));
        QVERIFY(*cut >= start && *cut <= std::chrono::steady_clock::now());
        const Lines seen = shown(*session);
        QVERIFY(await([&] { return session->newestView(view); }));
        QVERIFY(!view.oldestCut); // already shown
        SessionState state;
        QVERIFY(await([&] { return session->newest(state) && state.rateHz > 0.0; }));
        QVERIFY(state.recording && !state.cutting && state.recordedSeconds > 0.1);
        QVERIFY(state.cpuP999 > 0.0 && state.workP999 >= state.cpuP999 * 0.5);
        std::vector<TracePoint> trace;
        session->takeTrace(trace);
        QVERIFY(session->end());
        QVERIFY(seen == stage.workpiece());
        const Result<Take> take = stage.project.take(session->take());
        std::size_t at = 0;
        bool cutting = false;
        for (const Sample& sample : take->samples) {
            const bool now = !(sample.flags & sampleSpindleOff);
            if (now) {
                QVERIFY(at < trace.size());
                QCOMPARE(trace[at].tip, glm::vec3(sample.proxy.tip));
                QCOMPARE(trace[at].strokeBegins, !cutting);
                ++at;
            }
            cutting = now;
        }
        QCOMPARE(at, trace.size());
        QVERIFY(session->newestView(view) && linesOf(view.workpiece) == seen);
    }

    /// When the volume's memory runs out, old strokes are packed and milling continues; all of them can still be
    /// undone.
    void oldStrokesMakeRoomForNewCuts() {
        const QTemporaryDir folder;
        Stage stage(fileIn(folder));
        RunVolume& workpiece = stage.milling.embedded.workpiece;
        const Grid grid = workpiece.grid();
        RunVolume small = *RunVolume::make(grid, workpiece.properties(), 60'000);
        QVERIFY(small.fillBlock({0, 0}, {grid.lineCountU(), grid.lineCountV()}, 0, grid.toRunPosition(top),
                                stage.milling.embedded.stockProperty));
        workpiece = std::move(small);
        const Lines before = stage.workpiece();
        const auto session = stage.begin(handRequest());
        QVERIFY(session->startRecording("dense"));
        stage.hand.mill(100);
        QVERIFY(await([&] { return stage.hand.done() >= 20; })); // nothing is packed meanwhile
        bool full = false;
        SessionState state;
        const bool made = await([&] {
            if (!session->newest(state)) return false;
            full = full || (state.sample.flags & sampleMemoryFull);
            return full && !(state.sample.flags & sampleMemoryFull) && state.removalRate > 0.0;
        });
        QVERIFY(full);
        QVERIFY(made);
        QVERIFY(session->end());
        QCOMPARE(stage.strokes.count(), std::size_t{stage.strokes.added()});
        QVERIFY(stage.strokes.cost().packedBytes > 0);
        while (stage.strokes.canUndo()) QVERIFY(stage.strokes.undo(stage.project, workpiece));
        QVERIFY(stage.workpiece() == before);
    }

    /// The virtual operator as the window runs it: the stages of the plan, in time lapse, with the same result as on
    /// the command line.
    void theOperatorMillsTheSameInTimeLapse() {
        const QTemporaryDir folder, other;
        const OperatorRequest request;
        const std::atomic<bool> stop{false};
        Stage fast(fileIn(other));
        const Result<OperatorOutcome> milled =
            millWithOperator(fast.project, fast.milling, ToolBounds::borrowing(*fast.field), request, stop);
        QVERIFY(milled);
        Stage stage(fileIn(folder));
        const Result<OperatorPlan> plan = planOperator(stage.milling, ToolBounds::borrowing(*stage.field), request);
        QVERIFY(plan);
        QCOMPARE(plan->stages.size(), milled->takes.size());
        for (const OperatorStage& part : plan->stages) {
            VirtualOperator hand(part.intent, plan->mapping, plan->hand);
            SessionRequest lapse;
            lapse.allowance = part.allowance;
            lapse.mapping = plan->mapping;
            lapse.felt = plan->felt;
            lapse.ticksPerEdge = 50;
            lapse.takeName = part.name;
            const auto session = MillingSession::begin(stage.project, stage.milling,
                                                       ToolBounds::borrowing(*stage.field), hand, stage.strokes, lapse);
            QVERIFY(session && await([&] { return (*session)->ended(); }) && (*session)->end());
        }
        QVERIFY(stage.workpiece() == fast.workpiece());
        QCOMPARE(stage.project.take(1)->samples.size(), fast.project.take(1)->samples.size());
    }

    /// Whatever is requested: workshop rules by material, a full diameter and more in wax and board, half of one in
    /// aluminium.
    void theOperatorTakesNoLevelDeeperThanItsShare() {
        for (const auto& [material, share] :
             {std::pair{"machinable-wax", 2.0}, std::pair{"tooling-board", 2.0}, std::pair{"aluminium-6061", 0.5}})
            for (const double diameter : {2.0, 4.0})
                for (const double asked : {0.0, 50.0}) {
                    Tool tool = sessionTool();
                    tool.maximumDepthOfCut = 0.0;
                    tool.cutter.diameter = tool.cutter.shankDiameter = diameter;
                    tool.cutter.cornerRadius = 0.5 * diameter;
                    Setup setup = blockSetup();
                    setup.stockMaterial = material;
                    const MillingContext milling = partMilling(tool, setup);
                    Progress progress;
                    const auto field = clearanceField(milling, 0.5, progress);
                    QVERIFY(field);
                    OperatorRequest request;
                    request.levelDepth = asked;
                    const Result<OperatorPlan> plan = planOperator(milling, ToolBounds::borrowing(**field), request);
                    QVERIFY(plan && !plan->plan.levels.empty());
                    double above = top, deepest = 0.0;
                    for (const double level : plan->plan.levels) {
                        deepest = std::max(deepest, above - level);
                        above = level;
                    }
                    QVERIFY2(deepest <= share * diameter + 1e-9, qPrintable(QString::number(deepest)));
                    QVERIFY2(deepest >= 0.25 * share * diameter, qPrintable(QString::number(deepest)));
                }
    }
};

BURIN_TEST(TestMillingSession, NoApplication)

} // namespace burin::tst_milling_session

#include "tst_milling_session.moc"

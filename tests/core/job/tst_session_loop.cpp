// SPDX-FileCopyrightText: 2026 The Burin authors
// SPDX-License-Identifier: Apache-2.0
#include "core/job/recorded_cuts.h"
#include "core/job/session_loop.h"
#include "tests/core/cutting/scalar_cutter.h"
#include "tests/core/document/sample_project.h"
#include "tests/core/job/session_milling.h"
#include "tests/oracles/allocation_count.h"
#include "tests/test_program.h"

#include <QTemporaryDir>
#include <QtTest>

namespace burin::tst_session_loop {

using namespace burin::test;

/// A loop over a block, a hand that mills it on its button, and a take to record into.
struct LoopUnderTest {
    QTemporaryDir folder;
    Project project = *Project::create(folder.filePath("p.burin").toStdString());
    MillingContext milling = blockMilling();
    Progress progress;
    std::unique_ptr<const ClearanceField> field = *clearanceField(milling, 0.5, progress);
    StrokeHand hand;
    HapticStep step{milling.embedded.workpiece, *field, milling.tool, settingsFor(hand)};
    std::atomic<bool> stop{false};
    std::unique_ptr<SessionLoop> loop = std::make_unique<SessionLoop>(step, milling.embedded.workpiece, true, stop);
    Ring<Sample> unused{16};
    const Recorder recorder{unused, *project.beginTake(fixture::takeInfo("take"))};

    static HapticSettings settingsFor(const StrokeHand& hand) {
        HapticSettings settings;
        settings.stylus = hand.description();
        settings.cutsOnButton = true;
        return settings;
    }
};

/// The loop's side of a session, driven tick by tick.
class TestSessionLoop : public QObject {
    Q_OBJECT
private slots:
    void guidesAndWorkspaceComeInAtATicksEdge() {
        LoopUnderTest test;
        const auto tick = [&](int number) {
            const std::size_t before = allocationCount;
            if (test.loop->edge() != AtEdge::tick) return Sample{};
            const Sample sample = test.step.advance(test.hand.read(0.001 * number), 0.001);
            test.loop->tick(sample, {});
            return allocationCount == before ? sample : Sample{};
        };
        const glm::dvec3 tip = tick(0).stylusTip;
        TickNews news;
        GuideSettings guides;
        guides.guides[2].on = true;
        guides.guides[2].kind = GuideKind::levels;
        guides.guides[2].point = tip;
        guides.guides[2].distance = 0.5;
        test.loop->tell(guides);
        WorkspaceSettings workspace;
        workspace.scale = 3.0;
        workspace.clutched = true;
        test.loop->tell(workspace);
        Sample last;
        for (int i = 1; i < 200; ++i) last = tick(i);
        QVERIFY((last.flags & sampleOnGuide) != 0);
        QVERIFY(test.loop->takeNews(news));
        QCOMPARE(news.guides[2].is, GuideNews::Is::holding);
        QCOMPARE(news.guides[0].is, GuideNews::Is::off);
        QCOMPARE(news.workspaceScale, 3.0);
        QVERIFY(news.clutched);
        const int level = news.guides[2].level;
        test.loop->tell(LevelStep{-1});
        for (int i = 200; i < 600; ++i) tick(i);
        QVERIFY(test.loop->takeNews(news));
        QCOMPARE(news.guides[2].level, level - 1);
    }

    /// Takes, strokes, views, figures: none of it allocates in the loop, whatever the owner keeps of it.
    void noTickAllocates() {
        LoopUnderTest test;
        StrokeHistory strokes;
        WorkpieceView view;
        Stroke stroke;
        std::vector<Sample> samples(256);
        std::vector<TracePoint> trace(256);
        TickNews news;
        LiveFigures figures;
        constexpr int ticks = (StrokeHand::strokeTicks + StrokeHand::backTicks) * (int{StrokeHistory::maximum} + 10);
        test.hand.mill(1000);
        test.loop->requestTake({test.recorder.take(), &test.recorder});
        std::size_t allocations = 0, strokesSeen = 0, views = 0, recorded = 0;
        TickTiming timing;
        timing.period = 0.001;
        for (int tick = 0; tick < ticks; ++tick) {
            const StylusState state = test.hand.read(0.001 * tick);
            const std::size_t before = allocationCount;
            if (test.loop->edge() != AtEdge::tick) QFAIL("no tick");
            const Sample sample = test.step.advance(state, timing.period);
            timing.over += 1'000'000;
            timing.work = timing.cpu = 10'000;
            test.loop->tick(sample, timing);
            allocations += allocationCount - before;

            // The owner keeps as many strokes as permitted, and one view, which it renews.
            while (test.loop->takeStroke(stroke)) {
                strokes.add(std::move(stroke));
                ++strokesSeen;
            }
            if (tick % 16 == 0) {
                views += test.loop->takeView(view) ? 1u : 0u;
                test.loop->requestView();
            }
            recorded += test.loop->samples().pop(samples);
            test.loop->takeTrace(trace);
            test.loop->takeNews(news);
            test.loop->takeFigures(figures);
        }
        QCOMPARE(allocations, std::size_t{0});
        QVERIFY(strokesSeen > StrokeHistory::maximum);
        QCOMPARE(strokes.count(), StrokeHistory::maximum);
        QVERIFY(views > 300);
        QCOMPARE(recorded, std::size_t{ticks});
        QCOMPARE(news.ticks, std::uint64_t{ticks});
        QVERIFY(std::abs(figures.rateHz - 1000.0) < 1.0);
    }

    /// An owner that does not collect strokes for a long time gets fewer of them, and none with a gap in it.
    void strokesThatNobodyTakesGrowTogether() {
        LoopUnderTest test;
        test.hand.mill(20);
        test.loop->requestTake({test.recorder.take(), &test.recorder});
        TickTiming timing;
        timing.period = 0.001;
        std::vector<Lines> found; // the workpiece before each stroke
        std::vector<std::uint64_t> firsts;
        bool cutting = false;
        for (std::uint64_t tick = 0; test.hand.done() < 20; ++tick) {
            const StylusState state = test.hand.read(0.0);
            const bool begins = state.buttons != 0 && !cutting;
            cutting = state.buttons != 0;
            if (begins) {
                found.push_back(linesOf(test.milling.embedded.workpiece));
                firsts.push_back(tick);
            }
            QCOMPARE(test.loop->edge(), AtEdge::tick);
            test.loop->tick(test.step.advance(state, timing.period), timing);
        }
        test.loop->request(SessionLoop::Request::finish);
        test.loop->edge();
        QVERIFY(!test.loop->fulfilled()); // waits for the owner
        std::vector<Stroke> strokes;
        for (Stroke stroke; test.loop->takeStroke(stroke); test.loop->edge()) strokes.push_back(std::move(stroke));
        QVERIFY(test.loop->fulfilled());
        QCOMPARE(strokes.size(), std::size_t{9});
        for (std::size_t i = 0; i < strokes.size(); ++i) {
            QCOMPARE(strokes[i].first, firsts[i]);
            QVERIFY(linesOf(strokes[i].before) == found[i]);
        }
        QVERIFY(strokes.back().first + strokes.back().count > firsts.back()); // it contains all the others
    }

    /// When a stroke has ended, the workpiece is what the recorded moves leave of it, cut line by line or replayed: an
    /// undo, save or measurement never misses a cut.
    void aStrokesEndShowsAllThatWasCut() {
        LoopUnderTest test;
        constexpr int strokes = 8;
        test.hand.mill(strokes);
        test.loop->requestTake({test.recorder.take(), &test.recorder});
        TickTiming timing;
        timing.period = 0.001;
        Take take;
        MillingContext scalarMilling = blockMilling();
        tests::ScalarCutter scalar(test.milling.tool.cutter, scalarMilling.embedded.workpiece.grid());
        int ended = 0;
        bool lagged = false;
        while (test.hand.done() < strokes) {
            const StylusState state = test.hand.read(0.0);
            const bool wasUnderWay = test.loop->strokeUnderWay();
            QCOMPARE(test.loop->edge(), AtEdge::tick);
            take.samples.push_back(test.step.advance(state, timing.period));
            test.loop->tick(take.samples.back(), timing);
            Stroke stroke;
            while (test.loop->takeStroke(stroke)) continue;
            const Sample& sample = take.samples.back();
            const bool cuts = std::ranges::any_of(sample.removed, [](const RemovedMaterial& m) { return m.units > 0; });
            if (cuts)
                scalar.cut(scalarMilling.embedded.workpiece, take.samples[take.samples.size() - 2].proxy.tip,
                           sample.proxy.tip);
            const RunVolume& workpiece = test.milling.embedded.workpiece;
            lagged = lagged || workpiece.amounts() != scalarMilling.embedded.workpiece.amounts();
            if (!wasUnderWay || test.loop->strokeUnderWay()) continue;
            ++ended;
            const VolumeSnapshot shown = test.milling.embedded.workpiece.snapshot();
            QVERIFY(shown.amounts() == workpiece.amounts());
            QVERIFY(linesOf(shown) == linesOf(scalarMilling.embedded.workpiece));
            MillingContext replayed = blockMilling();
            QVERIFY(replayTake(take, test.milling.tool, replayed, test.progress));
            QVERIFY(linesOf(shown) == linesOf(replayed.embedded.workpiece));
        }
        QCOMPARE(ended, strokes);
        QVERIFY(lagged); // during a stroke the workpiece may be late; otherwise nothing was tested
    }

private:
    using Lines = std::vector<std::vector<Segment>>;
};

BURIN_TEST(TestSessionLoop, NoApplication)

} // namespace burin::tst_session_loop

#include "tst_session_loop.moc"

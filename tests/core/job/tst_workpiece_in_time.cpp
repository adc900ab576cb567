// SPDX-FileCopyrightText: 2026 The Burin authors
// SPDX-License-Identifier: Apache-2.0
#include "core/job/switched_off.h"
#include "core/job/workpiece_in_time.h"
#include "core/volume/operations/fingerprint.h"
#include "tests/core/job/recorded_takes.h"
#include "tests/test_program.h"

#include <QTemporaryDir>
#include <QtTest>

#include <algorithm>
#include <map>
#include <random>

namespace burin::tst_workpiece_in_time {

using namespace burin::test;

namespace {

/// Takes with the given numbers of strokes; in the last but one the newest three are undone.
struct Recorded {
    explicit Recorded(const std::vector<int>& strokes) : stage(folder.filePath("p.burin").toStdString()) {
        for (std::size_t i = 0; i < strokes.size(); ++i) {
            SessionRequest request = handRequest(Pace::fast);
            request.takeName = "take " + std::to_string(i + 1);
            const auto session = stage.begin(request);
            good = good && session && millStrokes(stage, *session, strokes[i]);
            for (int back = 0; good && i + 2 == strokes.size() && back < 3; ++back)
                good = session->undoStroke().hasValue();
            good = good && session->end();
        }
        const Result<std::vector<TakeInfo>> infos = stage.project.takes();
        for (const TakeInfo& info : *infos) takes.push_back(*stage.project.take(info.id));
    }
    QTemporaryDir folder;
    Stage stage;
    std::vector<Take> takes;
    bool good = true;
};

} // namespace

class TestWorkpieceInTime : public QObject {
    Q_OBJECT
private slots:
    /// 200 moments in any order, forwards and backwards, over takes and over undone strokes: every scanline is what a
    /// replay from the start leaves. Also with workpieces that were kept on the way.
    void anyMomentIsAReplayFromTheStart() {
        const Rows recorded({4200, 3700, 2900});
        QVERIFY(recorded.good);
        std::mt19937 random(37);
        std::vector<TakeMoment> moments{{0, 0}, {recorded.takes.back().info.id + 5, 1}};
        for (int i = 0; i < 198; ++i) {
            const Take& take = recorded.takes[random() % recorded.takes.size()];
            moments.push_back({take.info.id, random() % (take.samples.size() + 1)});
        }
        std::vector<TakeMoment> rising = moments;
        const TakeOrder order = orderOf(recorded.takes);
        const auto earlier = [&](const TakeMoment& one, const TakeMoment& other) { return order.isBefore(one, other); };
        std::ranges::sort(rising, earlier);
        const std::vector<Lines> expected = replayedTo(recorded.takes, rising);
        QCOMPARE(expected.size(), moments.size());
        std::map<TakeMoment, const Lines*, decltype(earlier)> at(earlier);
        for (std::size_t i = 0; i < rising.size(); ++i) at[rising[i]] = &expected[i];

        Progress progress;
        std::vector<KeptWorkpiece> kept;
        for (const bool again : {false, true}) { // from the stock alone, then with kept workpieces
            Result<WorkpieceInTime> time = WorkpieceInTime::make(stock(), sharedCuts(recorded.project), kept, progress);
            QVERIFY(time);
            std::ranges::shuffle(moments, random);
            for (const TakeMoment& moment : moments) {
                const Result<VolumeSnapshot> workpiece = time->at(moment, progress);
                QVERIFY(workpiece);
                QVERIFY2(linesOf(*workpiece) == *at[moment],
                         qPrintable(QString("take %1, sample %2").arg(moment.take).arg(moment.samples)));
            }
            std::vector<KeptWorkpiece> made = time->takeWorthKeeping();
            QCOMPARE(made.empty(), again);
            if (!again) kept = std::move(made);
        }
        QCOMPARE(kept.size(), recorded.takes.size()); // at their ends
    }

    /// Returning to an earlier moment costs no cutting, and neither does a kept workpiece; the moves up to a new moment
    /// do.
    void nothingIsCutTwice() {
        const Rows recorded({6000});
        QVERIFY(recorded.good);
        const std::int64_t take = recorded.takes.front().info.id;
        const std::uint64_t samples = recorded.takes.front().samples.size();
        Progress progress;
        Result<WorkpieceInTime> time = WorkpieceInTime::make(stock(), sharedCuts(recorded.project), {}, progress);
        QVERIFY(time && time->at({take, samples}, progress));
        const std::uint64_t all = time->takes().front()->motions.count();
        QVERIFY2(all > 4 * WorkpieceInTime::motionsPerStep, qPrintable(QString::number(all)));
        QCOMPARE(time->motionsCut(), all);
        QVERIFY(time->at({0, 0}, progress) && time->at({take, samples}, progress));
        QVERIFY(time->motionsCut() < all + WorkpieceInTime::motionsPerStep);

        Result<WorkpieceInTime> later =
            WorkpieceInTime::make(stock(), sharedCuts(recorded.project), time->takeWorthKeeping(), progress);
        QVERIFY(later && later->at({take, samples}, progress));
        QCOMPARE(later->motionsCut(), std::uint64_t{0});
    }

    /// A cancelled request leaves the workpiece at its moment, or on the way, and continues from there.
    void cancellingLosesNothing() {
        const Recorded recorded({40});
        QVERIFY(recorded.good);
        const TakeMoment end{recorded.takes.front().info.id, recorded.takes.front().samples.size()};
        Progress progress, cancelled;
        cancelled.cancel();
        Result<WorkpieceInTime> time = WorkpieceInTime::make(stock(), sharedCuts(recorded.stage.project), {}, progress);
        QVERIFY(time);
        const Result<VolumeSnapshot> none = time->at(end, cancelled);
        QVERIFY(!none && none.error().code == ErrorCode::cancelled);
        const Result<VolumeSnapshot> all = time->at(end, progress);
        QVERIFY(all && linesOf(*all) == recorded.stage.workpiece());
    }

    /// Work after a moment is switched off: the workpiece is that of the moment, whether it was kept or not; switched
    /// on again it is as before. A stroke that is off is not cut, and strokes are undone as before.
    void whatIsSwitchedOffCountsNoMore() {
        Recorded recorded({20, 12, 9});
        QVERIFY(recorded.good);
        Project& project = recorded.stage.project;
        Progress progress;
        const Lines all = recorded.stage.workpiece();
        const auto remade = [&] {
            MillingContext milling = blockMilling();
            return replayTakes(project, milling, progress) ? linesOf(milling.embedded.workpiece) : Lines{};
        };
        const Take& second = recorded.takes[1];
        const TakeMoment middle{second.info.id, second.samples.size() / 2 + 7};
        const Lines then = replayedTo(recorded.takes, {middle}).front();
        const Result<SwitchedOff> off = offAfter(project, middle);
        QVERIFY(off && off->size() == 2);
        const Result<SwitchedOff> before = switchedOff(project, *off);
        QVERIFY(before && setSwitchedOff(project, *off));
        QVERIFY(remade() == then);
        const Result<TakeOutline> outline = project.takeOutline(second.info.id);
        QVERIFY(outline && outline->info.undoneCount >= second.samples.size() - middle.samples);

        // If a workpiece was kept at the moment, nothing is cut again: neither the work before it, nor that which is
        // off.
        MillingContext milling = blockMilling();
        QVERIFY(replayTakes(project, milling, progress));
        QVERIFY(project.keepWorkpiece(*keptAs(milling.embedded.workpiece.snapshot(), middle, {}, progress),
                                      *project.recordedState()));
        const Result<RecordedWork> work = recordedWork(project);
        QVERIFY(work && work->kept && work->kept->at == middle);
        for (const RecordedCuts& cuts : work->cuts) QCOMPARE(cuts.motions.count(), cuts.done);
        QVERIFY(remade() == then);

        QVERIFY(setSwitchedOff(project, *before));
        QVERIFY(remade() == all);
        QVERIFY(recordedWork(project)->kept); // the work before the moment is the same
        QVERIFY(project.save());
        QVERIFY(remade() == all);
    }

    /// Ranges compared with a set of samples, one by one.
    void intervalsAreSwitchedSampleBySample() {
        Recorded recorded({3});
        QVERIFY(recorded.good);
        Project& project = recorded.stage.project;
        const std::int64_t take = recorded.takes.front().info.id;
        const std::uint64_t count = recorded.takes.front().samples.size();
        std::vector<bool> expected(count, false);
        std::mt19937 random(5);
        for (int i = 0; i < 200; ++i) {
            const SampleRange interval{random() % count, 1 + random() % 40};
            const bool off = random() % 2 == 0;
            const Result<SwitchedOff> wanted = withInterval(project, take, interval, off);
            QVERIFY(wanted && setSwitchedOff(project, *wanted));
            for (std::uint64_t s = interval.first; s < std::min(count, interval.first + interval.count); ++s)
                expected[s] = off;
            std::vector<bool> found(count, false);
            const Result<std::vector<SampleRange>> ranges = project.switchedOff(take);
            std::uint64_t end = 0;
            for (const SampleRange& range : *ranges) {
                QVERIFY(range.first > end || (range.first == 0 && end == 0)); // separate
                end = range.first + range.count;
                for (std::uint64_t s = range.first; s < end; ++s) found[s] = true;
            }
            QVERIFY(found == expected);
        }
        QVERIFY(!withInterval(project, take, {count, 1}, true));
        QVERIFY(!withInterval(project, take + 1, {0, 1}, true));
        const std::vector<SampleRange> beyond{{count - 1, 2}}, crossed{{5, 5}, {7, 2}};
        QVERIFY(!project.setSwitchedOff(take, beyond) && !project.setSwitchedOff(take, crossed));
    }

    /// Of many kept workpieces the newest stays, and at most the permitted number; invalid ones are removed first.
    void ofManyTheOlderAreThinnedOut() {
        Recorded recorded({3});
        QVERIFY(recorded.good);
        Project& project = recorded.stage.project;
        const std::int64_t take = recorded.takes.front().info.id;
        const RecordedState state = *project.recordedState();
        for (std::uint64_t i = 1; i <= 150; ++i) QVERIFY(project.keepWorkpiece({{take, i}, {}, "x"}, state));
        const std::vector<TakeMoment> kept = *project.keptMoments();
        QVERIFY(kept.size() > 30 && kept.size() <= 64);
        QVERIFY((kept.back() == TakeMoment{take, 150}));
        // A workpiece made in another state is not kept at all.
        QVERIFY(project.undoInterval(take, {0, 10}));
        QVERIFY(project.keepWorkpiece({{take, 151}, {}, "x"}, state));
        QVERIFY(project.keptMoments()->empty());
        for (std::uint64_t i = 200; i < 264; ++i)
            QVERIFY(project.keepWorkpiece({{take, i}, {}, "x"}, *project.recordedState()));
        QCOMPARE(project.keptMoments()->size(), std::size_t{64});
    }

    /// A project returns a kept workpiece as long as nothing that it is made from has changed; opening then cuts
    /// nothing.
    void whatIsKeptHoldsUntilWhatItIsMadeOfChanges() {
        Recorded recorded({10, 6});
        QVERIFY(recorded.good);
        Project& project = recorded.stage.project;
        Progress progress;
        const std::map<std::int64_t, std::size_t> strokes = recordedWork(project, false)->strokes;
        const TakeMoment end{recorded.takes.back().info.id, recorded.takes.back().samples.size()};
        QVERIFY(project.save());
        const Result<bool> unsaved = project.unsaved();
        QVERIFY(
            project.keepWorkpiece(*keptAs(recorded.stage.milling.embedded.workpiece.snapshot(), end, strokes, progress),
                                  *project.recordedState()));
        QCOMPARE(*project.unsaved(), *unsaved); // requires no saving
        QCOMPARE(project.keptMoments()->size(), std::size_t{1});

        const Result<RecordedWork> work = recordedWork(project);
        QVERIFY(work && work->kept && work->cuts.empty());
        QVERIFY(work->strokes == strokes);
        MillingContext opened = blockMilling();
        QVERIFY(replayTakes(*work, opened, progress));
        QVERIFY(linesOf(opened.embedded.workpiece) == recorded.stage.workpiece());
        QCOMPARE(fingerprint(opened.embedded.workpiece.snapshot()),
                 fingerprint(recorded.stage.milling.embedded.workpiece.snapshot()));
        QVERIFY(opened.embedded.workpiece.amounts() == recorded.stage.milling.embedded.workpiece.amounts());

        const SampleRange stroke{0, 20};
        QVERIFY(project.undoInterval(recorded.takes.front().info.id, stroke));
        QVERIFY(project.keptMoments()->empty());
        QVERIFY(!recordedWork(project)->kept);
        QVERIFY(project.redoInterval(recorded.takes.front().info.id, stroke));
        QCOMPARE(project.keptMoments()->size(), std::size_t{1});
        Setup finer = blockSetup();
        finer.voxel = 0.25;
        QVERIFY(project.setSetup(finer));
        QVERIFY(project.keptMoments()->empty());
        QVERIFY(project.setSetup(blockSetup()));
        QVERIFY(project.removeTake(recorded.takes.back().info.id));
        QVERIFY(project.keptMoments()->empty());
    }
};

BURIN_TEST(TestWorkpieceInTime, QCoreApplication)

} // namespace burin::tst_workpiece_in_time

#include "tst_workpiece_in_time.moc"

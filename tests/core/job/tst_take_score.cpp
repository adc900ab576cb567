// SPDX-FileCopyrightText: 2026 The Burin authors
// SPDX-License-Identifier: Apache-2.0
#include "core/job/take_score.h"
#include "core/recording/tip_smoothness.h"
#include "tests/core/job/part_milling.h"
#include "tests/test_program.h"

#include <QTemporaryDir>
#include <QtTest>

#include <cmath>

namespace burin::tst_take_score {

using namespace burin::test;

namespace {

constexpr double tick = 0.001; // s

Tool flatTool() {
    Tool tool = sessionTool();
    tool.id = "flat-4";
    tool.cutter.type = CutterType::flat;
    tool.cutter.cornerRadius = 0.0;
    return tool;
}

/// Ticks of a tool that moves along x at 20 mm/s with its spindle on.
std::vector<Sample> ticks(std::size_t count) {
    std::vector<Sample> samples(count);
    for (std::size_t i = 0; i < count; ++i) {
        samples[i].tick = i;
        samples[i].time = tick * static_cast<double>(i);
        samples[i].proxy.tip = {0.02 * static_cast<double>(i), 5.0, 12.0};
        samples[i].stylusTip = samples[i].proxy.tip;
    }
    return samples;
}

/// Makes ticks in which the part blocks the tool while the hand is deeper.
void push(std::vector<Sample>& samples, std::size_t first, double depth, std::uint32_t further = 0,
          std::size_t count = 20) {
    for (std::size_t i = first; i < first + count; ++i) {
        samples[i].flags |= sampleOnBoundary | further;
        samples[i].stylusTip.z = samples[i].proxy.tip.z - depth;
    }
}

/// Rows of a flat end mill over the whole block, a millimetre apart; each tick removes the volume that it sweeps.
std::vector<Sample> facing(double height, const Tool& tool, MillingContext& milling) {
    MaterialRemoval removal(tool.cutter, milling.embedded.workpiece.grid(), Writing::everyCut);
    std::vector<Sample> samples;
    for (double y = 0.0; y <= side; y += 1.0)
        for (double x = 0.0; x <= side; x += 1.0) {
            Sample sample;
            sample.tick = samples.size();
            sample.time = tick * static_cast<double>(sample.tick);
            sample.proxy.tip = {std::fmod(y, 2.0) == 0.0 ? x : side - x, y, height};
            sample.stylusTip = sample.proxy.tip;
            if (!samples.empty()) {
                const CutResult cut = removal.cut(milling.embedded.workpiece, samples.back().proxy, sample.proxy);
                sample.reportedRemoval = cut.volume;
                sample.removed[0] = {cut.removed[0].units, cut.removed[0].property};
            }
            samples.push_back(sample);
        }
    return samples;
}

/// A project to record takes in.
struct Recordings {
    Recordings() : project(*Project::create(folder.filePath("p.burin").toStdString())) {
        good = project.setModel(Model{}) && project.setSetup(blockSetup()) && project.setTool(flatTool());
    }
    std::int64_t record(const std::vector<Sample>& samples) {
        TakeInfo info;
        info.name = "take";
        info.toolId = flatTool().id;
        Result<Project::TakeWriter> writer = project.beginTake(info);
        good = good && writer && writer->append(samples) && writer->finish();
        return good ? writer->id() : 0;
    }
    TakeScore score(std::int64_t take, const MillingContext& milling) {
        Progress progress;
        Result<ScoreMatter> matter = scoreMatter(project, take, progress);
        if (!matter) qFatal("no matter");
        Result<TakeScore> score = takeScore(std::move(*matter), milling, progress);
        if (!score) qFatal("no score");
        return *score;
    }
    QTemporaryDir folder;
    Project project;
    bool good = true;
};

bool is(const std::optional<double>& value, double wanted, double off = 1e-9) {
    if (value && std::abs(*value - wanted) <= off) return true;
    qWarning("%g, not %g", value.value_or(std::nan("")), wanted);
    return false;
}

} // namespace

class TakeScoreTest final : public QObject {
    Q_OBJECT

private slots:
    /// Three pushes by construction. Pushes of less than 0.1 mm don't count, nor those in which something else blocks
    /// the tool, the spindle is off, or the samples were undone.
    void pushesIntoThePartAreCounted() {
        std::vector<Sample> samples = ticks(1000);
        push(samples, 100, 0.5);
        push(samples, 200, 0.08); // too small
        push(samples, 300, 0.12, 0, 10);
        push(samples, 310, 0.09, 0, 10); // a tremor at the limit
        push(samples, 320, 0.13, 0, 10);
        push(samples, 400, 2.0, sampleOnObstacle); // a fixture
        push(samples, 450, 2.0, sampleOnGuide);
        push(samples, 500, 2.0, sampleStylusInvalid);
        push(samples, 550, 2.0, sampleSpindleOff);
        push(samples, 600, 0.8, 0, 200); // long, but only one
        push(samples, 900, 3.0);         // undone
        Recordings recordings;
        const std::int64_t take = recordings.record(samples);
        const std::vector<SampleRange> back{{900, 100}}, off{{850, 100}};
        QVERIFY(recordings.good && recordings.project.undoInterval(take, back.front()));
        QVERIFY(recordings.project.setSwitchedOff(take, off));
        QCOMPARE(*recordings.project.takenBack(take), back);
        const TakeScore score = recordings.score(take, blockMilling());
        QVERIFY(is(score[ScoreValue::gougeTries], 3.0));
        QVERIFY(is(score[ScoreValue::largestPush], 0.8));
        QVERIFY(is(score[ScoreValue::duration], 0.999)); // from the first to the last of 1000 ticks
        // Ticks 0 to 549 and 570 to 899: the spindle is stopped between them, and the last 100 ticks were undone.
        QVERIFY(is(score[ScoreValue::milling], 0.549 + 0.329));
        QVERIFY(!score[ScoreValue::meanForce] && is(score[ScoreValue::removed], 0.0));
        QVERIFY(!score[ScoreValue::meanStockLeft]); // no part
        Progress progress;
        const Result<ScoreMatter> deeper = scoreMatter(recordings.project, take, progress, {.deep = 0.6});
        QVERIFY(deeper && is(deeper->score[ScoreValue::gougeTries], 1.0));
    }

    /// The mean of 5 N while cutting does not depend on air moves; the peak is that of one tick. Switching the take off
    /// makes no difference.
    void forceIsThatOfTheCut() {
        std::vector<Sample> samples = ticks(1000);
        for (std::size_t i = 200; i < 700; ++i) {
            samples[i].cuttingForce = {3.0, 0.0, -4.0};
            samples[i].reportedRemoval = 0.01;
        }
        Recordings recordings;
        const std::int64_t even = recordings.record(samples);
        samples[300].cuttingForce = {0.0, 30.0, 0.0};
        const std::int64_t uneven = recordings.record(samples);
        const MillingContext milling = blockMilling();
        const TakeScore score = recordings.score(even, milling), other = recordings.score(uneven, milling);
        QVERIFY(is(score[ScoreValue::meanForce], 5.0) && is(score[ScoreValue::peakForce], 5.0));
        QVERIFY(is(other[ScoreValue::meanForce], (499.0 * 5.0 + 30.0) / 500.0));
        QVERIFY(is(other[ScoreValue::peakForce], 30.0));
        TipSmoothness smoothness(tick);
        for (const Sample& sample : samples) smoothness.add(sample);
        smoothness.interrupt();
        QVERIFY(is(score[ScoreValue::smoothness], *smoothness.mean()));
        const std::vector<SampleRange> whole{{0, 1000}};
        QVERIFY(recordings.project.setSwitchedOff(even, whole));
        QCOMPARE(recordings.score(even, milling).values, score.values);
    }

    /// A block of 20 × 20 × 10 mm with a part of 8 × 8 mm up to z = 8 mm. A flat end mill reaches all of its top of
    /// 64 mm² and its sides of 224 mm². On them are 2 mm and 6 mm of stock, and 0.5 mm on the top after the block is
    /// faced to 8.5 mm, which removes 600 mm³. The stock left by a take includes the effect of earlier takes, unless
    /// they are switched off.
    void removalAndStockLeftAreThoseOfTheBlock() {
        const MillingContext part = partMilling(flatTool());
        MillingContext milled = partMilling(flatTool());
        Recordings recordings;
        const std::int64_t none = recordings.record(ticks(100));
        const std::vector<Sample> upper = facing(9.0, flatTool(), milled), lower = facing(8.5, flatTool(), milled);
        const std::int64_t first = recordings.record(upper), second = recordings.record(lower);
        QVERIFY(recordings.good);
        const auto leftOn = [](double top) { return (64.0 * top + 224.0 * 6.0) / 288.0; };
        const TakeScore before = recordings.score(none, part), half = recordings.score(first, part),
                        after = recordings.score(second, part);
        QVERIFY(is(before[ScoreValue::meanStockLeft], leftOn(2.0), 0.03));
        QVERIFY(is(half[ScoreValue::meanStockLeft], leftOn(1.0), 0.03));
        QVERIFY(is(after[ScoreValue::meanStockLeft], leftOn(0.5), 0.03));
        QVERIFY(is(after[ScoreValue::mostStockLeft], 6.0, 0.01));
        QVERIFY(is(half[ScoreValue::removed], 400.0, 0.5) && is(after[ScoreValue::removed], 200.0, 0.5));
        const double seconds = 440 * tick; // from the first to the last of 441 ticks
        QVERIFY(is(half[ScoreValue::milling], seconds));
        QVERIFY(is(half[ScoreValue::removalRate], 400.0 / seconds, 0.5 / seconds));
        const std::vector<SampleRange> whole{{0, lower.size()}};
        QVERIFY(recordings.project.setSwitchedOff(first, whole));
        QVERIFY(is(recordings.score(first, part)[ScoreValue::meanStockLeft], leftOn(1.0), 0.03));
        QVERIFY(is(recordings.score(second, part)[ScoreValue::meanStockLeft], leftOn(0.5), 0.03));

        std::vector<Sample> leaning = ticks(100);
        leaning[50].proxy.axis = glm::normalize(glm::dvec3(0.1, 0.0, 1.0));
        QVERIFY(!recordings.score(recordings.record(leaning), part)[ScoreValue::meanStockLeft]);
    }

    /// 300 ticks without a sample: 100 while the tool mills, which count as milling, and 200 while the spindle is off.
    /// The duration is that of the list of takes.
    void missedTicksTakeTime() {
        std::vector<Sample> samples = ticks(1000);
        for (std::size_t i = 600; i < 700; ++i) samples[i].flags |= sampleSpindleOff;
        for (std::size_t i = 200; i < samples.size(); ++i) {
            samples[i].tick += i < 650 ? 100 : 300;
            samples[i].time = tick * static_cast<double>(samples[i].tick);
        }
        Recordings recordings;
        const std::int64_t take = recordings.record(samples);
        const TakeScore score = recordings.score(take, blockMilling());
        QVERIFY(is(score[ScoreValue::duration], 1.299));
        QCOMPARE(score[ScoreValue::duration], recordings.project.takes()->front().seconds);
        // Ticks 0 to 699 and 1000 to 1299.
        QVERIFY(is(score[ScoreValue::milling], 0.699 + 0.299));
    }

    /// Verdict, difference, and ratio to the reference.
    void valuesAreComparedWithTheReference() {
        using Kind = ScoreVerdict::Kind;
        TakeScore take, reference;
        const auto verdict = [&](ScoreValue value, std::optional<double> own, std::optional<double> other) {
            take[value] = own;
            reference[value] = other;
            return verdictOf(value, take, reference);
        };
        const ScoreVerdict slower = verdict(ScoreValue::duration, 15.0, 10.0);
        QVERIFY(slower.kind == Kind::worse && is(slower.difference, 5.0) && is(slower.ratio, 1.5));
        QVERIFY(verdict(ScoreValue::duration, 10.04, 10.0).kind == Kind::same);
        QVERIFY(verdict(ScoreValue::smoothness, -1.5, -2.0).kind == Kind::better);
        QVERIFY(verdict(ScoreValue::removed, 500.0, 600.0).kind == Kind::worse);
        QVERIFY(verdict(ScoreValue::meanStockLeft, 0.5, 0.6).kind == Kind::better);
        const ScoreVerdict tries = verdict(ScoreValue::gougeTries, 2.0, 0.0);
        QVERIFY(tries.kind == Kind::worse && !tries.ratio && is(tries.difference, 2.0));
        QVERIFY(verdict(ScoreValue::gougeTries, 0.0, 0.0).kind == Kind::same);
        QVERIFY(verdict(ScoreValue::peakForce, std::nullopt, 3.0).kind == Kind::none);
    }

    void whatCannotBeScoredIsRefused() {
        Recordings recordings;
        Progress progress, cancelled;
        cancelled.cancel();
        const auto none = scoreMatter(recordings.project, 1, progress);
        QVERIFY(!none && none.error().code == ErrorCode::projectIncomplete);
        const std::int64_t take = recordings.record(ticks(100));
        const auto unknown = scoreMatters(recordings.project, take, take + 7, progress);
        QVERIFY(!unknown && unknown.error().code == ErrorCode::nameUnknown);
        const auto same = scoreMatters(recordings.project, take, take, progress);
        QVERIFY(!same && same.error().code == ErrorCode::argumentInvalid);
        const auto stopped = scoreMatter(recordings.project, take, cancelled);
        QVERIFY(!stopped && stopped.error().code == ErrorCode::cancelled);
        Result<ScoreMatter> matter = scoreMatter(recordings.project, take, progress);
        QVERIFY(matter);
        const Result<TakeScore> half = takeScore(std::move(*matter), partMilling(flatTool()), cancelled);
        QVERIFY(!half && half.error().code == ErrorCode::cancelled);
    }
};

BURIN_TEST(TakeScoreTest, QCoreApplication)

} // namespace burin::tst_take_score

#include "tst_take_score.moc"

// SPDX-FileCopyrightText: 2026 The Burin authors
// SPDX-License-Identifier: Apache-2.0
#include "core/job/program_time.h"
#include "core/volume/operations/fingerprint.h"
#include "tests/core/job/session_milling.h"
#include "tests/test_program.h"

#include <QtTest>

#include <algorithm>
#include <cmath>

namespace burin::tst_program_time {

using namespace burin::test;

namespace {

/// Down, along X, three quarters of a circle about the middle, up.
const char* const text =
    "G21 G90 G17 G94 G54\nM3 S10000\nG0 X-14 Y0\nZ2\nG1 Z-1.5 F300\nX8 F600\nG3 X0 Y-8 I-8 J0\nG4 P0.5\n"
    "G0 Z5\nM2\n";

CheckedProgram checked(const MillingContext& milling) {
    ProgramRequest request;
    request.tools = {sessionTool()};
    request.anyNumber = true;
    Progress progress;
    Result<CheckedProgram> program = checkProgram(milling, text, "test.ngc", request, progress);
    if (!program) std::abort();
    return std::move(*program);
}

} // namespace

class TestProgramTime : public QObject {
    Q_OBJECT
private slots:
    void init() {
        program_ = std::make_unique<CheckedProgram>(checked(milling_));
        Result<ProgramTime> made = programTime(*program_, milling_.machine, milling_.setup.workOffset, Progress());
        QVERIFY(made);
        time_ = std::make_unique<ProgramTime>(std::move(*made));
    }

    /// Its duration equals that of its check, to a tick.
    void itTakesTheTimeOfTheCheck() {
        QCOMPARE(time_->time.tracks.size(), std::size_t{1});
        QVERIFY(std::abs(time_->time.seconds() - program_->report.machiningSeconds) <= time_->tick);
    }

    /// The tool is on the program's path: by closed formulas for line and circle, from the program's zero.
    void theToolIsOnTheWay() {
        const glm::dvec3 zero = milling_.setup.workOffset;
        std::size_t onLine = 0, onCircle = 0;
        for (std::uint64_t i = 1; i <= time_->time.tracks.front().info.sampleCount; ++i) {
            const TakeMoment moment{1, i};
            const NcMotion& motion = program_->parsed.motions[time_->motionAt(moment)];
            if (time_->motionAt({1, i - 1}) != time_->motionAt(moment)) continue; // begins within this tick
            const glm::dvec3 tip = time_->poseAt(moment).tip - zero;
            if (motion.line == 6) {
                QVERIFY(std::abs(tip.y) < 1e-9 && std::abs(tip.z + 1.5) < 1e-9 && tip.x > -14.001 && tip.x <= 8.0);
                ++onLine;
            }
            if (motion.line == 7) {
                QVERIFY(std::abs(std::hypot(tip.x, tip.y) - 8.0) < 0.0011); // arcs are checked as chords
                QVERIFY(std::abs(tip.z + 1.5) < 1e-9);
                ++onCircle;
            }
        }
        // 22 mm and 3/4 of the circle at 10 mm/s, without acceleration: at least as many ticks.
        QVERIFY(static_cast<double>(onLine) * time_->tick > 2.1);
        QVERIFY(static_cast<double>(onCircle) * time_->tick > 3.7);
    }

    /// At its end the workpiece is the result of the check; half way along the line it contains the slot up to there.
    void theWorkpieceFollows() {
        Progress progress;
        const RunVolume untouched = std::move(*milling_.stock->makeStock(progress));
        const auto at = [&](const TakeMoment& moment) {
            RecordedWork work;
            work.cuts.push_back(*time_->time.cuts.front());
            work.cuts.front().end = work.cuts.front().motions.countWithin(moment.samples);
            return *workpieceOf(
                work, [&] { return milling_.stock->makeStock(progress); }, progress);
        };
        RunVolume all = at({1, ~std::uint64_t{0}});
        QCOMPARE(fingerprint(all.snapshot()), fingerprint(program_->machined));
        const auto motion = std::ranges::find(program_->parsed.motions, 6U, &NcMotion::line);
        const TakeMoment begin = time_->beginOf(static_cast<std::size_t>(motion - program_->parsed.motions.begin()));
        RunVolume before = at(begin);
        // A ball of radius 2 at a depth of 1.5: its removal on a distance of 10 mm, pi r² / 2 minus the segment above.
        TakeMoment half = begin;
        while (time_->poseAt(half).tip.x - milling_.setup.workOffset.x < -5.0) ++half.samples;
        TakeMoment later = half;
        while (time_->poseAt(later).tip.x - milling_.setup.workOffset.x < 5.0) ++later.samples;
        RunVolume first = at(half), second = at(later);
        const double way = time_->poseAt(later).tip.x - time_->poseAt(half).tip.x;
        const double angle = std::acos(0.5 / 2.0);
        const double area = 4.0 * angle - 0.5 * std::sqrt(4.0 - 0.25);
        const PropertyIndex wax = milling_.embedded.stockProperty;
        const double removed =
            static_cast<double>(first.amounts().units[wax] - second.amounts().units[wax]) * first.grid().unitVolume();
        QVERIFY2(std::abs(removed / (area * way) - 1.0) < 0.02, qPrintable(QString::number(removed / (area * way))));
        QVERIFY(before.amounts().units[wax] <= untouched.amounts().units[wax]);
    }

    /// Steps go from block to block, and a cut has force and feed.
    void stepsAreBlocksAndCurvesAreOfTheCheck() {
        const TakeTrack& track = time_->time.tracks.front();
        QVERIFY(track.steps.size() >= 4 && std::ranges::is_sorted(track.steps));
        const auto curve = [&](TrackCurve which) -> const std::vector<float>& {
            return track.curves[static_cast<std::size_t>(which)];
        };
        double most = 0.0;
        for (const LoadStep& load : program_->report.loadSteps) most = std::max(most, static_cast<double>(load.force));
        QVERIFY(most > 0.0);
        QCOMPARE(static_cast<double>(*std::ranges::max_element(curve(TrackCurve::force))), most);
        const auto cutting = track.strokes.front();
        const std::uint64_t middle = (cutting.first + cutting.count / 2) / TakeTrack::samplesPerBin;
        QVERIFY(std::abs(curve(TrackCurve::feed)[middle] - 10.0) < 0.5); // F600
    }

private:
    MillingContext milling_ = blockMilling();
    std::unique_ptr<CheckedProgram> program_;
    std::unique_ptr<ProgramTime> time_;
};

BURIN_TEST(TestProgramTime, QCoreApplication)

} // namespace burin::tst_program_time

#include "tst_program_time.moc"

// SPDX-FileCopyrightText: 2026 The Burin authors
// SPDX-License-Identifier: Apache-2.0
// The deviation of a take over time, and ticks of a take as samples.
#include "core/job/recorded_time.h"
#include "core/job/take_deviation.h"
#include "tests/core/document/sample_project.h"
#include "tests/core/job/session_stage.h"
#include "tests/core/volume/shapes.h"
#include "tests/test_program.h"

#include <QTemporaryDir>
#include <QTest>

#include <cmath>
#include <random>

namespace burin::tst_take_deviation {

using namespace burin::test;

namespace {

constexpr double ballRadius = 3.0; // mm

Tool ball() {
    Tool tool;
    tool.id = "ball";
    tool.cutter.type = CutterType::ball;
    tool.cutter.diameter = 2.0 * ballRadius;
    tool.cutter.cornerRadius = ballRadius;
    tool.cutter.fluteLength = 22.0;
    tool.cutter.shankDiameter = 5.8;
    tool.cutter.stickOut = 50.0;
    return tool;
}

Result<std::vector<float>> deviationOf(const std::vector<ToolPose>& poses, const MeshDistance& part) {
    Progress progress;
    return takeDeviation({{}, ball(), poses}, part, progress);
}

} // namespace

class TestTakeDeviation : public QObject {
    Q_OBJECT
private slots:
    /// A ball over a sphere: the distance of the centres less the radii, and negative inside it by as much as the ball
    /// is in the sphere.
    void overASphereItFollowsTheFormula() {
        constexpr double radius = 20.0;
        const MeshDistance part(sphereMesh({0, 0, 0}, radius, 400));
        const double facets = 2.0 * radius * (1.0 - std::cos(std::acos(-1.0) / 800.0)); // the mesh lies inside by this
        std::vector<ToolPose> poses;
        for (int i = 0; i < 2345; ++i) {
            const double angle = 0.0004 * i, gap = 0.8 * std::cos(0.01 * i) + 0.3; // down to 0.5 mm inside
            poses.push_back({{(radius + ballRadius + gap) * std::sin(angle), 0.0,
                              (radius + ballRadius + gap) * std::cos(angle) - ballRadius}});
        }
        const auto values = deviationOf(poses, part);
        QVERIFY(values);
        QCOMPARE(values->size(), std::size_t{235});
        for (std::size_t bin = 0; bin < values->size(); ++bin) {
            double expected = 1e9;
            for (std::size_t i = 10 * bin; i < std::min<std::size_t>(poses.size(), 10 * bin + 10); ++i)
                expected = std::min(expected, 0.8 * std::cos(0.01 * static_cast<double>(i)) + 0.3);
            const double off = static_cast<double>((*values)[bin]) - expected;
            QVERIFY2(off > -1e-4 && off < facets + 2e-4, qPrintable(QStringLiteral("%1: %2").arg(bin).arg(off)));
        }
    }

    /// Random poses, also tilted ones, far and near: as asking for each sample by itself.
    void itIsTheLeastOfAllSamples() {
        const MeshDistance part(sphereMesh({5, 0, 0}, 8.0, 60));
        const std::vector<RevolvedPiece> tool = pieces(ball().cutter);
        std::mt19937 random(5);
        std::uniform_real_distribution<double> any(-1.0, 1.0);
        std::vector<ToolPose> poses;
        glm::dvec3 tip(20.0, 0.0, 5.0), axis(0.0, 0.0, 1.0);
        for (int i = 0; i < 3000; ++i) {
            tip += glm::dvec3(any(random), any(random), any(random)) * (i % 500 == 0 ? 12.0 : 0.3);
            if (i % 700 > 600) axis = glm::normalize(axis + 0.05 * glm::dvec3(any(random), any(random), any(random)));
            poses.push_back({tip, axis});
        }
        const auto values = deviationOf(poses, part);
        QVERIFY(values);
        for (std::size_t bin = 0; bin < values->size(); ++bin) {
            double least = 1e9;
            for (std::size_t i = 10 * bin; i < 10 * bin + 10; ++i)
                least = std::min(least, part.clearance(tool, poses[i]).clearance);
            const double off = static_cast<double>((*values)[bin]) - least;
            QVERIFY2(std::abs(off) < 2e-4, qPrintable(QStringLiteral("%1: %2").arg(bin).arg(off)));
        }
    }

    void withoutAPartThereIsNone() {
        const auto values = deviationOf(std::vector<ToolPose>(25), MeshDistance(TriangleMesh{}));
        QVERIFY(values);
        QCOMPARE(values->size(), std::size_t{3});
        for (const float value : *values) QVERIFY(std::isnan(value));
    }

    void itIsCancelled() {
        Progress progress;
        progress.cancel();
        const MeshDistance part(sphereMesh({0, 0, 0}, 8.0, 20));
        QCOMPARE(takeDeviation({{}, ball(), std::vector<ToolPose>(5000)}, part, progress).error().code,
                 ErrorCode::cancelled);
    }

    /// A take whose loop missed ticks: poses are read in order, and ticks are found as samples, as by a search.
    void aTakeIsReadWithMissedTicks() {
        QTemporaryDir folder;
        Project project = *Project::create(folder.filePath("p.burin").toStdString());
        QVERIFY(project.setModel(Model{}) && project.setSetup(blockSetup()) && project.setTool(sessionTool()));
        TakeInfo info;
        info.name = "gaps";
        info.toolId = sessionTool().id;
        auto writer = project.beginTake(info);
        QVERIFY(writer);
        std::vector<Sample> samples;
        for (std::uint64_t tick = 3; samples.size() < 1000; tick += tick % 97 == 0 ? 5 : 1) {
            Sample sample;
            sample.tick = tick;
            sample.time = 0.001 * static_cast<double>(tick);
            sample.proxy.tip = {0.01 * static_cast<double>(tick), 0.0, 5.0};
            samples.push_back(sample);
        }
        QVERIFY(writer->append(samples) && writer->finish());
        const Result<DeviationMatter> matter = deviationMatter(project, writer->id(), Progress());
        QVERIFY(matter);
        QCOMPARE(matter->poses.size(), samples.size());
        QCOMPARE(matter->poses[500].tip.x, samples[500].proxy.tip.x);
        QCOMPARE(deviationMatter(project, 99, Progress()).error().code, ErrorCode::nameUnknown);

        const Result<RecordedTime> time = readRecordedTime(project);
        QVERIFY(time && time->tracks.size() == 1);
        const TakeTrack& track = time->tracks.front();
        QVERIFY(track.curves[static_cast<std::size_t>(TrackCurve::deviation)].empty());
        for (std::size_t i = 0; i < samples.size(); ++i) {
            QCOMPARE(track.tickOf(i), samples[i].tick);
            QCOMPARE(track.sampleOf(samples[i].tick), std::uint64_t{i});
            const std::uint64_t before = samples[i].tick - 1; // missed, or that of the sample before
            if (i > 0) QCOMPARE(track.sampleOf(before), std::uint64_t{samples[i - 1].tick == before ? i - 1 : i});
        }
        QCOMPARE(track.sampleOf(0), std::uint64_t{0});
    }
};

BURIN_TEST(TestTakeDeviation, NoApplication)

} // namespace burin::tst_take_deviation

#include "tst_take_deviation.moc"

// SPDX-FileCopyrightText: 2026 The Burin authors
// SPDX-License-Identifier: Apache-2.0
#define GLM_ENABLE_EXPERIMENTAL // glm::rotation
#include "core/cutting/voxel_tool.h"
#include "tests/core/cutting/sweeping.h"
#include "tests/core/tool/cutters.h"
#include "tests/core/tool/random_sweeps.h"
#include "tests/oracles/swept_cutter.h"
#include "tests/random_cases.h"
#include "tests/test_program.h"

#include <QtTest>
#include <glm/gtx/quaternion.hpp>
#include <rapidcheck.h>

namespace burin::tst_cutter_sweeps {

using namespace burin::tests;
using random::real;

namespace {

/// Whether the drawn flutes contain a point, with a rough margin: exact in the radius, which is what a drawing
/// specifies. A point within `margin` of the drawing counts as neither inside nor outside.
bool drawnHolds(const Cutter& cutter, const glm::dvec3& q, const glm::dvec3& axis, double margin) {
    const double height = glm::dot(q, axis), out = glm::length(q - height * axis);
    if (height < margin * -1.0 || height > cutter.fluteLength + margin) return false;
    // The radius jumps at shoulders, so a margin along the axis is checked as well.
    double radius = margin > 0.0 ? 0.0 : 1e9;
    for (const double shift : {-std::abs(margin), 0.0, std::abs(margin)}) {
        const double at = cutters::drawnRadius(cutter, std::clamp(height + shift, 0.0, cutter.fluteLength));
        radius = margin > 0.0 ? std::max(radius, at) : std::min(radius, at);
    }
    return out <= radius + margin;
}

bool sweptHolds(const Cutter& cutter, const PoseStep& step, const glm::dvec3& place, double margin) {
    constexpr int samples = 300;
    for (int i = 0; i <= samples; ++i) {
        const glm::dvec3 tip = step.fromTip + i / static_cast<double>(samples) * (step.toTip - step.fromTip);
        if (drawnHolds(cutter, place - tip, step.axis, margin)) return true;
    }
    return false;
}

bool isAir(const RunVolume& volume, LineIndex line, RunPosition position) {
    for (const Segment segment : volume.line(line))
        if (position < segment.end()) return segment.property() == airProperty;
    return true;
}

Pose poseOf(const glm::dvec3& tip, const glm::dvec3& axis) {
    return {tip, glm::rotation(glm::dvec3(0.0, 0.0, 1.0), axis)};
}

void rowForEveryType() {
    QTest::addColumn<int>("index");
    const std::vector<cutters::Named> all = cutters::all();
    for (int i = 0; i < static_cast<int>(all.size()); ++i) QTest::newRow(all[static_cast<std::size_t>(i)].name) << i;
}

} // namespace

/// Every cutter of revolution with any axis, against its drawing and against the paper's own method.
class CutterSweepsTest : public QObject {
    Q_OBJECT

private slots:
    void removeWhatTheDrawingSweeps_data() { rowForEveryType(); }
    void removeWhatTheDrawingSweeps() {
        QFETCH(int, index);
        const Cutter cutter = cutters::all()[static_cast<std::size_t>(index)].cutter;
        const std::vector<RevolvedPiece> flutes = flutePieces(cutter);
        int inside = 0, outside = 0;
        const bool held = testing::holdsInShare("swept drawing", [&] {
            const glm::dvec3 axis = random::axis(), from(real(-1.0, 1.0), real(-1.0, 1.0), real(-1.0, 1.0));
            const PoseStep step{from, from + 0.5 * random::moveFor(axis), axis};
            RunVolume volume =
                solid({-9.0, -9.0, -9.0}, 0.5, {36, 36, 36}, static_cast<RunAxis>(*rc::gen::inRange(0, 3)));
            RunAmounts removed;
            sweep(volume, flutes, step, removed);
            const Grid& grid = volume.grid();
            for (int point = 0; point < 60; ++point) {
                const LineIndex line{*rc::gen::inRange(0, 36), *rc::gen::inRange(0, 36)};
                const auto position = static_cast<RunPosition>(*rc::gen::inRange(0, 36 * 256));
                const glm::dvec3 place =
                    inSetupFrame(grid, {grid.lineCentre(line), grid.toMillimetres(position) + 0.5 * grid.edge() / 256});
                const double margin = 0.02; // the error of sampling the motion is smaller
                if (sweptHolds(cutter, step, place, -margin)) {
                    RC_ASSERT(isAir(volume, line, position));
                    ++inside;
                } else if (!sweptHolds(cutter, step, place, margin)) {
                    RC_ASSERT(!isAir(volume, line, position));
                    ++outside;
                }
            }
        });
        QVERIFY(held);
        QVERIFY(inside > 5 && outside > 5); // the test was not empty
    }

    /// Removal takes exactly the swept volume, counts it, and leaves protected material; a stationary tool removes
    /// nothing.
    void materialRemovalTakesTheSweep_data() { rowForEveryType(); }
    void materialRemovalTakesTheSweep() {
        QFETCH(int, index);
        const Cutter cutter = cutters::all()[static_cast<std::size_t>(index)].cutter;
        const std::vector<RevolvedPiece> flutes = flutePieces(cutter);
        QVERIFY(testing::holdsInShare("material removal", [&] {
            const glm::dvec3 axis = random::axis(), from(real(-1.0, 1.0), real(-1.0, 1.0), real(-1.0, 1.0));
            const glm::dvec3 to = from + 0.5 * random::moveFor(axis);
            const auto runs = static_cast<RunAxis>(*rc::gen::inRange(0, 3));
            RunVolume ours = solid({-9.0, -9.0, -9.0}, 0.5, {36, 36, 36}, runs);
            RunVolume wanted = solid({-9.0, -9.0, -9.0}, 0.5, {36, 36, 36}, runs);
            for (RunVolume* volume : {&ours, &wanted})
                RC_ASSERT(volume->fillBlock({20, 0}, {36, 36}, 0, 18 * 256, part));
            RunAmounts removed;
            sweep(wanted, flutes, {from, to, axis}, removed);
            MaterialRemoval removal(cutter, ours.grid());
            const CutResult cut = removal.cut(ours, ToolPose{from, axis}, ToolPose{to, axis});
            RC_ASSERT(ours.amounts() == wanted.amounts());
            RC_ASSERT(unitsOf(cut, softStock) == removed.units[softStock]);
            for (LineIndex line; line.v < 36; ++line.v)
                for (line.u = 0; line.u < 36; ++line.u)
                    RC_ASSERT(std::ranges::equal(ours.line(line), wanted.line(line)));
            RC_ASSERT(removal.cut(ours, ToolPose{to, axis}, ToolPose{to, axis}).volume == 0.0);
        }));
    }

    /// With an axis that rotates during the motion, the removed volume agrees with the true motion's sweep within the
    /// stated eighth of a voxel.
    void aTurningAxisSweepsItsMotion_data() { rowForEveryType(); }
    void aTurningAxisSweepsItsMotion() {
        QFETCH(int, index);
        const Cutter cutter = cutters::all()[static_cast<std::size_t>(index)].cutter;
        const double edge = 0.5, bound = SweepCutter::turnTolerance * edge;
        QVERIFY(testing::holdsInShare("turning axis", [&] {
            const glm::dvec3 axis = random::axis(), from(real(-1.0, 1.0), real(-1.0, 1.0), real(-1.0, 1.0));
            const glm::dvec3 other =
                glm::normalize(axis + 0.3 * glm::dvec3(real(-1.0, 1.0), real(-1.0, 1.0), real(-1.0, 1.0)));
            const ToolPose first{from, axis}, last{from + 0.2 * random::move(), other};
            RunVolume volume =
                solid(glm::dvec3(-16.0), edge, glm::ivec3(64), static_cast<RunAxis>(*rc::gen::inRange(0, 3)));
            MaterialRemoval removal(cutter, volume.grid());
            (void)removal.cut(volume, first, last);
            RC_ASSERT(removal.cut(volume, last, last).volume == 0.0);
            const Grid& grid = volume.grid();
            const oracles::SweptCutter motion(flutePieces(cutter), first, last, bound + 1e-6, 0.02);
            for (int point = 0; point < 80; ++point) {
                const LineIndex line{*rc::gen::inRange(0, 64), *rc::gen::inRange(0, 64)};
                const auto position = static_cast<RunPosition>(*rc::gen::inRange(0, 64 * 256));
                const bool isGone = isAir(volume, line, position);
                const auto verdict = motion.at(placeOn(grid, line, position + 0.5));
                RC_ASSERT(verdict !=
                          (isGone ? oracles::SweptCutter::Verdict::outside : oracles::SweptCutter::Verdict::inside));
            }
        }));
    }

    /// The paper's interpolation of voxel tools and the analytic sweep remove the same, within the resolution of
    /// voxels: half a voxel's diagonal for the tool's own voxels, half a step between two poses.
    void thePapersInterpolationRemovesTheSame_data() { rowForEveryType(); }
    void thePapersInterpolationRemovesTheSame() {
        QFETCH(int, index);
        const Cutter cutter = cutters::all()[static_cast<std::size_t>(index)].cutter;
        const std::vector<RevolvedPiece> flutes = flutePieces(cutter);
        const double edge = 0.5;
        const VoxelTool tool = VoxelTool::ofPieces(flutes, flutes.size(), edge).value();
        const bool held = testing::holdsInShare("interpolated poses", [&] {
            const glm::dvec3 axis = random::axis(), from(real(-1.0, 1.0), real(-1.0, 1.0), real(-1.0, 1.0));
            const glm::dvec3 to = from + 0.5 * random::move();
            const auto runs = static_cast<RunAxis>(*rc::gen::inRange(0, 3));
            RunVolume papers = solid({-9.0, -9.0, -9.0}, edge, {36, 36, 36}, runs);
            const VoxelCut cut = tool.cut(papers, poseOf(from, axis), poseOf(to, axis));
            RC_ASSERT(!cut.outOfMemory && cut.poses == tool.posesFor(poseOf(from, axis), poseOf(to, axis)));
            // The volume removed by the paper's method lies in the analytic sweep of the tool grown by the bound, and
            // contains that of the tool shrunk by it, judged at the voxels' centres.
            const double bound = 0.5 * std::sqrt(3.0) * edge + 0.5 * edge;
            const Grid& grid = papers.grid();
            for (int point = 0; point < 150; ++point) {
                const LineIndex line{*rc::gen::inRange(0, 36), *rc::gen::inRange(0, 36)};
                const std::int32_t k = *rc::gen::inRange(0, 36);
                const glm::dvec3 centre = inSetupFrame(
                    grid, {grid.lineCentre(line), grid.toMillimetres(static_cast<RunPosition>(k * 256 + 128))});
                double nearest = 1e9;
                for (int i = 0; i <= 100; ++i) {
                    const glm::dvec3 q = centre - (from + i / 100.0 * (to - from));
                    const double height = glm::dot(q, axis), radius = glm::length(q - height * axis);
                    for (const RevolvedPiece& piece : flutes)
                        nearest = std::min(nearest, signedDistance(piece, radius, height));
                }
                const bool taken = isAir(papers, line, static_cast<RunPosition>(k * 256 + 128));
                if (taken) RC_ASSERT(nearest <= bound);
                if (!taken) RC_ASSERT(nearest >= -bound);
            }
        });
        QVERIFY(held);
    }

    /// Both methods remove the same volume to first order in the voxel.
    void volumesOfBothWaysConverge() {
        const Cutter cutter = cutters::taperBall();
        const std::vector<RevolvedPiece> flutes = flutePieces(cutter);
        const glm::dvec3 axis = glm::normalize(glm::dvec3(0.3, -0.2, 1.0)), from(0.1, 0.2, -2.0), to(1.6, 1.0, -2.3);
        std::vector<double> errors;
        for (const double edge : {0.5, 0.25, 0.125}) {
            const auto side = static_cast<int>(std::lround(16.0 / edge));
            RunVolume papers = solid(glm::dvec3(-8.0), edge, glm::ivec3(side), RunAxis::z);
            RunVolume ours = solid(glm::dvec3(-8.0), edge, glm::ivec3(side), RunAxis::z);
            const VoxelTool tool = VoxelTool::ofPieces(flutes, flutes.size(), edge).value();
            const VoxelCut cut = tool.cut(papers, poseOf(from, axis), poseOf(to, axis));
            RunAmounts removed;
            sweep(ours, flutes, {from, to, axis}, removed);
            errors.push_back(
                std::abs(static_cast<double>(totalOf(cut.removed)) / static_cast<double>(totalOf(removed)) - 1.0));
            QVERIFY(papers.amounts().units[softStock] + cut.removed.units[softStock] ==
                    ours.amounts().units[softStock] + removed.units[softStock]);
        }
        qInfo("interpolated voxel tool against analytic sweep: %.3f, %.3f, %.3f", errors[0], errors[1], errors[2]);
        QVERIFY(errors[0] < 0.2 && errors[2] < 0.05);
    }

    /// The paper's slot (eq. 5): an end mill that moves evenly removes depth times width times feed times time, exactly
    /// to the unit where all of them are whole voxels; with the analytic sweep and with the paper's interpolation.
    void theSlotIsDepthTimesWidthTimesFeedTimesTime() {
        const double edge = 0.25, depth = 2.0, feed = 10.0, cycle = 0.025; // mm, mm/s, s: a voxel per cycle
        const Cutter cutter = cutters::make(CutterType::flat, 6.0, 0.0, 12.0);
        const std::vector<RevolvedPiece> flutes = flutePieces(cutter);
        const VoxelTool voxels = VoxelTool::ofPieces(flutes, 1, edge).value();
        for (const RunAxis runs : {RunAxis::z, RunAxis::x, RunAxis::y}) {
            RunVolume ours = solid({0.0, -6.0, -6.0}, edge, {120, 48, 24}, runs);
            RunVolume papers = solid({0.0, -6.0, -6.0}, edge, {120, 48, 24}, runs);
            const auto tipAt = [&](int step) { return glm::dvec3(8.0 + step * feed * cycle, 0.0, -depth); };
            for (int step = 0; step < 40; ++step) {
                RunAmounts swept;
                sweep(ours, flutes, {tipAt(step), tipAt(step + 1), {0.0, 0.0, 1.0}}, swept);
                const VoxelCut cut = voxels.cut(papers, {tipAt(step), {}}, {tipAt(step + 1), {}});
                if (step == 0) continue; // the plunge
                const double wanted = depth * cutter.diameter * feed * cycle;
                const double unit = ours.grid().unitVolume();
                // If the runs are not parallel to the tool, the half circle in front is a sum over scanlines: its ends
                // are rounded to the unit.
                const double slack =
                    runs == RunAxis::z ? 0.0 : 1.0 * unit * 2.0 * (depth / edge) * (cutter.diameter / edge);
                QVERIFY2(std::abs(static_cast<double>(totalOf(swept)) * unit - wanted) <= slack + 1e-9,
                         qPrintable(QString::number(static_cast<double>(totalOf(swept)) * unit)));
                QVERIFY(std::abs(static_cast<double>(totalOf(cut.removed)) * unit - wanted) < 1e-9);
            }
        }
    }
};

BURIN_TEST(CutterSweepsTest, NoApplication)

} // namespace burin::tst_cutter_sweeps

#include "tst_cutter_sweeps.moc"

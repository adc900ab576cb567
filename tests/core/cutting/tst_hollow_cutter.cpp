// SPDX-FileCopyrightText: 2026 The Burin authors
// SPDX-License-Identifier: Apache-2.0
#include "core/cutting/cutting_force.h"
#include "core/cutting/removal.h"
#include "core/cutting/tool_beam.h"
#include "tests/core/cutting/sweeping.h"
#include "tests/core/tool/fixed_tools.h"
#include "tests/oracles/allocation_count.h"
#include "tests/test_program.h"

#include <QtTest>

#include <cmath>

namespace burin::tst_hollow_cutter {

using namespace burin::tests;

namespace {

constexpr glm::dvec3 up(0.0, 0.0, 1.0);
constexpr double edge = 0.25;               // mm
constexpr double ring = pi * (36.0 - 16.0); // mm², between 12 and 8 mm

/// 40 × 30 × 10 mm.
RunVolume stock(RunAxis axis) {
    return solid({0.0, 0.0, 0.0}, edge, {160, 120, 40}, axis);
}

/// Moves a cutter in steps; returns the volume removed, mm³.
double moved(MaterialRemoval& removal, RunVolume& block, const glm::dvec3& from, const glm::dvec3& to, double step) {
    const int steps = std::max(1, static_cast<int>(std::ceil(glm::distance(from, to) / step)));
    double volume = 0.0;
    for (int i = 0; i < steps; ++i)
        volume += removal
                      .cut(block, ToolPose{glm::mix(from, to, double(i) / steps), up},
                           ToolPose{glm::mix(from, to, double(i + 1) / steps), up})
                      .volume;
    return volume;
}

/// Whether stock stands in the middle of the voxel at a point.
bool stands(const RunVolume& block, const glm::dvec3& place) {
    const glm::dvec3 at = (place - block.grid().low()) / edge;
    const VoxelIndex voxel{int(at.x), int(at.y), int(at.z)};
    const auto middle = static_cast<RunPosition>((block.grid().alongOf(voxel) + 0.5) * unitsPerVoxel);
    for (const Segment segment : block.line(block.grid().lineOf(voxel)))
        if (middle < segment.end()) return segment.property() != airProperty;
    return false;
}

} // namespace

/// A core drill of 12 × 8 mm that turns, by closed formulas.
class HollowCutterTest : public QObject {
    Q_OBJECT
private slots:
    void aPlungeLeavesACore() {
        for (const RunAxis axis : {RunAxis::x, RunAxis::y, RunAxis::z})
            for (const double offset : {0.0, 0.07, 0.125}) {
                RunVolume block = stock(axis);
                MaterialRemoval removal(cutters::annular(), block.grid(), Writing::deferred);
                const glm::dvec3 top(12.0 + offset, 15.0 + offset, 11.0);
                const double volume = moved(removal, block, top, top - 4.0 * up, 0.05);
                // Discs of 24 and 16 voxels radius, counted by the centres of voxels: a dozen of 1005 more or less.
                QVERIFY2(std::abs(volume / (3.0 * ring) - 1.0) < 0.02, qPrintable(QString::number(volume)));
                for (const double radius : {0.0, 2.0, 3.7})
                    QVERIFY(stands(block, {top.x + radius, top.y, 9.9}) && stands(block, {top.x, top.y - radius, 7.1}));
                for (const double radius : {4.3, 5.0, 5.7})
                    QVERIFY(!stands(block, {top.x + radius, top.y, 9.9}) &&
                            stands(block, {top.x + radius, top.y, 6.9}));
                QVERIFY(stands(block, {top.x + 6.3, top.y, 9.9}));
            }
    }

    /// Moved by more than its inside is wide, it leaves a slot of 12 mm with round ends: the front of the ring has cut
    /// everything, but for the core of the start, which its rear has cut.
    void movedSidewaysItCutsTheCoreAway() {
        RunVolume block = stock(RunAxis::z);
        MaterialRemoval removal(cutters::annular(), block.grid(), Writing::deferred);
        const glm::dvec3 start(10.0, 15.0, 7.0), end(24.0, 15.0, 7.0);
        double volume = moved(removal, block, start + 4.0 * up, start, 0.05);
        volume += moved(removal, block, start, end, 0.05);
        QVERIFY(!stands(block, {10.0, 15.0, 9.0}) && !stands(block, {13.5, 15.0, 9.0}));
        QVERIFY(!stands(block, {24.0, 15.0, 9.0}) && !stands(block, {20.5, 15.0, 9.0}));
        const double slot = 14.0 * 12.0 + pi * 36.0; // mm²
        QVERIFY2(std::abs(volume / (3.0 * slot) - 1.0) < 0.01, qPrintable(QString::number(volume / 3.0)));
        // Moved by less, a lens of the core stays: what two circles of 4 mm radius, 3 mm apart, have in common.
        RunVolume other = stock(RunAxis::z);
        MaterialRemoval again(cutters::annular(), other.grid(), Writing::deferred);
        volume = moved(again, other, start + 4.0 * up, start, 0.05) +
                 moved(again, other, start, start + glm::dvec3(3.0, 0.0, 0.0), 0.05);
        const double lens = 2.0 * 16.0 * std::acos(3.0 / 8.0) - 0.5 * 3.0 * std::sqrt(4.0 * 16.0 - 9.0);
        const double area = 3.0 * 12.0 + pi * 36.0 - lens;
        QVERIFY2(std::abs(volume / (3.0 * area) - 1.0) < 0.01, qPrintable(QString::number(volume / 3.0)));
        QVERIFY(stands(other, {11.5, 15.0, 9.0}));
    }

    /// Plunging: the reported volume follows the removed one, the ring is engaged all around, and its force is
    /// K times the volume by the distance that the edge turns.
    void itsForceIsThatOfATurningTool() {
        for (const RunAxis axis : {RunAxis::x, RunAxis::z}) {
            RunVolume block = stock(axis);
            Tool tool;
            tool.cutter = cutters::annular();
            const CuttingCoefficients coefficients = cuttingCoefficients(block.properties(), tool.cutter.diameter);
            const SpinningTool spindle = spinningTool(tool, 5000.0);
            QVERIFY(spindle.turns && spindle.teethPerSecond > 0.0);
            MaterialRemoval removal(tool.cutter, block.grid(), Writing::deferred);
            double reported = 0.0, volume = 0.0, work = 0.0, arc = 0.0, area = 0.0;
            constexpr double step = 0.02; // mm
            for (int i = 0; i < 300; ++i) {
                const ToolPose from{{12.0, 15.0, 11.0 - step * i}, up}, to{{12.0, 15.0, 11.0 - step * (i + 1)}, up};
                const CutResult cut = removal.cut(block, from, to);
                volume += cut.volume;
                reported += cut.reported;
                work += cuttingForce(cut, coefficients, spindle, from, to, 0.001).tangential * 0.001 * 5000.0;
                if (i == 200) {
                    arc = cut.engagement.arc;
                    area = cut.engagement.area;
                }
            }
            QVERIFY2(std::abs(reported / volume - 1.0) < 0.06,
                     qPrintable(QStringLiteral("%1 %2").arg(reported).arg(volume)));
            QVERIFY2(std::abs(work / (500.0 * reported) - 1.0) < 0.01, qPrintable(QString::number(work)));
            QVERIFY2(std::abs(arc - 2.0 * pi) < 0.4 && std::abs(area / ring - 1.0) < 0.05,
                     qPrintable(QStringLiteral("%1 %2").arg(arc).arg(area)));
        }
    }

    /// A tube bends as its second moment of area says: 1 - (8 / 12)⁴ of a full shaft.
    void itBendsLikeATube() {
        Tool tool;
        tool.modulus = 600'000.0;
        tool.cutter = cutters::annular();
        tool.cutter.stickOut = tool.cutter.fluteLength;
        const double hollow = ToolBeam(tool).bendingUnder(100.0, 0.0);
        tool.cutter.solid = nullptr;
        const double full = ToolBeam(tool).bendingUnder(100.0, 0.0);
        QVERIFY2(std::abs(full / hollow - (1.0 - std::pow(8.0 / 12.0, 4))) < 1e-3, qPrintable(QString::number(full)));
    }

    void cuttingAllocatesNothing() {
        RunVolume block = stock(RunAxis::z);
        MaterialRemoval removal(cutters::annular(), block.grid(), Writing::deferred);
        const std::size_t before = allocationCount.load();
        for (int i = 0; i < 300; ++i) {
            const ToolPose from{{8.0 + 0.05 * i, 15.0, 7.0}, up}, to{{8.0 + 0.05 * (i + 1), 15.0, 7.0}, up};
            (void)removal.cut(block, from, to);
        }
        QCOMPARE(allocationCount.load() - before, std::size_t{0});
    }
};

BURIN_TEST(HollowCutterTest, NoApplication)

} // namespace burin::tst_hollow_cutter

#include "tst_hollow_cutter.moc"

// SPDX-FileCopyrightText: 2026 The Burin authors
// SPDX-License-Identifier: Apache-2.0
#include "core/cutting/cutting_force.h"
#include "core/cutting/solid_contact.h"
#include "core/cutting/solid_cutter.h"
#include "tests/core/cutting/sweeping.h"
#include "tests/core/tool/fixed_tools.h"
#include "tests/core/tool/random_sweeps.h"
#include "tests/oracles/allocation_count.h"
#include "tests/test_program.h"

#include <QtTest>
#include <rapidcheck.h>

#include <cmath>
#include <numbers>
#include <span>
#include <vector>

namespace burin::tst_solid_cutter {

using namespace burin::tests;
using random::real;

namespace {

constexpr double edge = 0.5; // mm
constexpr glm::dvec3 up(0.0, 0.0, 1.0);

RunAxis anyAxis() {
    return static_cast<RunAxis>(*rc::gen::inRange(0, 3));
}

/// A tool of boxes that meet in the middle: hooks, forks, undercuts.
struct Boxes {
    std::vector<Box> boxes;
    double angle = 0.0; ///< rad

    static Boxes any() {
        Boxes tool;
        tool.angle = *rc::gen::inRange(0, 3) == 0 ? 0.0 : real(-3.0, 3.0);
        for (int count = *rc::gen::inRange(1, 4); count > 0; --count) {
            const glm::dvec3 low(real(-2.5, -0.4), real(-2.5, -0.4), real(0.0, 2.0));
            tool.boxes.push_back({low, {real(0.4, 2.5), real(0.4, 2.5), low.z + real(0.8, 3.0)}});
        }
        return tool;
    }
    ToolSolid solid() const {
        ToolSolid made;
        made.angle = angle;
        for (const Box& box : boxes) append(made.flutes, shapes::box(box.low, box.high)); // overlapping shells unite
        return made;
    }
    /// Largest depth in one of the boxes, mm; negative: the distance from all of them.
    double depth(const glm::dvec3& fromTip) const {
        const double cosine = std::cos(angle), sine = std::sin(angle);
        const glm::dvec3 place(cosine * fromTip.x + sine * fromTip.y, cosine * fromTip.y - sine * fromTip.x, fromTip.z);
        double deepest = -1e9;
        for (const Box& box : boxes) deepest = std::max(deepest, -shapes::boxDistance(box.low, box.high, place));
        return deepest;
    }
};

PropertyIndex propertyOn(std::span<const Segment> line, RunPosition place) {
    for (const Segment segment : line)
        if (place < segment.end()) return segment.property();
    return airProperty;
}

std::vector<glm::dvec3> anyWay() {
    std::vector<glm::dvec3> tips{{real(-3.0, 3.0), real(-3.0, 3.0), real(-2.0, 3.0)}};
    for (int i = *rc::gen::inRange(1, 4); i > 0; --i) {
        const double most = *rc::gen::elementOf(std::vector<double>{0.05, 0.4, 1.5});
        tips.push_back(tips.back() + glm::dvec3(real(-most, most), real(-most, most), real(-most, most)));
        if (*rc::gen::inRange(0, 4) == 0) tips.back().z = tips[tips.size() - 2].z;
    }
    return tips;
}

/// Drags a tool along x right through a block of 40 × 20 × 10 mm with voxels of 0.25 mm, 3 mm deep.
double dragged(const Cutter& cutter, RunAxis axis, double y) {
    RunVolume block = solid({0.0, 0.0, 0.0}, 0.25, {160, 80, 40}, axis);
    MaterialRemoval removal(cutter, block.grid(), Writing::deferred);
    double volume = 0.0;
    for (double x = -10.0; x < 50.0; x += 0.07)
        volume += removal.cut(block, ToolPose{{x, y, 7.0}, up}, ToolPose{{x + 0.07, y, 7.0}, up}).volume;
    return volume;
}

} // namespace

/// A tool that doesn't turn: the union of its poses, by brute force and by formula.
class TestSolidCutter : public QObject {
    Q_OBJECT
private slots:
    /// Every eighth of a voxel along one line of five is classified by the depth in the tool at poses a 20th of a voxel
    /// apart: deeper than the stated deviation is removed, farther outside than it stays; and so do protected runs.
    void removesWhatADenseGridSays() {
        const bool held = rc::check([] {
            const Boxes tool = Boxes::any();
            const RunAxis axis = anyAxis();
            constexpr int side = 14;
            RunVolume block = solid(glm::dvec3(-0.5 * side * edge), edge, glm::ivec3(side), axis);
            const Grid& grid = block.grid();
            (void)block.fillSpan({7, 7}, 0, grid.lineEnd(), part);
            const std::vector<glm::dvec3> tips = anyWay();
            SolidCutter cutter(std::make_shared<const SolidColumns>(tool.solid(), grid));
            RemovedUnits removed;
            std::vector<glm::dvec3> poses;
            for (std::size_t i = 1; i < tips.size(); ++i) {
                cutter.cut(block, tips[i - 1], tips[i], removed);
                const glm::dvec3 way = tips[i] - tips[i - 1];
                const int steps = static_cast<int>(glm::length(way) / edge * 20.0) + 1;
                for (int k = 0; k <= steps; ++k) poses.push_back(tips[i - 1] + way * (double(k) / steps));
            }
            // An eighth of a voxel along each axis across the runs, rounding along them, half the distance of the
            // poses.
            const double bound = (std::numbers::sqrt2 / 8.0 + 1.0 / 64.0 + 1.0 / 40.0) * edge;
            std::uint64_t gone = 0;
            for (LineIndex line; line.v < side; ++line.v)
                for (line.u = 0; line.u < side; ++line.u)
                    for (RunPosition unit = 16; unit < grid.lineEnd(); unit += 32) {
                        const PropertyIndex now = propertyOn(block.line(line), unit);
                        if (line == LineIndex{7, 7}) {
                            RC_ASSERT(now == part);
                            continue;
                        }
                        gone += now == airProperty ? 32U : 0U;
                        if ((line.u + 2 * line.v) % 5 != 0) continue; // one line of five
                        const glm::dvec3 place = placeOn(grid, line, unit);
                        double deepest = -1e9;
                        for (std::size_t i = 0; i < poses.size() && deepest <= bound; ++i)
                            deepest = std::max(deepest, tool.depth(place - poses[i]));
                        if (deepest > bound) RC_ASSERT(now == airProperty);
                        if (deepest < -bound) RC_ASSERT(now == softStock);
                    }
            RC_ASSERT(removed.byProperty[part] == 0U && removed.byProperty[softStock] == removed.total);
            RC_ASSERT(std::abs(double(gone) - double(removed.total)) <= 32.0 * side * side * 4.0);
        });
        QVERIFY(held);
    }

    /// The sums equal the loss of the runs; a tool at rest removes nothing; a move in one go removes what its parts do,
    /// except for the rounding of the parts' ends to a run unit.
    void aMoveMayBeSplit() {
        const bool held = rc::check([] {
            const ToolSolid tool = Boxes::any().solid();
            const RunAxis axis = anyAxis();
            const glm::dvec3 from(real(-6.0, 6.0), real(-6.0, 6.0), real(-3.0, 3.0));
            const glm::dvec3 to(real(-6.0, 6.0), real(-6.0, 6.0), real(-3.0, 3.0));
            RunVolume one = solid(glm::dvec3(-5.0), edge, glm::ivec3(20), axis);
            RunVolume other = solid(glm::dvec3(-5.0), edge, glm::ivec3(20), axis);
            const std::uint64_t before = totalOf(one.amounts());
            const auto columns = std::make_shared<const SolidColumns>(tool, one.grid()); // of both: the grids are equal
            SolidCutter whole(columns), parts(columns);
            RemovedUnits atOnce, inParts, atRest;
            whole.cut(one, from, to, atOnce);
            whole.cut(one, to, to, atRest);
            whole.reset();
            whole.cut(one, to, to, atRest);
            const int count = *rc::gen::inRange(2, 40);
            glm::dvec3 tip = from;
            for (int k = 1; k <= count; ++k) {
                const glm::dvec3 next = k == count ? to : glm::mix(from, to, double(k) / count);
                parts.cut(other, tip, next, inParts);
                tip = next;
            }
            RC_ASSERT(atRest.total == 0U && before - totalOf(one.amounts()) == atOnce.total);
            RC_ASSERT(before - totalOf(other.amounts()) == inParts.total);
            RC_ASSERT(std::abs(double(atOnce.total) - double(inParts.total)) <= 2.0 * 400.0);
        });
        QVERIFY(held);
    }

    /// Closed formula: width of the blade across the drag × depth × length of the block. Each wall of the slot is off
    /// by an eighth of a voxel at most, and each of its ends by half a scanline, unless it lies between two.
    void aScraperLeavesASlotOfItsWidth_data() {
        QTest::addColumn<double>("degrees");
        QTest::addColumn<double>("width");
        QTest::newRow("along its blade") << 0.0 << 2.0;
        QTest::newRow("across its blade") << 90.0 << 8.0;
        QTest::newRow("at an angle") << 30.0 << 8.0 * 0.5 + 2.0 * std::sqrt(0.75);
    }
    void aScraperLeavesASlotOfItsWidth() {
        QFETCH(double, degrees);
        QFETCH(double, width);
        const Cutter cutter = cutters::scraper(degrees * pi / 180.0);
        for (const RunAxis axis : {RunAxis::x, RunAxis::y, RunAxis::z})
            for (const double y : {9.0, 10.03, 11.7}) {
                const double across = dragged(cutter, axis, y) / (40.0 * 3.0);
                // mm: lattice; and, unless the width is a multiple of a voxel, one line more or less.
                const double bound = 2.0 * 0.125 * 0.25 + (degrees == 30.0 ? 0.25 : 0.0);
                QVERIFY2(std::abs(across - width) <= bound + 1e-6, qPrintable(QString::number(across)));
                if (degrees != 30.0 && axis != RunAxis::y) QVERIFY(std::abs(across - width) < 0.01);
            }
    }

    /// The energy of the cut is K times the removed volume, whatever the speed of the hand: Ft = 1000 K A.
    void theForceIsThatOfTheRemovedVolume() {
        RunVolume block = solid({0.0, 0.0, 0.0}, 0.25, {160, 80, 40}, RunAxis::z);
        Tool tool;
        tool.cutter = cutters::scraper();
        const CuttingCoefficients coefficients = cuttingCoefficients(block.properties(), tool.cutter.diameter);
        const SpinningTool moved = spinningTool(tool, 5000.0);
        MaterialRemoval removal(tool.cutter, block.grid(), Writing::deferred);
        double work = 0.0, volume = 0.0; // N mm, mm³
        for (int i = 0; i < 1500; ++i) {
            const double step = i % 300 < 150 ? 0.02 : 0.06;
            const double x =
                -10.0 + 0.02 * std::min(i % 300, 150) + 0.06 * std::max(i % 300 - 150, 0) + 12.0 * (i / 300);
            const ToolPose from{{x, 10.03, 7.0}, up}, to{{x + step, 10.03, 7.0}, up};
            const CutResult cut = removal.cut(block, from, to);
            volume += cut.volume;
            work += cuttingForce(cut, coefficients, moved, from, to, 0.001).tangential * step;
        }
        QVERIFY(volume > 200.0);
        const double energy = 0.5; // J/mm³ of the soft stock
        QVERIFY2(std::abs(work / (1000.0 * energy * volume) - 1.0) < 0.02, qPrintable(QString::number(work / volume)));
    }

    /// A second pass, deeper than the flutes are long: in its own slot the shank is free, at the slot's end it touches.
    void theShankIsThatOfTheModel() {
        RunVolume block = solid({0.0, 0.0, 0.0}, 0.25, {160, 80, 80}, RunAxis::z); // 20 mm high
        const Cutter cutter = cutters::scraper(0.0, 10.0);
        const auto columns = columnsOf(cutter, block.grid());
        SolidContact shank(columns, 1);
        SolidCutter flutes(columns);
        RemovedUnits removed;
        const double y = 10.03;
        const auto touches = [&](const glm::dvec3& tip) { return shank.at(block, tip).touches; };
        QVERIFY(touches({10.0, y, 8.0}) && !touches({10.0, y, 12.0})); // its flutes end 2 mm below the block's top
        flutes.cut(block, {-10.0, y, 12.0}, {25.0, y, 12.0}, removed);
        flutes.cut(block, {-10.0, y, 8.0}, {25.0, y, 8.0}, removed);
        QVERIFY(!touches({10.0, y, 8.0}) && !touches({25.0, y, 8.0}));
        QVERIFY(!touches({25.05, y, 9.0}));
        const ShankContact end = shank.at(block, {26.0, y, 8.0});
        QVERIFY(end.touches && end.touchesStock && end.piece == 1U && end.property == softStock);
        // 1 mm beyond the slot's end, 2 mm wide, from the top of the flutes at 18 mm up to the block's top at 20 mm
        QVERIFY2(std::abs(end.volume - 1.0 * 2.0 * 2.0) < 0.3, qPrintable(QString::number(end.volume)));
        QVERIFY(std::abs(end.place.x - 29.5) < 0.2 && std::abs(end.place.z - 19.0) < 0.1);
        QVERIFY(touches({25.0, y + 1.0, 8.0})); // beside the slot
    }

    void cuttingAllocatesNothing() {
        RunVolume block = solid({0.0, 0.0, 0.0}, 0.25, {160, 80, 40}, RunAxis::z);
        const Cutter cutter = cutters::scraper(0.3, 4.0);
        MaterialRemoval removal(cutter, block.grid(), Writing::deferred);
        SolidContact shank(columnsOf(cutter, block.grid()), 1);
        const std::size_t before = allocationCount.load();
        for (int i = 0; i < 500; ++i) {
            const ToolPose from{{0.05 * i, 10.0 + 0.01 * i, 7.0 - 0.004 * i}, up};
            const ToolPose to{{0.05 * (i + 1), 10.0 + 0.01 * (i + 1), 7.0 - 0.004 * (i + 1)}, up};
            removal.approach(block, from);
            (void)removal.cut(block, from, to);
            (void)shank.at(block, to.tip);
        }
        QCOMPARE(allocationCount.load() - before, std::size_t{0});
    }

    void posesFarAwayOrNotFiniteRemoveNothing() {
        RunVolume block = solid({0.0, 0.0, 0.0}, 0.25, {40, 40, 40}, RunAxis::z);
        MaterialRemoval removal(cutters::scraper(), block.grid());
        const double huge = 1e300, none = std::nan("");
        for (const glm::dvec3& far : {glm::dvec3(huge, 0.0, 0.0), {0.0, -huge, huge}, {none, 0.0, 0.0}})
            QCOMPARE(removal.cut(block, ToolPose{far, up}, ToolPose{far, up}).volume, 0.0);
        QCOMPARE(removal.cut(block, ToolPose{{-1e5, 0.0, 40.0}, up}, ToolPose{{1e5, 0.0, 40.0}, up}).volume, 0.0);
        QVERIFY(removal.cut(block, ToolPose{{-1e5, 5.03, 4.0}, up}, ToolPose{{1e5, 5.03, 4.0}, up}).volume > 100.0);
    }
};

BURIN_TEST(TestSolidCutter, NoApplication)

} // namespace burin::tst_solid_cutter

#include "tst_solid_cutter.moc"

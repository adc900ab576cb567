// SPDX-FileCopyrightText: 2026 The Burin authors
// SPDX-License-Identifier: Apache-2.0
#include "core/base/units.h"
#include "core/cutting/removal.h"
#include "tests/core/cutting/workpieces.h"
#include "tests/oracles/allocation_count.h"
#include "tests/oracles/moved_piece.h"
#include "tests/random_cases.h"
#include "tests/test_program.h"

#include <QtTest>
#include <rapidcheck.h>

namespace burin::tst_removal {

using namespace burin::tests;

namespace {

double real(double low, double high) {
    return low + (high - low) * *rc::gen::inRange(0, 1000001) / 1e6;
}

Cutter randomCutter() {
    const double diameter = real(1.0, 6.0);
    switch (*rc::gen::inRange(0, 3)) {
    case 0:
        return ball(diameter, real(4.0, 8.0));
    case 1:
        return flat(diameter, real(4.0, 8.0));
    default:
        return bullNose(diameter, diameter * real(0.05, 0.45), real(4.0, 8.0));
    }
}

/// Layers of both stocks with a protected block in the middle.
RunVolume layeredWorkpiece(const Grid& grid) {
    RunVolume volume = block(grid, softStock);
    for (LineIndex line; line.v < grid.lineCountV(); ++line.v)
        for (line.u = 0; line.u < grid.lineCountU(); ++line.u) {
            (void)volume.fillSpan(line, grid.lineEnd() / 2, grid.lineEnd(), hardStock);
            if (line.u > 4 && line.u < 9 && line.v > 3)
                (void)volume.fillSpan(line, grid.lineEnd() / 3 + 17, 2 * grid.lineEnd() / 3, part);
        }
    return volume;
}

std::array<std::uint64_t, 4> unitsWithin(std::span<const Segment> segments, RunPosition from, RunPosition to) {
    std::array<std::uint64_t, 4> units{};
    RunPosition start = 0;
    for (const Segment segment : segments) {
        const RunPosition low = std::max(start, from), high = std::min(segment.end(), to);
        if (low < high) units[segment.property()] += high - low;
        start = segment.end();
    }
    return units;
}

/// Volume of the flutes of a ball or flat end, mm³, and their projected area in a horizontal move, mm².
double volumeOf(const Cutter& cutter) {
    const double radius = cutter.radius(), corner = cutter.cornerRadius;
    const double end = corner == 0.0 ? 0.0 : 2.0 / 3.0 * pi * radius * radius * radius;
    return end + pi * radius * radius * (cutter.fluteLength - corner);
}
double frontOf(const Cutter& cutter) {
    const double radius = cutter.radius(), corner = cutter.cornerRadius;
    return 0.5 * pi * corner * corner + 2.0 * radius * (cutter.fluteLength - corner);
}

} // namespace

class RemovalTest : public QObject {
    Q_OBJECT

private slots:
    /// Every scanline loses the interval that the sampled sweep covers, to one run unit at each end, except protected
    /// runs.
    void eachScanlineLosesWhatTheSweepCovers() {
        const bool held = testing::holdsInShare("lines after a cut", [] {
            const Grid small = grid({-3.0, -2.5, -2.0}, 0.5, {13, 11, 10});
            RunVolume workpiece = layeredWorkpiece(small);
            const VolumeSnapshot before = workpiece.snapshot();
            const Cutter cutter = randomCutter();
            const glm::dvec3 from(real(-4, 4), real(-4, 4), real(-4, 3)), to(real(-4, 4), real(-4, 4), real(-4, 3));
            MaterialRemoval(cutter, small).cut(workpiece, from, to);
            for (LineIndex line; line.v < small.lineCountV(); ++line.v)
                for (line.u = 0; line.u < small.lineCountU(); ++line.u) {
                    const glm::dvec2 centre = small.lineCentre(line);
                    const oracles::SampledSpan span =
                        oracles::sampledSpan(flutes(cutter), from, to, centre.x, centre.y);
                    const double room = cutter.radius() - span.closest;
                    if (std::abs(room) < 1e-9) continue;
                    const auto old = unitsWithin(before.line(line), 0, small.lineEnd());
                    const auto now = unitsWithin(workpiece.line(line), 0, small.lineEnd());
                    const auto covered = room > 0.0 ? unitsWithin(before.line(line), small.toRunPosition(span.low),
                                                                  small.toRunPosition(span.high))
                                                    : std::array<std::uint64_t, 4>{};
                    RC_ASSERT(now[part] == old[part]);
                    for (const PropertyIndex stock : {softStock, hardStock}) {
                        const auto lost = static_cast<std::int64_t>(old[stock] - now[stock]);
                        RC_ASSERT(std::abs(lost - static_cast<std::int64_t>(covered[stock])) <= 2);
                    }
                }
        });
        QVERIFY(held);
    }

    /// The paper's method, eqs. 6–10: the union of the tool at interpolated poses, voxel by voxel. The swept cut
    /// removes all of it and, as the poses come closer, nothing else.
    void equalsTheUnionOfInterpolatedPoses() {
        const bool held = testing::holdsInShare("poses", [] {
            const Grid small = grid({-5.0, -5.0, -5.0}, 0.5, {20, 20, 20});
            RunVolume workpiece = block(small);
            const Cutter cutter = randomCutter();
            const glm::dvec3 from(real(-4, 4), real(-4, 4), real(-5, 3)), to(real(-4, 4), real(-4, 4), real(-5, 3));
            MaterialRemoval(cutter, small).cut(workpiece, from, to);
            const int poses = 1 + static_cast<int>(glm::length(to - from) / (0.02 * small.edge()));
            int missed = 0, beyond = 0;
            for (int i = 0; i < 20; ++i)
                for (int j = 0; j < 20; ++j)
                    for (int k = 0; k < 20; ++k) {
                        const glm::dvec3 centre = small.low() + small.edge() * (glm::dvec3(i, j, k) + 0.5);
                        bool inside = false, close = false;
                        for (int step = 0; step <= poses && !inside; ++step) {
                            const glm::dvec3 local = centre - (from + (to - from) * (double(step) / poses));
                            const double radius = std::hypot(local.x, local.y);
                            if (radius > cutter.radius() + 0.05) continue;
                            const oracles::Faces faces =
                                oracles::facesAt(flutes(cutter), std::min(radius, cutter.radius()));
                            const double depth = std::min(local.z - faces.low, faces.high - local.z);
                            inside = radius < cutter.radius() && depth > small.edge() / unitsPerVoxel;
                            close = close || depth > -0.05;
                        }
                        const bool removed = !workpiece.belongs({i, j, k});
                        // Within a run unit of the surface, rounding decides; between poses the sweep covers more.
                        if (inside && !removed) ++missed;
                        if (!inside && removed && !close) ++beyond;
                    }
            RC_ASSERT(missed == 0);
            RC_ASSERT(beyond == 0);
        });
        QVERIFY(held);
    }

    /// The units that the cuts report as removed equal the decrease of the volume's amounts exactly, over a whole walk.
    void removedUnitsAreTheDropOfTheAmounts() {
        const bool held = testing::holdsInShare("amounts", [] {
            const Grid small = grid({-3.0, -2.5, -2.0}, 0.25, {26, 22, 20});
            RunVolume workpiece = layeredWorkpiece(small);
            const RunAmounts before = workpiece.amounts();
            const Cutter cutter = randomCutter();
            MaterialRemoval removal(cutter, small);
            glm::dvec3 tip(real(-4, 4), real(-4, 4), 3.0);
            std::array<std::uint64_t, 4> removed{};
            double volume = 0.0;
            for (int tick = 0; tick < 30; ++tick) {
                const glm::dvec3 next = tip + glm::dvec3(real(-0.7, 0.7), real(-0.7, 0.7), real(-0.7, 0.4));
                const CutResult cut = removal.cut(workpiece, tip, next);
                for (const MaterialVolume& material : cut.removed) {
                    removed[material.property] += material.units;
                    RC_ASSERT(material.volume == static_cast<double>(material.units) * small.unitVolume());
                }
                volume += cut.volume;
                tip = next;
            }
            for (const PropertyIndex stock : {softStock, hardStock})
                RC_ASSERT(before.units[stock] - workpiece.amounts().units[stock] == removed[stock]);
            RC_ASSERT(before.units[part] == workpiece.amounts().units[part]);
            RC_ASSERT(workpiece.snapshot().amounts() == workpiece.amounts());
            const double drop = static_cast<double>(removed[softStock] + removed[hardStock]) * small.unitVolume();
            RC_ASSERT(std::abs(volume - drop) <= 1e-9 * drop);
        });
        QVERIFY(held);
    }

    void standingStillRemovesNothing() {
        const bool held = testing::holdsInShare("standing still", [] {
            const Grid small = grid({-3.0, -2.5, -2.0}, 0.25, {26, 22, 20});
            RunVolume workpiece = block(small);
            MaterialRemoval removal(randomCutter(), small);
            const glm::dvec3 from(real(-4, 4), real(-4, 4), real(-3, 3)), to(real(-4, 4), real(-4, 4), real(-3, 3));
            removal.cut(workpiece, from, to);
            for (int tick = 0; tick < 3; ++tick) {
                const CutResult still = removal.cut(workpiece, to, to);
                RC_ASSERT(still.volume == 0.0);
                RC_ASSERT(still.reported == 0.0);
                RC_ASSERT(!still.outOfMemory);
            }
        });
        QVERIFY(held);
    }

    /// A floor on a rounding tie, cut over a hundred times, keeps its height.
    void aFloorDoesNotSink() {
        const Grid fine = grid({0.0, 0.0, 0.0}, 0.2, {100, 50, 30});
        RunVolume workpiece = block(fine);
        MaterialRemoval removal(flat(4.0, 10.0), fine);
        const double tie = 2.0 + 0.5 * 0.2 / unitsPerVoxel;
        glm::dvec3 tip(4.0, 5.0, tie);
        removal.cut(workpiece, tip, {16.0, 5.0, tie});
        const RunAmounts after = workpiece.amounts();
        tip.x = 16.0;
        for (int pass = 0; pass < 100; ++pass) {
            const glm::dvec3 next(pass % 2 == 0 ? 4.0 : 16.0, 5.0, tie);
            removal.cut(workpiece, tip, next);
            tip = next;
        }
        QVERIFY(workpiece.amounts() == after);
    }

    /// Paper, eq. 5: VR = depth · width · feed · time for plain end milling. Width and distance are whole voxels here,
    /// the depth whole run units, so that the formula holds exactly.
    void slotOfAnEndMillFollowsThePapersFormula() {
        const double edge = 0.25, depth = 1.5, width = 4.0, feed = 25.0; // mm, mm/s
        const Grid fine = grid({0.0, 0.0, 0.0}, edge, {160, 40, 16});
        RunVolume workpiece = block(fine);
        MaterialRemoval removal(flat(width, 10.0), fine);
        glm::dvec3 tip(6.03, 5.0, 4.0 - depth);
        removal.cut(workpiece, tip + glm::dvec3(0.0, 0.0, 5.0), tip);
        double removed = 0.0;
        constexpr int ticks = 800;
        constexpr double period = 0.001;
        for (int tick = 0; tick < ticks; ++tick) {
            const glm::dvec3 next(6.03 + feed * period * (tick + 1), 5.0, tip.z);
            removed += removal.cut(workpiece, tip, next).volume;
            tip = next;
        }
        const double expected = depth * width * feed * ticks * period;
        QVERIFY2(std::abs(removed - expected) <= 1e-9 * expected, qPrintable(QString::number(removed - expected)));
    }

    void sweptVolumeConvergesToTheClosedFormula_data() {
        QTest::addColumn<bool>("round");
        QTest::addColumn<double>("edge");
        QTest::addColumn<double>("tolerance");
        for (const bool round : {true, false})
            for (const auto& [edge, tolerance] : {std::pair{0.4, 0.008}, std::pair{0.2, 0.006}, std::pair{0.1, 0.0015}})
                QTest::addRow("%s in voxels of %.1f", round ? "ball" : "flat", edge) << round << edge << tolerance;
    }
    void sweptVolumeConvergesToTheClosedFormula() {
        QFETCH(bool, round);
        QFETCH(double, edge);
        QFETCH(double, tolerance);
        const Cutter cutter = round ? ball(6.0, 8.0) : flat(6.0, 8.0);
        const Grid fine = grid({-4.0, -4.0, -1.0}, edge, glm::ivec3(glm::dvec3(18.0, 16.0, 12.0) / edge + 0.5));
        const glm::dvec3 start(0.013, 0.027, 0.011);
        RunVolume workpiece = block(fine);
        const glm::dvec3 move(7.1, 5.3, 0.0);
        const double horizontal = MaterialRemoval(cutter, fine).cut(workpiece, start, start + move).volume;
        const double expected = volumeOf(cutter) + glm::length(move) * frontOf(cutter);
        QVERIFY2(std::abs(horizontal / expected - 1.0) < tolerance,
                 qPrintable(QString::number(horizontal / expected - 1.0)));
        RunVolume other = block(fine);
        const double vertical = MaterialRemoval(cutter, fine).cut(other, start + glm::dvec3(0, 0, 2.3), start).volume;
        const double plunge = volumeOf(cutter) + 2.3 * pi * cutter.radius() * cutter.radius();
        QVERIFY2(std::abs(vertical / plunge - 1.0) < tolerance, qPrintable(QString::number(vertical / plunge - 1.0)));
    }

    void centroidOfAPlungeLiesOnTheAxis() {
        const Grid fine = grid({-5.0, -5.0, 0.0}, 0.1, {100, 100, 40});
        RunVolume workpiece = block(fine);
        const CutResult cut = MaterialRemoval(flat(4.0, 10.0), fine).cut(workpiece, {0, 0, 9}, {0, 0, 1});
        QVERIFY(glm::length(cut.centroid - glm::dvec3(0.0, 0.0, 2.5)) < 1e-9);
        QVERIFY(std::abs(cut.volume / (pi * 4.0 * 3.0) - 1.0) < 0.01);
    }

    void aTipThatIsNoNumberRemovesNothing() {
        const Grid small = grid({0.0, 0.0, 0.0}, 0.5, {10, 10, 10});
        RunVolume workpiece = block(small);
        const RunAmounts before = workpiece.amounts();
        MaterialRemoval removal(ball(3.0, 6.0), small);
        const double nan = std::nan("");
        QCOMPARE(removal.cut(workpiece, {nan, 1.0, 1.0}, {2.0, 2.0, 2.0}).volume, 0.0);
        QCOMPARE(removal.cut(workpiece, {2.0, 2.0, 2.0}, {2.0, 1e308 * 10, 2.0}).volume, 0.0);
        QVERIFY(workpiece.amounts() == before);
    }

    /// When the reserve is used up the cut stops and reports it, and still counts everything that it removed.
    void anExhaustedReserveStopsTheCut() {
        const Grid fine = grid({0.0, 0.0, 0.0}, 0.1, {160, 160, 60});
        RunVolume workpiece = RunVolume::make(fine, materials(), 40000).value();
        if (!workpiece.fillBlock({0, 0}, {160, 160}, 0, fine.lineEnd(), softStock)) QFAIL("no room for a plain block");
        const RunAmounts before = workpiece.amounts();
        const CutResult cut = MaterialRemoval(ball(6.0, 8.0), fine).cut(workpiece, {4, 4, 2}, {12, 12, 1.5});
        QVERIFY(cut.outOfMemory);
        QCOMPARE(before.units[softStock] - workpiece.amounts().units[softStock], unitsOf(cut, softStock));
    }

    void cuttingAllocatesNothing() {
        const Grid fine = grid({-10.0, -10.0, -10.0}, 0.2, {100, 100, 50});
        RunVolume workpiece = layeredWorkpiece(fine);
        const Cutter cutter = bullNose(6.0, 1.0, 12.0);
        const std::vector<RevolvedPiece> stack = pieces(cutter);
        MaterialRemoval removal(cutter, fine);
        glm::dvec3 tip(-6.0, 0.0, -4.0);
        bool touched = false;
        const std::size_t before = allocationCount.load();
        for (int tick = 0; tick < 400; ++tick) {
            const double step = tick < 200 ? 0.01 : 0.1; // with and without the flux
            const glm::dvec3 next = tip + glm::dvec3(step, 0.3 * step, -0.2 * step);
            removal.cut(workpiece, tip, next);
            touched = shankContact(workpiece, stack, next + glm::dvec3(0.0, 8.0, -11.0)).touches || touched;
            tip = next;
        }
        QCOMPARE(allocationCount.load() - before, std::size_t{0});
        QVERIFY(touched);
        QVERIFY(allocationCount.load() > 0); // the counter works
    }
};

BURIN_TEST(RemovalTest, NoApplication)

} // namespace burin::tst_removal

#include "tst_removal.moc"

// SPDX-FileCopyrightText: 2026 The Burin authors
// SPDX-License-Identifier: Apache-2.0
#include "core/cutting/removal.h"
#include "core/cutting/window_cutter.h"
#include "core/volume/runs/voxel_runs.h"
#include "tests/core/cutting/run_loss.h"
#include "tests/core/cutting/scalar_cutter.h"
#include "tests/core/tool/cutters.h"
#include "tests/core/tool/random_sweeps.h"
#include "tests/oracles/swept_cutter.h"
#include "tests/test_program.h"

#include <QtTest>
#include <rapidcheck.h>

#include <algorithm>
#include <cmath>
#include <iomanip>
#include <limits>
#include <sstream>
#include <vector>

namespace burin::tst_random_cuts {

using namespace burin::tests;
using oracles::SweptCutter;
using Verdict = SweptCutter::Verdict;

namespace {

constexpr PropertyIndex brass = 4, clamp = 5;

/// Three machinable materials, two protected ones.
PropertyList fiveMaterials() {
    PropertyList list = materials();
    (void)list.add(material("brass", 3.0, 0.4));
    (void)list.add(material("clamp", 1.0, 0.4, Machinability::isProtected));
    return list;
}

/// A box of one property, lines and run units.
struct Block {
    LineIndex low, high;
    RunPosition from = 0, to = 0;
    PropertyIndex property = airProperty;
};

struct Move {
    ToolPose from, to;
    bool settles = false; ///< afterwards
    bool turns() const { return from.axis != to.axis; }
};

/// A workpiece and the moves that cut it.
struct Job {
    Grid grid;
    RunPosition phase = 0; ///< the unit of each voxel that is examined
    std::vector<Block> blocks;
    std::vector<Move> moves;
};

std::ostream& operator<<(std::ostream& out, const ToolPose& pose) {
    const auto print = [&](const glm::dvec3& v) { out << "{" << v.x << ", " << v.y << ", " << v.z << "}"; };
    out << "tip ";
    print(pose.tip);
    out << " axis ";
    print(pose.axis);
    return out;
}
std::ostream& operator<<(std::ostream& out, const Job& job) {
    out << std::setprecision(17) << "runs along " << job.grid.axisOfRuns() << ", unit " << job.phase;
    for (const Block& block : job.blocks)
        out << "\nblock " << block.low.u << " " << block.low.v << " to " << block.high.u << " " << block.high.v << ", "
            << block.from << " to " << block.to << ": " << int(block.property);
    for (const Move& move : job.moves)
        out << "\nfrom " << move.from << "\n  to " << move.to << (move.settles ? ", settles" : "");
    return out;
}

Block anyBlock(const Grid& grid) {
    const LineIndex low{*rc::gen::inRange(0, grid.lineCountU()), *rc::gen::inRange(0, grid.lineCountV())};
    const auto from = *rc::gen::inRange<RunPosition>(0, grid.lineEnd());
    return {low,
            {std::min(low.u + *rc::gen::inRange(1, 16), grid.lineCountU()),
             std::min(low.v + *rc::gen::inRange(1, 16), grid.lineCountV())},
            from,
            std::min(from + *rc::gen::inRange<RunPosition>(1, 2000), grid.lineEnd()),
            *rc::gen::element(airProperty, hardStock, part, brass, clamp)};
}

/// Parallel to the runs, nearly parallel, or in any direction.
glm::dvec3 anyAxis(const Grid& grid) {
    glm::dvec3 axis(0.0);
    axis[grid.axisOfRuns()] = 1.0;
    switch (*rc::gen::inRange(0, 5)) {
    case 0:
        return axis;
    case 1:
        return glm::normalize(axis + 0.003 * random::axis());
    default:
        return random::axis();
    }
}

/// A pose with some point of the flutes in the grid.
ToolPose anyPose(const Grid& grid, const Cutter& cutter) {
    const glm::dvec3 axis = anyAxis(grid), share(real(0.0, 1.0), real(0.0, 1.0), real(0.0, 1.0));
    const glm::dvec3 place = grid.low() + share * (grid.box().high - grid.low());
    return {place - real(0.0, cutter.fluteLength) * axis, axis};
}

Move anyMove(const Grid& grid, const ToolPose& from) {
    const glm::dvec3 turned = glm::normalize(from.axis + *rc::gen::element(0.001, 0.03, 0.2) * random::axis());
    const glm::dvec3 axis = *rc::gen::inRange(0, 2) == 0 ? turned : from.axis;
    const glm::dvec3 way = random::moveFor(from.axis) / 6.0; // less than 1.8 mm
    const double voxels = *rc::gen::element(0.1, 1.0, 5.0, 20.0);
    return {from, {from.tip + voxels * grid.edge() * way, axis}, *rc::gen::inRange(0, 3) == 0};
}

/// Moves most of which continue from the previous one.
Job anyJob(const Cutter& cutter) {
    const auto runs = *rc::gen::element(RunAxis::x, RunAxis::y, RunAxis::z);
    Job job{
        Grid::make({-1.0, 2.0, -3.0}, 0.5, {29, 26, 31}, runs).value(), *rc::gen::inRange<RunPosition>(0, 256), {}, {}};
    for (int i = *rc::gen::inRange(0, 6); i > 0; --i) job.blocks.push_back(anyBlock(job.grid));
    ToolPose pose = anyPose(job.grid, cutter);
    for (int i = *rc::gen::inRange(3, 9); i > 0; --i) {
        job.moves.push_back(anyMove(job.grid, pose));
        pose = *rc::gen::inRange(0, 4) == 0 ? anyPose(job.grid, cutter) : job.moves.back().to;
    }
    return job;
}

RunVolume workpieceOf(const Job& job) {
    RunVolume volume = RunVolume::make(job.grid, fiveMaterials()).value();
    RC_ASSERT(fillMotley(volume));
    for (const Block& block : job.blocks)
        RC_ASSERT(volume.fillBlock(block.low, block.high, block.from, block.to, block.property));
    return volume;
}

bool usesWindow(const std::vector<RevolvedPiece>& flutes) {
    return flutes.size() == 1 && WindowCutter::serves(flutes.front());
}

/// Largest error of the removed volume, mm, as stated for each way of cutting. A unit of a line is removed when its
/// centre is swept, and the tests check centres, so that rounding to units adds nothing.
double marginOf(const std::vector<RevolvedPiece>& flutes, Writing writing, const Move& move, const Grid& grid) {
    constexpr double arithmetic = 1e-6; // mm
    if (writing == Writing::everyCut || !usesWindow(flutes))
        return arithmetic + (move.turns() ? SweepCutter::turnTolerance * grid.edge() : 0.0);
    const double extent = (reachOf(flutes) + glm::length(move.to.tip - move.from.tip)) / grid.edge();
    const double spans = 4.0 * SpanRows::outlineError * extent + SpanRows::uprightError + SpanRows::leaningWayError +
                         (SpanRows::endError + 0.5) / unitsPerVoxel;
    return grid.edge() * (spans + (move.turns() ? WindowCutter::turnTolerance : 0.0));
}

/// Largest error of a centroid, mm. The cache sums positions in single precision, relative to a point near the tool.
double centroidErrorOf(bool windowed, const Grid& grid) {
    return windowed ? std::numeric_limits<float>::epsilon() * glm::length(grid.box().size()) : 1e-9;
}

/// Sums of the reported cuts.
struct Reported {
    RunAmounts amounts;
    double volume = 0.0;
    glm::dvec3 moment{0.0}; ///< mm⁴

    void add(const CutResult& cut) {
        for (const MaterialVolume& material : cut.removed) amounts.units[material.property] += material.units;
        volume += cut.volume;
        if (cut.volume > 0.0) moment += cut.volume * cut.centroid;
    }
    glm::dvec3 centroid() const { return moment / volume; }
};

struct Judged {
    int gone = 0, left = 0, near = 0;
    int centroids = 0;
    double farthest = 0.0; ///< mm, largest error of a centroid
};

/// The removal reported by the cuts equals the loss of the runs, property by property, to the unit, and in position.
void checkSums(const VolumeSnapshot& before, const VolumeSnapshot& after, const Reported& reported, double tolerance,
               Judged& judged) {
    const RunLoss loss = lossBetween(before, after);
    RC_ASSERT(loss.onlyMachinable);
    RC_ASSERT(reported.amounts == loss.amounts);
    const double volume = loss.units * before.grid().unitVolume();
    RC_ASSERT(std::abs(reported.volume - volume) <= 1e-12 * volume);
    if (loss.units == 0.0) return;
    const double off = glm::length(reported.centroid() - loss.centroid());
    ++judged.centroids;
    judged.farthest = std::max(judged.farthest, off);
    RC_ASSERT(off < tolerance);
}

/// Checks one unit of every voxel of the grid: removed if any move sweeps it and it is machinable, otherwise unchanged.
void checkPlaces(const Job& job, const VolumeSnapshot& before, const VolumeSnapshot& after,
                 const std::vector<SweptCutter>& sweeps, Judged& judged) {
    const Grid& grid = job.grid;
    for (LineIndex line; line.v < grid.lineCountV(); ++line.v)
        for (line.u = 0; line.u < grid.lineCountU(); ++line.u)
            for (RunPosition unit = job.phase; unit < grid.lineEnd(); unit += unitsPerVoxel) {
                const PropertyIndex was = propertyAt(before.line(line), unit), is = propertyAt(after.line(line), unit);
                if (was == airProperty || before.properties().isProtected(was)) continue; // compared with the sums
                const glm::dvec3 place = placeOn(grid, line, unit + 0.5);
                auto verdict = Verdict::outside;
                for (const SweptCutter& sweep : sweeps) {
                    const Verdict one = sweep.at(place);
                    if (one != Verdict::outside) verdict = one;
                    if (one == Verdict::inside) break;
                }
                if (verdict == Verdict::near) {
                    ++judged.near;
                    continue;
                }
                const bool isGone = verdict == Verdict::inside;
                ++(isGone ? judged.gone : judged.left);
                if (is != (isGone ? airProperty : was)) {
                    std::ostringstream where;
                    where << "line " << line.u << ", " << line.v << ", unit " << unit << ": was " << int(was) << ", is "
                          << int(is) << (isGone ? ", but it was swept" : ", but nothing swept it");
                    RC_FAIL(where.str());
                }
            }
}

void checkJob(const Job& job, const Cutter& cutter, Writing writing, Judged& judged) {
    const std::vector<RevolvedPiece> flutes = flutePieces(cutter);
    const double tolerance = centroidErrorOf(writing == Writing::deferred && usesWindow(flutes), job.grid);
    RunVolume workpiece = workpieceOf(job);
    const VolumeSnapshot first = workpiece.snapshot();
    MaterialRemoval removal(cutter, job.grid, writing);
    VolumeSnapshot before = first;
    Reported reported;
    std::vector<SweptCutter> sweeps;
    const auto settle = [&] {
        const CutResult rest = removal.settle(workpiece);
        RC_ASSERT(!rest.outOfMemory && removal.settled());
        reported.add(rest);
        const VolumeSnapshot after = workpiece.snapshot();
        checkSums(before, after, reported, tolerance, judged);
        before = after;
        reported = {};
    };
    for (const Move& move : job.moves) {
        const CutResult cut = removal.cut(workpiece, move.from, move.to);
        RC_ASSERT(!cut.outOfMemory);
        reported.add(cut);
        if (writing == Writing::everyCut || move.settles) settle();
        sweeps.emplace_back(flutes, move.from, move.to, marginOf(flutes, writing, move, job.grid),
                            0.03 * job.grid.edge());
    }
    settle();
    RC_ASSERT(isValid(workpiece));
    checkPlaces(job, first, before, sweeps, judged);
}

} // namespace

/// Random jobs of successive cuts, with every cutter, in both modes of writing, in a workpiece of several materials,
/// gaps and protected bodies, along all run axes; compared with samples of the moved cutter.
class RandomCutsTest : public QObject {
    Q_OBJECT

private slots:
    void takeWhatTheMovedCutterCovers_data() {
        QTest::addColumn<int>("index");
        QTest::addColumn<bool>("deferred");
        const std::vector<cutters::Named> all = cutters::all();
        for (int i = 0; i < static_cast<int>(all.size()); ++i)
            for (const bool deferred : {false, true})
                QTest::addRow("%s, %s", all[static_cast<std::size_t>(i)].name, deferred ? "deferred" : "every cut")
                    << i << deferred;
    }
    void takeWhatTheMovedCutterCovers() {
        QFETCH(const int, index);
        QFETCH(const bool, deferred);
        const Cutter cutter = cutters::all()[static_cast<std::size_t>(index)].cutter;
        const std::vector<RevolvedPiece> flutes = flutePieces(cutter);
        // Cuts that the cache does not serve are written at once in either mode.
        const int percent = !deferred ? 8 : usesWindow(flutes) ? 22 : 3;
        Judged judged;
        const bool held = holds("random cuts", percent, [&] {
            // Positions and lengths have no small cases to try first.
            const Job job = *rc::gen::resize(rc::kNominalSize, rc::gen::exec([&] { return anyJob(cutter); }));
            checkJob(job, cutter, deferred ? Writing::deferred : Writing::everyCut, judged);
        });
        qInfo("%d gone, %d left, %d near; centroids %d, off by %.2g mm at most", judged.gone, judged.left, judged.near,
              judged.centroids, judged.farthest);
        QVERIFY(held);
        QVERIFY(judged.gone > 10 * percent && judged.left > 10 * percent && judged.centroids > 0);
    }
};

BURIN_TEST(RandomCutsTest, NoApplication)

} // namespace burin::tst_random_cuts

#include "tst_random_cuts.moc"

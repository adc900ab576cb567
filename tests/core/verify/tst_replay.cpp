// SPDX-FileCopyrightText: 2026 The Burin authors
// SPDX-License-Identifier: Apache-2.0
#include "core/base/units.h"
#include "core/cutting/contact.h"
#include "core/cutting/removal.h"
#include "core/verify/cut_filter.h"
#include "core/verify/replay.h"
#include "tests/test_program.h"

#include <QTest>
#include <oneapi/tbb/global_control.h>
#include <rapidcheck.h>

#include <algorithm>
#include <cmath>

namespace burin::tst_replay {

namespace {

constexpr double voxel = 0.4;                     // mm
constexpr glm::dvec3 size(18.4, 14.0, 10.0);      // mm, of the grid
constexpr double stockTop = 9.3, partTop = 2.7;   // mm
constexpr glm::dvec2 partLow(4.0), partHigh(9.0); // mm

/// Stock with a protected block in it and a cavity under an overhang.
RunVolume workpiece(RunAxis axis) {
    PropertyList list;
    Property stock, part;
    stock.id = "stock";
    part.id = "part";
    part.machinability = Machinability::isProtected;
    (void)list.add(stock);
    (void)list.add(part);
    const Grid grid = Grid::make(glm::dvec3(-1.0, 2.0, 3.0), voxel, glm::ivec3(glm::round(size / voxel)), axis).value();
    RunVolume volume = RunVolume::make(grid, list).value();
    const glm::ivec3 count = grid.count();
    const int top = static_cast<int>(std::floor(stockTop / voxel));
    for (int k = 0; k < top; ++k)
        for (int j = 0; j < count.y; ++j)
            for (int i = 0; i < count.x; ++i) {
                const glm::dvec3 at = (glm::dvec3(i, j, k) + 0.5) * voxel;
                const bool isPart =
                    at.z < partTop && at.x > partLow.x && at.x < partHigh.x && at.y > partLow.y && at.y < partHigh.y;
                const bool hollow = at.x > 13.0 && at.z > 3.0 && at.z < 5.0;
                if (!hollow) (void)volume.insert({i, j, k}, isPart ? PropertyIndex{2} : PropertyIndex{1});
            }
    return volume;
}

Tool toolOf(CutterType type) {
    Tool tool;
    tool.cutter = {type,
                   4.0,
                   type == CutterType::ball ? 2.0 : type == CutterType::bullNose ? 0.7 : 0.0,
                   5.0,
                   3.0,
                   7.0,
                   {{6.0, 8.0, 4.0}}};
    if (type == CutterType::drill) tool.cutter.taperAngle = pi / 3.0;
    return tool;
}

/// Its holder's cone is drawn in steps of a quarter of a voxel, none of which has a contact of a quarter of a voxel by
/// itself.
Tool withSteps(Tool tool) {
    constexpr int steps = 40;
    tool.cutter.holder.clear();
    for (int i = 0; i < steps; ++i) {
        const double diameter = 6.0 + 2.0 * (i + 0.5) / steps;
        tool.cutter.holder.push_back({diameter, diameter, 4.0 / steps});
    }
    return tool;
}

/// Moves in and around the stock, some with unknown start, some rapid, some with a stationary spindle. None has its
/// axis on a scanline: other lines would then be exactly on the tool's wall (3, 4, 5 voxels), where the last bit
/// decides.
std::vector<ToolMove> someMoves(std::size_t tools) {
    std::vector<ToolMove> moves;
    glm::dvec3 tip(5.0, 5.0, 20.0);
    const int count = *rc::gen::inRange(2, 9);
    for (int i = 0; i < count; ++i) {
        ToolMove move;
        move.from.tip = tip;
        const auto place = [](double low, double length) { return low + length * *rc::gen::inRange(0, 101) / 100.0; };
        move.to.tip = {place(-2.9863, 22.0), place(0.0171, 18.0), place(5.0, 9.0)};
        if (*rc::gen::inRange(0, 4) == 0) move.to.tip.z = tip.z;                       // level
        if (*rc::gen::inRange(0, 5) == 0) move.to.tip = {tip.x, tip.y, move.to.tip.z}; // straight down or up
        move.rapid = *rc::gen::inRange(0, 3) == 0;
        move.spindleOn = *rc::gen::inRange(0, 3) != 0;
        move.startKnown = i > 0 && *rc::gen::inRange(0, 8) != 0;
        move.tool = static_cast<std::uint16_t>(*rc::gen::inRange(0, static_cast<int>(tools)));
        move.line = static_cast<std::uint32_t>(i + 1);
        tip = move.to.tip;
        moves.push_back(move);
    }
    return moves;
}

/// One move after the other, each in steps of at most a voxel, each checked over the whole grid without a cache.
struct SlowReplay {
    std::vector<double> volumes;
    Findings findings;

    SlowReplay(const std::vector<ToolMove>& moves, const std::vector<Tool>& tools, RunVolume& volume) {
        constexpr glm::dvec3 up(0.0, 0.0, 1.0);
        for (const ToolMove& move : moves) {
            const Cutter& cutter = tools[move.tool].cutter;
            const std::vector<RevolvedPiece> stack = pieces(cutter);
            MaterialRemoval removal(cutter, volume.grid());
            const glm::dvec3 from = move.startKnown ? move.from.tip : move.to.tip;
            const int steps = std::max(1, static_cast<int>(std::ceil(glm::length(move.to.tip - from) / voxel)));
            glm::dvec3 tip = from;
            double taken = 0.0;
            for (int i = 1; i <= steps; ++i) {
                const glm::dvec3 next =
                    i == steps ? move.to.tip : glm::mix(from, move.to.tip, static_cast<double>(i) / steps);
                taken += removal.cut(volume, ToolPose{tip, up}, ToolPose{next, up}).volume;
                tip = next;
                const ShankContact contact = shankContact(volume, stack, flutePieces(cutter).size(), {next, up});
                if (!contact.touches) continue;
                const bool shank = sectionOf(cutter, contact.piece) == ToolSection::shank;
                findings.add(shank ? FindingKind::shankCollision : FindingKind::holderCollision, move.line,
                             contact.place, contact.volume);
            }
            volumes.push_back(taken);
            if (taken <= 1e-3) continue;
            if (move.rapid) findings.add(FindingKind::rapidInStock, move.line, move.to.tip, taken);
            if (!move.spindleOn) findings.add(FindingKind::spindleOff, move.line, move.to.tip, taken);
        }
    }
};

std::uint64_t differingUnits(const RunVolume& a, const RunVolume& b) {
    std::uint64_t units = 0;
    const Grid& grid = a.grid();
    for (LineIndex line{0, 0}; line.v < grid.lineCountV(); ++line.v)
        for (line.u = 0; line.u < grid.lineCountU(); ++line.u) {
            if (std::ranges::equal(a.line(line), b.line(line))) continue;
            const auto at = [&](const RunVolume& volume, RunPosition place) {
                for (const Segment segment : volume.line(line))
                    if (place < segment.end()) return segment.property();
                return airProperty;
            };
            for (RunPosition place = 0; place < grid.lineEnd(); ++place)
                units += at(a, place) != at(b, place) ? 1U : 0U;
        }
    return units;
}

std::vector<MoveCut> fastReplay(const std::vector<ToolMove>& moves, const std::vector<Tool>& tools, RunVolume& volume,
                                Findings& findings) {
    Progress progress;
    return replay(moves, tools, volume, findings, progress).value();
}

} // namespace

class ReplayTest : public QObject {
    Q_OBJECT
private slots:
    void isThatOfOneStepAfterTheOther();
    void takesWhatADenseGridSays();
    void doesNotDependOnTheNumberOfThreads();
    void tellsWhatEachMoveTook();
    void neverLeavesOutALineThatIsCut();
};

/// Values rounded to a run unit may differ by one where steps divide a move; nothing else may.
void ReplayTest::isThatOfOneStepAfterTheOther() {
    const std::vector<Tool> tools{toolOf(CutterType::ball), toolOf(CutterType::flat), toolOf(CutterType::bullNose),
                                  toolOf(CutterType::drill), withSteps(toolOf(CutterType::flat))};
    const bool holds = rc::check("whole moves by rows equal single steps over the whole grid", [&] {
        constexpr RunAxis axis = RunAxis::z; // with runs perpendicular to the tool a face may lie on a row of lines,
                                             // and a bit decides
        const std::vector<ToolMove> moves = someMoves(tools.size());
        RunVolume slow = workpiece(axis), fast = workpiece(axis);
        const SlowReplay expected(moves, tools, slow);
        Findings findings;
        const std::vector<MoveCut> cuts = fastReplay(moves, tools, fast, findings);
        const double unit = fast.grid().unitVolume();
        for (std::size_t i = 0; i < moves.size(); ++i)
            RC_ASSERT(std::abs(cuts[i].volume - expected.volumes[i]) < 50.0 * unit);
        RC_ASSERT(differingUnits(slow, fast) < 50U);
        const std::vector<Finding> one = findings.inProgramOrder(), other = expected.findings.inProgramOrder();
        RC_ASSERT(one.size() == other.size());
        for (std::size_t i = 0; i < one.size(); ++i) {
            RC_ASSERT(one[i].kind == other[i].kind && one[i].line == other[i].line);
            RC_ASSERT(std::abs(one[i].amount - other[i].amount) < 200.0 * unit + 1e-6 * other[i].amount);
            const bool contact =
                one[i].kind == FindingKind::shankCollision || one[i].kind == FindingKind::holderCollision;
            RC_ASSERT(!contact || glm::length(one[i].place - other[i].place) < voxel);
        }
    });
    QVERIFY(holds);
}

/// A point was cut by a ball if its centre came within its radius: checked for points on a lattice of a sixth of a
/// voxel.
void ReplayTest::takesWhatADenseGridSays() {
    const std::vector<Tool> tools{toolOf(CutterType::ball)};
    std::vector<ToolMove> moves(2);
    moves[0].from.tip = {1.3, 5.1, 9.2};
    moves[0].to.tip = moves[1].from.tip = {12.2, 9.4, 7.4};
    moves[1].to.tip = {3.1, 13.3, 8.8};
    RunVolume volume = workpiece(RunAxis::z);
    const RunVolume before = workpiece(RunAxis::z);
    Findings findings;
    const std::vector<MoveCut> cuts = fastReplay(moves, tools, volume, findings);

    const auto distance = [](const glm::dvec3& p, const glm::dvec3& a, const glm::dvec3& b) {
        const double along = std::clamp(glm::dot(p - a, b - a) / glm::dot(b - a, b - a), 0.0, 1.0);
        return glm::length(p - glm::mix(a, b, along));
    };
    const glm::dvec3 up(0.0, 0.0, 2.0);
    constexpr int fine = 6;
    const Grid& grid = volume.grid();
    double expected = 0.0;
    for (int k = 0; k < grid.count().z; ++k)
        for (int j = 0; j < grid.count().y; ++j)
            for (int i = 0; i < grid.count().x; ++i) {
                const std::optional<Run> run = before.locate({i, j, k});
                if (!run || run->property != 1) continue;
                for (int part = 0; part < fine * fine * fine; ++part) {
                    const glm::dvec3 inVoxel(part % fine, part / fine % fine, part / fine / fine);
                    const glm::dvec3 p = grid.low() + (glm::dvec3(i, j, k) + (inVoxel + 0.5) / double(fine)) * voxel;
                    bool taken = false;
                    for (const ToolMove& move : moves) {
                        const double nearest = distance(p, move.from.tip + up, move.to.tip + up);
                        taken = taken || nearest < 2.0; // the flutes continue upwards from the ball's centre
                        const glm::dvec2 plan(p);
                        const double flat =
                            distance({plan, 0.0}, {glm::dvec2(move.from.tip), 0.0}, {glm::dvec2(move.to.tip), 0.0});
                        const double share = std::clamp(
                            glm::dot(plan - glm::dvec2(move.from.tip), glm::dvec2(move.to.tip - move.from.tip)) /
                                glm::dot(glm::dvec2(move.to.tip - move.from.tip),
                                         glm::dvec2(move.to.tip - move.from.tip)),
                            0.0, 1.0);
                        taken = taken || (flat < 2.0 && p.z > glm::mix(move.from.tip, move.to.tip, share).z + 2.0);
                    }
                    if (taken) expected += std::pow(voxel / fine, 3.0);
                }
            }
    const double removed = cuts[0].volume + cuts[1].volume;
    QVERIFY2(std::abs(removed - expected) < 0.01 * expected,
             qPrintable(QStringLiteral("%1 %2").arg(removed).arg(expected)));
}

void ReplayTest::doesNotDependOnTheNumberOfThreads() {
    const std::vector<Tool> tools{toolOf(CutterType::bullNose), toolOf(CutterType::ball)};
    const bool holds = rc::check("one thread and many give the same bits", [&] {
        const std::vector<ToolMove> moves = someMoves(tools.size());
        RunVolume one = workpiece(RunAxis::z), many = workpiece(RunAxis::z);
        Findings alone, together;
        std::vector<MoveCut> a;
        {
            const oneapi::tbb::global_control limit(oneapi::tbb::global_control::max_allowed_parallelism, 1);
            a = fastReplay(moves, tools, one, alone);
        }
        const std::vector<MoveCut> b = fastReplay(moves, tools, many, together);
        for (std::size_t i = 0; i < moves.size(); ++i) RC_ASSERT(a[i].volume == b[i].volume);
        RC_ASSERT(one.amounts() == many.amounts());
        const std::vector<Finding> x = alone.inProgramOrder(), y = together.inProgramOrder();
        RC_ASSERT(x.size() == y.size());
        for (std::size_t i = 0; i < x.size(); ++i) RC_ASSERT(x[i].amount == y[i].amount && x[i].place == y[i].place);
    });
    QVERIFY(holds);
}

/// A second pass of a slot at the same depth removes nothing, one deeper by a millimetre removes its own millimetre.
void ReplayTest::tellsWhatEachMoveTook() {
    const std::vector<Tool> tools{toolOf(CutterType::flat)};
    std::vector<ToolMove> moves(4);
    const glm::dvec3 start(1.5, 8.2, 11.0), end(10.5, 8.2, 11.0), down(0.0, 0.0, -1.0);
    moves[0].from.tip = moves[0].to.tip = start;
    moves[1].from.tip = start;
    moves[1].to.tip = moves[2].from.tip = end;
    moves[2].to.tip = moves[3].from.tip = start;
    moves[3].to.tip = start + down;
    RunVolume volume = workpiece(RunAxis::z);
    Findings findings;
    const std::vector<MoveCut> cuts = fastReplay(moves, tools, volume, findings);
    const double depth = 3.0 + 23 * voxel - 11.0;
    QVERIFY(std::abs(cuts[1].volume - 9.0 * 4.0 * depth) < 0.02 * cuts[1].volume);
    QCOMPARE(cuts[2].volume, 0.0);
    QVERIFY(std::abs(cuts[3].volume - pi * 4.0) < 0.06 * cuts[3].volume);
    QVERIFY(glm::length(cuts[3].centroid - (start + 0.5 * down)) < 0.5 * voxel);
}

void ReplayTest::neverLeavesOutALineThatIsCut() {
    const Grid grid = Grid::make(glm::dvec3(0.0), 0.25, {64, 64, 256}).value();
    const bool holds = rc::check("the filter names every line that a span comes down to", [&] {
        const CutterType type = *rc::gen::element(CutterType::ball, CutterType::flat, CutterType::bullNose);
        const std::vector<RevolvedPiece> stack = flutePieces(toolOf(type).cutter);
        const auto place = [] {
            const auto at = [](int low, int high) { return *rc::gen::inRange(low, high) / 100.0; };
            return glm::dvec3(at(-500, 2100), at(-500, 2100), at(-200, 6000));
        };
        const glm::dvec3 from = place();
        glm::dvec3 to = place();
        if (*rc::gen::arbitrary<bool>()) to = from + 0.01 * (to - from);
        const CutFilter filter(stack, grid);
        const CutFilter::Way way = filter.way(from, to);
        const SweptPiece swept(stack.front(), from, to);
        for (std::int32_t v = 0; v < 64; v += 8)
            for (std::int32_t u = 0; u < 64; u += 8) {
                std::array<std::int32_t, 64> tops{};
                std::uint64_t cut = 0;
                for (int i = 0; i < 64; ++i) {
                    const glm::dvec2 centre = grid.lineCentre({u + i % 8, v + i / 8});
                    const std::optional<Span> span = swept.along(centre.x, centre.y);
                    if (!span) continue;
                    tops[static_cast<std::size_t>(i)] = static_cast<std::int32_t>(grid.toRunPosition(span->low)) + 1;
                    if (span->low < 64.0) cut |= std::uint64_t{1} << i;
                }
                RC_ASSERT((cut & ~filter.mayCut(way, {u, v}, tops.data(), 8)) == 0);
            }
    });
    QVERIFY(holds);
}

BURIN_TEST(ReplayTest, NoApplication)

} // namespace burin::tst_replay

#include "tst_replay.moc"

// SPDX-FileCopyrightText: 2026 The Burin authors
// SPDX-License-Identifier: Apache-2.0
#include "core/cutting/removal.h"
#include "core/cutting/solid_contact.h"
#include "core/verify/replay.h"
#include "tests/core/cutting/workpieces.h"
#include "tests/core/tool/fixed_tools.h"
#include "tests/test_program.h"

#include <QTest>
#include <rapidcheck.h>

#include <algorithm>
#include <cmath>

namespace burin::tst_solid_replay {

using namespace burin::tests;

namespace {

constexpr double voxel = 0.5; // mm

/// 20 × 20 × 12 mm with a part in one corner.
RunVolume milledBlock(RunAxis axis) {
    RunVolume volume = block(Grid::make(glm::dvec3(0.0), voxel, {40, 40, 24}, axis).value());
    for (int k = 0; k < 10; ++k)
        for (int j = 0; j < 12; ++j)
            for (int i = 0; i < 12; ++i) {
                (void)volume.remove({i, j, k});
                (void)volume.insert({i, j, k}, part);
            }
    return volume;
}

std::vector<ToolMove> anyMoves() {
    std::vector<ToolMove> moves;
    const auto place = [](double low, double length) { return low + length * *rc::gen::inRange(0, 1001) / 1000.0; };
    glm::dvec3 tip(10.0, 10.0, 30.0);
    for (int i = *rc::gen::inRange(2, 8); i > 0; --i) {
        ToolMove move;
        move.from.tip = tip;
        move.to.tip = {place(-6.0, 32.0), place(-6.0, 32.0), place(3.0, 12.0)};
        move.rapid = *rc::gen::inRange(0, 4) == 0;
        move.spindleOn = *rc::gen::inRange(0, 3) == 0;
        move.line = static_cast<std::uint32_t>(moves.size() + 1);
        tip = move.to.tip;
        moves.push_back(move);
    }
    return moves;
}

bool sameLines(const RunVolume& a, const RunVolume& b) {
    for (LineIndex line; line.v < a.grid().lineCountV(); ++line.v)
        for (line.u = 0; line.u < a.grid().lineCountU(); ++line.u)
            if (!std::ranges::equal(a.line(line), b.line(line))) return false;
    return true;
}

bool tells(const Findings& findings, FindingKind kind, std::uint32_t line) {
    return std::ranges::any_of(findings.inProgramOrder(),
                               [&](const Finding& found) { return found.kind == kind && found.line == line; });
}

} // namespace

/// A program with a tool that doesn't turn, checked by the same cut as it is milled with.
class SolidReplayTest : public QObject {
    Q_OBJECT
private slots:
    /// Bricks are cut in parallel, row by row; the reference cuts move by move over the whole grid. Lines are equal to
    /// the last run unit, volumes and findings follow from those of the reference.
    void aProgramCutsWhatTheHandCuts() {
        const bool held = rc::check([] {
            Tool tool;
            tool.cutter = cutters::scraper(*rc::gen::inRange(0, 12) * pi / 12.0);
            const auto axis = static_cast<RunAxis>(*rc::gen::inRange(0, 3));
            const std::vector<ToolMove> moves = anyMoves();
            RunVolume byHand = milledBlock(axis), byProgram = milledBlock(axis);
            MaterialRemoval removal(tool.cutter, byHand.grid(), Writing::deferred);
            Findings findings;
            Progress progress;
            std::vector<StepCut> loads;
            const std::vector<MoveCut> cuts =
                replay(moves, std::span(&tool, 1), byProgram, findings, progress, {}, &loads).value();
            for (std::size_t i = 0; i < moves.size(); ++i) {
                const ToolMove& move = moves[i];
                const double volume = removal.cut(byHand, ToolPose{move.from.tip}, ToolPose{move.to.tip}).volume;
                RC_ASSERT(std::abs(volume - cuts[i].volume) < 1e-9);
                const bool removes = volume > 1e-3;
                RC_ASSERT(tells(findings, FindingKind::spindleOn, move.line) == (removes && move.spindleOn));
                RC_ASSERT(tells(findings, FindingKind::rapidInStock, move.line) == (removes && move.rapid));
                RC_ASSERT(!tells(findings, FindingKind::spindleOff, move.line));
            }
            RC_ASSERT(sameLines(byHand, byProgram) && loads.empty());
        });
        QVERIFY(held);
    }

    /// The shank of a model of its own collides where the contact check of milling says so, and nowhere else.
    void itsShankCollides() {
        const bool held = rc::check([] {
            Tool tool;
            tool.cutter = cutters::scraper(*rc::gen::inRange(0, 12) * pi / 12.0, 5.0);
            const std::vector<ToolMove> moves = anyMoves();
            RunVolume byHand = milledBlock(RunAxis::z), byProgram = milledBlock(RunAxis::z);
            MaterialRemoval removal(tool.cutter, byHand.grid());
            SolidContact shank(columnsOf(tool.cutter, byHand.grid()), 1);
            Findings findings;
            Progress progress;
            (void)replay(moves, std::span(&tool, 1), byProgram, findings, progress).value();
            for (const ToolMove& move : moves) {
                const int steps =
                    std::max(1, static_cast<int>(std::ceil(glm::length(move.to.tip - move.from.tip) / voxel)));
                glm::dvec3 tip = move.from.tip;
                bool touches = false;
                for (int k = 1; k <= steps; ++k) {
                    const glm::dvec3 next =
                        k == steps ? move.to.tip : glm::mix(move.from.tip, move.to.tip, double(k) / steps);
                    (void)removal.cut(byHand, ToolPose{tip}, ToolPose{next});
                    touches = touches || shank.at(byHand, next).touches;
                    tip = next;
                }
                RC_ASSERT(tells(findings, FindingKind::shankCollision, move.line) == touches);
            }
        });
        QVERIFY(held);
    }
};

BURIN_TEST(SolidReplayTest, NoApplication)

} // namespace burin::tst_solid_replay

#include "tst_solid_replay.moc"

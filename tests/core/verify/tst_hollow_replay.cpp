// SPDX-FileCopyrightText: 2026 The Burin authors
// SPDX-License-Identifier: Apache-2.0
#include "core/cutting/removal.h"
#include "core/verify/replay.h"
#include "tests/core/cutting/workpieces.h"
#include "tests/core/tool/fixed_tools.h"
#include "tests/test_program.h"

#include <QTest>

#include <algorithm>
#include <cmath>
#include <span>

namespace burin::tst_hollow_replay {

using namespace burin::tests;

namespace {

/// 40 × 30 × 10 mm.
RunVolume stock(RunAxis axis) {
    return block(Grid::make(glm::dvec3(0.0), 0.25, {160, 120, 40}, axis).value());
}

/// Down into the stock, sideways, and up again.
std::vector<ToolMove> movesOf(std::initializer_list<glm::dvec3> tips) {
    std::vector<ToolMove> moves;
    const glm::dvec3* before = nullptr;
    for (const glm::dvec3& tip : tips) {
        if (before != nullptr) {
            ToolMove move;
            move.from.tip = *before;
            move.to.tip = tip;
            move.spindleOn = true;
            move.line = static_cast<std::uint32_t>(moves.size() + 1);
            moves.push_back(move);
        }
        before = &tip;
    }
    return moves;
}

} // namespace

/// A program with a core drill of 12 × 8 mm.
class HollowReplayTest : public QObject {
    Q_OBJECT
private slots:
    /// Equal to the last run unit, on any axis of the runs; it turns, so that nothing is found and its loads are known.
    void aProgramCutsWhatTheHandCuts() {
        Tool tool;
        tool.cutter = cutters::annular();
        const std::vector<ToolMove> moves =
            movesOf({{12.0, 15.03, 12.0}, {12.0, 15.03, 7.0}, {26.0, 15.4, 7.0}, {26.0, 15.4, 14.0}});
        for (const RunAxis axis : {RunAxis::x, RunAxis::y, RunAxis::z}) {
            RunVolume byHand = stock(axis), byProgram = stock(axis);
            MaterialRemoval removal(tool.cutter, byHand.grid(), Writing::deferred);
            Findings findings;
            Progress progress;
            std::vector<StepCut> loads;
            const std::vector<MoveCut> cuts =
                replay(moves, std::span(&tool, 1), byProgram, findings, progress, {}, &loads).value();
            for (std::size_t i = 0; i < moves.size(); ++i) {
                const double volume =
                    removal.cut(byHand, ToolPose{moves[i].from.tip}, ToolPose{moves[i].to.tip}).volume;
                QVERIFY(std::abs(volume - cuts[i].volume) < 1e-9);
                double loaded = 0.0;
                for (const StepCut& step : loads)
                    if (step.move == i) loaded += step.volume;
                QVERIFY2(std::abs(loaded - volume) < 1e-3 * volume + 1e-6, qPrintable(QString::number(loaded)));
            }
            for (LineIndex line; line.v < byHand.grid().lineCountV(); ++line.v)
                for (line.u = 0; line.u < byHand.grid().lineCountU(); ++line.u)
                    QVERIFY(std::ranges::equal(byHand.line(line), byProgram.line(line)));
            QVERIFY(findings.inProgramOrder().empty());
        }
    }

    /// The first half of the plunge removes half of the ring, pi (6² - 4²) mm² by 3 mm. Sideways, the front of the slot
    /// recedes over 12 mm all the way, and the rear of the inside over 8 mm until the core is cut away.
    void loadsComeWhenTheMaterialIsMet() {
        Tool tool;
        tool.cutter = cutters::annular();
        const std::vector<ToolMove> moves = movesOf({{12.0, 15.0, 10.0}, {12.0, 15.0, 7.0}, {26.0, 15.0, 7.0}});
        RunVolume block = stock(RunAxis::z);
        Findings findings;
        Progress progress;
        std::vector<StepCut> loads;
        (void)replay(moves, std::span(&tool, 1), block, findings, progress, {}, &loads).value();
        double core = 0.0, later = 0.0, plunged = 0.0;
        for (const StepCut& step : loads) {
            const double middle = (step.step + 0.5) / step.steps * (step.move == 0 ? 3.0 : 14.0); // mm
            if (step.move == 0 && middle < 1.5) plunged += step.volume;
            if (step.move == 1 && middle < 8.0) core += step.volume;
            if (step.move == 1 && middle >= 8.0) later += step.volume;
        }
        QVERIFY2(std::abs(plunged / (1.5 * pi * 20.0) - 1.0) < 0.1, qPrintable(QString::number(plunged)));
        const double expected = 3.0 * (8.0 * 12.0 + pi * 16.0); // mm³
        QVERIFY2(std::abs(core / expected - 1.0) < 0.03, qPrintable(QString::number(core)));
        QVERIFY2(std::abs(later / (3.0 * 6.0 * 12.0) - 1.0) < 0.03, qPrintable(QString::number(later)));
        for (const StepCut& step : loads) {
            const double length = 14.0 / step.steps; // mm
            if (step.move == 1) QVERIFY(step.volume < 3.0 * (12.0 + 8.0) * length * 1.5 + 0.5);
        }
    }
};

BURIN_TEST(HollowReplayTest, NoApplication)

} // namespace burin::tst_hollow_replay

#include "tst_hollow_replay.moc"

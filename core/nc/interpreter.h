// SPDX-FileCopyrightText: 2026 The Burin authors
// SPDX-License-Identifier: Apache-2.0
#pragma once

#include "core/nc/canned_cycles.h"
#include "core/nc/motion_writer.h"

namespace burin {

/// Executes blocks in the order of RS274/NGC (NIST IR 6556, table 8), whatever the order of their words.
class Interpreter {
public:
    Interpreter(const Control& control, const MachineState& start);
    Interpreter(const Interpreter&) = delete;
    Interpreter& operator=(const Interpreter&) = delete;

    /// @return false, with `fault` filled, on an error
    bool run(const Block& block, std::uint32_t line, BlockFault& fault);
    /// The program has ended: nothing after this is read.
    bool atEnd() const noexcept { return program.ended && !control_.readsOnBehindEnd; }
    const ModalState& state() const noexcept { return state_; }
    /// Value of one of the control's own parameters.
    std::optional<double> parameter(int number) const {
        return state_.frames.parameter(number, state_.length, state_.tool);
    }

    ParsedProgram program;

private:
    bool fail(ProgramProblem problem, std::uint32_t column);
    bool fail(ProgramProblem problem, const Word& word) { return fail(problem, word.column); }
    bool fail(ProgramProblem problem, const Code& code) { return fail(problem, code.column); }

    bool checkCodes(const Block& block);
    bool checkWords(const Block& block);
    bool checkUse(const Block& block);
    bool feedAndSpeed(const Block& block);
    bool toolChange(const Block& block);
    bool spindleAndCoolant(const Block& block);
    bool dwell(const Block& block);
    bool planeAndUnits(const Block& block);
    bool lengthOffset(const Block& block);
    bool workOffset(const Block& block);
    bool modes(const Block& block);
    bool once(const Block& block);
    bool setOffset(const Block& block);
    bool home(const Block& block, const Code& code);
    bool shift(const Block& block, const Code& code);
    bool motion(const Block& block);
    bool feedSuffices(const Block& block, std::uint32_t column);
    bool straight(const Block& block);
    bool machineFrame(const Block& block);
    bool stop(const Block& block);

    bool carryOut(const Block& block);
    /// Adds what may have caused a fault.
    void nameCauses(BlockFault& fault) const;
    /// Records what the block sets, for the search for causes.
    void note(NcSettingKind kind, int value);
    /// Value of an axis word, mm or degrees.
    double valueOf(const Word& word, Axis axis) const noexcept {
        return isRotary(axis) ? word.value : word.value * state_.length;
    }
    bool target(const Block& block, AxisValues& place, AxisSet& known);
    PartialPlace axisWords(const Block& block) const;
    int motionOf(const Block& block) const noexcept;

    const Control& control_;
    ModalState state_;
    MotionWriter writer_;
    CannedCycles cycles_;
    BlockFault* fault_ = nullptr;
    std::uint32_t line_ = 0;
    ByAxis<std::uint32_t> setOn_;        ///< the line that last moved the axis
    std::uint32_t incrementalSince_ = 0; ///< line of the G91 in force; 0: G90 is
};

} // namespace burin

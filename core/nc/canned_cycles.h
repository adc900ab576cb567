// SPDX-FileCopyrightText: 2026 The Burin authors
// SPDX-License-Identifier: Apache-2.0
#pragma once

#include "core/nc/motion_writer.h"

#include <optional>

namespace burin {

/// Converts G73 and G81 … G89 to moves (NIST IR 6556, 3.5.16, as LinuxCNC 2.9 reads it where the report leaves things
/// open): in any plane, absolute and incremental, with repeats. R, the depth, P, Q, I, J and K keep their values from
/// the previous block if a block omits them, as long as the same cycle stays in force. In incremental mode R is
/// relative to the height at which the first of a series of cycles began (also over changes of the plane, as in
/// LinuxCNC), and the depth is relative to R. Pecks (G73, G83) return to 0.254 mm (0.010 in) above the previous depth;
/// controls have a parameter for it.
class CannedCycles {
public:
    static bool isCycle(int motion) noexcept;

    /// @return false, with `fault` filled, on an error
    bool run(const Block& block, const Control& control, ModalState& state, MotionWriter& writer, BlockFault& fault);
    /// Called for any other motion: ends a series of cycles.
    void end() noexcept;

private:
    struct Hole;
    bool readWords(const Block& block, const Control& control, const ModalState& state, Hole& hole);
    bool readHeights(const Block& block, const ModalState& state, Hole& hole);
    bool checkWords(const Block& block, const ModalState& state, const Hole& hole);
    bool keep(const Block& block, char letter, std::optional<double>& kept, double factor, bool needed);
    bool fail(ProgramProblem problem, std::uint32_t column);
    void drill(const Hole& hole, ModalState& state, MotionWriter& writer) const;
    void peck(const Hole& hole, MotionWriter& writer) const;
    void tap(const Hole& hole, ModalState& state, MotionWriter& writer) const;
    void boreBack(const Hole& hole, ModalState& state, MotionWriter& writer) const;

    int last_ = gcode::noMotion; ///< the cycle that the kept words belong to
    std::optional<double> startHeight_;
    std::optional<double> height_, depth_, dwell_, step_; ///< mm, s; height and depth as the block states them
    std::array<std::optional<double>, 3> offset_{};       ///< mm, I J K
    BlockFault* fault_ = nullptr;
};

} // namespace burin

// SPDX-FileCopyrightText: 2026 The Burin authors
// SPDX-License-Identifier: Apache-2.0
#pragma once

#include "core/nc/arc_words.h"
#include "core/nc/modal_state.h"

namespace burin {

/// Appends motions to a program, each with the modes in force, and updates the position of the state.
class MotionWriter {
public:
    MotionWriter(ModalState& state, ParsedProgram& program) noexcept : state_(state), program_(program) {}

    /// Sets the line of the block that is executed now. @param feed its F where G93 is in force, otherwise the feed in
    /// force
    void beginBlock(std::uint32_t line) noexcept { line_ = line; }

    NcMotion& move(NcMotionKind kind, const AxisValues& target, AxisSet known, std::uint32_t column);
    /// @param target must end where the arc does
    void arc(const ArcWords& words, const AxisValues& target, AxisSet known, std::uint32_t column);
    void dwell(double seconds, std::uint32_t column);

private:
    void resolveFeed(NcMotion& motion) const noexcept;

    ModalState& state_;
    ParsedProgram& program_;
    std::uint32_t line_ = 0;
};

} // namespace burin

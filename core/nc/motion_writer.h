// SPDX-FileCopyrightText: 2026 The Burin authors
// SPDX-License-Identifier: Apache-2.0
#pragma once

#include "core/nc/arc_words.h"
#include "core/nc/modal_state.h"

namespace burin {

/// Appends motions to a program, each with what is in force, and keeps the state's place up with them.
class MotionWriter {
public:
    MotionWriter(ModalState& state, ParsedProgram& program) noexcept : state_(state), program_(program) {}

    /// Of the block that is carried out now. @param feed its F where G93 is in force, else what is in force
    void beginBlock(std::uint32_t line) noexcept { line_ = line; }

    NcMotion& move(NcMotionKind kind, const AxisValues& target, AxisSet known, std::uint32_t column);
    /// @param target ends where the arc does
    void arc(const ArcWords& words, const AxisValues& target, AxisSet known, std::uint32_t column);
    void dwell(double seconds, std::uint32_t column);

private:
    void resolveFeed(NcMotion& motion) const noexcept;

    ModalState& state_;
    ParsedProgram& program_;
    std::uint32_t line_ = 0;
};

} // namespace burin

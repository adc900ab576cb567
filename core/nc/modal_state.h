// SPDX-FileCopyrightText: 2026 The Burin authors
// SPDX-License-Identifier: Apache-2.0
#pragma once

#include "core/base/units.h"
#include "core/nc/block.h"
#include "core/nc/control.h"
#include "core/nc/frames.h"
#include "core/nc/parsed_program.h"

namespace burin {

/// The modes in force while a program runs. Plain data, except for its frames.
struct ModalState {
    ModalState(const Control& control, const MachineState& start)
        : frames(start, control.axes), retractToHeight(control.retractsToHeight) {}

    Frames frames;
    int motion = gcode::noMotion;
    int motionBesideCycles = gcode::noMotion; ///< from before the cycle in force
    int planeAxis = 2;                        ///< normal to the plane of arcs and cycles
    bool incremental = false;
    bool centresAbsolute = false;
    bool retractToHeight = false; ///< G99
    double length = 1.0;          ///< mm per unit
    bool unitsStated = false;
    PathMode pathMode = PathMode::machine;
    double blendTolerance = 0.0; ///< mm; 0: without limit
    double mergeTolerance = 0.0; ///< mm; 0: lines are not merged
    FeedMode feedMode = FeedMode::perMinute;
    double feed = 0.0;         ///< mm/min, 1/min, or mm per turn
    double spindleSpeed = 0.0; ///< 1/min
    SpindleState spindle = SpindleState::off;
    bool mist = false, flood = false;
    int selectedTool = 0, tool = 0;

    /// Resets the modes on M2 and M30, for a control that continues to read after them (GRBL 1.1, gcode.c).
    void setBack() {
        motion = motionBesideCycles = gcode::line;
        planeAxis = 2;
        incremental = false;
        feedMode = FeedMode::perMinute;
        spindle = SpindleState::off;
        mist = flood = false;
        frames.setWorkOffset(54);
    }
    bool inch() const noexcept { return length != 1.0; }
    bool spindleTurns() const noexcept { return spindle != SpindleState::off && spindleSpeed > 0.0; }
};

} // namespace burin

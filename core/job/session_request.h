// SPDX-FileCopyrightText: 2026 The Burin authors
// SPDX-License-Identifier: Apache-2.0
#pragma once

#include "core/base/staged_file.h"
#include "core/haptics/haptic_settings.h"
#include "core/haptics/loop/servo_loop.h"
#include "core/haptics/trace/session_trace.h"

#include <filesystem>
#include <limits>
#include <optional>
#include <string>

namespace burin {

/// The settings of a session, fixed from its begin to its end.
struct SessionRequest {
    double allowance = 0.0; ///< mm of stock that the boundary leaves on the part
    WorkspaceMapping mapping;
    Pace pace = Pace::realtime;
    int ticksPerEdge = 1;      ///< time lapse: number of ticks at each edge of the clock; virtual operators only
    bool cutsOnButton = false; ///< the spindle turns only while the stylus' first button is pressed
    FeltCutting felt;
    StockLayer stock;
    GainLimits gains;
    std::uint32_t forceButtons = 0; ///< dead man's switch: forces only while one of these is held, by bit; 0: always
    /// Keeps the workpiece before each stroke, so that the stroke can be undone. This occupies memory of the volume:
    /// when it runs out, the older half of the strokes can no longer be undone.
    bool undoable = true;
    double period = 0.0;         ///< of a tick, s; 0: the rate of a stylus that paces itself, otherwise 1 kHz
    std::filesystem::path trace; ///< of ticks, written during the session; empty: none
    /// Whether a trace that can't be written ends the session; otherwise it is discarded, which `takeFault` reports.
    bool traceRequired = true;
    /// Receives the complete trace in `end`, to be put in place together with the project. Null: `end` puts it in
    /// place.
    std::optional<StagedFile>* traceOutput = nullptr;
    /// A trace being played, whose changes between ticks are repeated; must outlive the session. Null: none.
    const SessionTrace* replayed = nullptr;
    /// In force from the first tick on; their curves must outlive the session. Empty: no guide is active until
    /// `setGuides`.
    std::optional<GuideSettings> guides;
    std::filesystem::path flights; ///< folder for records of faults (FlightRecorder); empty: next to the project
    std::string takeName;          ///< of a take that begins with the first tick; empty: no take
    double maximumSeconds = std::numeric_limits<double>::infinity(); ///< of the session's time
};

} // namespace burin

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

/// How a session is to run, from its begin to its end.
struct SessionRequest {
    double allowance = 0.0; ///< mm of stock that the boundary leaves on the part
    WorkspaceMapping mapping;
    Pace pace = Pace::realtime;
    int ticksPerEdge = 1;      ///< time lapse: so many ticks at each edge of the clock; virtual operators only
    bool cutsOnButton = false; ///< the spindle turns only while the stylus' first button is down
    FeltCutting felt;
    std::uint32_t forceButtons = 0; ///< dead man's: forces only while one of these is held, by bit; 0: always
    /// Keeps the workpiece as each stroke found it, so that it can be taken back. That holds back memory of the volume:
    /// when it runs out, the older half of the strokes stays for good.
    bool undoable = true;
    double period = 0.0; ///< s of a tick; 0: the stylus' own rate where it has one that it paces itself, or 1 kHz
    std::filesystem::path trace; ///< of ticks, written while the session lasts; empty: none
    /// Gets the complete trace with `end`, to be put in its place together with the project. Null: it is put there.
    std::optional<StagedFile>* traceOutput = nullptr;
    /// What a trace that is played was told between its ticks is told again; outlives the session. Null: nothing.
    const SessionTrace* replayed = nullptr;
    /// In force from the first tick on; their curves outlive the session. None: no guide holds until `setGuides`.
    std::optional<GuideSettings> guides;
    std::filesystem::path flights; ///< folder for records of faults (FlightRecorder); empty: beside the project
    std::string takeName;          ///< of a take that begins with the very first tick; empty: none does
    double maximumSeconds = std::numeric_limits<double>::infinity(); ///< of the session's time
};

} // namespace burin

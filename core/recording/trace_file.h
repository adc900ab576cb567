// SPDX-FileCopyrightText: 2026 The Burin authors
// SPDX-License-Identifier: Apache-2.0
#pragma once

#include "core/base/result.h"
#include "core/device/stylus.h"
#include "core/recording/sample.h"

#include <filesystem>
#include <span>
#include <string>
#include <string_view>
#include <vector>

namespace burin {

/// First line of a trace file. Then one reading a line: time in s (rising), position in mm and unit quaternion in the
/// device frame, buttons as a decimal number. UTF-8, lines end in LF or CR LF, decimal points, no spaces, no blank
/// line.
inline constexpr std::string_view traceHeader = "time_s,x_mm,y_mm,z_mm,qw,qx,qy,qz,buttons";
/// First two lines of a trace of ticks, which plays them again to the bit. Three columns more: the period in s that the
/// tick of this reading was told; whether the reading was valid (1) or not (0); the heat of the device's motors as a
/// share of what they bear, 0 where it is not known. Times need not rise: periods tell them. Between readings stand
/// lines of `changeMark` and a JSON object: what the session was told before the tick of the next reading (core/haptics
/// writes and reads them; its README.md has the keys).
inline constexpr std::string_view tickTraceMark = "# Burin trace 2";
inline constexpr std::string_view tickTraceHeader = "time_s,x_mm,y_mm,z_mm,qw,qx,qy,qz,buttons,period_s,valid,heat";
inline constexpr char changeMark = '!';
/// First line of a trace of ticks in its first version, which is read as ever: without heat and changes.
inline constexpr std::string_view firstTickTraceHeader = "time_s,x_mm,y_mm,z_mm,qw,qx,qy,qz,buttons,period_s,valid";

/// A line between two readings.
struct TraceChange {
    std::size_t reading = 0; ///< how many readings come before it
    std::size_t line = 0;    ///< of the file, from 1
    std::string text;        ///< behind the mark
};

struct Trace {
    std::vector<StylusState> readings;
    std::vector<TraceChange> changes; ///< in their order
};

/// Text of a trace. Numbers in their shortest form: reading gives the same bits. A trace of ticks if the readings have
/// periods; otherwise readings that are not valid are left out, as that format has no column for them.
std::string formatTrace(std::span<const StylusState> states);
/// One line of a trace of ticks. A reading that is not finite becomes one that is not valid: no tick tells them apart.
void appendTick(std::string& text, const StylusState& state);

/// @param origin names the text in errors (a file).
/// Errors: fileEmpty, traceInvalid (place: "line 12"; detail: what is wrong there). Every returned reading is valid,
/// but for those that a trace of ticks says were not.
Result<Trace> parseTrace(std::string_view text, const std::string& origin);

/// Errors: those of readFile and parseTrace.
Result<Trace> readTrace(const std::filesystem::path& file);

/// Errors: fileNotWritable, diskFull.
Result<void> writeTrace(const std::filesystem::path& file, std::span<const StylusState> states);

/// What the stylus did in a recording, to be played again. Ticks without a valid reading are marked so.
std::vector<StylusState> traceOf(std::span<const Sample> samples);

} // namespace burin

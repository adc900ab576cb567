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
/// First line of a trace of ticks, which plays them again to the bit. Two columns more: the period in s that the tick
/// of this reading was told, and whether the reading was valid (1) or not (0). Times need not rise: periods tell them.
inline constexpr std::string_view tickTraceHeader = "time_s,x_mm,y_mm,z_mm,qw,qx,qy,qz,buttons,period_s,valid";

/// Text of a trace. Numbers in their shortest form: reading gives the same bits. A trace of ticks if the readings have
/// periods; otherwise readings that are not valid are left out, as that format has no column for them.
std::string formatTrace(std::span<const StylusState> states);
/// One line of a trace of ticks. A reading that is not finite becomes one that is not valid: no tick tells them apart.
void appendTick(std::string& text, const StylusState& state);

/// @param origin names the text in errors (a file).
/// Errors: fileEmpty, traceInvalid (place: "line 12"; detail: what is wrong there). Every returned reading is valid,
/// but for those that a trace of ticks says were not.
Result<std::vector<StylusState>> parseTrace(std::string_view text, const std::string& origin);

/// Errors: those of readFile and parseTrace.
Result<std::vector<StylusState>> readTrace(const std::filesystem::path& file);

/// Errors: fileNotWritable, diskFull.
Result<void> writeTrace(const std::filesystem::path& file, std::span<const StylusState> states);

/// What the stylus did in a recording, to be played again. Ticks without a valid reading are marked so.
std::vector<StylusState> traceOf(std::span<const Sample> samples);

} // namespace burin

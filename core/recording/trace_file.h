// SPDX-FileCopyrightText: 2026 The Burin authors
// SPDX-License-Identifier: Apache-2.0
#pragma once

#include "core/base/result.h"
#include "core/device/stylus.h"
#include "core/recording/sample.h"

#include <cstdint>
#include <filesystem>
#include <optional>
#include <span>
#include <string>
#include <string_view>
#include <utility>
#include <vector>

namespace burin {

/// First line of a trace file. The other lines hold one reading each: time in s (rising), position in mm and unit
/// quaternion in the device frame, buttons as a decimal number. UTF-8, lines end in LF or CR LF, decimal points, no
/// spaces, no blank line.
inline constexpr std::string_view traceHeader = "time_s,x_mm,y_mm,z_mm,qw,qx,qy,qz,buttons";
/// First two lines of a trace of ticks, whose playback is bit-exact. It has three more columns: the period in s that
/// the tick of this reading was given; whether the reading was valid (1) or not (0); the heat of the device's motors as
/// a share of its limit, 0 if unknown. Times need not rise, because the periods are given. Between readings there may
/// be lines of `changeMark` and a JSON object: input that the session received before the tick of the next reading
/// (written and read by core/haptics; its README.md has the keys).
inline constexpr std::string_view tickTraceMark = "# Burin trace 2";
inline constexpr std::string_view tickTraceHeader = "time_s,x_mm,y_mm,z_mm,qw,qx,qy,qz,buttons,period_s,valid,heat";
inline constexpr char changeMark = '!';
/// First line of a trace of ticks in its first version, which can still be read: without heat and changes.
inline constexpr std::string_view firstTickTraceHeader = "time_s,x_mm,y_mm,z_mm,qw,qx,qy,qz,buttons,period_s,valid";

/// A line between two readings.
struct TraceChange {
    std::size_t reading = 0; ///< number of readings before it
    std::size_t line = 0;    ///< of the file, from 1
    std::string text;        ///< text after the mark
};

struct Trace {
    std::vector<StylusState> readings;
    std::vector<TraceChange> changes; ///< in their order
};

/// Parses a trace line by line.
class TraceParser {
public:
    /// @param origin  name of the text in errors (a file)
    explicit TraceParser(std::string origin) : origin_(std::move(origin)) {}

    /// A line: a reading or a change, or neither (a heading).
    struct Line {
        std::optional<StylusState> reading;
        std::optional<TraceChange> change;
    };
    /// @param line  without its line end. Errors: traceInvalid (place: "line 12"; detail: what is wrong there).
    Result<Line> take(std::string_view line);
    /// Ends the trace. Errors: traceInvalid if a heading or the readings are missing.
    Result<void> end();

private:
    enum class Next : std::uint8_t { firstHeading, secondHeading, readings };
    Result<void> takeHeading(std::string_view line);
    Error invalid(std::string detail) const;

    std::string origin_;
    Next next_ = Next::firstHeading;
    std::size_t fields_ = 0; ///< number of fields of a reading, which determines the kind of trace
    std::size_t line_ = 0, readings_ = 0;
    double lastTime_ = 0.0; ///< s
};

/// Text of a trace. Numbers in their shortest form that reads back bit-exactly. A trace of ticks if the readings have
/// periods; otherwise invalid readings are left out, because that format has no column for them.
std::string formatTrace(std::span<const StylusState> states);
/// Appends the first line of a trace of readings only, with its line end.
void appendTraceHeading(std::string& text);
/// Appends one line of it; nothing for an invalid reading, because this format has no column for that.
void appendReading(std::string& text, const StylusState& state);
/// Appends one line of a trace of ticks. A reading that is not finite is written as invalid: ticks treat both alike.
void appendTick(std::string& text, const StylusState& state);

/// @param origin  name of the text in errors (a file).
/// Errors: fileEmpty, traceInvalid (place: "line 12"; detail: what is wrong there). Every returned reading is valid,
/// except for those that a trace of ticks marks as invalid.
Result<Trace> parseTrace(std::string_view text, const std::string& origin);

/// Errors: those of readFile and parseTrace.
Result<Trace> readTrace(const std::filesystem::path& file);

/// Errors: fileNotWritable, diskFull.
Result<void> writeTrace(const std::filesystem::path& file, std::span<const StylusState> states);

/// The stylus data of a tick, for playback. Without a valid reading it is marked as invalid.
StylusState readingOf(const Sample& sample);
/// The stylus data of a recording.
std::vector<StylusState> traceOf(std::span<const Sample> samples);

} // namespace burin

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

/// Understands a trace line by line.
class TraceParser {
public:
    /// @param origin names the text in errors (a file)
    explicit TraceParser(std::string origin) : origin_(std::move(origin)) {}

    /// A line: one of both, or neither (a heading).
    struct Line {
        std::optional<StylusState> reading;
        std::optional<TraceChange> change;
    };
    /// @param line without its end. Errors: traceInvalid (place: "line 12"; detail: what is wrong there).
    Result<Line> take(std::string_view line);
    /// There are no more lines. Errors: traceInvalid where a heading or the readings are missing.
    Result<void> end();

private:
    enum class Next : std::uint8_t { firstHeading, secondHeading, readings };
    Result<void> takeHeading(std::string_view line);
    Error invalid(std::string detail) const;

    std::string origin_;
    Next next_ = Next::firstHeading;
    std::size_t fields_ = 0; ///< of a reading, which tells the kind of trace
    std::size_t line_ = 0, readings_ = 0;
    double lastTime_ = 0.0; ///< s
};

/// Text of a trace. Numbers in their shortest form: reading gives the same bits. A trace of ticks if the readings have
/// periods; otherwise readings that are not valid are left out, as that format has no column for them.
std::string formatTrace(std::span<const StylusState> states);
/// The first line of a trace of readings alone, with its end.
void appendTraceHeading(std::string& text);
/// One line of it; none for a reading that is not valid, as this form has no column for that.
void appendReading(std::string& text, const StylusState& state);
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

/// What the stylus did in a tick, to be played again. One without a valid reading is marked so.
StylusState readingOf(const Sample& sample);
/// What the stylus did in a recording.
std::vector<StylusState> traceOf(std::span<const Sample> samples);

} // namespace burin

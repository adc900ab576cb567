// SPDX-FileCopyrightText: 2026 The Burin authors
// SPDX-License-Identifier: Apache-2.0
#include "core/recording/trace_file.h"

#include "core/base/csv.h"
#include "core/base/file.h"
#include "core/base/numbers.h"

#include <algorithm>
#include <array>
#include <charconv>
#include <cmath>
#include <optional>

namespace burin {

namespace {

constexpr std::size_t fieldCount = 9, firstTickFieldCount = 11, tickFieldCount = 12;
// A quaternion that was rounded to four digits still passes; one that was never normalised does not.
constexpr double unitTolerance = 1e-3;

using Fields = std::array<std::string_view, tickFieldCount>;

Error invalid(const std::string& origin, std::size_t line, std::string detail) {
    return {ErrorCode::traceInvalid, origin, "line " + std::to_string(line), std::move(detail)};
}

std::optional<Fields> split(std::string_view line, std::size_t count) {
    Fields fields;
    for (std::size_t i = 0; i < count; ++i) {
        const std::size_t comma = line.find(',');
        if ((comma == std::string_view::npos) != (i + 1 == count)) return std::nullopt;
        fields[i] = line.substr(0, comma);
        line.remove_prefix(i + 1 == count ? line.size() : comma + 1);
    }
    return fields;
}

std::optional<std::uint32_t> parseButtons(std::string_view text) {
    std::uint32_t value = 0;
    const auto [end, error] = std::from_chars(text.data(), text.data() + text.size(), value);
    if (text.empty() || error != std::errc{} || end != text.data() + text.size()) return std::nullopt;
    return value;
}

/// Parses the columns that both kinds of trace have. The quaternion's length is not checked.
Result<StylusState> parsePose(const Fields& fields, const std::string& origin, std::size_t number) {
    std::array<double, fieldCount - 1> values{};
    for (std::size_t i = 0; i < values.size(); ++i) {
        const std::optional<double> value = parseNumber(fields[i]);
        if (!value) return invalid(origin, number, "value " + std::to_string(i + 1) + " is not a number");
        values[i] = *value;
    }
    const std::optional<std::uint32_t> buttons = parseButtons(fields[fieldCount - 1]);
    if (!buttons) return invalid(origin, number, "buttons is not a whole number from 0 to 4294967295");

    StylusState state;
    state.time = values[0];
    state.pose.position = {values[1], values[2], values[3]};
    state.pose.rotation = glm::dquat(values[4], values[5], values[6], values[7]);
    state.buttons = *buttons;
    state.valid = true;
    return state;
}

/// @param count  of fields, which determines the kind of trace
Result<StylusState> parseReading(std::string_view line, std::size_t count, const std::string& origin,
                                 std::size_t number) {
    const std::optional<Fields> fields = split(line, count);
    if (!fields) return invalid(origin, number, "not " + std::to_string(count) + " values between commas");
    Result<StylusState> state = parsePose(*fields, origin, number);
    if (!state) return state;
    if (count >= firstTickFieldCount) {
        const std::optional<double> period = parseNumber((*fields)[fieldCount]);
        if (!period) return invalid(origin, number, "value 10 is not a number");
        const std::string_view valid = (*fields)[fieldCount + 1];
        if (valid != "0" && valid != "1") return invalid(origin, number, "value 11 is neither 0 nor 1");
        state->period = *period;
        state->valid = valid == "1";
    }
    if (count == tickFieldCount) {
        const std::optional<double> heat = parseNumber((*fields)[fieldCount + 2]);
        if (!heat || *heat < 0.0) return invalid(origin, number, "value 12 is not a number of at least 0");
        state->motorHeat = *heat;
    }
    if (state->valid && !(std::abs(glm::length(state->pose.rotation) - 1.0) <= unitTolerance))
        return invalid(origin, number, "the quaternion's length is not 1");
    return state;
}

void appendPose(std::string& text, const StylusState& state) {
    const glm::dvec3& p = state.pose.position;
    const glm::dquat& q = state.pose.rotation;
    for (const double value : {state.time, p.x, p.y, p.z, q.w, q.x, q.y, q.z}) {
        text += formatShortest(value);
        text += ',';
    }
    text += std::to_string(state.buttons);
}

bool hasPeriod(const StylusState& state) {
    return state.period != 0.0;
}

bool isFinite(const Pose& pose) {
    const glm::dquat& q = pose.rotation;
    return burin::isFinite(pose.position) && burin::isFinite(glm::dvec3(q.x, q.y, q.z)) && std::isfinite(q.w);
}

} // namespace

void appendTick(std::string& text, const StylusState& state) {
    StylusState told = state;
    if (!isFinite(told.pose)) {
        told.pose = {};
        told.valid = false;
    }
    if (!std::isfinite(told.time)) told.time = 0.0;
    // For a tick, every value that is not above 0 is the same fault.
    if (!std::isfinite(told.period) || told.period <= 0.0) told.period = -1.0;
    appendPose(text, told);
    text += ',';
    text += formatShortest(told.period);
    text += told.valid ? ",1," : ",0,";
    // A value that is not finite means unknown, as it does to a tick.
    text += formatShortest(told.motorHeat > 0.0 && std::isfinite(told.motorHeat) ? told.motorHeat : 0.0);
    text += '\n';
}

void appendTraceHeading(std::string& text) {
    text.append(traceHeader).append("\n");
}

void appendReading(std::string& text, const StylusState& state) {
    if (!state.valid) return;
    appendPose(text, state);
    text += '\n';
}

std::string formatTrace(std::span<const StylusState> states) {
    const bool ticks = std::ranges::any_of(states, hasPeriod);
    std::string text;
    if (ticks)
        text.append(tickTraceMark).append("\n").append(tickTraceHeader).append("\n");
    else
        appendTraceHeading(text);
    for (const StylusState& state : states) ticks ? appendTick(text, state) : appendReading(text, state);
    return text;
}

Error TraceParser::invalid(std::string detail) const {
    return burin::invalid(origin_, line_, std::move(detail));
}

Result<void> TraceParser::takeHeading(std::string_view line) {
    if (next_ == Next::firstHeading && line == tickTraceMark) {
        next_ = Next::secondHeading;
        return {};
    }
    const bool marked = next_ == Next::secondHeading;
    fields_ = marked ? tickFieldCount : line == firstTickTraceHeader ? firstTickFieldCount : fieldCount;
    if (line != (marked ? tickTraceHeader : fields_ == fieldCount ? traceHeader : firstTickTraceHeader))
        return invalid("the " + std::string(marked ? "second" : "first") + " line must be " +
                       std::string(marked ? tickTraceHeader : traceHeader));
    next_ = Next::readings;
    return {};
}

Result<TraceParser::Line> TraceParser::take(std::string_view line) {
    ++line_;
    if (next_ != Next::readings) {
        if (Result<void> heading = takeHeading(line); !heading) return std::move(heading).error();
        return Line{};
    }
    if (fields_ == tickFieldCount && line.starts_with(changeMark))
        return Line{{}, TraceChange{readings_, line_, std::string(line.substr(1))}};
    const Result<StylusState> state = parseReading(line, fields_, origin_, line_);
    if (!state) return state.error();
    if (fields_ == fieldCount && readings_ > 0 && !(state->time > lastTime_))
        return invalid("the time is not later than in the line before");
    lastTime_ = state->time;
    ++readings_;
    return Line{*state, {}};
}

Result<void> TraceParser::end() {
    ++line_;
    if (next_ != Next::readings) return takeHeading({});
    if (readings_ == 0) return invalid("no reading follows");
    return {};
}

Result<Trace> parseTrace(std::string_view text, const std::string& origin) {
    if (text.empty()) return Error{ErrorCode::fileEmpty, origin, "", ""};
    TraceParser parser(origin);
    Trace trace;
    while (!text.empty()) {
        Result<TraceParser::Line> line = parser.take(takeLine(text));
        if (!line) return std::move(line).error();
        if (line->reading) trace.readings.push_back(*line->reading);
        if (line->change) trace.changes.push_back(std::move(*line->change));
    }
    if (Result<void> ended = parser.end(); !ended) return std::move(ended).error();
    return trace;
}

Result<Trace> readTrace(const std::filesystem::path& file) {
    const Result<std::string> text = readFile(file);
    if (!text) return text.error();
    return parseTrace(*text, file.string());
}

Result<void> writeTrace(const std::filesystem::path& file, std::span<const StylusState> states) {
    return writeFileAtomically(file, formatTrace(states));
}

StylusState readingOf(const Sample& sample) {
    return {sample.time, sample.device, sample.buttons, (sample.flags & sampleStylusInvalid) == 0};
}

std::vector<StylusState> traceOf(std::span<const Sample> samples) {
    std::vector<StylusState> states;
    states.reserve(samples.size());
    for (const Sample& sample : samples) states.push_back(readingOf(sample));
    return states;
}

} // namespace burin

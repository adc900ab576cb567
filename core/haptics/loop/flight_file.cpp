// SPDX-FileCopyrightText: 2026 The Burin authors
// SPDX-License-Identifier: Apache-2.0
#include "core/base/numbers.h"
#include "core/haptics/loop/flight_recorder.h"
#include "core/recording/take_csv.h"

namespace burin {
namespace {

constexpr std::string_view loopColumns =
    "over_ns,period_s,interval_us,work_before_us,cpu_before_us,missed,late,scheduling,fault,"
    "reading_x_mm,reading_y_mm,reading_z_mm,reading_qw,reading_qx,reading_qy,reading_qz,reading_buttons,reading_valid,";

void append(std::string& text, double value) {
    text += formatShortest(value);
    text += ',';
}

void append(std::string& text, std::uint64_t value) {
    text += std::to_string(value);
    text += ',';
}

void append(std::string& text, std::string_view value) {
    text += value;
    text += ',';
}

/// As one line of a comment, whatever characters the device's name contains.
std::string oneLine(std::string text) {
    for (char& letter : text)
        if (static_cast<unsigned char>(letter) < 0x20) letter = ' ';
    return text;
}

void appendRow(std::string& text, const FlightRecorder::Entry& entry, std::span<const std::uint8_t> properties) {
    const TickTiming& timing = entry.timing;
    append(text, static_cast<std::uint64_t>(timing.over));
    append(text, timing.period);
    for (const std::int64_t nanoseconds : {timing.interval, timing.work, timing.cpu})
        append(text, static_cast<double>(nanoseconds) * 1e-3);
    append(text, timing.missed);
    append(text, timing.late);
    append(text, nameOf(timing.scheduling));
    append(text, nameOf(timing.fault));
    const StylusState& reading = timing.reading;
    for (int axis = 0; axis < 3; ++axis) append(text, reading.pose.position[axis]);
    const glm::dquat& q = reading.pose.rotation;
    for (const double value : {q.w, q.x, q.y, q.z}) append(text, value);
    append(text, std::uint64_t{reading.buttons});
    append(text, std::uint64_t{reading.valid ? 1U : 0U});
    appendTakeCsvRow(text, entry.sample, properties);
}

} // namespace

std::string formatFlight(const FlightSettings& settings, TickFault fault, double unixTime,
                         const std::vector<FlightRecorder::Entry>& entries) {
    std::vector<Sample> samples;
    samples.reserve(entries.size());
    for (const FlightRecorder::Entry& entry : entries) samples.push_back(entry.sample);
    const std::vector<std::uint8_t> properties = removedProperties(samples);
    std::string text = "# Burin flight record 2\n";
    text += "# fault: " + std::string(nameOf(fault)) + "\n# unix_time_s: " + formatFixed(unixTime, 3) +
            "\n# period_s: " + formatShortest(settings.period) + "\n# device: " + oneLine(settings.device) + "\n";
    text += std::string(loopColumns) + takeCsvHeader(properties, settings.materials) + "\n";
    for (const FlightRecorder::Entry& entry : entries) appendRow(text, entry, properties);
    return text;
}

} // namespace burin

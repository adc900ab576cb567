// SPDX-FileCopyrightText: 2026 The Burin authors
// SPDX-License-Identifier: Apache-2.0
#include "core/recording/take_csv.h"

#include "core/base/numbers.h"
#include "core/base/staged_file.h"
#include "core/recording/trace_file.h"

#include <functional>
#include <string_view>
#include <utility>

namespace burin {

namespace {

constexpr std::string_view fixedColumns =
    "tick,time_s,device_x_mm,device_y_mm,device_z_mm,device_qw,device_qx,device_qy,device_qz,"
    "stylus_x_mm,stylus_y_mm,stylus_z_mm,tool_x_mm,tool_y_mm,tool_z_mm,axis_x,axis_y,axis_z,"
    "force_x_n,force_y_n,force_z_n,torque_x_n_mm,torque_y_n_mm,torque_z_n_mm,cutting_force_x_n,cutting_force_y_n,"
    "cutting_force_z_n,"
    "reported_removal_mm3,buttons,flags";

void append(std::string& text, double value) {
    text += ',';
    text += formatShortest(value);
}

void append(std::string& text, const glm::dvec3& vector) {
    for (int axis = 0; axis < 3; ++axis) append(text, vector[axis]);
}

/// RFC 4180: a user-defined material may have any name.
std::string quotedForCsv(const std::string& field) {
    if (field.find_first_of(",\"\r\n") == std::string::npos) return field;
    std::string quoted = "\"";
    for (const char letter : field) quoted += letter == '"' ? std::string("\"\"") : std::string(1, letter);
    return quoted + '"';
}

std::uint64_t removedUnits(const Sample& sample, std::uint8_t property) {
    std::uint64_t units = 0;
    for (const RemovedMaterial& entry : sample.removed)
        if (entry.property == property) units += entry.units;
    return units;
}

} // namespace

void RemovedProperties::add(std::span<const Sample> samples) noexcept {
    for (const Sample& sample : samples)
        for (const RemovedMaterial& entry : sample.removed)
            if (entry.units > 0) seen_[entry.property] = true;
}

std::vector<std::uint8_t> RemovedProperties::properties() const {
    std::vector<std::uint8_t> properties;
    for (std::size_t i = 1; i < seen_.size(); ++i)
        if (seen_[i]) properties.push_back(static_cast<std::uint8_t>(i));
    return properties;
}

std::vector<std::uint8_t> removedProperties(std::span<const Sample> samples) {
    RemovedProperties removed;
    removed.add(samples);
    return removed.properties();
}

std::string takeCsvHeader(std::span<const std::uint8_t> properties, const MaterialIds& materials) {
    std::string text(fixedColumns);
    for (const std::uint8_t property : properties)
        text += "," +
                quotedForCsv("removed_units_" + (property < materials.size() ? materials[property]
                                                                             : "property_" + std::to_string(property)));
    return text;
}

void appendTakeCsvRow(std::string& text, const Sample& sample, std::span<const std::uint8_t> properties) {
    text += std::to_string(sample.tick);
    append(text, sample.time);
    append(text, sample.device.position);
    const glm::dquat& rotation = sample.device.rotation;
    for (const double value : {rotation.w, rotation.x, rotation.y, rotation.z}) append(text, value);
    append(text, sample.stylusTip);
    append(text, sample.proxy.tip);
    append(text, sample.proxy.axis);
    append(text, sample.force);
    append(text, sample.torque);
    append(text, sample.cuttingForce);
    append(text, sample.reportedRemoval);
    text += ',' + std::to_string(sample.buttons) + ',' + std::to_string(sample.flags);
    for (const std::uint8_t property : properties) text += ',' + std::to_string(removedUnits(sample, property));
    text += '\n';
}

namespace {

using AppendSample = std::function<void(std::string& text, const Sample& sample)>;

/// Writes a heading, and what `append` makes of each sample.
Result<void> writeSamples(const std::filesystem::path& file, std::string text, const SampleSource& take,
                          const AppendSample& append) {
    Result<StagedFile> staged = StagedFile::begin(file);
    if (!staged) return std::move(staged).error();
    Result<void> written = staged->append(text);
    if (written)
        written = take([&](std::span<const Sample> samples) {
            text.clear();
            for (const Sample& sample : samples) append(text, sample);
            return staged->append(text);
        });
    if (written) written = staged->flush();
    return written ? staged->putInPlace() : written;
}

} // namespace

Result<void> writeTakeCsv(const std::filesystem::path& file, const SampleSource& take, const MaterialIds& materials) {
    RemovedProperties removed; // known once all samples have been visited
    Result<void> seen = take([&removed](std::span<const Sample> samples) -> Result<void> {
        removed.add(samples);
        return {};
    });
    if (!seen) return seen;
    const std::vector<std::uint8_t> properties = removed.properties();
    return writeSamples(
        file, takeCsvHeader(properties, materials) + '\n', take,
        [&properties](std::string& text, const Sample& sample) { appendTakeCsvRow(text, sample, properties); });
}

Result<void> writeTakeTrace(const std::filesystem::path& file, const SampleSource& take) {
    std::string heading;
    appendTraceHeading(heading);
    return writeSamples(file, std::move(heading), take,
                        [](std::string& text, const Sample& sample) { appendReading(text, readingOf(sample)); });
}

} // namespace burin

// SPDX-FileCopyrightText: 2026 The Burin authors
// SPDX-License-Identifier: Apache-2.0
#include "core/recording/take_csv.h"

#include "core/base/numbers.h"
#include "core/base/staged_file.h"

#include <array>
#include <string_view>

namespace burin {

namespace {

constexpr std::string_view fixedColumns =
    "tick,time_s,device_x_mm,device_y_mm,device_z_mm,device_qw,device_qx,device_qy,device_qz,"
    "stylus_x_mm,stylus_y_mm,stylus_z_mm,tool_x_mm,tool_y_mm,tool_z_mm,axis_x,axis_y,axis_z,"
    "force_x_n,force_y_n,force_z_n,cutting_force_x_n,cutting_force_y_n,cutting_force_z_n,"
    "reported_removal_mm3,buttons,flags";
constexpr std::size_t pieceSize = 1u << 20; // bytes

void append(std::string& text, double value) {
    text += ',';
    text += formatShortest(value);
}

void append(std::string& text, const glm::dvec3& vector) {
    for (int axis = 0; axis < 3; ++axis) append(text, vector[axis]);
}

std::uint64_t removedUnits(const Sample& sample, std::uint8_t property) {
    std::uint64_t units = 0;
    for (const RemovedMaterial& entry : sample.removed)
        if (entry.property == property) units += entry.units;
    return units;
}

} // namespace

std::vector<std::uint8_t> removedProperties(std::span<const Sample> samples) {
    std::array<bool, 256> seen{};
    for (const Sample& sample : samples)
        for (const RemovedMaterial& entry : sample.removed)
            if (entry.units > 0) seen[entry.property] = true;
    std::vector<std::uint8_t> properties;
    for (std::size_t i = 1; i < seen.size(); ++i)
        if (seen[i]) properties.push_back(static_cast<std::uint8_t>(i));
    return properties;
}

std::string takeCsvHeader(std::span<const std::uint8_t> properties) {
    std::string text(fixedColumns);
    for (const std::uint8_t property : properties) text += ",removed_units_property_" + std::to_string(property);
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
    append(text, sample.cuttingForce);
    append(text, sample.reportedRemoval);
    text += ',' + std::to_string(sample.buttons) + ',' + std::to_string(sample.flags);
    for (const std::uint8_t property : properties) text += ',' + std::to_string(removedUnits(sample, property));
    text += '\n';
}

namespace {

Result<StagedFile> stageTakeCsv(const std::filesystem::path& file, std::span<const Sample> samples) {
    Result<StagedFile> staged = StagedFile::begin(file);
    if (!staged) return staged;
    const std::vector<std::uint8_t> properties = removedProperties(samples);
    std::string text = takeCsvHeader(properties) + '\n';
    const auto send = [&]() -> Result<void> {
        Result<void> sent = staged->append(text);
        text.clear();
        return sent;
    };
    for (const Sample& sample : samples) {
        appendTakeCsvRow(text, sample, properties);
        if (text.size() < pieceSize) continue;
        if (Result<void> sent = send(); !sent) return std::move(sent).error();
    }
    if (Result<void> sent = send(); !sent) return std::move(sent).error();
    if (Result<void> flushed = staged->flush(); !flushed) return std::move(flushed).error();
    return staged;
}

} // namespace

Result<void> writeTakeCsv(const std::filesystem::path& file, std::span<const Sample> samples) {
    Result<StagedFile> staged = stageTakeCsv(file, samples);
    return staged ? staged->putInPlace() : std::move(staged).error();
}

} // namespace burin

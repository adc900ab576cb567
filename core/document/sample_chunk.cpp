// SPDX-FileCopyrightText: 2026 The Burin authors
// SPDX-License-Identifier: Apache-2.0
#include "core/document/sample_chunk.h"

#include "core/document/column_codec.h"

#include <algorithm>
#include <array>

namespace burin {

namespace {

constexpr char forceForm = 1, torqueForm = 2; // without and with the torque of the device

// Columns of both forms, in this order; the last three exist only in form 2. The proxy's tip comes three columns after
// the stylus's, so that free motion, in which both are equal, is not stored twice.
constexpr std::size_t tickColumn = 0, timeColumn = 1, deviceColumn = 2, stylusTipColumn = 9, proxyColumn = 12,
                      forceColumn = 18, cuttingForceColumn = 21, reportedColumn = 24, removedColumn = 25,
                      propertiesColumn = 33, buttonsColumn = 34, flagsColumn = 35, forceColumns = 36, torqueColumn = 36,
                      torqueColumns = 39;
constexpr std::size_t lookBack = proxyColumn - stylusTipColumn;
static_assert(std::tuple_size_v<decltype(Sample::removed)> == propertiesColumn - removedColumn);

using Row = std::array<std::uint64_t, torqueColumns>;

void put(Row& row, std::size_t column, const glm::dvec3& vector) {
    for (int axis = 0; axis < 3; ++axis) row[column + static_cast<std::size_t>(axis)] = wordOf(vector[axis]);
}

glm::dvec3 vectorAt(const Row& row, std::size_t column) {
    return {doubleOf(row[column]), doubleOf(row[column + 1]), doubleOf(row[column + 2])};
}

Row rowOf(const Sample& sample) {
    Row row{};
    row[tickColumn] = sample.tick;
    row[timeColumn] = wordOf(sample.time);
    put(row, deviceColumn, sample.device.position);
    const glm::dquat& turn = sample.device.rotation;
    row[deviceColumn + 3] = wordOf(turn.w);
    put(row, deviceColumn + 4, {turn.x, turn.y, turn.z});
    put(row, stylusTipColumn, sample.stylusTip);
    put(row, proxyColumn, sample.proxy.tip);
    put(row, proxyColumn + 3, sample.proxy.axis);
    put(row, forceColumn, sample.force);
    put(row, cuttingForceColumn, sample.cuttingForce);
    row[reportedColumn] = wordOf(sample.reportedRemoval);
    for (std::size_t i = 0; i < sample.removed.size(); ++i) {
        row[removedColumn + i] = sample.removed[i].units;
        row[propertiesColumn] |= std::uint64_t{sample.removed[i].property} << (8 * i);
    }
    row[buttonsColumn] = sample.buttons;
    row[flagsColumn] = sample.flags;
    put(row, torqueColumn, sample.torque);
    return row;
}

Sample sampleOf(const Row& row) {
    Sample sample;
    sample.tick = row[tickColumn];
    sample.time = doubleOf(row[timeColumn]);
    sample.device.position = vectorAt(row, deviceColumn);
    const glm::dvec3 imaginary = vectorAt(row, deviceColumn + 4);
    sample.device.rotation = glm::dquat(doubleOf(row[deviceColumn + 3]), imaginary.x, imaginary.y, imaginary.z);
    sample.stylusTip = vectorAt(row, stylusTipColumn);
    sample.proxy = {vectorAt(row, proxyColumn), vectorAt(row, proxyColumn + 3)};
    sample.force = vectorAt(row, forceColumn);
    sample.cuttingForce = vectorAt(row, cuttingForceColumn);
    sample.reportedRemoval = doubleOf(row[reportedColumn]);
    for (std::size_t i = 0; i < sample.removed.size(); ++i) {
        sample.removed[i].units = row[removedColumn + i];
        sample.removed[i].property = static_cast<std::uint8_t>((row[propertiesColumn] >> (8 * i)) & 0xff);
    }
    sample.buttons = static_cast<std::uint32_t>(row[buttonsColumn]);
    sample.flags = static_cast<std::uint32_t>(row[flagsColumn]);
    sample.torque = vectorAt(row, torqueColumn);
    return sample;
}

/// Of most devices no sample has any: its columns would be the same words again and again.
bool hasTorque(const Sample& sample) {
    const std::uint64_t none = wordOf(0.0);
    return wordOf(sample.torque.x) != none || wordOf(sample.torque.y) != none || wordOf(sample.torque.z) != none;
}

} // namespace

std::string encodeSamples(std::span<const Sample> samples) {
    const bool turns = std::ranges::any_of(samples, hasTorque);
    std::vector<Column> columns(turns ? torqueColumns : forceColumns, Column(samples.size()));
    for (std::size_t i = 0; i < samples.size(); ++i) {
        const Row row = rowOf(samples[i]);
        for (std::size_t column = 0; column < columns.size(); ++column) columns[column][i] = row[column];
    }
    return (turns ? torqueForm : forceForm) + encodeColumns(columns, lookBack);
}

std::optional<std::vector<Sample>> decodeSamples(std::string_view chunk, std::size_t count) {
    if (chunk.empty() || count > samplesPerChunk) return std::nullopt;
    const bool turns = chunk.front() == torqueForm;
    if (!turns && chunk.front() != forceForm) return std::nullopt;
    const std::optional<std::vector<Column>> columns =
        decodeColumns(chunk.substr(1), turns ? torqueColumns : forceColumns, count);
    if (!columns) return std::nullopt;
    std::vector<Sample> samples;
    samples.reserve(count);
    Row row{};
    put(row, torqueColumn, glm::dvec3(0.0));
    for (std::size_t i = 0; i < count; ++i) {
        for (std::size_t column = 0; column < columns->size(); ++column) row[column] = (*columns)[column][i];
        samples.push_back(sampleOf(row));
    }
    return samples;
}

} // namespace burin

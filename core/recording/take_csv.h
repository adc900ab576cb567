// SPDX-FileCopyrightText: 2026 The Burin authors
// SPDX-License-Identifier: Apache-2.0
#pragma once

#include "core/base/result.h"
#include "core/recording/sample_source.h"

#include <array>
#include <cstdint>
#include <filesystem>
#include <span>
#include <string>
#include <vector>

namespace burin {

/// Finds the properties of which material was removed.
class RemovedProperties {
public:
    void add(std::span<const Sample> samples) noexcept;
    std::vector<std::uint8_t> properties() const; ///< rising

private:
    std::array<bool, 256> seen_{};
};
/// The properties for all samples.
std::vector<std::uint8_t> removedProperties(std::span<const Sample> samples);

/// Ids of the materials of a property list, each at its index; 0 is air.
using MaterialIds = std::vector<std::string>;

/// The column names of a take as comma-separated values: every field of Sample with its unit, and one column of removed
/// run units for each of `properties`, named `removed_units_<id of the material>`, or `removed_units_property_<index>`
/// if `materials` does not have it. No line end.
std::string takeCsvHeader(std::span<const std::uint8_t> properties, const MaterialIds& materials);

/// Appends one tick in those columns to `text`, with a line end. Numbers in their shortest form, decimal points.
void appendTakeCsvRow(std::string& text, const Sample& sample, std::span<const std::uint8_t> properties);

/// Writes header and all ticks. Written in pieces, so that memory does not grow with the length of the recording; the
/// file is written completely or not at all. Errors: fileNotWritable, diskFull, those of `take`.
Result<void> writeTakeCsv(const std::filesystem::path& file, const SampleSource& take, const MaterialIds& materials);
/// Writes only the stylus data, as a trace (trace_file.h) that can be played back. Errors: as writeTakeCsv.
Result<void> writeTakeTrace(const std::filesystem::path& file, const SampleSource& take);

} // namespace burin

// SPDX-FileCopyrightText: 2026 The Burin authors
// SPDX-License-Identifier: Apache-2.0
#pragma once

#include "core/base/result.h"
#include "core/recording/sample.h"

#include <filesystem>
#include <span>
#include <string>
#include <vector>

namespace burin {

/// Properties of which anything was removed, rising.
std::vector<std::uint8_t> removedProperties(std::span<const Sample> samples);

/// The column names of a take as comma-separated values: every field of Sample with its unit, and one column of removed
/// run units for each of `properties`. No line end.
std::string takeCsvHeader(std::span<const std::uint8_t> properties);

/// One tick in those columns, appended to `text` with a line end. Numbers in their shortest form, decimal points.
void appendTakeCsvRow(std::string& text, const Sample& sample, std::span<const std::uint8_t> properties);

/// Header and all ticks. Written in pieces, so that a long take needs no second copy in memory; the file stands whole
/// or not at all. Errors: fileNotWritable, diskFull.
Result<void> writeTakeCsv(const std::filesystem::path& file, std::span<const Sample> samples);

} // namespace burin

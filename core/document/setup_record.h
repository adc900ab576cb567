// SPDX-FileCopyrightText: 2026 The Burin authors
// SPDX-License-Identifier: Apache-2.0
#pragma once

#include "core/setup/setup.h"

#include <cstdint>
#include <optional>
#include <string>
#include <string_view>

namespace burin {

/// Returns a setup as JSON text, its keys with their units; every number is restored bit for bit. A stock from a file
/// is represented only by its checksum.
/// Errors: argumentInvalid with the key of a number that is not finite (an empty stock box is allowed).
Result<std::string> toJson(const Setup& setup);

/// Empty if `text` was not written by `toJson`. A stock from a file is left out.
std::optional<Setup> setupFromJson(std::string_view text);
/// StockVolume::checksum of the stock that `text` was written with; empty if that was not from a file.
std::optional<std::uint64_t> stockChecksumOf(std::string_view text);

} // namespace burin

// SPDX-FileCopyrightText: 2026 The Burin authors
// SPDX-License-Identifier: Apache-2.0
#pragma once

#include "core/setup/setup.h"

#include <cstdint>
#include <optional>
#include <string>
#include <string_view>

namespace burin {

/// A setup as JSON text, its keys with their units; every number reads back bit for bit. Of a stock from a file it says
/// the checksum alone.
/// Errors: argumentInvalid with the key of a number that is not finite (an empty stock box is allowed).
Result<std::string> toJson(const Setup& setup);

/// Nothing when `text` is not what `toJson` writes. A stock from a file is left out.
std::optional<Setup> setupFromJson(std::string_view text);
/// StockVolume::checksum of the stock that `text` was written with; nothing where that was from no file.
std::optional<std::uint64_t> stockChecksumOf(std::string_view text);

} // namespace burin

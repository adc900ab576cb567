// SPDX-FileCopyrightText: 2026 The Burin authors
// SPDX-License-Identifier: Apache-2.0
#pragma once

#include <cstddef>
#include <optional>
#include <string>
#include <string_view>

namespace burin {

/// One Zstandard frame (RFC 8878) with its content size and checksum. Throws std::bad_alloc, nothing else.
std::string compress(std::string_view bytes);

/// The content of a frame that `compress` made; nothing when it is damaged, cut short or holds more than `maximumSize`
/// bytes.
std::optional<std::string> decompress(std::string_view frame, std::size_t maximumSize);

} // namespace burin

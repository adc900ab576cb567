// SPDX-FileCopyrightText: 2026 The Burin authors
// SPDX-License-Identifier: Apache-2.0
#pragma once

#include <cstddef>
#include <optional>
#include <string>
#include <string_view>

namespace burin {

/// One Zstandard frame (RFC 8878) with its content size and checksum. If the content is compressed to less than a
/// 256th, a skippable frame of zeros follows, so that readers can derive bounds from the packed size. Throws
/// std::bad_alloc, nothing else.
std::string compress(std::string_view bytes);

/// The content of a frame that `compress` made; empty if it is damaged, incomplete or holds more than `maximumSize`
/// bytes.
std::optional<std::string> decompress(std::string_view frame, std::size_t maximumSize);

/// The largest content of a frame of `packed` bytes, in bytes. A frame that claims more was not made by Burin, and is
/// refused before memory is allocated for it.
constexpr std::size_t mostUnpacked(std::size_t packed) {
    return (std::size_t{16} << 20U) + 256 * packed;
}
/// The largest total content of all frames of a file, in bytes.
constexpr std::size_t mostUnpackedTogether(std::size_t packed) {
    return (std::size_t{128} << 20U) + 256 * packed;
}

} // namespace burin

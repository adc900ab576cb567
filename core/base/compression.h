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

/// Bytes that follow the last frame in a form that older readers skip (a skippable frame, RFC 8878, 3.1.2).
/// @param bytes at most 4 GiB
std::string attached(std::string_view bytes);
/// Returns the content of the frame that `attached` made, behind any number of other frames; empty if there is none, or
/// a frame before it is damaged.
std::string_view attachmentOf(std::string_view frames) noexcept;

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

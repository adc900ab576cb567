// SPDX-FileCopyrightText: 2026 The Burin authors
// SPDX-License-Identifier: Apache-2.0
#pragma once

#include <cstddef>
#include <optional>
#include <string>
#include <string_view>

namespace burin {

/// One Zstandard frame (RFC 8878) with its content size and checksum. Behind what packs to less than a 256th stands a
/// skippable frame of zeros, so that a reader's bounds can follow from the packed size. Throws std::bad_alloc, nothing
/// else.
std::string compress(std::string_view bytes);

/// The content of a frame that `compress` made; nothing when it is damaged, cut short or holds more than `maximumSize`
/// bytes.
std::optional<std::string> decompress(std::string_view frame, std::size_t maximumSize);

/// Most bytes that a frame of `packed` bytes comes to. One that claims more is none of ours, and is refused before
/// memory is taken for it.
constexpr std::size_t mostUnpacked(std::size_t packed) {
    return (std::size_t{16} << 20U) + 256 * packed;
}
/// Most bytes that all frames of a file come to together.
constexpr std::size_t mostUnpackedTogether(std::size_t packed) {
    return (std::size_t{128} << 20U) + 256 * packed;
}

} // namespace burin

// SPDX-FileCopyrightText: 2026 The Burin authors
// SPDX-License-Identifier: Apache-2.0
#include "core/base/compression.h"

#include <memory>
#include <new>
#include <zstd.h>

namespace burin {

namespace {
constexpr int level = 3; // Zstandard's default: higher levels gained little on noisy doubles
// Chosen so that the total of many frames also stays below the limit for their file.
constexpr std::size_t evenBytes = 64U << 10U, mostPacking = 256;
constexpr std::size_t skippableHeader = 8;

// Magic numbers of skippable frames, little-endian: what follows them is skipped by every reader.
constexpr std::string_view zerosMark("\x50\x2a\x4d\x18", 4), attachmentMark("\x51\x2a\x4d\x18", 4);

/// RFC 8878, 3.1.2: the magic number and the size of the content, both little-endian.
std::string skippableHead(std::string_view mark, std::size_t size) {
    std::string head(mark);
    for (std::size_t i = 0; i < 4; ++i) head.push_back(static_cast<char>((size >> (8 * i)) & 0xff));
    return head;
}

std::string skippableFrame(std::size_t zeros) {
    return skippableHead(zerosMark, zeros).append(zeros, '\0');
}
} // namespace

std::string compress(std::string_view bytes) {
    const std::unique_ptr<ZSTD_CCtx, decltype(&ZSTD_freeCCtx)> context(ZSTD_createCCtx(), &ZSTD_freeCCtx);
    if (!context) throw std::bad_alloc();
    ZSTD_CCtx_setParameter(context.get(), ZSTD_c_compressionLevel, level);
    ZSTD_CCtx_setParameter(context.get(), ZSTD_c_checksumFlag, 1);
    std::string frame(ZSTD_compressBound(bytes.size()), '\0');
    const std::size_t written = ZSTD_compress2(context.get(), frame.data(), frame.size(), bytes.data(), bytes.size());
    // With a buffer of the bound's size, only memory for its tables can be lacking.
    if (ZSTD_isError(written) != 0) throw std::bad_alloc();
    frame.resize(written);
    if (bytes.size() > evenBytes + mostPacking * written) {
        const std::size_t lacking = (bytes.size() - evenBytes) / mostPacking + 1 - written;
        frame += skippableFrame(lacking > skippableHeader ? lacking - skippableHeader : 0);
    }
    return frame;
}

std::string attached(std::string_view bytes) {
    return skippableHead(attachmentMark, bytes.size()).append(bytes);
}

std::string_view attachmentOf(std::string_view frames) noexcept {
    while (!frames.empty()) {
        const std::size_t size = ZSTD_findFrameCompressedSize(frames.data(), frames.size());
        if (ZSTD_isError(size) != 0 || size > frames.size()) return {};
        if (frames.starts_with(attachmentMark)) return frames.substr(skippableHeader, size - skippableHeader);
        frames.remove_prefix(size);
    }
    return {};
}

std::optional<std::string> decompress(std::string_view frame, std::size_t maximumSize) try {
    const unsigned long long stated = ZSTD_getFrameContentSize(frame.data(), frame.size());
    if (stated == ZSTD_CONTENTSIZE_ERROR || stated == ZSTD_CONTENTSIZE_UNKNOWN || stated > maximumSize)
        return std::nullopt;
    std::string bytes(static_cast<std::size_t>(stated), '\0');
    const std::size_t written = ZSTD_decompress(bytes.data(), bytes.size(), frame.data(), frame.size());
    if (ZSTD_isError(written) != 0 || written != bytes.size()) return std::nullopt;
    return bytes;
} catch (const std::bad_alloc&) { // a damaged frame may state any size
    return std::nullopt;
}

} // namespace burin

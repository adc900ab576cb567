// SPDX-FileCopyrightText: 2026 The Burin authors
// SPDX-License-Identifier: Apache-2.0
#include "core/base/compression.h"

#include <memory>
#include <new>
#include <zstd.h>

namespace burin {

namespace {
constexpr int level = 3; // Zstandard's own choice: higher ones gained little on noisy doubles
} // namespace

std::string compress(std::string_view bytes) {
    const std::unique_ptr<ZSTD_CCtx, decltype(&ZSTD_freeCCtx)> context(ZSTD_createCCtx(), &ZSTD_freeCCtx);
    if (!context) throw std::bad_alloc();
    ZSTD_CCtx_setParameter(context.get(), ZSTD_c_compressionLevel, level);
    ZSTD_CCtx_setParameter(context.get(), ZSTD_c_checksumFlag, 1);
    std::string frame(ZSTD_compressBound(bytes.size()), '\0');
    const std::size_t written = ZSTD_compress2(context.get(), frame.data(), frame.size(), bytes.data(), bytes.size());
    // With room for the bound, all that can be lacking is memory for its tables.
    if (ZSTD_isError(written) != 0) throw std::bad_alloc();
    frame.resize(written);
    return frame;
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

// SPDX-FileCopyrightText: 2026 The Burin authors
// SPDX-License-Identifier: Apache-2.0
#include "core/cad/worker_message.h"

#include <algorithm>
#include <cstddef>
#include <cstdint>
#include <cstdlib>
#include <cstring>
#include <span>
#include <string>
#include <string_view>
#include <vector>

extern "C" std::size_t LLVMFuzzerMutate(std::uint8_t* bytes, std::size_t count, std::size_t room);

namespace {

using namespace burin;

// The header of a frame: mark, version, kind and a reserved word of four bytes each, size and checksum of eight.
constexpr std::size_t headSize = 32, kindAt = 8, sizeAt = 16, checksumAt = 24;
constexpr std::uint32_t kinds = 10; // one more than exist

/// As core/cad/worker_message.cpp computes it; without it no answer would be accepted and the code after the check
/// would not be tested.
std::uint64_t checksum(std::span<const std::uint8_t> bytes) {
    std::uint64_t hash = 14695981039346656037ULL;
    for (std::size_t at = 0; at < bytes.size(); at += sizeof hash) {
        std::uint64_t word = 0;
        std::memcpy(&word, &bytes[at], std::min(bytes.size() - at, sizeof word));
        hash = (hash ^ word) * 1099511628211ULL;
        hash ^= hash >> 32;
    }
    return hash;
}

/// Gives the bytes after the header a matching header.
void seal(std::span<std::uint8_t> frame, std::uint32_t kind) {
    static const std::string plain = encodeFrame(WorkerProgress{});
    std::memcpy(frame.data(), plain.data(), headSize);
    const std::uint64_t size = frame.size() - headSize, sum = checksum(frame.subspan(headSize));
    std::memcpy(&frame[kindAt], &kind, sizeof kind);
    std::memcpy(&frame[sizeAt], &size, sizeof size);
    std::memcpy(&frame[checksumAt], &sum, sizeof sum);
}

/// A frame that was accepted is encoded to the same bytes again, whether it arrives in one piece or in several.
void readStream(std::string_view stream) {
    FrameReader whole, pieces;
    whole.append(stream);
    std::vector<std::string> first, second;
    while (const auto frame = whole.next()) first.push_back(encodeFrame(*frame));
    for (std::size_t at = 0; at < stream.size(); at += 7) {
        pieces.append(stream.substr(at, 7));
        while (const auto frame = pieces.next()) second.push_back(encodeFrame(*frame));
    }
    if (first != second) std::abort();
    for (const std::string& frame : first) {
        FrameReader again;
        again.append(frame);
        const auto read = again.next();
        if (!read || encodeFrame(*read) != frame) std::abort();
    }
}

} // namespace

/// The messages that the import program may send to Burin, and those that it may receive.
extern "C" int LLVMFuzzerTestOneInput(const std::uint8_t* bytes, std::size_t count) {
    const std::string_view stream(reinterpret_cast<const char*>(bytes), count);
    readStream(stream);
    if (const auto request = decodeRequest(stream)) {
        const auto again = decodeRequest(encodeRequest(*request));
        if (!again || again->index() != request->index()) std::abort();
    }
    return 0;
}

extern "C" std::size_t LLVMFuzzerCustomMutator(std::uint8_t* bytes, std::size_t count, std::size_t room,
                                               unsigned int seed) {
    if (count < headSize || seed % 8 == 0) return LLVMFuzzerMutate(bytes, count, room);
    std::uint32_t kind = 0;
    std::memcpy(&kind, bytes + kindAt, sizeof kind);
    if (seed % 16 == 1) kind = (seed >> 8U) % kinds;
    const std::size_t size = LLVMFuzzerMutate(bytes + headSize, count - headSize, room - headSize);
    seal({bytes, headSize + size}, kind);
    return headSize + size;
}

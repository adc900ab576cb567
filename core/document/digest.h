// SPDX-FileCopyrightText: 2026 The Burin authors
// SPDX-License-Identifier: Apache-2.0
#pragma once

#include "core/document/database.h"

#include <algorithm>
#include <bit>
#include <cstdint>
#include <cstring>
#include <string>
#include <string_view>
#include <utility>
#include <vector>

namespace burin {

/// Accumulates words one after the other. Each step is a bijection of the word, so a single differing word always
/// changes the value.
class Digest {
public:
    void add(std::uint64_t word) noexcept {
        value_ = (value_ ^ word) * 0x9E3779B97F4A7C15u; // 2^64 over the golden ratio, odd
        value_ ^= value_ >> 29;
    }
    void add(std::string_view bytes) noexcept {
        add(bytes.size());
        const std::size_t whole = bytes.size() / 8 * 8;
        for (std::size_t start = 0; start < whole; start += 8) add(wholeWordAt(bytes, start));
        if (whole < bytes.size()) add(wordAt(bytes, whole));
    }
    std::int64_t value() const noexcept { return static_cast<std::int64_t>(value_); }

private:
    /// `wordAt` of eight bytes, quickly: a project has hundreds of megabytes of them.
    static std::uint64_t wholeWordAt(std::string_view bytes, std::size_t start) noexcept {
        if constexpr (std::endian::native != std::endian::little) return wordAt(bytes, start);
        std::uint64_t word = 0;
        std::memcpy(&word, bytes.data() + start, sizeof word);
        return word;
    }
    static std::uint64_t wordAt(std::string_view bytes, std::size_t start) noexcept {
        const std::size_t end = std::min(bytes.size(), start + 8);
        std::uint64_t word = 0;
        for (std::size_t i = end; i > start; --i) word = word << 8 | static_cast<unsigned char>(bytes[i - 1]);
        return word;
    }
    std::uint64_t value_ = 0;
};

/// Adds all result rows of a query.
Result<void> addRows(Database& database, const std::string& question, Digest& digest);

using Questions = std::vector<std::pair<const char*, std::string>>;

/// Returns the digest of the results of all queries, each with its name.
Result<std::int64_t> digestOf(Database& database, const Questions& questions);

} // namespace burin

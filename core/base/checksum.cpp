// SPDX-FileCopyrightText: 2026 The Burin authors
// SPDX-License-Identifier: Apache-2.0
#include "core/base/checksum.h"

#include <array>
#include <cstddef>

namespace burin {

namespace {

constexpr std::array<std::uint64_t, 256> remainders = [] {
    constexpr std::uint64_t polynomial = 0xc96c5795d7870f42;
    std::array<std::uint64_t, 256> table{};
    for (std::size_t i = 0; i < table.size(); ++i) {
        std::uint64_t remainder = i;
        for (int bit = 0; bit < 8; ++bit) remainder = (remainder >> 1) ^ ((remainder & 1) != 0 ? polynomial : 0);
        table[i] = remainder;
    }
    return table;
}();

} // namespace

std::uint64_t checksum(std::string_view bytes) noexcept {
    std::uint64_t remainder = ~std::uint64_t{0};
    for (const char byte : bytes)
        remainder = remainders[(remainder ^ static_cast<unsigned char>(byte)) & 0xff] ^ (remainder >> 8);
    return ~remainder;
}

} // namespace burin

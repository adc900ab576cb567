// SPDX-FileCopyrightText: 2026 The Burin authors
// SPDX-License-Identifier: Apache-2.0
#pragma once

#include <algorithm>
#include <cstddef>
#include <cstdint>
#include <span>

namespace burin::fuzz {

/// Divides an input into reports: a byte with the length, then that many bytes.
template <class Take>
void forEachReport(std::span<const std::uint8_t> input, const Take& take) {
    while (!input.empty()) {
        const std::size_t size = std::min<std::size_t>(input[0], input.size() - 1);
        take(input.subspan(1, size));
        input = input.subspan(1 + size);
    }
}

} // namespace burin::fuzz

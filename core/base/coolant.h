// SPDX-FileCopyrightText: 2026 The Burin authors
// SPDX-License-Identifier: Apache-2.0
#pragma once

#include <array>
#include <cstdint>
#include <string_view>

namespace burin {

/// Coolant, as a control switches it: off (M9), mist (M7), flood (M8).
enum class Coolant : std::uint8_t { off, mist, flood };

/// The name used in files.
constexpr std::string_view idOf(Coolant coolant) noexcept {
    constexpr std::array<std::string_view, 3> ids{"off", "mist", "flood"};
    return ids[static_cast<std::size_t>(coolant)];
}

} // namespace burin

// SPDX-FileCopyrightText: 2026 The Burin authors
// SPDX-License-Identifier: Apache-2.0
#pragma once

#include <cstdint>
#include <span>
#include <string>
#include <string_view>

namespace burin::test {

/// A valid program with a single fault in it.
struct Damaged {
    std::string text;
    std::string what; ///< description for people
    /// Lines of the text, from 1, one of which a finding must name: that of the damage, or, where a line was removed,
    /// from its position to the first move that lacks it. Both 0: nothing could be damaged.
    std::uint32_t first = 0, last = 0;
};

/// A kind of damage.
struct DamageKind {
    std::string_view name;
    /// Dialects to whose programs it is applied.
    std::span<const std::string_view> dialects;
    /// @param number 0 …: each selects another position or amount
    Damaged (*make)(const std::string& text, const std::string& dialect, std::uint32_t number);
};

std::span<const DamageKind> damageKinds();

} // namespace burin::test

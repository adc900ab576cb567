// SPDX-FileCopyrightText: 2026 The Burin authors
// SPDX-License-Identifier: Apache-2.0
#pragma once

#include <cstdint>
#include <span>
#include <string>
#include <string_view>

namespace burin::test {

/// A sound program with one thing wrong in it.
struct Damaged {
    std::string text;
    std::string what; ///< for people
    /// Lines of the text, from 1, one of which a finding has to name: that of the damage, or, where a line was taken
    /// out, from where it was to the first move that lacks it. Both 0: nothing could be damaged.
    std::uint32_t first = 0, last = 0;
};

/// A kind of damage.
struct DamageKind {
    std::string_view name;
    /// Dialects whose programs it is done to.
    std::span<const std::string_view> dialects;
    /// @param number 0 …: each another place or amount
    Damaged (*make)(const std::string& text, const std::string& dialect, std::uint32_t number);
};

std::span<const DamageKind> damageKinds();

} // namespace burin::test

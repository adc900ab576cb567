// SPDX-FileCopyrightText: 2026 The Burin authors
// SPDX-License-Identifier: Apache-2.0
#pragma once

#include <array>
#include <cstdint>
#include <optional>
#include <string_view>

namespace burin {

/// The role of an imported solid in a setup.
enum class BodyRole : std::uint8_t {
    part,            ///< the finished part: protected from cutting
    stock,           ///< raw material, for a stock that is made of solids
    insert,          ///< within the stock, with its own material; can be cut
    protectedInsert, ///< within the stock, with its own material; protected from cutting
    fixture,         ///< holds the stock: the tool stays clear of it
    ignored          ///< treated as absent
};
inline constexpr std::array bodyRoles{BodyRole::part,    BodyRole::stock,  BodyRole::insert, BodyRole::protectedInsert,
                                      BodyRole::fixture, BodyRole::ignored};

/// Stable id, for files and the command line: "part", "protected-insert", …
std::string_view idOf(BodyRole role) noexcept;
std::optional<BodyRole> bodyRoleFromId(std::string_view id) noexcept;

/// Whether the tool is stopped at the body's surface and no cut removes any of the body.
constexpr bool isProtected(BodyRole role) noexcept {
    return role == BodyRole::part || role == BodyRole::protectedInsert;
}
/// Whether the body fills voxels of the workpiece in addition to the raw material.
constexpr bool isEmbedded(BodyRole role) noexcept {
    return isProtected(role) || role == BodyRole::insert;
}

} // namespace burin

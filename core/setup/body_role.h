// SPDX-FileCopyrightText: 2026 The Burin authors
// SPDX-License-Identifier: Apache-2.0
#pragma once

#include <array>
#include <cstdint>
#include <optional>
#include <string_view>

namespace burin {

/// What an imported solid is in a setup.
enum class BodyRole : std::uint8_t {
    part,            ///< to be made: nothing may cut it
    stock,           ///< raw material, of a stock that is made of solids
    insert,          ///< within the stock, of a material of its own; it is cut
    protectedInsert, ///< within the stock, of a material of its own; nothing may cut it
    fixture,         ///< holds the stock: the tool stays clear of it
    ignored          ///< it is not there
};
inline constexpr std::array bodyRoles{BodyRole::part,    BodyRole::stock,  BodyRole::insert, BodyRole::protectedInsert,
                                      BodyRole::fixture, BodyRole::ignored};

/// Stable id, for files and the command line: "part", "protected-insert", …
std::string_view idOf(BodyRole role) noexcept;
std::optional<BodyRole> bodyRoleFromId(std::string_view id) noexcept;

/// The tool is held at its surface, and no cut takes any of it.
constexpr bool isProtected(BodyRole role) noexcept {
    return role == BodyRole::part || role == BodyRole::protectedInsert;
}
/// It fills voxels of the workpiece besides the raw material.
constexpr bool isEmbedded(BodyRole role) noexcept {
    return isProtected(role) || role == BodyRole::insert;
}

} // namespace burin

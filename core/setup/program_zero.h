// SPDX-FileCopyrightText: 2026 The Burin authors
// SPDX-License-Identifier: Apache-2.0
#pragma once

#include "core/geometry/placement.h"

#include <array>
#include <cstdint>
#include <optional>
#include <string_view>

namespace burin {

/// What the position of program zero refers to.
enum class ZeroReference : std::uint8_t {
    stock, ///< the box around the stock
    part,  ///< the box around the protected bodies
    point  ///< a given point: a picked vertex, or where a tool touched
};
inline constexpr std::array zeroReferences{ZeroReference::stock, ZeroReference::part, ZeroReference::point};
/// Stable id, for files and the command line: "stock", "part", "point".
std::string_view idOf(ZeroReference reference) noexcept;
std::optional<ZeroReference> zeroReferenceFromId(std::string_view id) noexcept;

/// A position in a box along one axis.
enum class BoxSide : std::uint8_t { low, middle, high };
inline constexpr std::array boxSides{BoxSide::low, BoxSide::middle, BoxSide::high};
/// Stable id: "low", "middle", "high".
std::string_view idOf(BoxSide side) noexcept;
std::optional<BoxSide> boxSideFromId(std::string_view id) noexcept;

/// Returns a corner, the middle of an edge or face, or the centre of a box, selected by one side per axis.
glm::dvec3 placeOn(const Box& box, const std::array<BoxSide, 3>& sides) noexcept;

/// The program zero of a setup, and the control's work offset that stores it.
struct ProgramZero {
    int workOffset = 54; ///< as NcMotion::workOffset: 54 … 59, 591 … 593, 1000 + n
    ZeroReference on = ZeroReference::stock;
    std::array<BoxSide, 3> sides{BoxSide::middle, BoxSide::middle, BoxSide::high}; ///< of its box, along x, y, z
    glm::dvec3 point{0.0};                                                         ///< mm, setup frame, for point

    friend bool operator==(const ProgramZero&, const ProgramZero&) = default;
};

/// Returns the program zero of a moved part: a point moves with the part; a position on a box is kept, as it is
/// determined again from the box.
ProgramZero moved(ProgramZero zero, const Placement& by);

} // namespace burin

// SPDX-FileCopyrightText: 2026 The Burin authors
// SPDX-License-Identifier: Apache-2.0
#pragma once

#include "core/base/text.h"

#include <glm/glm.hpp>

#include <cstdint>
#include <span>
#include <vector>

namespace burin {

/// Why a part of a path cannot be machined.
enum class OmissionReason : std::uint8_t {
    part,   ///< no motion past the part was found
    access, ///< it cannot be reached from above without entering the part
    shank,  ///< the shank would enter remaining material
    holder, ///< the holder would enter remaining material
    plunge, ///< it begins in material, there is no room for a ramp or helix, and the tool must not plunge
};
/// Stable id, for JSON: "part", "access", …
const char* idOf(OmissionReason reason);
/// The cause, and what the user can do about it; two sentences of the user interface.
TextId textOf(OmissionReason reason);
/// The remedy if nothing else of a path remains: the end of a sentence, marked for translation.
TextId remedyOf(OmissionReason reason);

/// A part of a path that an edit left out: the tool retracts before it, and continues behind it.
struct Omission {
    OmissionReason reason = OmissionReason::part;
    std::int64_t source = 0;          ///< PathSource::id
    std::int64_t first = 0, last = 0; ///< Moment::tick
    std::vector<glm::dvec3> line;     ///< mm, setup frame: polyline of the path before the edit, not empty
    double length = 0.0;              ///< mm
};

/// The total length, mm.
double lengthOf(std::span<const Omission> parts) noexcept;

/// Pointers to the parts, the longest first; parts of equal length keep their order.
std::vector<const Omission*> longestFirst(std::span<const Omission> parts);

/// The least length that is kept between two omitted parts, or between one and an end of its stroke; shorter pieces are
/// left out as well: half of the cutter's diameter, which a tool that only plunged there would have cleared anyway.
/// @param diameter mm. @return mm
constexpr double shortestKept(double diameter) noexcept {
    return 0.5 * diameter;
}

} // namespace burin

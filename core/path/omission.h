// SPDX-FileCopyrightText: 2026 The Burin authors
// SPDX-License-Identifier: Apache-2.0
#pragma once

#include "core/base/text.h"

#include <glm/glm.hpp>

#include <cstdint>
#include <span>
#include <vector>

namespace burin {

/// Why a part of a path can't be made.
enum class OmissionReason : std::uint8_t {
    part,   ///< no motion past the part was found
    access, ///< nothing leads there from above without entering the part
    shank,  ///< the shank would enter material that is left
    holder, ///< the holder would enter material that is left
    plunge, ///< it begins in material, a ramp or helix finds no room, and the tool must not plunge
};
/// Stable id, for JSON: "part", "access", …
const char* idOf(OmissionReason reason);
/// What prevents it, and what the user can do about it; two sentences of the user interface.
TextId textOf(OmissionReason reason);
/// What helps where nothing else is left of a path: the end of a sentence, marked for translation.
TextId remedyOf(OmissionReason reason);

/// A part of a path that an edit left out: the tool retracts before it, and goes on behind it.
struct Omission {
    OmissionReason reason = OmissionReason::part;
    std::int64_t source = 0;          ///< PathSource::id
    std::int64_t first = 0, last = 0; ///< Moment::tick
    std::vector<glm::dvec3> line;     ///< mm, setup frame: polyline of the path as it was before the edit, not empty
    double length = 0.0;              ///< mm
};

/// mm, of all of them.
double lengthOf(std::span<const Omission> parts) noexcept;

/// Pointers into them, the longest first; equal ones as they were.
std::vector<const Omission*> longestFirst(std::span<const Omission> parts);

/// What is kept between two parts that are left out, or between one and an end of its stroke, is at least so long; else
/// it is left out as well: half of the cutter's diameter, which a tool that only plunged there would have cleared
/// anyway.
/// @param diameter mm. @return mm
constexpr double shortestKept(double diameter) noexcept {
    return 0.5 * diameter;
}

} // namespace burin

// SPDX-FileCopyrightText: 2026 The Burin authors
// SPDX-License-Identifier: Apache-2.0
#pragma once

#include "core/base/result.h"
#include "core/setup/guide_curve.h"

#include <array>
#include <cstdint>

namespace burin {

enum class GuideKind : std::uint8_t {
    plane,
    levels,   ///< parallel planes, of which the nearest one holds
    line,     ///< endless
    curve,    ///< an edge of the part
    surface,  ///< a constant distance of the tool from the part
    stepOver, ///< a constant distance from the last pass, on either side, seen along `direction`
    axis,     ///< the tool's axis at a fixed lead and tilt
};

/// A virtual fixture: where the hand likes to be held (Rosenberg 1993; Abbott, Marayong & Okamura 2007). Setup frame.
struct Guide {
    GuideKind kind = GuideKind::plane;
    bool on = false;
    glm::dvec3 point{0.0}; ///< mm, on the plane, the first level, or the line
    /// Unit: normal of plane and levels, direction of the line; stepOver: along which the distance is seen; axis: the
    /// normal that lead and tilt start from.
    glm::dvec3 direction{0.0, 0.0, 1.0};
    double distance = 1.0;  ///< mm: between levels (> 0), from the part (>= 0), step-over (> 0)
    double lead = 0.0;      ///< rad, of the axis towards where the tool goes
    double tilt = 0.0;      ///< rad, of the axis to the left of where it goes
    bool onSurface = false; ///< axis: the part's normal at the tool, where it is known, instead of `direction`
    const GuideCurve* curve = nullptr; ///< outlives every loop that was told of it

    friend bool operator==(const Guide&, const Guide&) = default;
};

/// All guides of a session: plain data, handed to the loop at a tick's edge. Where not all can hold at once, the
/// earlier one stays.
struct GuideSettings {
    static constexpr std::size_t capacity = 8;
    std::array<Guide, capacity> guides{};
    std::uint32_t stepButton = 0; ///< bits of the stylus' buttons that ask for the next level, or end a pass
};

/// Errors: argumentInvalid (place: which entry; not finite, no direction, a distance or curve that does not do).
Result<void> checkGuide(const Guide& guide);
/// Errors: of the first guide that is on and does not do.
Result<void> checkGuides(const GuideSettings& settings);

} // namespace burin

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
    levels,   ///< parallel planes, of which the nearest one is active
    line,     ///< infinite
    curve,    ///< an edge of the part
    surface,  ///< a constant distance of the tool from the part
    stepOver, ///< a constant distance from the last pass, on either side, seen along `direction`
    axis,     ///< the tool's axis at a fixed lead and tilt
};

/// A virtual fixture: constrains the hand to a geometry (Rosenberg 1993; Abbott, Marayong & Okamura 2007). Setup frame.
struct Guide {
    GuideKind kind = GuideKind::plane;
    bool on = false;
    glm::dvec3 point{0.0}; ///< mm, on the plane, the first level, or the line
    /// Unit vector. plane and levels: the normal; line: its direction; stepOver: the direction along which the distance
    /// is projected; axis: the normal from which lead and tilt are measured.
    glm::dvec3 direction{0.0, 0.0, 1.0};
    double distance = 1.0;             ///< mm: between levels and step-over (>= 0.01), from the part (>= 0)
    double lead = 0.0;                 ///< rad, of the axis towards the direction of motion
    double tilt = 0.0;                 ///< rad, of the axis to the left of the direction of motion
    bool onSurface = false;            ///< axis: use the part's normal at the tool, if known, instead of `direction`
    const GuideCurve* curve = nullptr; ///< must outlive every loop that received it

    friend bool operator==(const Guide&, const Guide&) = default;
};

/// All guides of a session: plain data, passed to the loop between two ticks. Where not all of them can be satisfied at
/// once, the earlier guide takes precedence.
struct GuideSettings {
    static constexpr std::size_t capacity = 8;
    std::array<Guide, capacity> guides{};
    std::uint32_t stepButton = 0; ///< bits of the stylus buttons that switch to the next level, or end a pass
};

/// Errors: argumentInvalid (subject: the entry, place: its value; not finite, no direction, an invalid distance or
/// curve).
Result<void> checkGuide(const Guide& guide);
/// Errors: those of the first guide that is on and invalid.
Result<void> checkGuides(const GuideSettings& settings);

} // namespace burin

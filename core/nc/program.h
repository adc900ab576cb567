// SPDX-FileCopyrightText: 2026 The Burin authors
// SPDX-License-Identifier: Apache-2.0
#pragma once

#include "core/base/coolant.h"
#include "core/machine/axis_values.h"
#include "core/machine/machine_profile.h"

#include <glm/glm.hpp>

#include <array>
#include <cstdint>
#include <optional>
#include <string>
#include <string_view>
#include <vector>

namespace burin {

enum class NcMoveKind : std::uint8_t { rapid, line, arc, dwell };

/// How an arc turns, as in PathArc and Arc: about an axis of the frame, by at most one turn; a full turn if both ends
/// are equal.
struct NcArc {
    glm::dvec3 centre{0.0}; ///< mm, in the frame of the work offset; its component along the axis has no meaning
    int axis = 2;           ///< 0 X, 1 Y, 2 Z
    bool clockwise = false; ///< seen against the axis
};

/// One move of a program, before a dialect formats it.
struct NcMove {
    NcMoveKind kind = NcMoveKind::line;
    AxisValues target;       ///< in the frame of the work offset in force; has no meaning for a dwell
    double feed = 0.0;       ///< mm/min, degrees/min if only rotary axes move; 0 for rapids and dwells
    std::int64_t source = 0; ///< with `sample`, the moment in it, as in PathPoint
    std::int64_t sample = -1;
    std::string comment;  ///< written before the move; empty: none
    NcArc arc{};          ///< only of an arc
    double seconds = 0.0; ///< only of a dwell
    /// 1/min, in force from before this move; 0: unchanged. The spindle gets time to reach it before a rapid; in a cut,
    /// the feeds take care of that.
    double spindleSpeed = 0.0;
    std::optional<Coolant> coolant{}; ///< in force from before this move; empty: unchanged
};

enum class SpindleDirection : std::uint8_t { clockwise, anticlockwise };
enum class NcUnits : std::uint8_t { millimetre, inch };
/// As files and command lines name them: "mm", "inch".
constexpr const char* idOf(NcUnits units) noexcept {
    return units == NcUnits::inch ? "inch" : "mm";
}
constexpr std::optional<NcUnits> ncUnitsFromId(std::string_view id) noexcept {
    for (const NcUnits units : {NcUnits::millimetre, NcUnits::inch})
        if (id == idOf(units)) return units;
    return std::nullopt;
}

/// The part of a program that uses one tool. Begins with a rapid move.
struct NcSection {
    int toolNumber = 1;
    std::string toolName;
    double spindleSpeed = 0.0; ///< 1/min
    SpindleDirection direction = SpindleDirection::clockwise;
    Coolant coolant = Coolant::off;
    std::vector<NcMove> moves;
};

/// A program before a dialect formats it. Lengths are in mm whatever `units` is.
struct NcProgram {
    std::string name;
    std::vector<std::string> header; ///< comment lines
    NcUnits units = NcUnits::millimetre;
    int workOffset = 54;                    ///< as NcMotion::workOffset: 54 … 59, 591 … 593, 1000 + n
    double safeHeight = 0.0;                ///< mm above the zero of the work offset, where travel is free
    double blendTolerance = 0.0;            ///< mm by which the control may deviate from the path; 0: it stops exactly
    double spindleStart = spindleStartTime; ///< s; 0: no dwell for it
    std::vector<NcSection> sections;
};

} // namespace burin

// SPDX-FileCopyrightText: 2026 The Burin authors
// SPDX-License-Identifier: Apache-2.0
#pragma once

#include "core/base/result.h"

#include <glm/glm.hpp>

#include <cstddef>
#include <optional>
#include <string>
#include <string_view>
#include <vector>

namespace burin {

/// The side of the cutter on which the material lies while a clockwise spindle (M3) feeds past it.
enum class Immersion : std::uint8_t {
    slot,    ///< on both sides: radial depth = diameter
    up,      ///< to the left of the feed: conventional milling, chips start thin
    down,    ///< to the right of the feed: climb milling, chips start thick
    unknown, ///< not stated
};

/// One measured cut and its conditions.
struct ForceRecord {
    std::size_t line = 0;                    ///< of the file, from 1; the first one of a cut of several rows
    std::size_t samples = 1;                 ///< number of rows whose mean force this is
    std::string material;                    ///< id
    std::string cut;                         ///< id of the cut; empty: the row is a separate cut
    glm::dvec3 force{0.0};                   ///< N, mean over whole turns of the spindle, with the sign of the file
    glm::dvec3 axis{0.0, 0.0, 1.0};          ///< unit, from tip to holder
    glm::dvec3 feedDirection{1.0, 0.0, 0.0}; ///< unit, motion of the tool relative to the workpiece
    double spindleSpeed = 0.0;               ///< 1/min, > 0
    double diameter = 0.0;                   ///< mm, > 0
    int teeth = 1;                           ///< >= 1
    double axialDepth = 0.0;                 ///< mm, >= 0
    double radialDepth = 0.0;                ///< mm, 0 … diameter
    double feed = 0.0;                       ///< mm/min, >= 0
    Immersion immersion = Immersion::unknown;
    std::optional<double> statedRate; ///< mm³/s, >= 0, if it is not depth · width · feed

    double toolEdgeSpeed() const noexcept; ///< v, mm/s
    double removalRate() const noexcept;   ///< mm³/s: the stated rate, else depth · width · feed (paper, eq. 5)
    double feedPerTooth() const noexcept;  ///< mm
    /// mm: mean over the engaged arc, 2 fz ae / (D phi) with cos phi = 1 - 2 ae / D, of a wall along the tool axis
    /// (slot: 2 fz / pi). 0 without radial depth.
    double meanChipThickness() const noexcept;
};

/// Reads force records: CSV, UTF-8, commas, decimal points, one heading line that names each column with its unit, in
/// any order; lines that are empty or begin with '#' are skipped. core/cutting/README.md lists the columns.
/// Rows with the same `cut` are samples of one cut and become one record with their mean force.
/// @param origin file name for messages
/// Errors: resourceInvalid (place: line and column; detail: what is wrong and what to write), fileEmpty.
Result<std::vector<ForceRecord>> parseForceRecords(std::string_view text, const std::string& origin);

/// Returns the names of the required columns of a file, or of the optional ones, for help and messages.
std::vector<std::string_view> forceRecordColumns(bool required);

} // namespace burin

// SPDX-FileCopyrightText: 2026 The Burin authors
// SPDX-License-Identifier: Apache-2.0
#pragma once

#include "core/base/result.h"
#include "core/geometry/plan_region.h"

#include <filesystem>
#include <string>
#include <string_view>
#include <vector>

namespace burin {

/// A curve of a drawing, in plan.
struct DrawnCurve {
    std::vector<glm::dvec2> places; ///< mm; a closed curve does not repeat its first point
    bool closed = false;
    std::string layer; ///< for DXF; for SVG the id of the nearest group that has one. May be empty
};

/// A DXF or SVG drawing: curves in plan, X to the right and Y upwards. Arcs, circles, ellipses and splines are chords
/// within 0.002 mm of their curve.
struct PlanDrawing {
    std::vector<DrawnCurve> curves;
    std::vector<glm::dvec2> points; ///< mm: points, and centres of circles
    double unit = 1.0;              ///< mm per unit of the file, as used for reading
    bool unitStated = true;         ///< otherwise mm were assumed, or 1/96 inch for SVG
    std::vector<std::string> notes; ///< omitted elements, in English, each once
};

/// Largest file that is read, in bytes, and largest number of points of its curves.
inline constexpr std::uintmax_t largestDrawing = 64u << 20;
inline constexpr std::size_t mostDrawnPlaces = 2'000'000;

/// Reads a drawing; its format is detected from its content. @param unit mm per unit of the file; 0: as the file says
/// Errors: fileNotFound, fileNotReadable, resourceInvalid (neither DXF nor SVG, broken, too large, or without a curve;
/// detail: where and why).
Result<PlanDrawing> readDrawing(const std::filesystem::path& file, double unit = 0.0);
/// The same for a text. @param origin for messages
Result<PlanDrawing> drawingOf(std::string_view text, const std::string& origin, double unit = 0.0);

/// The region enclosed by the closed curves, by the even-odd rule; open curves whose ends meet within 0.01 mm are
/// joined. Errors: argumentInvalid (none is closed). @param origin for messages
Result<PlanRegion> regionOf(const PlanDrawing& drawing, const std::string& origin);

/// All curves as lines at height 0, closed ones back to their start; mm.
std::vector<std::vector<glm::dvec3>> linesOf(const PlanDrawing& drawing);

} // namespace burin

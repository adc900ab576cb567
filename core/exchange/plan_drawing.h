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
    std::vector<glm::dvec2> places; ///< mm; a closed one does not repeat its first place
    bool closed = false;
    std::string layer; ///< of a DXF; of an SVG the id of the nearest group that has one. May be empty
};

/// A DXF or SVG drawing: curves in plan, X to the right and Y upwards. Arcs, circles, ellipses and splines are chords
/// within 0.002 mm of their curve.
struct PlanDrawing {
    std::vector<DrawnCurve> curves;
    std::vector<glm::dvec2> points; ///< mm: points, and centres of circles
    double unit = 1.0;              ///< mm, of the file's unit, as it was read
    bool unitStated = true;         ///< else it was taken as mm, or of an SVG as 1/96 inch
    std::vector<std::string> notes; ///< what was left out, in English, each once
};

/// Largest file that is read, bytes, and the most places that its curves may have.
inline constexpr std::uintmax_t largestDrawing = 64u << 20;
inline constexpr std::size_t mostDrawnPlaces = 2'000'000;

/// Reads a drawing; its kind is found from its content. @param unit mm of the file's unit; 0: as the file says
/// Errors: fileNotFound, fileNotReadable, resourceInvalid (neither DXF nor SVG, broken, too large, or without a curve;
/// detail: where and why).
Result<PlanDrawing> readDrawing(const std::filesystem::path& file, double unit = 0.0);
/// The same of a text. @param origin for messages
Result<PlanDrawing> drawingOf(std::string_view text, const std::string& origin, double unit = 0.0);

/// What the closed curves enclose, by the even-odd rule; curves that are open but end where another begins are joined
/// within 0.01 mm. Errors: argumentInvalid (none is closed). @param origin for messages
Result<PlanRegion> regionOf(const PlanDrawing& drawing, const std::string& origin);

/// All curves as lines at the height 0, closed ones back to their beginning; mm.
std::vector<std::vector<glm::dvec3>> linesOf(const PlanDrawing& drawing);

} // namespace burin

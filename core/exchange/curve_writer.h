// SPDX-FileCopyrightText: 2026 The Burin authors
// SPDX-License-Identifier: Apache-2.0
#pragma once

#include "core/exchange/plan_drawing.h"

#include <array>
#include <optional>
#include <string>

namespace burin {

/// mm, largest distance between a drawing's curves and their chords.
inline constexpr double drawingChord = 0.002;

/// Maps the coordinates of a shape to mm of the drawing: x' = x.x * x + y.x * y + shift.x, …
struct PlanTransform {
    glm::dvec2 x{1.0, 0.0}, y{0.0, 1.0}, shift{0.0};

    glm::dvec2 of(const glm::dvec2& place) const noexcept { return place.x * x + place.y * y + shift; }
    glm::dvec2 ofVector(const glm::dvec2& vector) const noexcept { return vector.x * x + vector.y * y; }
};
/// First `inner`, then `outer`.
PlanTransform combined(const PlanTransform& outer, const PlanTransform& inner) noexcept;

/// Converts the shapes of a file to the curves of a drawing. Coordinates are those of the shape, before `transform`.
class CurveWriter {
public:
    explicit CurveWriter(PlanDrawing& drawing) : drawing_(drawing) {}

    PlanTransform transform;
    std::string layer;

    void moveTo(const glm::dvec2& place);
    void lineTo(const glm::dvec2& place);
    void quadraticTo(const glm::dvec2& control, const glm::dvec2& end);
    void cubicTo(const glm::dvec2& first, const glm::dvec2& second, const glm::dvec2& end);
    /// centre + u cos t + v sin t, t from `from` by `sweep`, rad; connected to the current curve by a straight line.
    void ellipse(const glm::dvec2& centre, const glm::dvec2& u, const glm::dvec2& v, double from, double sweep);
    /// A circular arc to a point; `bulge` is the tangent of a quarter of its angle, > 0 anticlockwise (DXF).
    void bulgeTo(const glm::dvec2& end, double bulge);
    void close();
    /// Ends the current curve; a single point is not a curve.
    void finish();
    void point(const glm::dvec2& place);
    /// Notes that something is left out, each text once.
    void note(const std::string& text);

    /// The fault: a point that is not finite or too far away, or too many points; empty if there is none.
    const std::optional<std::string>& fault() const noexcept { return fault_; }
    const glm::dvec2& at() const noexcept { return at_; }

private:
    void add(const glm::dvec2& place); ///< mm of the drawing
    void fail(const char* what);

    PlanDrawing& drawing_;
    DrawnCurve curve_;
    glm::dvec2 at_{0.0}, first_{0.0}; ///< in the shape's coordinates
    std::size_t places_ = 0;
    std::optional<std::string> fault_;
};

/// The readers of each format. Errors: resourceInvalid.
Result<PlanDrawing> dxfDrawing(std::string_view text, const std::string& origin, double unit);
Result<PlanDrawing> svgDrawing(std::string_view text, const std::string& origin, double unit);
/// Draws the data of an SVG path (its attribute d). @return the fault; empty if there is none
std::string drawSvgPath(std::string_view data, CurveWriter& writer);

} // namespace burin

// SPDX-FileCopyrightText: 2026 The Burin authors
// SPDX-License-Identifier: Apache-2.0
#pragma once

#include "core/exchange/plan_drawing.h"

#include <array>
#include <optional>
#include <string>

namespace burin {

/// mm: how far chords of a drawing's curves may be from them.
inline constexpr double drawingChord = 0.002;

/// From the coordinates of a figure to mm of the drawing: x' = x.x * x + y.x * y + shift.x, …
struct PlanTransform {
    glm::dvec2 x{1.0, 0.0}, y{0.0, 1.0}, shift{0.0};

    glm::dvec2 of(const glm::dvec2& place) const noexcept { return place.x * x + place.y * y + shift; }
    glm::dvec2 ofVector(const glm::dvec2& vector) const noexcept { return vector.x * x + vector.y * y; }
};
/// First `inner`, then `outer`.
PlanTransform combined(const PlanTransform& outer, const PlanTransform& inner) noexcept;

/// Makes the curves of a drawing out of figures as files have them. Coordinates are the figure's, before `transform`.
class CurveWriter {
public:
    explicit CurveWriter(PlanDrawing& drawing) : drawing_(drawing) {}

    PlanTransform transform;
    std::string layer;

    void moveTo(const glm::dvec2& place);
    void lineTo(const glm::dvec2& place);
    void quadraticTo(const glm::dvec2& control, const glm::dvec2& end);
    void cubicTo(const glm::dvec2& first, const glm::dvec2& second, const glm::dvec2& end);
    /// centre + u cos t + v sin t, t from `from` by `sweep`, rad; joined to what is there by a straight line.
    void ellipse(const glm::dvec2& centre, const glm::dvec2& u, const glm::dvec2& v, double from, double sweep);
    /// A circle's arc to a place; `bulge` is the tangent of a quarter of its angle, > 0 anticlockwise (DXF).
    void bulgeTo(const glm::dvec2& end, double bulge);
    void close();
    /// What was drawn so far is a curve; one place alone is none.
    void finish();
    void point(const glm::dvec2& place);
    /// Says once that something is left out.
    void note(const std::string& text);

    /// What is wrong with a place that is not finite, or too far, or with too many of them; nothing: all is well.
    const std::optional<std::string>& fault() const noexcept { return fault_; }
    const glm::dvec2& at() const noexcept { return at_; }

private:
    void add(const glm::dvec2& place); ///< mm of the drawing
    void fail(const char* what);

    PlanDrawing& drawing_;
    DrawnCurve curve_;
    glm::dvec2 at_{0.0}, first_{0.0}; ///< the figure's coordinates
    std::size_t places_ = 0;
    std::optional<std::string> fault_;
};

/// What a reader of one form gives. Errors: resourceInvalid.
Result<PlanDrawing> dxfDrawing(std::string_view text, const std::string& origin, double unit);
Result<PlanDrawing> svgDrawing(std::string_view text, const std::string& origin, double unit);
/// Draws the data of an SVG path (its attribute d). @return what is wrong with it; empty: nothing
std::string drawSvgPath(std::string_view data, CurveWriter& writer);

} // namespace burin

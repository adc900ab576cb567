// SPDX-FileCopyrightText: 2026 The Burin authors
// SPDX-License-Identifier: Apache-2.0
#include "core/exchange/curve_writer.h"

#include "core/base/units.h"

#include <algorithm>
#include <cmath>

namespace burin {
namespace {

constexpr int mostChords = 20000; // per shape

int chordsFor(double measure) {
    if (!std::isfinite(measure)) return 1; // its points will be refused
    return static_cast<int>(std::clamp(std::ceil(std::sqrt(measure / drawingChord)), 1.0, double(mostChords)));
}

} // namespace

PlanTransform combined(const PlanTransform& outer, const PlanTransform& inner) noexcept {
    return {outer.ofVector(inner.x), outer.ofVector(inner.y), outer.of(inner.shift)};
}

void CurveWriter::fail(const char* what) {
    if (!fault_) fault_ = what;
}

void CurveWriter::add(const glm::dvec2& place) {
    if (fault_) return;
    if (!(std::abs(place.x) <= farthestInPlan && std::abs(place.y) <= farthestInPlan))
        return fail("has a place farther than 1e5 mm from its origin");
    if (++places_ > mostDrawnPlaces) return fail("has more than two million places");
    if (curve_.places.empty() || curve_.places.back() != place) curve_.places.push_back(place);
}

void CurveWriter::moveTo(const glm::dvec2& place) {
    finish();
    at_ = first_ = place;
    add(transform.of(place));
}

void CurveWriter::lineTo(const glm::dvec2& place) {
    at_ = place;
    add(transform.of(place));
}

/// The distance of a parabola from its chord is a quarter of its second difference, over the square of the number of
/// chords.
void CurveWriter::quadraticTo(const glm::dvec2& control, const glm::dvec2& end) {
    const glm::dvec2 start = at_;
    const int chords = chordsFor(0.25 * glm::length(transform.ofVector(start - 2.0 * control + end)));
    for (int i = 1; i <= chords; ++i) {
        const double t = static_cast<double>(i) / chords, s = 1.0 - t;
        add(transform.of(s * s * start + 2.0 * s * t * control + t * t * end));
    }
    at_ = end;
}

/// The second derivative of a cubic is at most six times its greatest second difference, and the distance of the chords
/// is an eighth of that over the square of their number.
void CurveWriter::cubicTo(const glm::dvec2& first, const glm::dvec2& second, const glm::dvec2& end) {
    const glm::dvec2 start = at_;
    const double bend = std::max(glm::length(transform.ofVector(start - 2.0 * first + second)),
                                 glm::length(transform.ofVector(first - 2.0 * second + end)));
    const int chords = chordsFor(0.75 * bend);
    for (int i = 1; i <= chords; ++i) {
        const double t = static_cast<double>(i) / chords, s = 1.0 - t;
        add(transform.of(s * s * s * start + 3.0 * s * s * t * first + 3.0 * s * t * t * second + t * t * t * end));
    }
    at_ = end;
}

/// The distance of a chord of the angle a from a circle is r (1 - cos(a / 2)), which is less than r a² / 8.
void CurveWriter::ellipse(const glm::dvec2& centre, const glm::dvec2& u, const glm::dvec2& v, double from,
                          double sweep) {
    const glm::dvec2 moved = transform.ofVector(u), other = transform.ofVector(v);
    const double radius = std::sqrt(glm::dot(moved, moved) + glm::dot(other, other));
    const int chords = std::max(2, chordsFor(radius * sweep * sweep / 8.0));
    for (int i = 0; i <= chords; ++i) {
        const double angle = from + sweep * i / chords;
        at_ = centre + std::cos(angle) * u + std::sin(angle) * v;
        if (i == 0 && curve_.places.empty()) first_ = at_;
        add(transform.of(at_));
    }
}

void CurveWriter::bulgeTo(const glm::dvec2& end, double bulge) {
    const glm::dvec2 chord = end - at_;
    const double length = glm::length(chord);
    if (bulge == 0.0 || !std::isfinite(bulge) || length == 0.0) return lineTo(end);
    const double sweep = 4.0 * std::atan(bulge);
    const glm::dvec2 left(-chord.y, chord.x);
    const glm::dvec2 centre = 0.5 * (at_ + end) + left * (1.0 - bulge * bulge) / (4.0 * bulge);
    const glm::dvec2 u = at_ - centre, v(-u.y, u.x);
    ellipse(centre, u, v, 0.0, sweep);
    at_ = end;
}

void CurveWriter::close() {
    if (!curve_.places.empty()) {
        if (curve_.places.size() > 1 && glm::distance(curve_.places.front(), curve_.places.back()) < 1e-9)
            curve_.places.pop_back();
        curve_.closed = true;
    }
    const glm::dvec2 start = first_;
    finish();
    at_ = first_ = start;
}

void CurveWriter::finish() {
    if (curve_.places.size() >= (curve_.closed ? 3u : 2u)) {
        curve_.layer = layer;
        drawing_.curves.push_back(std::move(curve_));
    }
    curve_ = {};
}

void CurveWriter::point(const glm::dvec2& place) {
    const glm::dvec2 moved = transform.of(place);
    if (std::abs(moved.x) <= farthestInPlan && std::abs(moved.y) <= farthestInPlan &&
        drawing_.points.size() < mostDrawnPlaces)
        drawing_.points.push_back(moved);
    else
        fail("has a point that is too far, or too many of them");
}

void CurveWriter::note(const std::string& text) {
    constexpr std::size_t most = 20;
    if (drawing_.notes.size() < most && std::ranges::find(drawing_.notes, text) == drawing_.notes.end())
        drawing_.notes.push_back(text);
}

} // namespace burin

// SPDX-FileCopyrightText: 2026 The Burin authors
// SPDX-License-Identifier: Apache-2.0
#pragma once

#include "core/geometry/revolved_piece.h"

#include <algorithm>
#include <array>
#include <cmath>
#include <functional>
#include <limits>
#include <optional>

namespace burin::oracles {

/// Heights of the end faces of a piece at a distance from the axis that is less than its outline's radius, mm above the
/// tip.
struct Faces {
    double low = 0.0, high = 0.0;
};

inline double outlineOf(const RevolvedPiece& piece) {
    return std::max(piece.bottomRadius, piece.topRadius);
}

/// Computed directly from the definition of a frustum with a rounded bottom edge.
inline Faces facesAt(const RevolvedPiece& piece, double radius) {
    Faces faces{piece.bottom, piece.top};
    const double height = piece.top - piece.bottom;
    if (radius > piece.bottomRadius)
        faces.low += height * (radius - piece.bottomRadius) / (piece.topRadius - piece.bottomRadius);
    if (radius > piece.topRadius)
        faces.high -= height * (radius - piece.topRadius) / (piece.bottomRadius - piece.topRadius);
    const double beyond = radius - (piece.bottomRadius - piece.cornerRadius);
    if (piece.cornerRadius > 0.0 && beyond > 0.0)
        faces.low +=
            piece.cornerRadius - std::sqrt(std::max(0.0, piece.cornerRadius * piece.cornerRadius - beyond * beyond));
    return faces;
}

/// Least value of a function over 0 … 1 by sampling ever finer around the best sample; `start` is an additional sample.
inline double leastBySampling(const std::function<double(double)>& value, double start, double* where = nullptr) {
    double low = 0.0, high = 1.0, best = start, least = value(start);
    for (int zoom = 0; zoom < 9; ++zoom) {
        constexpr int samples = 256;
        const double step = (high - low) / samples;
        for (int i = 0; i <= samples; ++i) {
            const double t = i == samples ? high : low + i * step;
            if (const double here = value(t); here < least) {
                least = here;
                best = t;
            }
        }
        low = std::max(0.0, best - step);
        high = std::min(1.0, best + step);
    }
    if (where != nullptr) *where = best;
    return least;
}

/// The intersection of the line at (x, y) with a piece that moves between two tips, found by sampling poses on the
/// segment.
struct SampledSpan {
    double closest = 0.0; ///< mm, least distance from the axis
    double low = 0.0, high = 0.0;
};
inline SampledSpan sampledSpan(const RevolvedPiece& piece, const glm::dvec3& from, const glm::dvec3& to, double x,
                               double y) {
    const auto distance = [&](double t) {
        return std::hypot(x - (from.x + t * (to.x - from.x)), y - (from.y + t * (to.y - from.y)));
    };
    const double infinity = std::numeric_limits<double>::infinity();
    SampledSpan span;
    double at = 0.0;
    span.closest = leastBySampling(distance, 0.0, &at);
    const auto lowAt = [&](double t) {
        const double radius = distance(t);
        return radius < outlineOf(piece) ? from.z + t * (to.z - from.z) + facesAt(piece, radius).low : infinity;
    };
    const auto downAt = [&](double t) {
        const double radius = distance(t);
        return radius < outlineOf(piece) ? -(from.z + t * (to.z - from.z) + facesAt(piece, radius).high) : infinity;
    };
    span.low = leastBySampling(lowAt, at);
    span.high = -leastBySampling(downAt, at);
    return span;
}

} // namespace burin::oracles

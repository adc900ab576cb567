// SPDX-FileCopyrightText: 2026 The Burin authors
// SPDX-License-Identifier: Apache-2.0
#include "ui/input/nearest_piece.h"

#include "core/base/units.h"

#include <algorithm>
#include <cmath>
#include <limits>

namespace burin {
namespace {

constexpr double chordTurn = 5.0 * pi / 180.0; // rad, angle of the chords that approximate an arc in the search
constexpr double chordSlack = 8.0;             // pixels by which an arc may deviate from such a chord in the picture
constexpr double end = 1e-6;                   // share of a piece: points this close to an end are the end

double distanceToLine(const QPointF& place, const QPointF& from, const QPointF& to) {
    const QPointF along = to - from;
    const double square = QPointF::dotProduct(along, along);
    const double share = square > 0.0 ? std::clamp(QPointF::dotProduct(place - from, along) / square, 0.0, 1.0) : 0.0;
    const QPointF off = place - (from + share * along);
    return std::hypot(off.x(), off.y());
}

double snapped(double share) {
    return share < end ? 0.0 : share > 1.0 - end ? 1.0 : share;
}

/// In perspective, nearer parts appear longer, so halves of the picture are not halves of the piece.
double shareOnLine(const QPointF& pointer, const glm::dvec3& from, const glm::dvec3& to, const Appearance& appearance) {
    constexpr int halvings = 24; // precision: a ten-millionth of the piece
    const QPointF along = appearance(to) - appearance(from);
    double low = 0.0, high = 1.0;
    for (int i = 0; i < halvings; ++i) {
        const double middle = 0.5 * (low + high);
        const bool before = QPointF::dotProduct(pointer - appearance(glm::mix(from, to, middle)), along) > 0.0;
        (before ? low : high) = middle;
    }
    return snapped(0.5 * (low + high));
}

struct Found {
    double distance = std::numeric_limits<double>::infinity(); // pixels
    double share = 0.0;
};

/// On an arc: finds the nearest chord, then refines by ternary search around it. @param within pixels; points farther
/// away are not found
Found nearestOnArc(const QPointF& pointer, const Arc& arc, const Appearance& appearance, double within) {
    const ArcTurn turn = turnOf(arc);
    const double chords = std::max(1.0, std::ceil(std::abs(turn.sweep) / chordTurn));
    const auto appears = [&](double share) { return appearance(placeOn(arc, turn, share)); };
    const auto distanceAt = [&](double share) {
        const QPointF off = appears(share) - pointer;
        return std::hypot(off.x(), off.y());
    };
    double nearest = within + chordSlack, chord = -1.0;
    QPointF last = appears(0.0);
    for (double i = 0.0; i < chords; i += 1.0) {
        const QPointF next = appears((i + 1.0) / chords);
        if (const double distance = distanceToLine(pointer, last, next); distance < nearest) {
            nearest = distance;
            chord = i;
        }
        last = next;
    }
    if (chord < 0.0) return {};
    double low = std::max(0.0, (chord - 1.0) / chords), high = std::min(1.0, (chord + 2.0) / chords);
    while (high - low > 0.1 * end) {
        const double third = (high - low) / 3.0;
        if (distanceAt(low + third) < distanceAt(high - third))
            high -= third;
        else
            low += third;
    }
    const double share = snapped(0.5 * (low + high));
    return {distanceAt(share), share};
}

Found nearestOn(const QPointF& pointer, const PathPiece& piece, const Appearance& appearance, double within) {
    if (piece.arc) return nearestOnArc(pointer, *piece.arc, appearance, within);
    const double distance = distanceToLine(pointer, appearance(piece.from), appearance(piece.to));
    if (!(distance < within)) return {};
    return {distance, shareOnLine(pointer, piece.from, piece.to, appearance)};
}

} // namespace

glm::dvec3 PathPiece::at(double share) const {
    return arc ? placeOn(*arc, turnOf(*arc), share) : glm::mix(from, to, share);
}

std::optional<NearestPlace> nearestPlace(const QPointF& pointer, std::size_t count,
                                         const std::function<std::optional<PathPiece>(std::size_t)>& pieceAt,
                                         const Appearance& appearance) {
    double nearest = pointerReach;
    std::optional<NearestPlace> place;
    for (std::size_t i = 0; i < count; ++i) {
        const std::optional<PathPiece> piece = pieceAt(i);
        if (!piece) continue;
        const Found found = nearestOn(pointer, *piece, appearance, nearest);
        if (!(found.distance < nearest)) continue;
        nearest = found.distance;
        place = NearestPlace{i, found.share};
    }
    return place;
}

} // namespace burin

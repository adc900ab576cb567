// SPDX-FileCopyrightText: 2026 The Burin authors
// SPDX-License-Identifier: Apache-2.0
#pragma once

#include "core/geometry/revolved_piece.h"
#include "core/tool/span.h"

#include <glm/glm.hpp>

#include <algorithm>
#include <cmath>
#include <functional>
#include <limits>

namespace burin::oracles {

/// Distance beyond the lateral surface of a piece, between its end faces or anywhere else, directly from its
/// definition; convex.
inline double beyondSide(const RevolvedPiece& piece, double radius, double height) {
    if (piece.bulgeRadius > 0.0)
        return std::hypot(std::max(radius - piece.bulgeCentreRadius, 0.0), height - piece.bulgeCentreHeight) -
               piece.bulgeRadius;
    const double part = (height - piece.bottom) / (piece.top - piece.bottom);
    const double beyond = radius - (piece.bottomRadius + part * (piece.topRadius - piece.bottomRadius));
    if (!(piece.cornerRadius > 0.0)) return beyond;
    const double out = std::max(radius - (piece.bottomRadius - piece.cornerRadius), 0.0);
    const double below = std::max(piece.bottom + piece.cornerRadius - height, 0.0);
    return std::max(beyond, std::hypot(out, below) - piece.cornerRadius);
}

/// Distance of a point beyond the lateral surface or an end face, mm; negative inside; convex. @param q from the tip
inline double beyondSurface(const RevolvedPiece& piece, const glm::dvec3& q, const glm::dvec3& axis) {
    const double height = glm::dot(q, axis);
    const double side = beyondSide(piece, glm::length(q - height * axis), height);
    return std::max({side, piece.bottom - height, height - piece.top});
}

/// Least value of a convex function by golden section.
inline double leastOfConvex(const std::function<double(double)>& value, double low, double high,
                            double* where = nullptr) {
    constexpr double golden = 0.6180339887498949;
    double a = high - golden * (high - low), b = low + golden * (high - low);
    double atA = value(a), atB = value(b);
    for (int step = 0; step < 75; ++step) {
        if (atA < atB || (atA == atB && step % 2 == 0)) {
            high = b;
            b = a;
            atB = atA;
            a = high - golden * (high - low);
            atA = value(a);
        } else {
            low = a;
            a = b;
            atA = atB;
            b = low + golden * (high - low);
            atB = value(b);
        }
    }
    if (where != nullptr) *where = 0.5 * (low + high);
    return value(0.5 * (low + high));
}

/// A piece with any axis on a straight motion, and one line along Z: everything is searched on the implicit form of the
/// piece, without formulas for sections. In names, t is the part of the motion, 0 … 1, and z the height.
class SearchedLine {
public:
    SearchedLine(const RevolvedPiece& piece, const glm::dvec3& from, const glm::dvec3& to, const glm::dvec3& axis,
                 double x, double y)
        : piece_(piece), from_(from), to_(to), axis_(axis), x_(x), y_(y) {
        depth_ = leastOfConvex([this](double t) { return deepestAt(t); }, 0.0, 1.0, &inside_);
        for (const double end : {0.0, 1.0}) {
            if (const double here = deepestAt(end); here < depth_) {
                depth_ = here;
                inside_ = end;
            }
        }
    }
    /// Least distance beyond the piece's surface (roughly, mm) along the line, at any part of the motion.
    double depth() const { return depth_; }
    /// Only where depth() < 0.
    Span span() const { return {leastEnd(1.0), -leastEnd(-1.0)}; }

private:
    static constexpr double wide = 30.0; ///< mm, more than any piece reaches from its tip

    double beyondAt(double t, double z) const {
        return beyondSurface(piece_, glm::dvec3(x_, y_, z) - (from_ + t * (to_ - from_)), axis_);
    }
    double deepestAt(double t, double* where = nullptr) const {
        const double tip = from_.z + t * (to_.z - from_.z);
        return leastOfConvex([&](double z) { return beyondAt(t, z); }, tip - wide, tip + wide, where);
    }
    /// Lower end of the chord at a part of the motion, or the upper one, negated; infinite where there is no chord.
    double endAt(double t, double side) const {
        double inner = 0.0;
        if (!(deepestAt(t, &inner) < 0.0)) return std::numeric_limits<double>::infinity();
        double outer = inner - 2.0 * side * wide;
        for (int step = 0; step < 60; ++step) {
            const double middle = 0.5 * (inner + outer);
            (beyondAt(t, middle) < 0.0 ? inner : outer) = middle;
        }
        return side * inner;
    }
    /// The ends are convex in t where they exist: golden section that is directed to the part that is known to be
    /// inside.
    double leastEnd(double side) const {
        double low = 0.0, high = 1.0;
        double best = std::min({endAt(inside_, side), endAt(0.0, side), endAt(1.0, side)});
        for (int step = 0; step < 75; ++step) {
            const double a = low + 0.382 * (high - low), b = low + 0.618 * (high - low);
            const double atA = endAt(a, side), atB = endAt(b, side);
            best = std::min({best, atA, atB});
            const bool none = std::isinf(atA) && std::isinf(atB);
            if (none ? inside_ < 0.5 * (a + b) : atA < atB)
                high = b;
            else
                low = a;
        }
        return best;
    }

    RevolvedPiece piece_;
    glm::dvec3 from_, to_, axis_;
    double x_, y_;
    double inside_ = 0.0, depth_ = 0.0;
};

} // namespace burin::oracles

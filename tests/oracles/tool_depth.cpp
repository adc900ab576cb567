// SPDX-FileCopyrightText: 2026 The Burin authors
// SPDX-License-Identifier: Apache-2.0
#include "tests/oracles/tool_depth.h"

#include "tests/oracles/moved_piece.h"

#include <algorithm>
#include <cmath>
#include <numbers>

namespace burin::oracles {
namespace {

constexpr double fullTurn = 2.0 * std::numbers::pi;

glm::dvec3 anyAcross(const glm::dvec3& axis) {
    return glm::normalize(glm::cross(axis, std::abs(axis.x) < 0.5 ? glm::dvec3(1, 0, 0) : glm::dvec3(0, 1, 0)));
}

} // namespace

ToolDepth::ToolDepth(std::span<const RevolvedPiece> pieces, double spacing)
    : pieces_(pieces.begin(), pieces.end()), spacing_(spacing) {
    for (const RevolvedPiece& piece : pieces) {
        const double outline = outlineOf(piece);
        const int steps = std::max(4, static_cast<int>(std::ceil(outline / spacing)));
        for (int i = 0; i <= steps; ++i) {
            const double radius = outline * i / steps;
            const Faces faces = facesAt(piece, radius);
            profile_.push_back({radius, faces.low});
            profile_.push_back({radius, faces.high});
        }
        // A rounding is steep at its outer end, where equal steps of the radius would leave gaps.
        const double corner = piece.cornerRadius;
        const int turns = static_cast<int>(std::ceil(0.5 * std::numbers::pi * corner / spacing));
        for (int i = 0; i <= turns && corner > 0.0; ++i) {
            const double angle = 0.5 * std::numbers::pi * i / turns;
            profile_.push_back({piece.bottomRadius - corner * (1.0 - std::sin(angle)),
                                piece.bottom + corner * (1.0 - std::cos(angle))});
        }
        const int heights = static_cast<int>(std::ceil((piece.top - piece.bottom - corner) / spacing));
        for (int i = 0; i <= heights; ++i) {
            const double part = static_cast<double>(i) / std::max(1, heights);
            profile_.push_back(
                {corner > 0.0 ? piece.bottomRadius : piece.bottomRadius + part * (piece.topRadius - piece.bottomRadius),
                 piece.bottom + corner + part * (piece.top - piece.bottom - corner)});
        }
    }
}

double ToolDepth::at(const ToolPose& pose, const SolidDistance& solid, std::span<const glm::dvec3> ofSolid) const {
    const glm::dvec3 x = anyAcross(pose.axis), y = glm::cross(pose.axis, x);
    const auto distanceAt = [&](const Ring& ring, double angle) {
        return solid(pose.tip + ring.height * pose.axis + ring.radius * (std::cos(angle) * x + std::sin(angle) * y));
    };
    double least = 1e300;
    for (const Ring& ring : profile_) {
        const glm::dvec3 centre = pose.tip + ring.height * pose.axis;
        if (solid(centre) - ring.radius > std::min(least, 0.0)) continue; // no point of the ring is nearer
        const int count = std::max(8, static_cast<int>(std::ceil(fullTurn * ring.radius / spacing_)));
        double angle = 0.0, onRing = 1e300;
        for (int i = 0; i < count; ++i) {
            const double distance = distanceAt(ring, fullTurn * i / count);
            if (distance >= onRing) continue;
            onRing = distance;
            angle = fullTurn * i / count;
        }
        for (double step = 0.5 * fullTurn / count; step * ring.radius > 1e-4; step *= 0.5)
            for (const double side : {-step, step}) {
                const double distance = distanceAt(ring, angle + side);
                if (distance >= onRing) continue;
                onRing = distance;
                angle += side;
            }
        least = std::min(least, onRing);
    }
    for (const glm::dvec3& point : ofSolid) {
        const glm::dvec3 q = point - pose.tip;
        const double height = glm::dot(q, pose.axis), radius = glm::length(q - height * pose.axis);
        for (const RevolvedPiece& piece : pieces_) {
            if (height <= piece.bottom || height >= piece.top || radius >= outlineOf(piece)) continue;
            const Faces faces = facesAt(piece, radius);
            // The distance to the outside along the axis or straight sideways is at least the shortest one.
            const double depth = std::min({height - faces.low, faces.high - height, outlineOf(piece) - radius});
            least = std::min(least, -depth);
        }
    }
    return -least;
}

} // namespace burin::oracles

// SPDX-FileCopyrightText: 2026 The Burin authors
// SPDX-License-Identifier: Apache-2.0
#include "ui/scene/tool_cover.h"

#include "core/base/units.h"
#include "ui/scene/across.h"

#include <algorithm>
#include <array>
#include <cmath>
#include <limits>

namespace burin {
namespace {

constexpr std::array<double, 3> rings{1.3, 2.0, 3.0}; // radii of the cutter from the axis
constexpr int placesPerRing = 12;

/// A half-line in the tool frame.
struct HalfLine {
    glm::dvec3 from, along;
};

/// Whether it passes through the cylinder round a piece.
bool meets(const HalfLine& line, const RevolvedPiece& piece) {
    double low = 0.0, high = std::numeric_limits<double>::infinity();
    const auto narrow = [&](double from, double to) {
        low = std::max(low, std::min(from, to));
        high = std::min(high, std::max(from, to));
    };
    if (std::abs(line.along.z) > 1e-12)
        narrow((piece.bottom - line.from.z) / line.along.z, (piece.top - line.from.z) / line.along.z);
    else if (line.from.z < piece.bottom || line.from.z > piece.top)
        return false;
    const glm::dvec2 from(line.from), along(line.along);
    const double radius = piece.widestRadius(), square = glm::dot(along, along), half = glm::dot(from, along);
    const double outside = glm::dot(from, from) - radius * radius;
    if (square < 1e-24) return outside < 0.0 && low < high;
    const double root = half * half - square * outside;
    if (root <= 0.0) return false;
    narrow((-half - std::sqrt(root)) / square, (-half + std::sqrt(root)) / square);
    return low < high;
}

} // namespace

double coveredShare(const Cutter& cutter, const ToolPose& pose, const CameraView& view) {
    const CameraAxes axes = axesOf(view);
    const auto [x, y] = acrossOf(pose.axis);
    const glm::dvec3 away = axes.eye - pose.tip, eye(glm::dot(away, x), glm::dot(away, y), glm::dot(away, pose.axis));
    const std::vector<RevolvedPiece> stack = pieces(cutter);
    int hidden = 0;
    for (const double ring : rings)
        for (int i = 0; i < placesPerRing; ++i) {
            const double angle = 2.0 * pi * i / placesPerRing, radius = ring * cutter.radius();
            const glm::dvec3 from(radius * std::cos(angle), radius * std::sin(angle), 0.0);
            const HalfLine line{from, glm::normalize(eye - from)};
            for (std::size_t piece = 0; piece < stack.size(); ++piece) {
                if (sectionOf(cutter, piece) == ToolSection::flutes || !meets(line, stack[piece])) continue;
                ++hidden;
                break;
            }
        }
    return static_cast<double>(hidden) / (rings.size() * placesPerRing);
}

} // namespace burin

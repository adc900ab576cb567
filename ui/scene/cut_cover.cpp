// SPDX-FileCopyrightText: 2026 The Burin authors
// SPDX-License-Identifier: Apache-2.0
#include "ui/scene/cut_cover.h"

#include "core/base/units.h"
#include "core/geometry/triangle_ray.h"
#include "ui/scene/across.h"

#include <algorithm>
#include <array>
#include <cmath>
#include <limits>

namespace burin {
namespace {

constexpr std::array<double, 3> rings{1.3, 2.0, 3.0}; // distances from the axis, in radii of the cutter
constexpr int placesPerRing = 12;

constexpr double fadedOpacity = 0.1;               // for each of three or four pieces of a holder behind each other
constexpr double fadesFrom = 0.1, fadedFrom = 0.5; // hidden fraction of the tip's surroundings

/// Whether a ray in the tool frame passes through the bounding cylinder of a piece.
bool meets(const Ray& line, const RevolvedPiece& piece) {
    double low = 0.0, high = std::numeric_limits<double>::infinity();
    const auto narrow = [&](double from, double to) {
        low = std::max(low, std::min(from, to));
        high = std::min(high, std::max(from, to));
    };
    if (std::abs(line.direction.z) > 1e-12)
        narrow((piece.bottom - line.origin.z) / line.direction.z, (piece.top - line.origin.z) / line.direction.z);
    else if (line.origin.z < piece.bottom || line.origin.z > piece.top)
        return false;
    const glm::dvec2 from(line.origin), along(line.direction);
    const double radius = piece.widestRadius(), square = glm::dot(along, along), half = glm::dot(from, along);
    const double outside = glm::dot(from, from) - radius * radius;
    if (square < 1e-24) return outside < 0.0 && low < high;
    const double root = half * half - square * outside;
    if (root <= 0.0) return false;
    narrow((-half - std::sqrt(root)) / square, (-half + std::sqrt(root)) / square);
    return low < high;
}

/// The fraction of the surroundings of a tip from which the sight line to the eye is blocked.
/// @param hides takes the sight line with its full length as direction
template <class Hides>
double hiddenShare(const CutPlace& cut, const CameraView& view, const Hides& hides) {
    const glm::dvec3 eye = axesOf(view).eye;
    const auto [x, y] = acrossOf(cut.pose.axis);
    int hidden = 0;
    for (const double ring : rings)
        for (int i = 0; i < placesPerRing; ++i) {
            const double angle = 2.0 * pi * i / placesPerRing, radius = ring * cut.radius;
            const glm::dvec3 place = cut.pose.tip + radius * (std::cos(angle) * x + std::sin(angle) * y);
            if (hides(Ray{place, eye - place})) ++hidden;
        }
    return static_cast<double>(hidden) / (rings.size() * placesPerRing);
}

} // namespace

double coveredShare(const Cutter& cutter, const ToolPose& pose, const CameraView& view) {
    const auto [x, y] = acrossOf(pose.axis);
    const auto inToolFrame = [&, x = x, y = y](const glm::dvec3& v) {
        return glm::dvec3(glm::dot(v, x), glm::dot(v, y), glm::dot(v, pose.axis));
    };
    const std::vector<RevolvedPiece> stack = pieces(cutter);
    return hiddenShare({pose, cutter.radius()}, view, [&](const Ray& sight) {
        const Ray line{inToolFrame(sight.origin - pose.tip), inToolFrame(glm::normalize(sight.direction))};
        for (std::size_t piece = 0; piece < stack.size(); ++piece)
            if (sectionOf(cutter, piece) != ToolSection::flutes && meets(line, stack[piece])) return true;
        return false;
    });
}

double coveredShare(const TriangleTree& solid, const CutPlace& cut, const CameraView& view) {
    return hiddenShare(cut, view, [&](const Ray& sight) {
        const std::optional<TriangleHit> hit = nearestHit(sight, solid);
        return hit && !hit->leaving && hit->distance < 1.0; // nearer than the eye
    });
}

double opacityOver(double coveredShare) {
    const double share = std::clamp((coveredShare - fadesFrom) / (fadedFrom - fadesFrom), 0.0, 1.0);
    return 1.0 - share * (1.0 - fadedOpacity);
}

} // namespace burin

// SPDX-FileCopyrightText: 2026 The Burin authors
// SPDX-License-Identifier: Apache-2.0
#include "ui/input/press_preview.h"

#include "core/base/units.h"
#include "core/volume/operations/ray_cast.h"
#include "ui/scene/across.h"

#include <algorithm>
#include <cmath>
#include <limits>

namespace burin {
namespace {

constexpr int rings = 8;             // of sample points on the cutter, from its axis to its edge
constexpr int placesPerRing = 6;     // on the innermost ring; the k-th has k times as many
constexpr double insideEdge = 0.999; // of the radius

/// Height of the flutes' surface above the tip, seen from below, mm.
double undersideAt(const std::vector<RevolvedPiece>& flutes, double radius) {
    double lowest = std::numeric_limits<double>::infinity();
    for (const RevolvedPiece& piece : flutes)
        if (const std::optional<HeightRange> heights = heightsAt(piece, radius))
            lowest = std::min(lowest, heights->low);
    return lowest;
}

/// The contact that limits the cutter's descent.
struct Rest {
    double lift = 0.0; ///< mm along the axis, from the target position of the tip
    glm::dvec3 place{0.0};
};

/// Finds the highest point of the part under each point of the cutter's underside.
class Probe {
public:
    Probe(const VolumeSnapshot& workpiece, const glm::dvec3& tip, const glm::dvec3& axis)
        : workpiece_(workpiece), tip_(tip), axis_(axis) {
        const Box box = workpiece.grid().box();
        for (unsigned corner = 0; corner < 8; ++corner)
            above_ = std::max(above_, glm::dot(box.corner(corner) - tip, axis) + 1.0);
    }
    /// Casts a ray down along the axis, at an offset from it. @return empty if nothing is hit
    std::optional<RayHit> below(const glm::dvec3& aside, RayTarget target) const {
        return castRay(workpiece_, tip_ + aside + axis_ * above_, -axis_, target);
    }
    void feel(const glm::dvec3& aside, double underside, std::optional<Rest>& highest) const {
        const std::optional<RayHit> hit = below(aside, RayTarget::protectedOnly);
        if (!hit) return;
        const double lift = above_ - hit->distance - underside;
        if (!highest || lift > highest->lift) highest = Rest{lift, hit->place};
    }

private:
    const VolumeSnapshot& workpiece_;
    glm::dvec3 tip_, axis_;
    double above_ = 0.0; ///< mm above the tip: above everything
};

std::optional<Rest> restOf(const Probe& probe, const Cutter& cutter, const glm::dvec3& axis) {
    const std::vector<RevolvedPiece> flutes = flutePieces(cutter);
    const auto [x, y] = acrossOf(axis);
    std::optional<Rest> highest;
    probe.feel(glm::dvec3(0.0), undersideAt(flutes, 0.0), highest);
    for (int ring = 1; ring <= rings; ++ring) {
        const double radius = cutter.radius() * insideEdge * ring / rings, underside = undersideAt(flutes, radius);
        if (!std::isfinite(underside)) continue;
        for (int i = 0; i < ring * placesPerRing; ++i) {
            const double angle = 2.0 * pi * i / (ring * placesPerRing);
            probe.feel(radius * (std::cos(angle) * x + std::sin(angle) * y), underside, highest);
        }
    }
    return highest;
}

} // namespace

std::optional<PressMark> pressPreview(const VolumeSnapshot& workpiece, const Cutter& cutter, const glm::dvec3& aimed,
                                      const glm::dvec3& axis, double allowance) {
    if (workpiece.empty()) return std::nullopt;
    const Probe probe(workpiece, aimed, axis);
    const std::optional<RayHit> surface = probe.below(glm::dvec3(0.0), RayTarget::anything);
    if (!surface) return std::nullopt;
    PressMark mark{aimed, axis, cutter.radius(), glm::dot(surface->place - aimed, axis), std::nullopt};
    const std::optional<Rest> rest = restOf(probe, cutter, axis);
    if (rest && rest->lift + allowance >= 0.0) {
        const double lift = rest->lift + allowance;
        mark.tip += axis * lift;
        mark.depth -= lift;
        mark.contact = rest->place;
    }
    return mark;
}

} // namespace burin

// SPDX-FileCopyrightText: 2026 The Burin authors
// SPDX-License-Identifier: Apache-2.0
#include "core/volume/surface/fitted_face.h"

#include "core/base/units.h"
#include "core/geometry/frame_along.h"
#include "core/volume/surface/surface_patch.h"

#include <algorithm>
#include <array>
#include <cmath>
#include <limits>
#include <utility>

namespace burin {

namespace {

using Kind = FittedSurface::Kind;

constexpr std::array radii{3.0, 5.0, 8.0, 13.0, 21.0, 34.0, 60.0}; ///< voxels around the point, step by step
constexpr std::size_t startsOfRound =
    4;                                ///< a round face may look flat next to the point: this many first radii are tried
constexpr double agreedWithin = 0.75; ///< voxels
constexpr double agreedAngle = 35.0 * pi / 180.0;
constexpr double firstAngle = 50.0 * pi / 180.0;  ///< from the point's own normal, for the first fit
constexpr double smoothAngle = 15.0 * pi / 180.0; ///< from point to point: an edge turns by more
constexpr double smoothReach = 12.0;              ///< voxels: what is smooth within it has to be explained
constexpr double explainedShare = 0.5;
constexpr std::size_t fewest = 12;
/// Voxels: the surface rounds its edges, and its corners, by about 2.5 voxels.
constexpr double leastRadius = 2.7, leastOther = 4.0; // of a hole; of a boss or a sphere
constexpr double smallFace = 8.0;                     ///< voxels: the smoothing of the surface reaches its middle
/// A simpler surface is taken if it explains this share of what the others do.
constexpr double simplerShare = 0.75;
/// Or if it deviates so much less than they do from what is next to the point: an arc from the floor of a
/// shallow slot to the faces beside it explains more than the floor does, but nothing well.
constexpr double betterTimes = 0.5;
constexpr double nextReach = 6.0; ///< voxels

struct Fit {
    FittedSurface surface;
    std::vector<SurfacePoint> points;
    double weight = 0.0; ///< the number of points that agree, each by how well it does
};

class FaceSearch {
public:
    FaceSearch(const SurfacePatch& patch, std::uint32_t start, double voxel)
        : patch_(patch), start_(start), from_(patch.points()[start]), voxel_(voxel) {
        smooth_ = within(smoothReach, [](const SurfacePoint& one, const SurfacePoint& other) {
            return glm::dot(one.normal, other.normal) >= std::cos(smoothAngle);
        });
        next_ = facingPoints(nextReach);
    }

    /// The surface of that kind that explains most.
    std::optional<Fit> best(Kind kind) const {
        std::optional<Fit> best;
        for (std::size_t start = 0; start < (kind == Kind::plane ? 1 : startsOfRound); ++start) {
            std::optional<Fit> fit = grown(kind, start);
            if (fit && explains(*fit) && (!best || fit->weight > best->weight)) best = std::move(fit);
        }
        return best;
    }

    /// voxels, root mean square, from what is next to the point.
    double deviation(const FittedSurface& surface) const {
        double sum = 0.0;
        for (const SurfacePoint& point : next_) {
            const double away = surface.distance(point.place) / voxel_;
            sum += away * away;
        }
        return std::sqrt(sum / static_cast<double>(next_.size()));
    }

    /// The mean normal next to the point.
    glm::dvec3 meanNormal() const {
        glm::dvec3 sum = from_.normal;
        for (const std::uint32_t other : patch_.neighbours(start_)) sum += patch_.points()[other].normal;
        return glm::length(sum) > 0.0 ? glm::normalize(sum) : from_.normal;
    }

private:
    /// Fits a surface within one of the radii, then extends it as far as it agrees with the points.
    std::optional<Fit> grown(Kind kind, std::size_t start) const {
        std::vector<SurfacePoint> points = facingPoints(radii[start]);
        std::optional<FittedSurface> surface;
        for (std::size_t i = start; i <= radii.size(); ++i) { // the last radius twice
            surface = fitSurface(kind, points);
            if (!surface || !agrees(*surface, from_)) return std::nullopt;
            points = within(radii[std::min(i, radii.size() - 1)],
                            [&](const SurfacePoint&, const SurfacePoint& point) { return agrees(*surface, point); });
            if (points.size() < fewest) return std::nullopt;
        }
        surface = fitSurface(kind, withoutBorder(*surface, points));
        if (!surface || !agrees(*surface, from_) || isRoundedEdge(*surface)) return std::nullopt;
        Fit fit{*surface, std::move(points), 0.0};
        for (const SurfacePoint& point : fit.points) fit.weight += agreement(*surface, point);
        return fit;
    }
    /// Whether a fit explains most of what is smooth around the point.
    bool explains(const Fit& fit) const {
        const auto agreeing =
            std::ranges::count_if(smooth_, [&](const SurfacePoint& point) { return agrees(fit.surface, point); });
        return static_cast<double>(agreeing) >= explainedShare * static_cast<double>(smooth_.size());
    }
    bool isRoundedEdge(const FittedSurface& surface) const {
        return surface.kind != Kind::plane &&
               surface.radius <
                   (surface.kind == Kind::sphere || surface.side > 0.0 ? leastOther : leastRadius) * voxel_;
    }
    bool agrees(const FittedSurface& surface, const SurfacePoint& point) const {
        return agreement(surface, point) > 0.0;
    }
    /// 0 … 1, by distance and angle (a soft inlier count as in MSAC; Torr & Zisserman 2000).
    double agreement(const FittedSurface& surface, const SurfacePoint& point) const {
        const double away = surface.distance(point.place) / (agreedWithin * voxel_);
        const double turned = 1.0 - glm::dot(surface.normal(point.place), point.normal);
        return std::max(0.0, 1.0 - away * away) * std::max(0.0, 1.0 - turned / (1.0 - std::cos(agreedAngle)));
    }
    /// Points within a radius, voxels, with nearly the normal of the start, the start among them.
    std::vector<SurfacePoint> facingPoints(double radius) const {
        return within(radius, [&](const SurfacePoint&, const SurfacePoint& point) {
            return glm::dot(point.normal, from_.normal) >= std::cos(firstAngle);
        });
    }
    template <typename Accept>
    std::vector<SurfacePoint> within(double radius, const Accept& accept) const {
        std::vector<SurfacePoint> found;
        for (const std::uint32_t each : patch_.connected(start_, [&](const SurfacePoint&one, const SurfacePoint&other) {
                 return glm::distance(other.place, from_.place) <= radius * voxel_ && accept(one, other);
             }))
            found.push_back(patch_.points()[each]);
        return found;
    }
    /// Points at a bevelled edge agree roughly and would shift the fit: those that deviate far more than most are left
    /// out.
    std::vector<SurfacePoint> withoutBorder(const FittedSurface& surface,
                                            const std::vector<SurfacePoint>& points) const {
        std::vector<double> deviations, turns;
        for (const SurfacePoint& point : points) {
            deviations.push_back(std::abs(surface.distance(point.place)));
            turns.push_back(1.0 - glm::dot(surface.normal(point.place), point.normal));
        }
        const auto limitOf = [](std::vector<double> values, double least) {
            const auto middle = values.begin() + static_cast<std::ptrdiff_t>(values.size() / 2);
            std::ranges::nth_element(values, middle);
            return 3.0 * *middle + least;
        };
        const double farthest = limitOf(deviations, 0.01 * voxel_), steepest = limitOf(turns, 0.002);
        std::vector<SurfacePoint> kept;
        for (std::size_t i = 0; i < points.size(); ++i)
            if (deviations[i] <= farthest && turns[i] <= steepest) kept.push_back(points[i]);
        return kept;
    }

    const SurfacePatch& patch_;
    std::uint32_t start_;
    SurfacePoint from_;
    double voxel_;
    std::vector<SurfacePoint> smooth_; ///< what is connected to the point without an edge
    std::vector<SurfacePoint> next_;   ///< what is next to the point and faces the same way
};

/// The radius of an arc that is seen over less than half a turn is the more uncertain the flatter it is: its rise is
/// r (1 - cos) of half its angle.
double radiusUncertainty(const Fit& fit, double within) {
    double least = 1.0; // cosine of half the angle
    const glm::dvec3 middle = fit.surface.normal(fit.points.front().place);
    for (const SurfacePoint& point : fit.points)
        least = std::min(least, glm::dot(middle, fit.surface.normal(point.place)));
    return within / std::clamp(1.0 - least, 1e-6, 1.0);
}

/// Whether the points determine the radius to a half of it.
bool hasRadius(const Fit& fit, double voxel) {
    return fit.surface.kind == Kind::plane || radiusUncertainty(fit, 0.5 * voxel) <= 0.5 * fit.surface.radius;
}

std::optional<Fit> bestFit(const FaceSearch& search, double voxel) {
    std::array<std::optional<Fit>, 3> fits;
    constexpr double none = std::numeric_limits<double>::infinity();
    std::array<double, 4> deviations{none, none, none, none}; // one more than surfaces: none is rounder than a sphere
    double most = 0.0;
    for (const Kind kind : {Kind::plane, Kind::cylinder, Kind::sphere}) {
        const auto which = static_cast<std::size_t>(kind);
        std::optional<Fit>& fit = fits[which];
        fit = search.best(kind);
        if (fit && !hasRadius(*fit, voxel)) fit.reset();
        if (fit) most = std::max(most, fit->weight);
        if (fit) deviations[which] = search.deviation(fit->surface);
    }
    for (std::size_t i = 0; i < fits.size(); ++i) {
        if (!fits[i]) continue;
        const double rounder =
            *std::min_element(deviations.begin() + static_cast<std::ptrdiff_t>(i) + 1, deviations.end());
        const bool isBetter = rounder < none && deviations[i] <= betterTimes * rounder;
        if (isBetter || fits[i]->weight >= simplerShare * most) return std::move(fits[i]);
    }
    return std::nullopt;
}

/// mm, the length of a face along a direction.
double lengthAlong(const Fit& fit, const glm::dvec3& direction) {
    double low = 0.0, high = 0.0;
    for (const SurfacePoint& point : fit.points) {
        const double along = glm::dot(point.place - fit.points.front().place, direction);
        low = std::min(low, along);
        high = std::max(high, along);
    }
    return high - low;
}

/// mm, the lesser extent of a plane's points.
double widthOf(const Fit& fit) {
    double width = 1e300;
    const glm::dvec3 one = anyAcross(fit.surface.axis), other = glm::cross(fit.surface.axis, one);
    for (int i = 0; i < 8; ++i) {
        const double angle = i * pi / 8.0;
        width = std::min(width, lengthAlong(fit, std::cos(angle) * one + std::sin(angle) * other));
    }
    return width;
}

} // namespace

double surfaceUncertainty(const Grid& grid, const glm::dvec3& normal) noexcept {
    const double alongRuns = std::abs(normal[grid.axisOfRuns()]);
    if (alongRuns > 0.99999) return grid.edge() / 200.0;
    return (alongRuns >= std::sqrt(0.5) ? 0.05 : 0.5) * grid.edge();
}

std::optional<FittedFace> fittedFaceAt(const VolumeSnapshot& workpiece, const glm::dvec3& place) {
    const std::optional<SurfacePoint> nearest = nearestOnSurface(workpiece, place);
    if (!nearest) return std::nullopt;
    const Grid& grid = workpiece.grid();
    const SurfacePatch patch(workpiece, nearest->place, radii.back() * grid.edge());
    FittedFace face;
    face.place = nearest->place;
    face.normal = nearest->normal;
    const std::optional<std::uint32_t> start = patch.nearest(nearest->place);
    if (start) {
        const FaceSearch search(patch, *start, grid.edge());
        face.normal = search.meanNormal();
        if (const std::optional<Fit> fit = bestFit(search, grid.edge())) {
            face.surface = fit->surface;
            face.place = fit->surface.closest(nearest->place);
            face.normal = fit->surface.normal(face.place);
            face.within = surfaceUncertainty(grid, face.normal);
            const bool isPlane = fit->surface.kind == Kind::plane;
            if (isPlane && widthOf(*fit) < smallFace * grid.edge())
                face.within = std::max(face.within, 0.25 * grid.edge());
            if (!isPlane) face.radiusWithin = radiusUncertainty(*fit, 0.5 * grid.edge());
            if (fit->surface.kind != Kind::sphere) {
                const double extent = isPlane ? widthOf(*fit) : lengthAlong(*fit, fit->surface.axis);
                face.angleWithin = std::atan2(2.0 * face.within, extent);
            }
            return face;
        }
    }
    face.within = surfaceUncertainty(grid, face.normal);
    return face;
}

} // namespace burin

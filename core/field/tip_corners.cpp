// SPDX-FileCopyrightText: 2026 The Burin authors
// SPDX-License-Identifier: Apache-2.0
#include "core/field/tip_corners.h"

#include "core/field/cube.h"
#include "core/field/spread.h"

#include <limits>

namespace burin {

namespace {

const glm::vec3 notAsked(std::numeric_limits<float>::infinity()); // marks a gradient that was not evaluated
constexpr int farApart = 4;                                       // bricks, between corners that are always evaluated
constexpr double tolerance = 1e-4;                                // voxels

float roundedDown(double value) noexcept {
    const auto nearest = static_cast<float>(value);
    return static_cast<double>(nearest) > value ? std::nextafter(nearest, -std::numeric_limits<float>::infinity())
                                                : nearest;
}

/// By how much a value between a cube's corners may exceed the clearance, which changes no faster than the tip moves
/// and has no greater curvature than the distance from a ball.
double interpolationExcess(double least, double edge) noexcept {
    const double reach = halfDiagonal * edge, away = least - reach;
    return away > 0.0 ? std::min(reach, 0.375 * edge * edge / away) : reach;
}

} // namespace

TipCorners::TipCorners(const MeshDistance& part, const ToolFieldRequest& request, const FieldResolution& resolution,
                       BrickField& field)
    : part_(part), request_(request), resolution_(resolution), field_(field), samples_(field.cornerCount()) {}

double TipCorners::nearEnough(const FieldResolution& resolution, double edge) noexcept {
    return std::max(std::hypot(resolution.high, std::sqrt(0.5) * edge), resolution.clear + halfDiagonal * edge) + 1e-6;
}

void TipCorners::sample(Progress& progress, double from, double to) {
    const auto at = [&](double share) { return from + share * (to - from); };
    sampleAt(farApart, 0, progress, from, at(0.2));
    sampleAt(2, farApart, progress, at(0.2), at(0.5));
    sampleAt(1, 2, progress, at(0.5), to);
    for (std::size_t i = 0; i < samples_.size(); ++i) {
        const auto distance = static_cast<double>(samples_[i].clearance.distance);
        field_.corners[i] = roundedDown(distance - tolerance * request_.voxel - 1e-6 - 1.2e-7 * std::abs(distance));
    }
    boundCoarseBricks();
}

/// The last corners belong to every step, so that each corner lies on a cube.
bool TipCorners::isAt(const glm::ivec3& corner, int step) const noexcept {
    for (int axis = 0; axis < 3; ++axis)
        if (corner[axis] % step != 0 && corner[axis] != field_.bricks[axis]) return false;
    return true;
}

/// Evaluates corners `step` bricks apart; those that are `above` bricks apart are known, none if that is 0.
void TipCorners::sampleAt(int step, int above, Progress& progress, double from, double to) {
    const int rows = field_.bricks.y + 1;
    const auto count = static_cast<std::size_t>(rows) * static_cast<std::size_t>(field_.bricks.z + 1);
    const double deep = -1.5 * field_.brickEdge(); // below any band: an error of a voxel is acceptable there
    spreadIntervals(count, from, to, progress, [&](std::size_t first, std::size_t end) {
        TipAsker asker(part_, request_, {tolerance * request_.voxel, deep, request_.voxel});
        for (std::size_t row = first; row < end && !progress.cancelled(); ++row)
            for (int i = 0; i <= field_.bricks.x; ++i) {
                const glm::ivec3 corner(i, static_cast<int>(row) % rows, static_cast<int>(row) / rows);
                if (!isAt(corner, step) || (above > 0 && isAt(corner, above))) continue;
                TipSample& sample = samples_[field_.cornerAt(corner)];
                if (const auto safe = above > 0 ? safeValue(corner, above) : std::nullopt) {
                    sample = {{static_cast<float>(*safe), notAsked}, 1.0F};
                    continue;
                }
                sample = asker.ask(field_.brickLow(corner));
                float& distance = sample.clearance.distance;
                if (static_cast<double>(distance) < deep) distance -= static_cast<float>(request_.voxel);
            }
    });
}

/// A lower bound for a corner between those `step` bricks apart, if no cube that it lies on may contain the band.
std::optional<double> TipCorners::safeValue(const glm::ivec3& corner, int step) const noexcept {
    double value = farthestClearance;
    for (int side = 0; side < 8; ++side) {
        Cube cube;
        bool inside = true;
        for (int axis = 0; axis < 3; ++axis) {
            const int from = corner[axis] - ((side >> axis) & 1);
            inside = inside && from >= 0 && from < field_.bricks[axis];
            cube.low[axis] = from / step * step;
            cube.high[axis] = std::min(cube.low[axis] + step, field_.bricks[axis]);
        }
        if (!inside) continue;
        const std::optional<double> there = safeValue(corner, cube);
        if (!there) return std::nullopt;
        value = std::min(value, *there);
    }
    return value;
}

/// Empty if the cube may contain the band, or the value is too low for coarse bricks to show that the tool is clear
/// there. A tip with the band's clearance is that near to a position where the tool touches, and half a face's diagonal
/// limits how far that position is from the nearest corner (`nearEnough`); no tip is less deep than a corner is, minus
/// the distance to it. If a corner was not evaluated, the larger cube around it decided this.
std::optional<double> TipCorners::safeValue(const glm::ivec3& corner, const Cube& cube) const noexcept {
    const glm::ivec3 size = cube.high - cube.low;
    const double edge = field_.brickEdge() * std::max({size.x, size.y, size.z});
    double least = farthestClearance, most = -farthestClearance, sum = 0.0;
    bool asked = true;
    for (int i = 0; i < 8; ++i) {
        const glm::ivec3 at = cube.low + size * cornerOf(i);
        const DistanceSample& sample = samples_[field_.cornerAt(at)].clearance;
        const auto distance = static_cast<double>(sample.distance);
        const glm::dvec3 share = glm::abs(glm::dvec3(corner - at)) / glm::dvec3(size);
        asked = asked && !std::isinf(sample.gradient.x);
        least = std::min(least, distance);
        most = std::max(most, distance);
        sum += (1.0 - share.x) * (1.0 - share.y) * (1.0 - share.z) * distance;
    }
    const bool deep = most + request_.voxel + halfDiagonal * edge < resolution_.low;
    const double brick = nearEnough(resolution_, field_.brickEdge()); // least value of the corners of coarse bricks
    if (asked && !deep && least <= std::max(nearEnough(resolution_, edge), brick + halfDiagonal * edge))
        return std::nullopt;
    const double value = sum - interpolationExcess(least, edge);
    if (most > 0.0 && value <= brick) return std::nullopt;
    return value;
}

void TipCorners::boundCoarseBricks() {
    for (std::size_t number = 0; number < field_.brickCount(); ++number) {
        const glm::ivec3 brick = field_.brickOf(number);
        double least = farthestClearance;
        for (int i = 0; i < 8; ++i)
            least = std::min(least, static_cast<double>(field_.corners[field_.cornerAt(brick + cornerOf(i))]));
        const double bound = interpolationExcess(least, field_.brickEdge());
        field_.coarseBound[number] = static_cast<float>(bound * (1.0 + 1e-6) + 1e-6);
    }
}

bool TipCorners::mayHoldBand(const glm::ivec3& brick, TipAsker& asker) const {
    const double edge = field_.brickEdge(), radius = halfDiagonal * edge;
    double least = farthestClearance, most = -farthestClearance;
    for (int i = 0; i < 8; ++i) {
        const DistanceSample& corner = samples_[field_.cornerAt(brick + cornerOf(i))].clearance;
        if (std::isinf(corner.gradient.x)) return false; // far away, or deep
        least = std::min(least, static_cast<double>(corner.distance));
        most = std::max(most, static_cast<double>(corner.distance));
    }
    if (least > nearEnough(resolution_, edge) || most + request_.voxel + radius < resolution_.low) return false;
    if (most >= resolution_.low) return true;
    return static_cast<double>(asker.ask(field_.brickLow(brick) + 0.5 * edge).clearance.distance) + radius >=
           resolution_.low;
}

} // namespace burin

// SPDX-FileCopyrightText: 2026 The Burin authors
// SPDX-License-Identifier: Apache-2.0
#include "core/volume/surface/surface_materials.h"

#include "core/base/whole_registers.h"

#include <algorithm>

namespace burin {

namespace {

static_assert(SurfaceMaterials::spare >= lanes);
using Place = SurfaceMaterials::Place;
using Frame = SurfaceMaterials::Frame;

/// Below a point, voxels. Down to this depth the part takes precedence over what lies on it.
constexpr std::array<float, 3> partDepths{0.3F, 0.6F, 0.9F};

/// The components of eight vectors along u, v and the runs; one number behind them is read.
struct EightVectors {
    Floats along[3];
};
template <int axisOfRuns>
BURIN_INLINE EightVectors eightAt(const glm::vec3* vectors) noexcept {
    const auto [xyz] = eight_lanes::foursAt<Floats, 3>(&vectors->x); // and the next vector's x
    return {{xyz[(axisOfRuns + 1) % 3], xyz[(axisOfRuns + 2) % 3], xyz[axisOfRuns]}};
}
BURIN_INLINE Integers clamped(Integers values, std::int32_t end) noexcept {
    return least(most(values, integers(0)), integers(end - 1));
}

/// Positions outside the grid are moved to its border.
template <int axisOfRuns>
BURIN_INLINE void placesAlong(const Frame& frame, const glm::vec3* points, const glm::vec3* normals, std::size_t count,
                              float depth, Place* places) noexcept {
    for (std::size_t i = 0; i < count; i += lanes) {
        const EightVectors point = eightAt<axisOfRuns>(points + i), normal = eightAt<axisOfRuns>(normals + i);
        const auto below = [&](std::size_t axis) noexcept { // voxels from the grid's low end
            return (point.along[axis] - frame.low[axis]) * frame.perMillimetre - depth * normal.along[axis];
        };
        const Integers u = clamped(wholeOf(below(0)), frame.count[0]), v = clamped(wholeOf(below(1)), frame.count[1]);
        const Integers line = (v - frame.first[1]) * frame.step + (u - frame.first[0]);
        const Integers position = clamped(wholeOf(below(2) * float{unitsPerVoxel} + 0.5F), frame.count[2]);
        const Integers low = __builtin_shufflevector(line, position, 0, 8, 1, 9, 2, 10, 3, 11),
                       high = __builtin_shufflevector(line, position, 4, 12, 5, 13, 6, 14, 7, 15);
        static_assert(sizeof(Place) * lanes == sizeof low + sizeof high);
        __builtin_memcpy(static_cast<void*>(places + i), &low, sizeof low);
        __builtin_memcpy(static_cast<void*>(places + i + lanes / 2), &high, sizeof high);
    }
}
BURIN_VECTORISED void placesBelow(const Frame& frame, const glm::vec3* points, const glm::vec3* normals,
                                  std::size_t count, float depth, Place* places) noexcept {
    switch (frame.axisOfRuns) {
    case 0:
        return placesAlong<0>(frame, points, normals, count, depth, places);
    case 1:
        return placesAlong<1>(frame, points, normals, count, depth, places);
    default:
        return placesAlong<2>(frame, points, normals, count, depth, places);
    }
}

Frame frameOf(const Grid& grid, const SurfaceWindow& window, const SurfaceLines& lines) {
    Frame frame;
    frame.axisOfRuns = grid.axisOfRuns();
    const std::array axes{grid.axisOfU(), grid.axisOfV(), grid.axisOfRuns()};
    for (std::size_t i = 0; i < 3; ++i) frame.low[i] = static_cast<float>(grid.low()[axes[i]]);
    frame.perMillimetre = static_cast<float>(1.0 / grid.edge());
    frame.first = {window.firstU << window.level, window.firstV << window.level};
    frame.count = {grid.lineCountU(), grid.lineCountV(), static_cast<std::int32_t>(grid.lineEnd())};
    frame.step = static_cast<std::int32_t>(lines.step());
    return frame;
}

} // namespace

void SurfaceMaterials::find(const VolumeSnapshot& workpiece, const SurfaceWindow& window, const SurfaceLines& lines,
                            std::span<const glm::vec3> points, const glm::vec3* normals, PropertyIndex* properties) {
    const PropertyList& list = workpiece.properties();
    frame_ = frameOf(workpiece.grid(), window, lines);
    const std::size_t depths = lines.holdsProtected(list) ? partDepths.size() : 1;
    for (std::size_t depth = 0; depth < depths; ++depth) {
        if (places_[depth].size() < points.size() + spare) places_[depth].resize(2 * points.size() + spare);
        placesBelow(frame_, points.data(), normals, points.size(), partDepths[depth], places_[depth].data());
    }
    const SurfaceLines::Materials materials(lines);
    const Place* const first = places_[0].data();
    for (std::size_t i = 0; i < points.size(); ++i) properties[i] = materials.at(first[i].line, first[i].position);
    for (std::size_t depth = 1; depth < depths; ++depth)
        for (std::size_t i = 0; i < points.size(); ++i) {
            const PropertyIndex property = materials.at(places_[depth][i].line, places_[depth][i].position);
            const bool counts =
                properties[i] == airProperty || (list.isProtected(property) && !list.isProtected(properties[i]));
            if (counts) properties[i] = property;
        }
    const std::array further{0.6F, 0.9F, 1.3F, 1.8F, 1.8F * static_cast<float>(window.cell())};
    const std::span<PropertyIndex> all(properties, points.size());
    for (auto found = std::ranges::find(all, airProperty); found != all.end();
         found = std::find(found + 1, all.end(), airProperty)) {
        const auto i = static_cast<std::size_t>(found - all.begin());
        *found = search(lines, points.subspan(i), normals + i, further);
    }
}

/// For points where the first depths found nothing: deeper, then (a splinter thinner than that) in the neighbouring
/// voxels.
PropertyIndex SurfaceMaterials::search(const SurfaceLines& lines, std::span<const glm::vec3> point,
                                       const glm::vec3* normal, std::span<const float> depths) const {
    const SurfaceLines::Materials materials(lines);
    std::array<Place, lanes> places;
    for (const float depth : depths) {
        placesBelow(frame_, point.data(), normal, 1, depth, places.data());
        const PropertyIndex property = materials.at(places[0].line, places[0].position);
        if (property != airProperty) return property;
    }
    constexpr auto half = static_cast<std::int32_t>(unitsPerVoxel / 2);
    placesBelow(frame_, point.data(), normal, 1, 0.0F, places.data());
    for (std::int32_t v = -1; v <= 1; ++v)
        for (std::int32_t u = -1; u <= 1; ++u)
            for (std::int32_t n = -2; n <= 2; ++n) {
                const PropertyIndex property =
                    materials.at(places[0].line + v * frame_.step + u, places[0].position + n * half);
                if (property != airProperty) return property;
            }
    return airProperty;
}

} // namespace burin

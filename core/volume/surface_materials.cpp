// SPDX-FileCopyrightText: 2026 The Burin authors
// SPDX-License-Identifier: Apache-2.0
#include "core/volume/surface_materials.h"

#include "core/base/vectorised.h"

namespace burin {

namespace {

static_assert(SurfaceMaterials::spare >= lanes);
using Place = SurfaceMaterials::Place;
using Frame = SurfaceMaterials::Frame;

/// Below a point, voxels. So far down the part counts for more than what lies on it.
constexpr std::array<float, 3> partDepths{0.3F, 0.6F, 0.9F};

/// One coordinate of eight vectors.
BURIN_INLINE Floats eightOf(const glm::vec3* vectors, int axis) noexcept {
    const float* const at = &vectors->x + axis;
    return Floats{at[0], at[3], at[6], at[9], at[12], at[15], at[18], at[21]};
}
/// Voxels from the grid's low end at a depth below eight points.
BURIN_INLINE Floats voxelsBelow(const Frame& frame, const glm::vec3* points, const glm::vec3* normals, float depth,
                                std::size_t axis) noexcept {
    const Floats way = eightOf(points, frame.axes[axis]) - frame.low[axis];
    return way * frame.perMillimetre - depth * eightOf(normals, frame.axes[axis]);
}
BURIN_INLINE Integers clamped(Integers values, std::int32_t end) noexcept {
    return least(most(values, integers(0)), integers(end - 1));
}

/// Places beside the grid are moved to its border.
BURIN_VECTORISED void placesBelow(const Frame& frame, const glm::vec3* points, const glm::vec3* normals,
                                  std::size_t count, float depth, Place* places) noexcept {
    for (std::size_t i = 0; i < count; i += lanes) {
        const Integers u = wholeOf(voxelsBelow(frame, points + i, normals + i, depth, 0));
        const Integers v = wholeOf(voxelsBelow(frame, points + i, normals + i, depth, 1));
        const Floats along = voxelsBelow(frame, points + i, normals + i, depth, 2) * float{unitsPerVoxel} + 0.5F;
        const Integers line =
            (clamped(v, frame.count[1]) - frame.first[1]) * frame.step + (clamped(u, frame.count[0]) - frame.first[0]);
        const Integers position = clamped(wholeOf(along), frame.count[2]);
        for (int lane = 0; lane < lanes; ++lane)
            places[i + static_cast<std::size_t>(lane)] = {line[lane], position[lane]};
    }
}

Frame frameOf(const Grid& grid, const SurfaceWindow& window, const SurfaceLines& lines) {
    Frame frame;
    frame.axes = {grid.axisOfU(), grid.axisOfV(), grid.axisOfRuns()};
    for (std::size_t i = 0; i < 3; ++i) frame.low[i] = static_cast<float>(grid.low()[frame.axes[i]]);
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
    const std::array further{0.6F, 0.9F, 1.3F, 1.8F, 1.8F * static_cast<float>(window.cell())};
    for (std::size_t i = 0; i < points.size(); ++i) {
        PropertyIndex found = airProperty;
        for (std::size_t depth = 0; depth < depths; ++depth) {
            const PropertyIndex property = lines.propertyAt(places_[depth][i].line, places_[depth][i].position);
            const bool first = found == airProperty || (list.isProtected(property) && !list.isProtected(found));
            found = first ? property : found;
        }
        properties[i] = found != airProperty ? found : search(lines, points.subspan(i), normals + i, further);
    }
}

/// Where the first depths found nothing: further down, then (a splinter thinner than that) in the voxels around.
PropertyIndex SurfaceMaterials::search(const SurfaceLines& lines, std::span<const glm::vec3> point,
                                       const glm::vec3* normal, std::span<const float> depths) const {
    std::array<Place, lanes> places;
    for (const float depth : depths) {
        placesBelow(frame_, point.data(), normal, 1, depth, places.data());
        const PropertyIndex property = lines.propertyAt(places[0].line, places[0].position);
        if (property != airProperty) return property;
    }
    constexpr auto half = static_cast<std::int32_t>(unitsPerVoxel / 2);
    placesBelow(frame_, point.data(), normal, 1, 0.0F, places.data());
    for (std::int32_t v = -1; v <= 1; ++v)
        for (std::int32_t u = -1; u <= 1; ++u)
            for (std::int32_t n = -2; n <= 2; ++n) {
                const PropertyIndex property =
                    lines.propertyAt(places[0].line + v * frame_.step + u, places[0].position + n * half);
                if (property != airProperty) return property;
            }
    return airProperty;
}

} // namespace burin

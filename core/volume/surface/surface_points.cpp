// SPDX-FileCopyrightText: 2026 The Burin authors
// SPDX-License-Identifier: Apache-2.0
#include "core/volume/surface/surface_points.h"

#include "core/base/whole_registers.h"

namespace burin {

namespace any_processor {
namespace {
using namespace eight_lanes;
#include "core/volume/surface/surface_points_lanes.h"
} // namespace

BURIN_VECTORISED void placeSurfacePoints(const SurfaceFrame& frame, const SurfaceBatch& cubes, glm::vec3* points,
                                         glm::vec3* normals, SurfaceEdges& edges) noexcept {
    placeAll(frame, cubes, points, normals, edges);
}
} // namespace any_processor

#ifdef BURIN_AVX512
BURIN_AVX512_BEGIN
namespace avx512 {
namespace {
BURIN_USING_SIXTEEN_LANES
#include "core/volume/surface/surface_points_lanes.h"

void placeSurfacePoints(const SurfaceFrame& frame, const SurfaceBatch& cubes, glm::vec3* points, glm::vec3* normals,
                        SurfaceEdges& edges) noexcept {
    placeAll(frame, cubes, points, normals, edges);
}
} // namespace
} // namespace avx512
BURIN_AVX512_END
#endif

void placeSurfacePoints(const SurfaceFrame& frame, const SurfaceBatch& cubes, glm::vec3* points, glm::vec3* normals,
                        SurfaceEdges& edges) noexcept {
#ifdef BURIN_AVX512
    if (hasAvx512) return avx512::placeSurfacePoints(frame, cubes, points, normals, edges);
#endif
    any_processor::placeSurfacePoints(frame, cubes, points, normals, edges);
}

} // namespace burin

// SPDX-FileCopyrightText: 2026 The Burin authors
// SPDX-License-Identifier: Apache-2.0
#include "ui/scene/workpiece_surface.h"

#include "core/base/parallel.h"
#include "core/volume/surface_simplification.h"
#include "ui/scene/workpiece_polydata.h"

#include <oneapi/tbb/enumerable_thread_specific.h>

#include <vector>

namespace burin {

vtkSmartPointer<vtkPolyData> workpieceSurface(const VolumeSnapshot& workpiece) {
    const glm::ivec2 tiles = surfaceTiles(workpiece.grid());
    std::vector<SurfaceMesh> pieces(static_cast<std::size_t>(tiles.x) * static_cast<std::size_t>(tiles.y));
    oneapi::tbb::enumerable_thread_specific<SurfaceExtractor> extractors;
    parallelFor(0, tiles.x * tiles.y, [&](int tile) {
        extractors.local().extract(workpiece, {tile % tiles.x, tile / tiles.x}, {},
                                   pieces[static_cast<std::size_t>(tile)]);
    });
    std::vector<const SurfaceMesh*> all;
    for (const SurfaceMesh& piece : pieces) all.push_back(&piece);
    SurfaceMesh whole;
    SurfaceSimplifier().join(all, whole);
    return surfacePolyData(whole, workpiece.properties(), barePartColour);
}

} // namespace burin

// SPDX-FileCopyrightText: 2026 The Burin authors
// SPDX-License-Identifier: Apache-2.0
#pragma once

#include "core/geometry/mesh_distance.h"
#include "core/verify/deviation_scale.h"
#include "core/volume/surface/surface.h"

#include <array>
#include <cstdint>
#include <memory>
#include <unordered_map>
#include <vector>

namespace burin {

/// Colouring of a workpiece's surface by its distance from the part.
struct ExcessColours {
    std::shared_ptr<const MeshDistance> part; ///< setup frame, mm; never null
    DeviationTolerance tolerance;

    DeviationScale scale() const { return DeviationScale(tolerance, DeviationScale::Reach::milling); }
    friend bool operator==(const ExcessColours&, const ExcessColours&) = default;
};

/// Distances measured for the colours of a surface, for those of the same surface after a cut: points that are still
/// there are not measured again. For one `ExcessColours::part` and range. Keeps what the last colouring used. One
/// thread at a time.
class ExcessMemory {
    friend class ExcessMeasuring;
    struct Key {
        std::array<std::uint32_t, 3> bits; ///< of the coordinates
        friend bool operator==(const Key&, const Key&) = default;
    };
    struct Hash {
        std::size_t operator()(const Key& key) const noexcept;
    };
    struct Measured {
        double signedDistance = 0.0;
        double within = -1.0;  ///< mm, of the query that `beyond` answers; negative: not asked
        bool measured = false; ///< whether `signedDistance` was
        bool beyond = false;   ///< whether nothing is nearer than `within`
    };
    std::unordered_map<Key, Measured, Hash> before_, now_;
};

/// How finely a surface is subdivided for its colours: edges within the range of the scale are no longer than
/// `longest`, and those longer than `shortest` are halved if the value at their midpoint differs from the interpolated
/// one by more than `unlike`.
struct ExcessDetail {
    double cell = 0.0;                    ///< mm, cell size of the surface, > 0
    double shortest = 0.0, longest = 0.0; ///< mm
    double unlike = 0.0;                  ///< in bands of the scale

    /// @param moving for drawing while things move: fewer triangles
    static ExcessDetail of(double cell, bool moving) {
        return moving ? ExcessDetail{cell, 4.0 * cell, 32.0 * cell, 0.5}
                      : ExcessDetail{cell, 2.0 * cell, 16.0 * cell, 0.2};
    }
};

/// The colours of a surface's points by the stock left on the part there: the distance to the part, from the meshes of
/// both. Where the workpiece is bare part, no stock is left. The surface is first subdivided where a triangle would
/// hide how the stock varies across it; its shape doesn't change. Any thread. Cost: some microseconds per point within
/// the range that is not in the memory.
std::vector<DeviationColour> colourByExcess(SurfaceMesh& mesh, const PropertyList& properties,
                                            const ExcessColours& left, const ExcessDetail& detail,
                                            ExcessMemory& memory);

} // namespace burin

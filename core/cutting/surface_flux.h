// SPDX-FileCopyrightText: 2026 The Burin authors
// SPDX-License-Identifier: Apache-2.0
#pragma once

#include "core/geometry/revolved_piece.h"
#include "core/volume/run_volume.h"

#include <array>
#include <vector>

namespace burin {

class GapWindow;

/// What the surface of the flutes takes in a short move: the integral of normal · motion over the part of the surface
/// that has material ahead of it. Unlike the volume that the runs lose, it does not come in rows of scanlines, so that
/// a force that follows it does not rattle. A first-order figure, for moves well below a voxel.
///
/// The surface is held as patches, each with its exact integral of the normal (by the divergence theorem the flux
/// through a closed patchwork of them is the swept volume, whatever their number). A patch looks for material one
/// voxel ahead of itself *along the motion*: scanlines whose centre the tool has passed are cut already, and a look
/// along the normal would see the wall beside the tool, which it only slides along.
class SurfaceFlux {
public:
    /// @param edge of a voxel, mm. Allocates; a few thousand patches at most.
    SurfaceFlux(const RevolvedPiece& flutes, double edge);

    struct Flux {
        std::array<double, 256> volume{}; ///< mm³ by property; protected ones and air stay 0
        glm::dvec3 moment{0.0};           ///< mm⁴: volume times place
        double total = 0.0;               ///< mm³
    };
    /// @param tip    at the end of the move, mm, setup frame, axis +Z, runs along z
    /// @param motion of the tip, mm, not 0
    /// @param window what of the workpiece is gone, though not yet written; may be none
    void measure(const RunVolume& workpiece, const GapWindow* window, const glm::dvec3& tip, const glm::dvec3& motion,
                 Flux& flux) const noexcept;

private:
    struct Patch {
        glm::dvec3 area{0.0};         ///< mm², integral of the outward normal
        double x = 0.0, y = 0.0;      ///< mm from the axis, of its middle
        double low = 0.0, high = 0.0; ///< mm above the tip
    };
    /// Ring of the surface between two circles about the axis.
    struct Ring {
        double innerRadius = 0.0, outerRadius = 0.0, low = 0.0, high = 0.0;
    };
    void addRing(const Ring& ring, double spacing);

    std::vector<Patch> patches_;
    double edge_ = 0.0;
};

} // namespace burin

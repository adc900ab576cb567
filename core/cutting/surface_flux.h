// SPDX-FileCopyrightText: 2026 The Burin authors
// SPDX-License-Identifier: Apache-2.0
#pragma once

#include "core/geometry/plan_region.h"
#include "core/geometry/pose.h"
#include "core/geometry/revolved_piece.h"
#include "core/volume/runs/run_volume.h"

#include <array>
#include <cstdint>
#include <limits>
#include <span>
#include <vector>

namespace burin {

class CutCache;

/// The engagement of the flutes with the machinable material ahead of them: only the surface that a tick's motion
/// pushes into material, not that which slides along it. All 0 if there is no engagement.
struct Engagement {
    /// rad, 0 … 2 pi: total of the directions about the tool axis in which the flutes meet material (slot: pi; half
    /// immersion: pi/2; plunge into solid stock: 2 pi). Accurate to a patch's width, and where the flutes slide along
    /// the stock, to half a voxel: for 15 voxels of radius 0.4 rad, from 30 voxels on 0.5 rad.
    double arc = 0.0;
    /// mm along the tool axis, from the lowest to the highest point that meets material. Accurate to a patch's height.
    double depth = 0.0;
    /// mm², engaged area of the flutes, measured on the surface, not projected (side of a flat end: arc · radius ·
    /// depth). Accurate to one patch at its border.
    double area = 0.0;
};

/// The volume that the surface of the flutes removes in a short move: the integral of normal · motion over the part of
/// the surface with material ahead of it. Unlike the volume that the runs lose, it does not come in rows of scanlines,
/// so that a force derived from it does not rattle. A first-order value, for moves well below a voxel.
///
/// The surface is divided into patches, each with its exact integral of the normal (by the divergence theorem the flux
/// through a closed set of patches is the swept volume, whatever their number). A patch samples the material one voxel
/// ahead of itself *along its motion*: scanlines whose centre the tool has passed are cut already, and a sample along
/// the normal would find the wall next to the tool, which it only slides along.
///
/// If the tool is parallel to the runs, its wall is divided into strips, each of which samples one scanline for its
/// whole height. Across the runs and for a leaning tool, the wall is divided into rings of patches, whose height grows
/// with the distance from the tip, and each patch samples one point. The points are staggered within their rings, so
/// that the patches pass a border of the stock, or a layer of scanlines, one after another and not a whole ring at
/// once.
class SurfaceFlux {
public:
    /// @param flutes from the tip up, mm
    /// @param edge   of a voxel, mm. Allocates at most some two thousand patches a piece, a quarter of that above 30
    /// voxels of radius.
    SurfaceFlux(std::span<const RevolvedPiece> flutes, double edge);
    /// The same of flutes with a hollow. @param section (distance from the axis, height above the tip), mm
    /// @param top of the flutes, mm above the tip: material above it meets the shank
    SurfaceFlux(const PlanRegion& section, double top, double edge);

    struct Flux {
        std::array<double, 256> volume{}; ///< mm³ by property; protected ones and air stay 0
        glm::dvec3 moment{0.0};           ///< mm⁴: volume times position, setup frame
        double total = 0.0;               ///< mm³
        Engagement engagement;
    };
    /// @param from, to poses at the ends of the move, mm, setup frame; any axes, which may rotate slightly during the
    /// move
    /// @param window pending writes of the workpiece; may be null
    void measure(const RunVolume& workpiece, const CutCache* window, const ToolPose& from, const ToolPose& to,
                 Flux& flux) const noexcept;

private:
    using Directions = std::array<std::uint64_t, 2>; ///< a bit for each 128th of the circle
    struct Patch {
        glm::dvec3 area{0.0};         ///< mm², integral of the outward normal, tool frame
        glm::dvec3 place{0.0};        ///< mm, tool frame: the point on the surface that it samples from
        glm::dvec3 normal{0.0};       ///< unit, outwards, tool frame: of the surface at `place`
        double low = 0.0, high = 0.0; ///< mm above the tip
        double size = 0.0;            ///< mm², length of `area`
        Directions directions{};      ///< the directions that it covers
    };
    /// Ring of the surface between two circles about the axis, with the outside on its right as seen from the inner
    /// circle; the walls of a hollow go down from `low` to `high`.
    struct Ring {
        double innerRadius = 0.0, outerRadius = 0.0, low = 0.0, high = 0.0; ///< mm
        double bulge = 0.0;     ///< mm, radius of the arc between the circles; 0: straight
        glm::dvec2 centre{0.0}; ///< mm, of the arc: from the axis, above the tip
    };
    struct ProfilePlace {
        glm::dvec2 place{0.0}, normal{0.0}; ///< mm and unit, as (distance from the axis, height along it)
    };
    /// The tool in the frame of the grid's lines, and its motion in the tool frame.
    struct Stand {
        glm::dmat3 turn{1.0};    ///< from the tool frame to the lines'
        glm::dvec3 tip{0.0};     ///< mm, frame of the lines
        glm::dvec3 motion{0.0};  ///< mm, of the tip, tool frame
        glm::dvec3 turning{0.0}; ///< rad, about the tip, tool frame
        double lookAhead = 0.0;  ///< mm
        glm::dvec3 probe{0.0};   ///< mm, frame of the lines: the tip, moved ahead by `lookAhead`
        glm::dvec3 lines{0.0};   ///< mm, frame of the lines: low corner of the grid
    };
    struct Sum;

    /// The size of the patches of a piece.
    struct Fineness {
        double spacing = 0.0; ///< mm, of patches of its ends and arcs
        double strip = 0.0;   ///< mm, width of the wall's strips
        double sector = 0.0;  ///< mm, width of the patches of the wall's rings
    };
    Fineness finenessFor(double radius) const noexcept;
    void addPiece(const RevolvedPiece& piece, double innerRadius);
    void addEdge(const glm::dvec2& from, const glm::dvec2& to, const Fineness& fineness);
    void addArc(const RevolvedPiece& piece, const glm::dvec2& centre, double radius, double from, double to,
                double spacing);
    void addSide(const RevolvedPiece& piece, const Fineness& fineness);
    static ProfilePlace placeOn(const Ring& ring, double share) noexcept;
    void addRing(const Ring& ring, int sectors, std::vector<Patch>& patches) const;
    void measureAlongRuns(const Patch& patch, const Stand& stand, Sum& sum) const noexcept;
    double heightPushedInto(const Patch& patch, const Stand& stand, LineIndex line) const noexcept;
    void measureAtPlace(const Patch& patch, const Stand& stand, Sum& sum) const noexcept;

    std::vector<Patch> end_;    ///< bottom, corners, arcs and cones
    std::vector<Patch> strips_; ///< of walls parallel to the axis, over their whole height
    std::vector<Patch> wall_;   ///< of the same walls, in rings
    double edge_ = 0.0;
};

} // namespace burin

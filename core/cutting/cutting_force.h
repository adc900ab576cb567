// SPDX-FileCopyrightText: 2026 The Burin authors
// SPDX-License-Identifier: Apache-2.0
#pragma once

#include "core/cutting/removal.h"

#include <array>

namespace burin {

// Names of values of a material: the force that an edge needs regardless of the chip thickness; 0 if not stated.
inline constexpr std::string_view tangentialEdgeForce = "tangential_edge_force"; ///< Kte, N/mm of engaged edge
inline constexpr std::string_view radialEdgeForce = "radial_edge_force";         ///< Kre, N/mm of engaged edge

/// The values that the cutting force depends on besides the removed volume, copied out of the property list so that the
/// tick reads plain arrays.
struct CuttingCoefficients {
    struct Entry {
        double specificEnergy = 0.0;  ///< K, J/mm³, if no chip law is given
        double kienzleForce = 0.0;    ///< kc1.1, N/mm²; 0: K is constant
        double kienzleExponent = 0.0; ///< mc
        double radialRatio = 0.0;     ///< Kr, 1
        double edgeForce = 0.0;       ///< Kte, N/mm
        double radialEdgeForce = 0.0; ///< Kre, N/mm
        /// J/mm³: K of the mean chip in a slot at the tool's feed by the table, independent of the hand's speed.
        double tableEnergy = 0.0;

        /// K, J/mm³. Kienzle's law holds for chips of 0.005 to 1 mm; beyond this range K is that of the nearest limit,
        /// as no data are published for chips thinner than the edge is sharp. @param chip mm, mean thickness
        double energyAt(double chip) const noexcept;
    };
    std::array<Entry, 256> byProperty{};
    double hardest = 0.0; ///< J/mm³, the greatest tableEnergy of all machinable materials
};
/// @param diameter mm, of the tool
CuttingCoefficients cuttingCoefficients(const PropertyList& properties, double diameter);

/// A tool, as needed for the force: on a turning spindle, or one that doesn't turn, whose edge moves with the tip.
struct SpinningTool {
    double radius = 0.0;         ///< mm, largest radius of the flutes, > 0
    double edgeSpeed = 0.0;      ///< v, mm/s, of the flutes' edge, > 0
    double teethPerSecond = 0.0; ///< 1/s
    bool turns = true;           ///< false: v is the speed of the motion, and K is tableEnergy
};
SpinningTool spinningTool(const Tool& tool, double edgeSpeed) noexcept;

/// Returns the area of the flutes projected along their motion when cutting a slot of the given depth, mm².
/// @param depth mm from the tip
double slotArea(const Cutter& cutter, double depth);

/// The force of a tick's cut on the tool.
struct CuttingForce {
    // As in the paper: unscaled, at the speed of the hand. Setup frame.
    double tangential = 0.0;  ///< N: sum over materials of 1000 K MRR / v (paper, eqs. 11, 12, 14), plus the edge force
    double radial = 0.0;      ///< N: sum of Kr Ft (eq. 13), plus the edge force
    double removalRate = 0.0; ///< mm³/s
    glm::dvec3 force{0.0};    ///< against the motion (tangential) and away from the removed material (radial)

    // The quantities that do not depend on the hand's speed; the force that is felt is computed from these.
    bool cuts = false;        ///< the spindle turns, and nothing prevented the flutes from cutting
    glm::dvec3 motion{0.0};   ///< mm, of the point where material is removed, setup frame
    double volume = 0.0;      ///< mm³, as reported
    double area = 0.0;        ///< mm²: area that meets the material, projected along the motion: volume divided by the
                              ///< length of the motion
    double energy = 0.0;      ///< J/mm³: tableEnergy of this tick's mix of materials
    double radialRatio = 0.0; ///< Kr of the mix
    glm::dvec3 away{0.0};     ///< unit: from the removed material towards the tool
    double reference = 0.0;   ///< N: 1000 K A of the reference cut, which gives the scale
};

/// Computes the force of one tick. K is that of the mean chip, whose thickness is feed per tooth · (area along the
/// motion / engaged surface): in a slot 2 fz / pi. If the engagement is not known, a slot is assumed. The edges add Kte
/// and Kre times the mean engaged length of edge over a turn: teeth · engaged surface / (2 pi R). The force that is
/// felt is without them: a force independent of the chip would also act at rest, which makes the loop unstable.
///
/// Tangential: against the motion of the point where material is removed, including the rotation of the axis. Radial:
/// from that point towards the axis; within a third of the radius it turns towards the direction of the axis, so that a
/// plunging tool is pushed back along its axis and the force does not jump.
///
/// A tool that doesn't turn: the same with v of the motion, so that Ft = 1000 K A, with A the area that meets material;
/// no chip law and no edge force, as both are stated for teeth.
/// @param cut    what the tick removed; its reported volumes drive the force
/// @param from, to tool poses, setup frame. @param period of the tick, s, > 0
CuttingForce cuttingForce(const CutResult& cut, const CuttingCoefficients& coefficients, const SpinningTool& tool,
                          const ToolPose& from, const ToolPose& to, double period) noexcept;

/// The cutting conditions of a tool in a material by the tool's preset or the tables: the feed for the machine,
/// independent of the hand's speed.
struct CuttingConditions {
    double spindleSpeed = 0.0;     ///< 1/min
    double feed = 0.0;             ///< mm/min
    double plungeFeed = 0.0;       ///< mm/min
    double surfaceSpeed = 0.0;     ///< mm/s, surface speed of the flutes at the spindle speed
    bool limitedByMachine = false; ///< the value of preset or table exceeded a limit of the tool or machine
    double rampAngle = 0.0;        ///< rad, largest angle at which ramps and helices enter material
};
/// Returns the name of the value of a material that overrides `name` for one type of cutter: "surface_speed_drill".
std::string valueForCutter(std::string_view name, CutterType cutter);
/// The values that a material may state for a single type of cutter in addition to the general ones.
inline constexpr std::array valuesByCutter{surfaceSpeed, chipLoadPerDiameter, plungeFeedRatio};

/// Returns the tool's preset for a material, a grade also by its base; nullptr: the tables apply.
const CuttingPreset* presetFor(const Tool& tool, const Property& material) noexcept;

/// Returns the values of the tool's preset for the material, if it has one; the tables lend a plunge feed that the
/// preset does not state. Otherwise n = vc / (pi D) and feed = n z fz, both within the given limits; if the spindle
/// speed is limited, the feed follows the reduced speed. Values for the tool's type of cutter (`valueForCutter`)
/// override the general ones.
/// @param maximumSpindleSpeed of the machine, 1/min; the tool's own limit applies too
/// @param maximumFeed         of the machine, mm/min
/// Errors: resourceInvalid (subject: material, place: the missing value), argumentInvalid (a limit not above 0).
Result<CuttingConditions> cuttingConditions(const Tool& tool, const Property& material, double maximumSpindleSpeed,
                                            double maximumFeed);

} // namespace burin

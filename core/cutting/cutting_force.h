// SPDX-FileCopyrightText: 2026 The Burin authors
// SPDX-License-Identifier: Apache-2.0
#pragma once

#include "core/cutting/removal.h"

#include <array>

namespace burin {

// Names of values of a material: what an edge needs to cut at all, however thin the chip; 0 where a material has none.
inline constexpr std::string_view tangentialEdgeForce = "tangential_edge_force"; ///< Kte, N/mm of engaged edge
inline constexpr std::string_view radialEdgeForce = "radial_edge_force";         ///< Kre, N/mm of engaged edge

/// What the cutting force depends on besides the removed volume; copied out of the property list, so that the tick
/// reads plain arrays.
struct CuttingCoefficients {
    struct Entry {
        double specificEnergy = 0.0;  ///< K, J/mm³, where there is no law of the chip
        double kienzleForce = 0.0;    ///< kc1.1, N/mm²; 0: K is constant
        double kienzleExponent = 0.0; ///< mc
        double radialRatio = 0.0;     ///< Kr, 1
        double edgeForce = 0.0;       ///< Kte, N/mm
        double radialEdgeForce = 0.0; ///< Kre, N/mm
        /// J/mm³: K of the mean chip in a slot at the feed that the table gives for the tool, whatever the hand's is.
        double tableEnergy = 0.0;

        /// K, J/mm³. Kienzle's law holds for chips of 0.005 to 1 mm; beyond, K stays what it is there, as nobody
        /// publishes what an edge does to thinner chips than it is sharp. @param chip mm, mean thickness
        double energyAt(double chip) const noexcept;
    };
    std::array<Entry, 256> byProperty{};
    double hardest = 0.0; ///< J/mm³, the greatest tableEnergy of what is machinable
};
/// @param diameter mm, of the tool
CuttingCoefficients cuttingCoefficients(const PropertyList& properties, double diameter);

/// A tool on a turning spindle, as the force sees it.
struct SpinningTool {
    double radius = 0.0;         ///< mm, of the flutes where they are widest, > 0
    double edgeSpeed = 0.0;      ///< v, mm/s, of the flutes' edge, > 0
    double teethPerSecond = 0.0; ///< 1/s
};
SpinningTool spinningTool(const Tool& tool, double edgeSpeed) noexcept;

/// mm²: what the flutes show along their motion when they cut a slot of so much depth. @param depth mm from the tip
double slotArea(const Cutter& cutter, double depth);

/// What a tick's cut does to the tool.
struct CuttingForce {
    // As the paper has it: unscaled, by the speed that the hand has. Setup frame.
    double tangential = 0.0;  ///< N: sum over materials of 1000 K MRR / v (paper, eqs. 11, 12, 14), and the edge's
    double radial = 0.0;      ///< N: sum of Kr Ft (eq. 13), and the edge's
    double removalRate = 0.0; ///< mm³/s
    glm::dvec3 force{0.0};    ///< against the motion (tangential) and away from the removed material (radial)

    // What of it does not go with the hand's speed: what is felt.
    bool cuts = false;        ///< the spindle turns, and nothing kept the flutes from cutting
    glm::dvec3 motion{0.0};   ///< mm, of the place where material is removed, setup frame
    double volume = 0.0;      ///< mm³, as reported
    double area = 0.0;        ///< mm²: what meets the material, seen along the motion: volume over way
    double energy = 0.0;      ///< J/mm³: tableEnergy of this tick's mix of materials
    double radialRatio = 0.0; ///< Kr of the mix
    glm::dvec3 away{0.0};     ///< unit: from the removed material towards the tool
    double reference = 0.0;   ///< N: 1000 K A of the reference cut, which gives the scale
};

/// The force of one tick. K is that of the mean chip, whose thickness is feed per tooth · (area along the motion /
/// engaged surface): in a slot 2 fz / pi. Where the engagement is not known, a slot's is taken. The edges add Kte and
/// Kre on the length of them that is engaged in the mean over a turn: teeth · engaged surface / (2 pi R). What is felt
/// is without them: a force that does not go with the chip would be one of rest, which no loop bears.
///
/// Tangential: against the motion of the place where material is removed, a turning axis included. Radial: from that
/// place towards the axis; within a third of the radius it leans over to the axis' own direction, so that a tool that
/// plunges is pushed back along its axis and nothing jumps.
/// @param cut    what the tick removed; its reported volumes drive the force
/// @param from, to tool poses, setup frame. @param period of the tick, s, > 0
CuttingForce cuttingForce(const CutResult& cut, const CuttingCoefficients& coefficients, const SpinningTool& tool,
                          const ToolPose& from, const ToolPose& to, double period) noexcept;

/// What a tool does in a material by the tables: the feed that the machine gets, whatever the hand's speed was.
struct CuttingConditions {
    double spindleSpeed = 0.0;     ///< 1/min
    double feed = 0.0;             ///< mm/min
    double plungeFeed = 0.0;       ///< mm/min
    double surfaceSpeed = 0.0;     ///< mm/s, that the spindle speed gives at the flutes
    bool limitedByMachine = false; ///< the table asked for more than tool or machine can do
    double rampAngle = 0.0;        ///< rad, at which ramps and helices go down into material at most
};
/// Name of the value of a material that stands before `name` for one kind of cutter: "surface_speed_drill".
std::string valueForCutter(std::string_view name, CutterType cutter);
/// Those that a material may have for a kind of cutter besides the one for all.
inline constexpr std::array valuesByCutter{surfaceSpeed, chipLoadPerDiameter, plungeFeedRatio};

/// n = vc / (pi D), feed = n z fz, both within the limits given; where the spindle is too slow, the feed follows the
/// speed that it reaches. Values for the tool's kind of cutter (`valueForCutter`) stand before those for all.
/// @param maximumSpindleSpeed of the machine, 1/min; the tool's own limit counts too
/// @param maximumFeed         of the machine, mm/min
/// Errors: resourceInvalid (subject: material, place: the value that it lacks), argumentInvalid (a limit not above 0).
Result<CuttingConditions> cuttingConditions(const Tool& tool, const Property& material, double maximumSpindleSpeed,
                                            double maximumFeed);

} // namespace burin

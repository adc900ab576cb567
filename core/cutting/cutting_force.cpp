// SPDX-FileCopyrightText: 2026 The Burin authors
// SPDX-License-Identifier: Apache-2.0
#include "core/cutting/cutting_force.h"

#include "core/base/units.h"
#include "core/cutting/slot_chip.h"

#include <algorithm>
#include <cmath>

namespace burin {

namespace {

constexpr double thinnestChip = 0.005, thickestChip = 1.0; // mm
constexpr double usualChipLoad = 0.01;                     // of the diameter, if the material states none
constexpr double leaningShare = 1.0 / 3.0;                 // of the radius

/// Unit vector from the removed material towards the tool.
glm::dvec3 awayFrom(const glm::dvec3& place, const ToolPose& pose, double radius) noexcept {
    const glm::dvec3 offset = place - pose.tip;
    const glm::dvec3 sideways = offset - glm::dot(offset, pose.axis) * pose.axis;
    const double length = glm::length(sideways);
    if (!(length > 0.0)) return pose.axis;
    const double t = std::min(1.0, length / (leaningShare * radius));
    const double angle = 0.5 * pi * t * t * (3.0 - 2.0 * t); // from the axis
    return std::cos(angle) * pose.axis - std::sin(angle) / length * sideways;
}

/// Returns the motion of a point of the tool, mm; first order in the rotation of the axis.
glm::dvec3 motionOf(const glm::dvec3& place, const ToolPose& from, const ToolPose& to) noexcept {
    return to.tip - from.tip + glm::cross(glm::cross(from.axis, to.axis), place - to.tip);
}

} // namespace

double CuttingCoefficients::Entry::energyAt(double chip) const noexcept {
    if (kienzleForce <= 0.0) return specificEnergy;
    return kienzleForce * std::pow(std::clamp(chip, thinnestChip, thickestChip), -kienzleExponent) /
           newtonMillimetresPerJoule;
}

CuttingCoefficients cuttingCoefficients(const PropertyList& properties, double diameter) {
    CuttingCoefficients coefficients;
    for (int i = 1; i < properties.size(); ++i) {
        const auto index = static_cast<PropertyIndex>(i);
        const Property& property = properties[index];
        CuttingCoefficients::Entry& entry = coefficients.byProperty[index];
        entry.specificEnergy = property.valueOr(specificCuttingEnergy, 0.0);
        entry.radialRatio = property.valueOr(radialForceRatio, 0.0);
        entry.edgeForce = property.valueOr(tangentialEdgeForce, 0.0);
        entry.radialEdgeForce = property.valueOr(radialEdgeForce, 0.0);
        if (property.values.contains(kienzleForce) && property.values.contains(kienzleExponent)) {
            entry.kienzleForce = property.valueOr(kienzleForce, 0.0);
            entry.kienzleExponent = property.valueOr(kienzleExponent, 0.0);
        }
        entry.tableEnergy =
            entry.energyAt(slotChipRatio * property.valueOr(chipLoadPerDiameter, usualChipLoad) * diameter);
        if (!properties.isProtected(index)) coefficients.hardest = std::max(coefficients.hardest, entry.tableEnergy);
    }
    return coefficients;
}

SpinningTool spinningTool(const Tool& tool, double edgeSpeed) noexcept {
    const double radius = tool.cutter.radius();
    if (!tool.cutter.turns()) return {radius, edgeSpeed, 0.0, false};
    return {radius, edgeSpeed, radius > 0.0 ? tool.fluteCount * edgeSpeed / (2.0 * pi * radius) : 0.0};
}

double slotArea(const Cutter& cutter, double depth) {
    constexpr int slices = 200; // of a piece: a sphere's area accurate to 0.1 %
    double area = 0.0;
    for (const RevolvedPiece& piece : flutePieces(cutter)) {
        const double top = std::min(piece.top, depth), slice = (top - piece.bottom) / slices;
        for (int i = 0; i < slices && slice > 0.0; ++i)
            area += 2.0 * radiusAt(piece, piece.bottom + (i + 0.5) * slice) * slice;
    }
    return area;
}

CuttingForce cuttingForce(const CutResult& cut, const CuttingCoefficients& coefficients, const SpinningTool& tool,
                          const ToolPose& from, const ToolPose& to, double period) noexcept {
    CuttingForce result;
    result.cuts = true;
    const bool removes = cut.reported > 0.0;
    result.motion = motionOf(removes ? cut.reportedCentroid : to.tip, from, to);
    const double way = glm::length(result.motion);
    if (!removes || !(way > 0.0) || !(tool.edgeSpeed > 0.0) || !(period > 0.0)) return result;

    result.volume = cut.reported;
    result.area = cut.reported / way;
    const double ratio = cut.engagement.area > 0.0 ? std::min(1.0, result.area / cut.engagement.area) : slotChipRatio;
    const double feedPerTooth = tool.teethPerSecond > 0.0 ? way / (period * tool.teethPerSecond) : 0.0;
    const double engagedEdge = tool.teethPerSecond * cut.engagement.area / tool.edgeSpeed; // mm
    const double speed = tool.turns ? tool.edgeSpeed : way / period;                       // mm/s
    double radialEnergy = 0.0;
    for (const MaterialVolume& material : cut.removed) {
        if (material.property == airProperty) break;
        const CuttingCoefficients::Entry& entry = coefficients.byProperty[material.property];
        const double rate = material.reported / period, share = material.reported / cut.reported;
        const double specific = tool.turns ? entry.energyAt(feedPerTooth * ratio) : entry.tableEnergy;
        const double tangential = newtonMillimetresPerJoule * specific * rate / speed;
        result.removalRate += rate;
        result.tangential += tangential + entry.edgeForce * engagedEdge * share;
        result.radial += entry.radialRatio * tangential + entry.radialEdgeForce * engagedEdge * share;
        const double energy = entry.tableEnergy * share;
        result.energy += energy;
        radialEnergy += entry.radialRatio * energy;
    }
    if (result.energy > 0.0) result.radialRatio = radialEnergy / result.energy;
    result.away = awayFrom(cut.reportedCentroid, to, tool.radius);
    result.force = result.away * result.radial - result.motion * (result.tangential / way);
    return result;
}

} // namespace burin

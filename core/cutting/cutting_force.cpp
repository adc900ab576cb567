// SPDX-FileCopyrightText: 2026 The Burin authors
// SPDX-License-Identifier: Apache-2.0
#include "core/cutting/cutting_force.h"

#include "core/base/units.h"

namespace burin {

namespace {

/// Unit vector from the removed material towards the tool's axis; where it was removed right below the tip, up.
glm::dvec3 awayFrom(const glm::dvec3& place, const glm::dvec3& tip) noexcept {
    constexpr double onAxis = 1e-6; // mm
    const glm::dvec3 away(tip.x - place.x, tip.y - place.y, 0.0);
    const double length = glm::length(away);
    return length > onAxis ? away / length : glm::dvec3(0.0, 0.0, 1.0);
}

} // namespace

CuttingCoefficients cuttingCoefficients(const PropertyList& properties) {
    CuttingCoefficients coefficients;
    for (int i = 1; i < properties.size(); ++i) {
        const auto index = static_cast<PropertyIndex>(i);
        const Property& property = properties[index];
        coefficients.byProperty[index] = {property.valueOr(specificCuttingEnergy, 0.0),
                                          property.valueOr(radialForceRatio, 0.0)};
    }
    return coefficients;
}

CuttingForce cuttingForce(const CutResult& cut, const CuttingCoefficients& coefficients, const glm::dvec3& motion,
                          const glm::dvec3& tip, double cuttingSpeed, double period) noexcept {
    CuttingForce result;
    if (!(cuttingSpeed > 0.0) || !(period > 0.0)) return result;
    for (const MaterialVolume& material : cut.removed) {
        if (material.property == airProperty) break;
        const CuttingCoefficients::Entry& entry = coefficients.byProperty[material.property];
        const double rate = material.reported / period;
        const double tangential = newtonMillimetresPerJoule * entry.specificEnergy * rate / cuttingSpeed;
        result.removalRate += rate;
        result.tangential += tangential;
        result.radial += entry.radialRatio * tangential;
    }
    if (!(result.removalRate > 0.0)) return result;
    const double step = glm::length(motion);
    if (step > 0.0) result.force -= motion * (result.tangential / step);
    result.force += awayFrom(cut.reportedCentroid, tip) * result.radial;
    return result;
}

} // namespace burin

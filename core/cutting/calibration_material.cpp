// SPDX-FileCopyrightText: 2026 The Burin authors
// SPDX-License-Identifier: Apache-2.0
#include "core/base/numbers.h"
#include "core/cutting/calibration.h"
#include "core/cutting/cutting_force.h"

namespace burin {

namespace {

std::string sourceOf(const MaterialCalibration& calibration, const Confidence& confidence,
                     const std::string& evidence) {
    const std::string projection = calibration.options.projection == ForceProjection::feedAndAxis
                                       ? "Chen & Yang 2004, eq. 15"
                                       : "mean forces of turning teeth";
    return "calibrated from " + evidence + ": " + std::to_string(calibration.residuals.size()) + " of " +
           std::to_string(calibration.records) + " records, " + projection + ", mean chips of " +
           formatFixed(calibration.chipLow, 4) + " to " + formatFixed(calibration.chipHigh, 4) + " mm; " +
           formatFixed(100.0 * calibration.options.confidence, 0) + " % confidence " + textOf(confidence);
}

} // namespace

std::string textOf(const Confidence& confidence) {
    constexpr int decimals = 4;
    return formatFixed(confidence.value, decimals) + " (" + formatFixed(confidence.low, decimals) + " to " +
           formatFixed(confidence.high, decimals) + ")";
}

Property calibratedMaterial(const Property& basis, const MaterialCalibration& calibration,
                            const std::string& evidence) {
    Property material = basis;
    material.id = calibration.material;
    const auto set = [&](std::string_view name, const Confidence& confidence, const char* unit) {
        material.values.insert_or_assign(
            std::string(name), NamedValue{confidence.value, unit, sourceOf(calibration, confidence, evidence), false});
    };
    set(specificCuttingEnergy, calibration.specificEnergy, "J/mm^3");
    set(radialForceRatio, calibration.radialRatio, "1");
    // With the other laws, the new K includes the previous edge force.
    material.values.erase(std::string(tangentialEdgeForce));
    material.values.erase(std::string(radialEdgeForce));
    if (calibration.options.law == ChipLaw::edge) {
        set(tangentialEdgeForce, calibration.edgeForce, "N/mm");
        set(radialEdgeForce, calibration.radialEdgeForce, "N/mm");
    }
    if (calibration.options.law == ChipLaw::kienzle) {
        set(kienzleForce, calibration.kienzleForce, "N/mm^2");
        set(kienzleExponent, calibration.kienzleExponent, "1");
    } else {
        material.values.erase(std::string(kienzleForce));
        material.values.erase(std::string(kienzleExponent));
    }
    return material;
}

} // namespace burin

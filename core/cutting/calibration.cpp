// SPDX-FileCopyrightText: 2026 The Burin authors
// SPDX-License-Identifier: Apache-2.0
#include "core/cutting/calibration.h"

#include "core/base/numbers.h"
#include "core/base/units.h"
#include "core/cutting/calibration_fit.h"

#include <algorithm>
#include <cmath>

namespace burin {

namespace {

constexpr std::size_t fewestConstant = 4, fewestOfTwo = 6;
constexpr double leastChipSpread = 1.5;     // thickest over thinnest chip
constexpr double widestExponentError = 0.5; // of mc, either side

Error refused(const std::string& origin, const std::string& material, std::string why) {
    return {ErrorCode::resourceInvalid, origin, "material " + material, std::move(why)};
}

/// Writes the coefficients and their confidence from the least squares to the result.
void conclude(const ForceFit& fit, double t, MaterialCalibration& result) {
    const double chip = fit.referenceChip();
    const Estimate k = fit.specificEnergy();
    result.chip = chip;
    result.specificEnergy = {k.value, k.value - t * k.error, k.value + t * k.error};
    if (result.options.law == ChipLaw::constant) return;
    const Estimate mc = fit.exponent(), logForce = fit.logarithmOfForceAtOneMillimetre();
    result.kienzleExponent = {mc.value, mc.value - t * mc.error, mc.value + t * mc.error};
    result.kienzleForce = {std::exp(logForce.value), std::exp(logForce.value - t * logForce.error),
                           std::exp(logForce.value + t * logForce.error)};
}

std::string hiddenForce(bool pointsAlong, const CalibrationOptions& options) {
    if (!pointsAlong) return "noise hides the cutting force; measure deeper cuts or more of them";
    return options.forcesOnWorkpiece
               ? "the forces on the workpiece point against the feed; are they those on the tool?"
               : "the forces on the tool point along the feed; are they those on the workpiece (--on-workpiece)?";
}

void sortByLine(std::vector<LeftOut>& leftOut) {
    std::sort(leftOut.begin(), leftOut.end(), [](const LeftOut& a, const LeftOut& b) { return a.line < b.line; });
}

/// Calibrates with ChipLaw::edge.
Result<MaterialCalibration> withEdge(EdgeFit fit, const std::string& origin, MaterialCalibration result) {
    const std::string& material = result.material;
    fit.run();
    if (fit.counted() < fewestOfTwo || 3 * (fit.size() - fit.counted()) > fit.size())
        return refused(origin, material,
                       "the records disagree too much; look for air cuts, chatter or wrong conditions in them");
    const double t = studentQuantile(result.options.confidence, 2 * static_cast<int>(fit.counted()) - 4);
    const auto between = [](double value, double error) { return Confidence{value, value - error, value + error}; };
    const double energy = fit.chip().real() / newtonMillimetresPerJoule;
    result.specificEnergy = between(energy, t * fit.chipError() / newtonMillimetresPerJoule);
    result.edgeForce = between(fit.edge().real(), t * fit.edgeError());
    result.radialEdgeForce = between(fit.edge().imag(), t * fit.edgeError());
    if (!(energy > 0.0)) return refused(origin, material, hiddenForce(true, result.options));
    if (!(result.specificEnergy.low > 0.0)) return refused(origin, material, hiddenForce(false, result.options));
    if (!(result.edgeForce.high > 0.0) || !(result.radialEdgeForce.high > 0.0))
        return refused(origin, material,
                       "the force of the edge comes out negative; use another law (--law kienzle or constant)");
    // A negative value is noise of an edge that needs no force.
    for (Confidence* const edge : {&result.edgeForce, &result.radialEdgeForce})
        edge->value = std::max(0.0, edge->value);
    const std::optional<Confidence> ratio =
        ratioOf({fit.chip().imag(), fit.chipError()}, {fit.chip().real(), fit.chipError()}, t);
    if (!ratio || !(ratio->value >= 0.0))
        return refused(origin, material,
                       "the radial force pulls the tool into the material; use another projection (--projection)");
    result.radialRatio = *ratio;
    fit.report(result);
    result.chip = std::sqrt(result.chipLow * result.chipHigh);
    sortByLine(result.leftOut);
    return result;
}

} // namespace

Result<MaterialCalibration> calibrate(std::span<const ForceRecord> records, const std::string& material,
                                      const CalibrationOptions& options, const std::string& origin) {
    MaterialCalibration result;
    result.material = material;
    result.options = options;
    std::vector<ForceObservation> observations;
    std::vector<double> speeds;
    for (const ForceRecord& record : records) {
        if (record.material != material) continue;
        ++result.records;
        ForceObservation observation;
        if (const std::string reason = observe(record, options, observation); !reason.empty()) {
            result.leftOut.push_back({record.line, reason});
            continue;
        }
        observations.push_back(observation);
        speeds.push_back(record.toolEdgeSpeed());
    }
    const bool kienzle = options.law == ChipLaw::kienzle, edge = options.law == ChipLaw::edge;
    const std::size_t fewest = kienzle || edge ? fewestOfTwo : fewestConstant;
    if (observations.size() < fewest)
        return refused(origin, material,
                       "only " + std::to_string(observations.size()) + " records can be used; measure " +
                           std::to_string(fewest) + " or more");
    const auto [thin, thick] =
        std::minmax_element(observations.begin(), observations.end(),
                            [](const ForceObservation& a, const ForceObservation& b) { return a.chip < b.chip; });
    if ((kienzle || edge) && thick->chip < leastChipSpread * thin->chip)
        return refused(origin, material,
                       (edge ? "the edge's force needs" : "an exponent needs") +
                           std::string(" chips of different thickness; measure feeds that differ by a factor of ") +
                           formatShortest(leastChipSpread) + " or more" +
                           (edge ? ", or use another law (--law constant)" : ""));
    if (edge) {
        result.edgeSpeed = medianOf(speeds);
        return withEdge(EdgeFit(std::move(observations)), origin, std::move(result));
    }

    ForceFit fit(std::move(observations), kienzle);
    fit.run();
    const int freedoms = static_cast<int>(fit.counted()) - (kienzle ? 2 : 1);
    if (fit.pointsAlong()) return refused(origin, material, hiddenForce(true, options));
    if (fit.counted() < fewest || 3 * (fit.observations().size() - fit.counted()) > fit.observations().size())
        return refused(origin, material,
                       "the records disagree too much; look for air cuts, chatter or wrong conditions in them");
    const double t = studentQuantile(options.confidence, freedoms);
    conclude(fit, t, result);
    if (kienzle && !(result.kienzleExponent.high - result.kienzleExponent.low <= 2.0 * widestExponentError))
        return refused(
            origin, material,
            "noise hides the exponent; measure feeds that differ more, or more of them, or use a constant K");
    if (!(result.specificEnergy.low > 0.0)) return refused(origin, material, hiddenForce(false, options));
    const std::optional<Confidence> ratio = ratioOf(fit.radialEnergy(), fit.energyForRatio(), t);
    if (!ratio || !(ratio->value >= 0.0))
        return refused(origin, material,
                       "the radial force pulls the tool into the material; use another projection (--projection)");
    result.radialRatio = *ratio;
    fit.report(result);
    result.edgeSpeed = medianOf(speeds);
    sortByLine(result.leftOut);
    return result;
}

} // namespace burin

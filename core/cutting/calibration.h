// SPDX-FileCopyrightText: 2026 The Burin authors
// SPDX-License-Identifier: Apache-2.0
#pragma once

#include "core/cutting/calibration_records.h"
#include "core/cutting/calibration_statistics.h"
#include "core/volume/runs/property_list.h"

#include <span>
#include <string>
#include <vector>

namespace burin {

/// How K depends on the chip thickness.
enum class ChipLaw : std::uint8_t {
    constant, ///< K
    kienzle,  ///< K(h) = kc1.1 · h^-mc / 1000, h the mean chip thickness
    edge,     ///< K, plus Kte and Kre for each mm of engaged edge, regardless of the chip (Altintas' shear and edge)
};

/// How tangential and radial force are derived from a measured force.
enum class ForceProjection : std::uint8_t {
    /// Chen & Yang 2004, eq. 15: Ft along d⊥, which is perpendicular to the tool axis, in its plane with the feed, and
    /// against the feed; Fr along the axis d. The result is the force that the hand feels against its motion.
    feedAndAxis,
    /// The force perpendicular to the axis is resolved into the tangential and radial forces of the teeth that turn
    /// within the engaged arc (slot, up or down); the measured force is their mean over a turn. K is then the specific
    /// energy itself, P = K MRR, of forces proportional to the chip thickness. ChipLaw::edge separates the edge forces;
    /// with the other laws they count for a fifth less in a slot.
    turningTeeth,
};

struct CalibrationOptions {
    ChipLaw law = ChipLaw::constant;
    ForceProjection projection = ForceProjection::turningTeeth;
    bool forcesOnWorkpiece = false; ///< true: forces on the workpiece, as from a dynamometer below it; false: forces on
                                    ///< the tool
    double confidence = 0.95;       ///< 0 < … < 1
};

/// A record excluded from the fit.
struct LeftOut {
    std::size_t line = 0;
    std::string reason; ///< English
};

/// The residual of one record.
struct Residual {
    std::size_t line = 0;
    double tangential = 0.0, radial = 0.0; ///< N, measured - fitted
};

/// K and Kr of one material.
struct MaterialCalibration {
    std::string material;
    CalibrationOptions options;
    std::size_t records = 0;                         ///< of the material, including those left out
    std::vector<Residual> residuals;                 ///< of those that count
    std::vector<LeftOut> leftOut;                    ///< in ascending order of lines
    double chipLow = 0.0, chipHigh = 0.0;            ///< mm, range of the mean chip thickness of the records that count
    double chip = 0.0;                               ///< mm: their geometric mean
    double edgeSpeed = 0.0;                          ///< mm/s, median of v
    Confidence specificEnergy;                       ///< K, J/mm³; with Kienzle's law at `chip`
    Confidence radialRatio;                          ///< Kr
    Confidence kienzleForce, kienzleExponent;        ///< kc1.1, N/mm²; mc. Only for ChipLaw::kienzle
    Confidence edgeForce, radialEdgeForce;           ///< Kte, Kre, N/mm. Only for ChipLaw::edge
    double tangentialNoise = 0.0, radialNoise = 0.0; ///< N, standard deviation of the residuals
};

/// Fits K and Kr of one material to the records that name it.
///
/// Ft = 1000 K MRR / v and Fr = Kr Ft (paper, eqs. 12, 13, 16, 17) for each record, MRR and v from its conditions.
/// Noise model: each component of a record's force has an independent normal error with the same deviation in all
/// records of the material; a few records may be outliers. These are found by their residuals from a robust fit (median
/// of ratios; with Kienzle's law median of slopes) and left out; the rest is fitted by least squares, each record
/// weighted according to its projection. Confidence: Student's t for K, and linearised at the solution for mc and, in
/// its logarithm, kc1.1; Fieller's interval for Kr. All formulas are closed, with at most two unknowns; with
/// ChipLaw::edge these are complex, as both components of a record are then fitted together.
///
/// Errors: resourceInvalid (subject: `origin`, place: the material; detail: the reason and what to measure): fewer than
/// 4 records that count (Kienzle, edge: 6), more than a third of them outliers, a force below the noise, one that
/// points along the feed (perhaps the wrong sign) or into the material, chip thicknesses too similar to fit an
/// exponent.
Result<MaterialCalibration> calibrate(std::span<const ForceRecord> records, const std::string& material,
                                      const CalibrationOptions& options, const std::string& origin);

/// Returns the material with the calibrated values: K and Kr; with Kienzle's law also kc1.1 and mc, which a constant K
/// removes. Each has the calibration as its source.
/// @param basis    the material before calibration, or a similar one: name, colour and all other values are taken from
/// it
/// @param evidence file and date, "forces.csv, 2026-11-21"
Property calibratedMaterial(const Property& basis, const MaterialCalibration& calibration, const std::string& evidence);

/// Returns the text for reports, in English: "2.1300 (2.0500 to 2.2100)".
std::string textOf(const Confidence& confidence);

} // namespace burin

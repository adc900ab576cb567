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

/// How K depends on the chip.
enum class ChipLaw : std::uint8_t {
    constant, ///< K
    kienzle,  ///< K(h) = kc1.1 · h^-mc / 1000, h the mean chip thickness
    edge,     ///< K, and for each mm of engaged edge Kte and Kre, however thin the chip (Altintas' shear and edge)
};

/// What a measured force says of tangential and radial force.
enum class ForceProjection : std::uint8_t {
    /// Chen & Yang 2004, eq. 15: Ft along d⊥, which is across the tool axis, in its plane with the feed, and against
    /// the feed; Fr along the axis d. What is calibrated is what the hand feels against its motion.
    feedAndAxis,
    /// The force across the axis, resolved for the tangential and radial force of the teeth that turn within the
    /// engaged arc (slot, up or down), whose mean over a turn it is. K is then the specific energy itself, P = K MRR,
    /// of forces that go with the chip's thickness. ChipLaw::edge tells the edge's apart; with the other laws it
    /// counts for a fifth less in a slot.
    turningTeeth,
};

struct CalibrationOptions {
    ChipLaw law = ChipLaw::constant;
    ForceProjection projection = ForceProjection::turningTeeth;
    bool forcesOnWorkpiece = false; ///< as a dynamometer below it measures; else those on the tool
    double confidence = 0.95;       ///< 0 < … < 1
};

/// A record that the fit does not count.
struct LeftOut {
    std::size_t line = 0;
    std::string reason; ///< English
};

/// What the fit leaves of one record.
struct Residual {
    std::size_t line = 0;
    double tangential = 0.0, radial = 0.0; ///< N, measured - fitted
};

/// K and Kr of one material.
struct MaterialCalibration {
    std::string material;
    CalibrationOptions options;
    std::size_t records = 0;                         ///< of the material, those left out included
    std::vector<Residual> residuals;                 ///< of those that count
    std::vector<LeftOut> leftOut;                    ///< rising lines
    double chipLow = 0.0, chipHigh = 0.0;            ///< mm, mean chip thickness of the records that count
    double chip = 0.0;                               ///< mm: their geometric mean
    double edgeSpeed = 0.0;                          ///< mm/s, median of v
    Confidence specificEnergy;                       ///< K, J/mm³; with Kienzle's law at `chip`
    Confidence radialRatio;                          ///< Kr
    Confidence kienzleForce, kienzleExponent;        ///< kc1.1, N/mm²; mc. Of ChipLaw::kienzle alone
    Confidence edgeForce, radialEdgeForce;           ///< Kte, Kre, N/mm. Of ChipLaw::edge alone
    double tangentialNoise = 0.0, radialNoise = 0.0; ///< N, standard deviation of the residuals
};

/// Fits K and Kr of one material to the records that name it.
///
/// Ft = 1000 K MRR / v and Fr = Kr Ft (paper, eqs. 12, 13, 16, 17) for each record, MRR and v from its conditions.
/// Noise model: each component of a record's force has an independent normal error, alike in all records of the
/// material; a few records may be far off for reasons of their own. These are found by their residuals from a robust
/// fit (median of ratios; with Kienzle's law median of slopes) and left out; the rest is fitted by least squares, each
/// record with the weight that its projection leaves it. Confidence: Student's t for K, and linearised at the solution
/// for mc and, in its logarithm, kc1.1; Fieller's interval for Kr. Closed formulas; two unknowns at most, with
/// ChipLaw::edge two complex ones, as both components of a record are then fitted together.
///
/// Errors: resourceInvalid (subject: `origin`, place: the material; detail: why not and what to measure): fewer than 4
/// records that count (Kienzle, edge: 6), more than a third of them far off, a force that noise hides, one that points
/// along the feed (the other sign?) or into the material, chips too much alike for an exponent.
Result<MaterialCalibration> calibrate(std::span<const ForceRecord> records, const std::string& material,
                                      const CalibrationOptions& options, const std::string& origin);

/// The material with what was calibrated: K, Kr, with Kienzle's law kc1.1 and mc, with constant K neither, each with
/// the calibration as its source.
/// @param basis    the material as it was, or one that is like it: name, colour and all other values are its own
/// @param evidence file and date, "forces.csv, 2026-11-21"
Property calibratedMaterial(const Property& basis, const MaterialCalibration& calibration, const std::string& evidence);

/// For reports, in English: "2.1300 (2.0500 to 2.2100)".
std::string textOf(const Confidence& confidence);

} // namespace burin

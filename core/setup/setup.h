// SPDX-FileCopyrightText: 2026 The Burin authors
// SPDX-License-Identifier: Apache-2.0
#pragma once

#include "core/base/progress.h"
#include "core/base/result.h"
#include "core/cad/model.h"
#include "core/volume/run_volume.h"

#include <string>
#include <vector>

namespace burin {

/// How a part lies in its stock: one clamping. The setup frame is the model's frame.
struct Setup {
    double voxel = 0.5;         ///< mm
    glm::dvec3 marginLow{5.0};  ///< mm of stock below the part along x, y, z
    glm::dvec3 marginHigh{5.0}; ///< mm above
    std::string stockMaterial = "aluminium-6061";
    std::vector<std::string> bodyMaterials; ///< per body; empty: the stock's
    Box stock;                              ///< mm; filled by `placeStock`
    glm::dvec3 workOffset{0.0};             ///< program zero in the setup frame, mm; filled by `placeStock`
    RunAxis runs = RunAxis::z;              ///< of the volume: along the spindle, or what comes next to it
};

/// Box stock around a model: its box grown by the margins. Program zero: centre of the stock's top face.
/// Errors: stockInvalid (a margin below 0 or not finite, a voxel not > 0).
Result<Setup> placeStock(const Model& model, Setup setup);

/// What a grid would take, before it is made.
struct EmbeddingSize {
    glm::ivec3 voxels{0};
    double megabytes = 0.0; ///< reserved memory of the volume, MB (1e6 bytes)
};
Result<EmbeddingSize> embeddingSize(const Setup& setup);

/// A part in its stock, as runs.
struct EmbeddedSetup {
    RunVolume workpiece;
    std::vector<PropertyIndex> bodyProperties; ///< protected, per body
    PropertyIndex stockProperty = airProperty; ///< machinable
    double partVolume = 0.0;                   ///< mm³ of protected runs
    double stockVolume = 0.0;                  ///< mm³ of machinable runs
    std::vector<std::string> warnings;         ///< English: open meshes, overlapping bodies
};

/// Fills a grid with the stock (machinable) and the bodies (protected). Where bodies overlap the later one has the
/// place. A body whose surface is open, folded or turned is filled by the rules of voxelise(), with a warning that says
/// where. Stock faces lie on run ends along the run axis exactly and on voxel faces across (the grid is the stock box,
/// rounded up to whole voxels; the overhang is air). Errors: volumeTooLarge, outOfMemory, volumeOutOfMemory,
/// nameUnknown (a material), partOutsideStock, cancelled.
/// @param materials looked through by id before the library: those that a project keeps
Result<EmbeddedSetup> embed(const Model& model, const Setup& setup, const std::vector<Property>& materials,
                            Progress& progress);

} // namespace burin

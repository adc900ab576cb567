// SPDX-FileCopyrightText: 2026 The Burin authors
// SPDX-License-Identifier: Apache-2.0
#pragma once

#include "core/base/progress.h"
#include "core/base/result.h"
#include "core/cad/model.h"
#include "core/volume/runs/run_volume.h"

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
/// Errors: stockInvalid (a voxel or a stock box that is none), volumeTooLarge.
Result<EmbeddingSize> embeddingSize(const Setup& setup);

/// Something doubtful about a body, and how it was filled all the same (rules of voxelise()).
struct EmbeddingFinding {
    enum class Kind {
        openSurface,        ///< what its surface encloses on some scanlines is a guess
        unseenOpening,      ///< its surface is open, but between the scanlines alone
        turnedFaces,        ///< faces do not agree on what is outside: filled by parity
        insideOut,          ///< a shell is turned inwards: filled as well
        overlappingShells,  ///< of one body: whatever any of them holds was filled
        duplicateTriangles, ///< counted once
        tooSmall,           ///< no scanline meets it: nothing of it is protected
        overlappingBodies   ///< the later one has the place
    };
    Kind kind = Kind::openSurface;
    std::string body{};        ///< its name; "Body 2" where the model has none
    std::size_t count = 0;     ///< scanlines; triangles where those are there twice
    std::size_t openEdges = 0; ///< of an open surface
    std::size_t rims = 0;      ///< that they form; 0: not known
    std::string otherBody{};   ///< that it overlaps
    double volume = 0.0;       ///< mm³, of an overlap of bodies
    Box place{};               ///< mm, setup frame; empty: not known

    /// What was filled is what it would be without.
    bool harmless() const noexcept { return kind == Kind::unseenOpening || kind == Kind::duplicateTriangles; }
};

/// A part in its stock, as runs.
struct EmbeddedSetup {
    RunVolume workpiece;
    std::vector<PropertyIndex> bodyProperties; ///< protected, per body
    PropertyIndex stockProperty = airProperty; ///< machinable
    double partVolume = 0.0;                   ///< mm³ of protected runs
    double stockVolume = 0.0;                  ///< mm³ of machinable runs
    std::vector<EmbeddingFinding> findings;    ///< by body
};

/// Fills a grid with the stock (machinable) and the bodies (protected). Where bodies overlap the later one has the
/// place. A body whose surface is open, folded or turned is filled by the rules of voxelise(), with a finding that says
/// where. Stock faces lie on run ends along the run axis exactly and on voxel faces across (the grid is the stock box,
/// rounded up to whole voxels; the overhang is air). Errors: volumeTooLarge, outOfMemory, volumeOutOfMemory,
/// nameUnknown (a material), partOutsideStock, cancelled.
/// @param materials looked through by id before the library: those that a project keeps
Result<EmbeddedSetup> embed(const Model& model, const Setup& setup, const std::vector<Property>& materials,
                            Progress& progress);

} // namespace burin

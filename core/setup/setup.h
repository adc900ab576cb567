// SPDX-FileCopyrightText: 2026 The Burin authors
// SPDX-License-Identifier: Apache-2.0
#pragma once

#include "core/base/progress.h"
#include "core/base/result.h"
#include "core/base/setup_id.h"
#include "core/cad/model.h"
#include "core/geometry/placement.h"
#include "core/setup/body_role.h"
#include "core/setup/cylinder_shape.h"
#include "core/setup/material_amount.h"
#include "core/setup/material_region.h"
#include "core/setup/obstacle.h"
#include "core/setup/program_zero.h"
#include "core/setup/stock_volume.h"
#include "core/volume/runs/run_volume.h"

#include <array>
#include <memory>
#include <optional>
#include <string>
#include <string_view>
#include <vector>

namespace burin {

/// What the raw material looks like before it is milled.
enum class StockForm : std::uint8_t {
    box,      ///< its edges along the axes of the setup frame
    cylinder, ///< round bar, whichever way it lies
    solids,   ///< the bodies of the model whose role is stock
    file      ///< voxel by voxel, as a file had it
};
inline constexpr std::array stockForms{StockForm::box, StockForm::cylinder, StockForm::solids, StockForm::file};
/// Stable id, for files and the command line: "box", "cylinder", "solids", "file".
std::string_view idOf(StockForm form) noexcept;
std::optional<StockForm> stockFormFromId(std::string_view id) noexcept;

/// Where a stock that another setup left comes from.
struct LeftBy {
    SetupId setup = firstSetup;
    std::int64_t digest = 0; ///< Project::jobDigest of that setup when it was taken: another one says that it changed
};

/// How a part lies in its stock: one clamping. Functions that take a model with a setup take it as it lies there
/// (placed(), core/cad/model.h).
struct Setup {
    Placement placement;        ///< from the model's own frame to the setup frame
    double voxel = 0.5;         ///< mm
    glm::dvec3 marginLow{5.0};  ///< mm of stock below the part along x, y, z
    glm::dvec3 marginHigh{5.0}; ///< mm above
    std::string stockMaterial = "aluminium-6061";
    std::vector<std::string> bodyMaterials; ///< per body; empty: the stock's
    std::vector<BodyRole> roles;            ///< per body; those that it does not name are parts
    std::vector<MaterialRegion> regions;    ///< layers of the stock that have a material of their own
    StockForm form = StockForm::box;
    bool stated = false;    ///< box or cylinder as they stand here, whatever the part; else the part and the margins
    CylinderShape cylinder; ///< of that form; its axis is the user's, the rest `placeStock` fills in unless stated
    /// Of that form: voxel, run axis and materials are its own, whatever of it was protected can be milled, and the
    /// material that most of it is stands for the stock's.
    StockVolume::Shared volume;
    std::optional<LeftBy> leftBy; ///< of that form, where the volume is what another setup left
    bool freeCarving = false;     ///< no part is wanted: nothing pushes back
    Box stock;                  ///< mm: the stock, or the box around it; filled by `placeStock` unless a box is stated
    ProgramZero zero;           ///< where the programs have it
    glm::dvec3 workOffset{0.0}; ///< program zero in the setup frame, mm; filled by `placeStock`
    RunAxis runs = RunAxis::z;  ///< of the volume: along the spindle, or what comes next to it
};

glm::dvec3 topOf(const Setup& setup) noexcept; ///< mm: the centre of the top face of the stock's box

BodyRole roleOf(const Setup& setup, std::size_t body) noexcept;

/// Its name; "Body 2" where the model has none.
std::string nameOf(const Model& model, std::size_t body);

/// Ids of all materials that it names, each once: the stock's, those of bodies, those of layers. Not those of a stock
/// from a file, which brings its own.
std::vector<std::string> materialsUsed(const Setup& setup);

/// The bodies that nothing may cut: the model itself, shared, where that is all of them. Copies their meshes else.
std::shared_ptr<const Model> protectedPart(std::shared_ptr<const Model> model, const Setup& setup);

/// The bodies whose role is fixture, as obstacles without a margin. Errors: those of fixturesOf.
Result<std::vector<Obstacle>> bodyFixtures(const Model& model, const Setup& setup);

/// Finds where the stock lies. A box or cylinder that is not stated is the smallest around part and inserts, grown by
/// the margins: a cylinder goes round the middle of their box; its ends have the margins of the axis that it lies
/// nearest to, its side the largest of the others. A stock from a file lies where the file says. Then
/// where program zero is, as placeZero. Errors: stockInvalid (a margin below 0 or not finite, a voxel not > 0, no part
/// and no free carving, a stated stock that is none, stock of solids or of a file without one), those of checkRegions
/// and placeZero.
Result<Setup> placeStock(const Model& model, Setup setup);

/// Finds where program zero is: on the stock as it lies, on the part, or at its point.
/// @param model as it lies in the setup. Errors: stockInvalid (zero on a part where there is none, a point that is not
/// finite).
Result<Setup> placeZero(const Model& model, Setup setup);

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

/// What became of a graded region: the values that were found in it, sorted into bands.
struct RegionGrading {
    std::string region, value, unit; ///< names, and the value's unit
    double low = 0.0, high = 0.0;    ///< of the value, in its unit
    int bands = 0;
    double error = 0.0; ///< by which a place's value may be off, in its unit
};

/// A part in its stock, as runs.
struct EmbeddedSetup {
    RunVolume workpiece;
    std::vector<PropertyIndex> bodyProperties;   ///< per body; air for one that is not embedded
    PropertyIndex stockProperty = airProperty;   ///< machinable
    std::vector<PropertyIndex> regionProperties; ///< per region; of a graded one the material that it is a grade of
    std::vector<RegionGrading> gradings;         ///< of the graded ones, in order
    RunAmounts untouched;                        ///< what it holds before anything is milled
    double partVolume = 0.0;                     ///< mm³ of protected runs
    double stockVolume = 0.0;                    ///< mm³ of machinable runs
    std::vector<EmbeddingFinding> findings;      ///< by body
};

/// Each material of the stock before anything is milled. Any thread.
std::vector<MaterialAmount> materialAmounts(const EmbeddedSetup& embedded);

/// Fills a grid with the stock, its layers in their order, the inserts, then what is protected. Where protected bodies
/// overlap the later one has the place. A body whose surface is open, folded or turned is filled by the rules of
/// voxelise(), with a finding that says where. Faces of a stock that is a box lie on run ends along the run axis
/// exactly and on voxel faces across (the grid is the stock's box, rounded up to whole voxels; the overhang is air).
/// Errors: volumeTooLarge, outOfMemory, volumeOutOfMemory, nameUnknown (a material), partOutsideStock (part or insert
/// out of the stock's box, or the part out of a stock of another form), argumentInvalid (inserts that overlap by more
/// than a thousandth of the smaller, an insert too small for the voxels, more materials than a cut can tell apart, a
/// material without a specific cutting energy or Kienzle force, what gradingOf finds), cancelled.
/// @param materials looked through by id before the library: those that a project keeps
Result<EmbeddedSetup> embed(const Model& model, const Setup& setup, const std::vector<Property>& materials,
                            Progress& progress);

} // namespace burin

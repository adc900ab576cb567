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

/// The shape of the raw material before it is milled.
enum class StockForm : std::uint8_t {
    box,      ///< edges parallel to the axes of the setup frame
    cylinder, ///< round bar of any orientation
    solids,   ///< the bodies of the model whose role is stock
    file      ///< voxel by voxel, as read from a file
};
inline constexpr std::array stockForms{StockForm::box, StockForm::cylinder, StockForm::solids, StockForm::file};
/// Stable id, for files and the command line: "box", "cylinder", "solids", "file".
std::string_view idOf(StockForm form) noexcept;
std::optional<StockForm> stockFormFromId(std::string_view id) noexcept;

/// The origin of a stock that was left by another setup.
struct LeftBy {
    SetupId setup = firstSetup;
    std::int64_t digest = 0; ///< Project::jobDigest of that setup at that time; a different one shows that it changed
};

/// How a part lies in its stock: one clamping. Functions that take a model together with a setup expect the model in
/// the setup frame (placed(), core/cad/model.h).
struct Setup {
    Placement placement;        ///< from the model's own frame to the setup frame
    double voxel = 0.5;         ///< mm
    glm::dvec3 marginLow{5.0};  ///< stock below the part along x, y, z, mm
    glm::dvec3 marginHigh{5.0}; ///< stock above the part, mm
    std::string stockMaterial = "aluminium-6061";
    std::vector<std::string> bodyMaterials; ///< per body; empty: the stock's material
    std::vector<BodyRole> roles;            ///< per body; bodies beyond its end are parts
    std::vector<MaterialRegion> regions;    ///< layers of the stock with a material of their own
    StockForm form = StockForm::box;
    bool stated = false;    ///< box or cylinder as given here; otherwise derived from part and margins
    CylinderShape cylinder; ///< of that form; the user gives its axis; `placeStock` sets the rest unless stated
    /// The stock of form `file`. Voxel size, run axis and materials are taken from it; material that was protected in
    /// it can be milled, and its most frequent material counts as the stock's.
    StockVolume::Shared volume;
    std::optional<LeftBy> leftBy; ///< of form `file`, if another setup left the volume
    bool freeCarving = false;     ///< carving without a part: nothing holds the tool back
    Box stock;                    ///< mm: the stock, or the box around it; set by `placeStock` unless a box is stated
    ProgramZero zero;             ///< of the setup's programs
    glm::dvec3 workOffset{0.0};   ///< program zero in the setup frame, mm; set by `placeStock`
    RunAxis runs = RunAxis::z;    ///< of the volume: along the spindle, or nearest to it
};

glm::dvec3 topOf(const Setup& setup) noexcept; ///< centre of the top face of the stock's box, mm

BodyRole roleOf(const Setup& setup, std::size_t body) noexcept;

/// Returns the name of a body; "Body 2" if the model gives none.
std::string nameOf(const Model& model, std::size_t body);

/// Returns the ids of all materials that the setup names, each once: those of the stock, the bodies and the layers.
/// Excludes the materials of a stock from a file, which the file provides.
std::vector<std::string> materialsUsed(const Setup& setup);

/// Returns the model's protected bodies: the model itself, shared, if all bodies are protected; otherwise a model with
/// copies of their meshes.
std::shared_ptr<const Model> protectedPart(std::shared_ptr<const Model> model, const Setup& setup);

/// Returns the bodies whose role is fixture, as obstacles without a margin. Errors: those of fixturesOf.
Result<std::vector<Obstacle>> bodyFixtures(const Model& model, const Setup& setup);

/// Determines the position of the stock. A box or cylinder that is not stated is the smallest around part and inserts,
/// enlarged by the margins: a cylinder is centred on their box; its ends get the margins of the coordinate axis nearest
/// to its own axis, its side the largest margin of the other two. A stock from a file lies where the file says. Then
/// determines program zero, as placeZero does. Errors: stockInvalid (a margin below 0 or not finite, a voxel not > 0,
/// no part and no free carving, an invalid stated stock, stock of solids or of a file without one), those of
/// checkRegions and placeZero.
Result<Setup> placeStock(const Model& model, Setup setup);

/// Determines the position of program zero: on the stock as placed, on the part, or at its point.
/// @param model in the setup frame. Errors: stockInvalid (zero on a part where there is none, a point that is not
/// finite).
Result<Setup> placeZero(const Model& model, Setup setup);

/// The size and memory requirement of a grid that is not made yet.
struct EmbeddingSize {
    glm::ivec3 voxels{0};
    double megabytes = 0.0; ///< reserved memory of the volume, MB (1e6 bytes)
};
/// Errors: stockInvalid (an invalid voxel size or stock box), volumeTooLarge.
Result<EmbeddingSize> embeddingSize(const Setup& setup);

/// A defect of a body, and how the body was filled despite it (rules of voxelise()).
struct EmbeddingFinding {
    enum class Kind {
        openSurface,        ///< on some scanlines, what the surface encloses is a guess
        unseenOpening,      ///< the surface is open, but only between the scanlines
        turnedFaces,        ///< faces are oriented inconsistently: filled by parity
        insideOut,          ///< a shell is oriented inwards: filled as well
        overlappingShells,  ///< of one body: their union was filled
        duplicateTriangles, ///< counted once
        tooSmall,           ///< no scanline crosses it: none of it is protected
        overlappingBodies   ///< the later one takes precedence
    };
    Kind kind = Kind::openSurface;
    std::string body{};        ///< its name; "Body 2" if the model gives none
    std::size_t count = 0;     ///< of scanlines; of triangles for duplicateTriangles
    std::size_t openEdges = 0; ///< of an open surface
    std::size_t rims = 0;      ///< closed loops formed by the open edges; 0: not known
    std::string otherBody{};   ///< that the body overlaps
    double volume = 0.0;       ///< mm³, of an overlap of bodies
    Box place{};               ///< mm, setup frame; empty: not known

    /// Whether what was filled is the same as without the defect.
    bool harmless() const noexcept { return kind == Kind::unseenOpening || kind == Kind::duplicateTriangles; }
};

/// The result of grading a region: the values found in it, sorted into bands.
struct RegionGrading {
    std::string region, value, unit; ///< names, and the value's unit
    double low = 0.0, high = 0.0;    ///< of the value, in its unit
    int bands = 0;
    double error = 0.0; ///< largest error of the value at any point, in its unit
};

/// A part in its stock, represented as runs.
struct EmbeddedSetup {
    RunVolume workpiece;
    std::vector<PropertyIndex> bodyProperties;   ///< per body; air for a body that is not embedded
    PropertyIndex stockProperty = airProperty;   ///< machinable
    std::vector<PropertyIndex> regionProperties; ///< per region; of a graded region the base material of its grades
    std::vector<RegionGrading> gradings;         ///< of the graded regions, in order
    RunAmounts untouched;                        ///< amounts in the workpiece before milling
    double partVolume = 0.0;                     ///< mm³ of protected runs
    double stockVolume = 0.0;                    ///< mm³ of machinable runs
    std::vector<EmbeddingFinding> findings;      ///< in the order of the bodies
};

/// Returns the amount of each material of the stock before milling. Thread-safe.
std::vector<MaterialAmount> materialAmounts(const EmbeddedSetup& embedded);

/// Fills a grid with the stock, its layers in their order, the inserts, and finally the protected bodies. Where
/// protected bodies overlap, the later one takes precedence. A body whose surface is open, folded or inverted is filled
/// by the rules of voxelise(), with a finding that gives the position. The faces of a box stock lie exactly on run ends
/// along the run axis and on voxel faces across it (the grid is the stock's box, rounded up to whole voxels; the excess
/// is air).
/// Errors: volumeTooLarge, outOfMemory, volumeOutOfMemory, nameUnknown (a material), partOutsideStock (part or insert
/// outside the stock's box, or the part outside a stock of another form), argumentInvalid (inserts that overlap by more
/// than a thousandth of the smaller, an insert too small for the voxels, more materials than a cut can distinguish,
/// errors of gradingOf), resourceInvalid (a material without a specific cutting energy or Kienzle force), cancelled.
/// @param materials searched by id before the library: those stored in a project
Result<EmbeddedSetup> embed(const Model& model, const Setup& setup, const std::vector<Property>& materials,
                            Progress& progress);

} // namespace burin

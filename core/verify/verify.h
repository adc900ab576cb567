// SPDX-FileCopyrightText: 2026 The Burin authors
// SPDX-License-Identifier: Apache-2.0
#pragma once

#include "core/base/progress.h"
#include "core/base/result.h"
#include "core/cad/import.h"
#include "core/geometry/mesh_distance.h"
#include "core/machine/machine_profile.h"
#include "core/nc/control.h"
#include "core/nc/parser.h"
#include "core/path/path.h"
#include "core/setup/obstacle.h"
#include "core/setup/setup.h"
#include "core/tool/tool.h"
#include "core/verify/load.h"
#include "core/verify/machine_time.h"

#include <string>
#include <vector>

namespace burin {

/// A program, and all that it is judged against. Coordinates of the program are in the frame of the work offset,
/// everything else is in the setup frame.
struct VerifyRequest {
    const ParsedProgram* program = nullptr;
    const Model* model = nullptr;       ///< all bodies, with the roles of `setup`
    const Model* partModel = nullptr;   ///< the bodies that nothing may cut; null: all of them
    const MeshDistance* part = nullptr; ///< of their meshes, chord <= 0.005 mm
    Setup setup;
    std::vector<Property> materials;  ///< by id, used before those of the library: the ones that a project stores
    std::vector<Obstacle> obstacles;  ///< only those that are switched on are judged
    Tool tool;                        ///< of every move, if `tools` is empty
    std::vector<Tool> tools;          ///< tools that the program may call by their numbers; empty: it may call only one
    const Control* control = nullptr; ///< reads the program; null: what depends on it is not judged
    int workOffset = 54;              ///< that stores the zero of the setup, numbered as in NcMotion::workOffset
    /// The program that milled the workpiece before, and the tools that it may call: as in `tools`, or one for all. It
    /// is not judged. Null: the workpiece is fresh.
    const ParsedProgram* before = nullptr;
    std::vector<Tool> toolsBefore;
    MachineProfile machine;
    Box travel; ///< mm, setup frame: where the machine lets the tip go; empty: the location of its travel is not known
    double gougeTolerance = 0.02; ///< mm
    double sampling = 0.1;        ///< mm along moves
    /// mm: largest difference between the allowance left and that of `promised`, and largest stock left at the part by
    /// blended corners; 0: neither is judged.
    double excessTolerance = 0.1;
    /// paths that the program is to follow, setup frame; null: none is known
    const std::vector<Path>* promised = nullptr;
    double nearDistance = 1.0; ///< mm: a shank or holder that passes closer is reported as a warning; 0: none is
    /// number of the worst samples that are judged on the exact B-rep; 0, or no B-rep: mesh only
    std::size_t exactSamples = 500;
    ImportOptions import; ///< worker and limits for the exact distances

    const Model& protectedBodies() const noexcept { return partModel != nullptr ? *partModel : *model; }
};

enum class FindingKind : std::uint8_t {
    gouge,             ///< amount: mm of depth
    rapidInStock,      ///< amount: mm³ that the rapid would remove
    shankCollision,    ///< amount: mm³ of overlap
    holderCollision,   ///< amount: mm³ of overlap
    spindleOff,        ///< amount: mm³ removed while the spindle stands still
    spindleOn,         ///< amount: mm³ removed by a tool that doesn't turn, while the spindle turns
    travelLimit,       ///< amount: mm of travel that an axis would need
    feedLimit,         ///< amount: mm/min
    spindleLimit,      ///< amount: 1/min
    rotaryLimit,       ///< amount: degrees, the value of a rotary axis beyond its limits
    unknownStart,      ///< a feed move from a position that the program has not set; amount: 0
    obstacleCollision, ///< the tool enters a fixture or a keep-out volume; amount: mm of depth
    // Load of the cut on spindle and tool, beyond `Finding::limit`:
    spindlePower,  ///< amount: W at the cutter
    spindleTorque, ///< amount: N m
    toolBreakage,  ///< amount: N/mm² of bending stress; limit: strength over `breakingReserve`
    toolBending,   ///< amount: mm of deflection where the tool cuts
    chipLoad,      ///< amount: mm, thickest chip of a tooth
    depthOfCut,    ///< amount: mm along the tool's axis
    widthOfCut,    ///< amount: mm across it
    centrePlunge,  ///< straight down into material with a tool that does not cut at its centre; amount: mm of depth
    // Settings of the program, at the line that makes them:
    toolUnknown,         ///< a tool that the request does not have: nothing after it is judged; amount: its number
    toolNotLoaded,       ///< feeds before it loads the tool that it names; amount: 0
    lengthOffsetMissing, ///< moves along Z with a tool whose length offset is not in force; amount: its number
    lengthOffsetOfOther, ///< the length of another tool; amount: the H number
    workOffsetOther,     ///< another work offset than the setup's; amount: its number, as in NcMotion::workOffset
    spindleReversed,     ///< feeds while the spindle turns in the wrong direction for the cutter; amount: 1/min
    cornerGouge,         ///< a corner that the program lets the control cut (G64) enters the part; amount: mm of depth
    cornerExcess,        ///< such a corner leaves stock at the part; amount: mm
    allowanceDiffers,    ///< from that of the path to follow; amount: mm left on the part; limit: mm left by the path
    // For the program as a whole, without a line (0):
    partNotProtected, ///< bodies too small for the voxels, which are not protected at all; amount: how many
};
inline constexpr FindingKind lastFindingKind = FindingKind::partNotProtected;
/// Stable id of a kind, for JSON: "gouge", "rapid_in_stock", …
const char* idOf(FindingKind kind);
/// The unit of a kind's amount, in ASCII: "mm", "mm^3"; empty if the amount has no meaning.
const char* unitOf(FindingKind kind);

struct Finding {
    FindingKind kind = FindingKind::gouge;
    std::uint32_t line = 0;  ///< in the program's text, from 1, of the cause; 0: none
    glm::dvec3 place{0.0};   ///< mm, setup frame
    double amount = 0.0;     ///< in the unit of the kind
    double limit = 0.0;      ///< in the same unit, the limit that was exceeded; 0: the kind has none
    std::uint32_t count = 1; ///< number of lines that it stands for, if one is reported for many near each other
};

/// What shank or holder comes close to.
enum class NearTo : std::uint8_t { stock, part, obstacle };

/// Shank or holder passes something closer than `VerifyRequest::nearDistance` without touching it: a warning, no fault.
struct NearPass {
    ToolSection section = ToolSection::holder;
    NearTo to = NearTo::part;
    std::uint32_t line = 0; ///< of the program's text, from 1
    glm::dvec3 place{0.0};  ///< mm, setup frame, on the neighbour
    /// mm; exact on the mesh of the part or an obstacle; to stock, to the resolution of its runs
    double distance = 0.0;
    /// number of lines that pass the same neighbour within `nearPlace` of there; this is the nearest
    std::uint32_t lines = 1;
};
inline constexpr double nearPlace = 10.0; ///< mm
/// Stable id, for JSON: "holder_near_part", "shank_near_stock", …
std::string idOf(const NearPass& pass);

/// The collision area of a line (paper, eq. 4): surface voxels of shank and holder that are surface voxels of the
/// workpiece, at the pose of the line with the largest overlap.
struct TouchedVoxels {
    std::uint32_t line = 0;          ///< of the program's text, from 1
    ToolPose pose;                   ///< setup frame
    double edge = 0.0;               ///< mm, of the voxels
    std::vector<glm::dvec3> centres; ///< mm, setup frame
};

/// Signed distance from the part's surface to what the program leaves there.
struct DeviationSample {
    glm::dvec3 place{0.0}; ///< on the part, mm, setup frame
    double excess = 0.0;   ///< mm of stock along the normal; 0: bare
    double gouge = 0.0;    ///< mm by which the tool entered the part here; 0 within the tolerance for gouges
    bool reachable = true; ///< whether the tool can touch the part here without entering it or going below it
};

/// A motion that exceeds a limit of spindle or tool which a lower feed can keep: power, torque, bending stress or chip.
struct FeedLimit {
    std::uint32_t motion = 0; ///< index in ParsedProgram::motions
    double feed = 0.0;        ///< mm/min: the greatest feed within the limits; 0: no feed is
};

/// The result of re-simulating a program on its setup.
struct VerifyReport {
    double gougeMax = 0.0;     ///< mm, >= 0: exact where samples were judged exactly, otherwise on the mesh
    double gougeMaxMesh = 0.0; ///< mm, >= 0
    std::size_t samples = 0;   ///< number of samples along the moves that were judged
    std::size_t exactSamples = 0;
    double excessMax = 0.0;      ///< mm of stock left over reachable points of the part, along its normal
    double excessMean = 0.0;     ///< mm, over reachable points
    double reachableShare = 0.0; ///< of the part's surface, 0 … 1
    double removed = 0.0;        ///< mm³
    /// share of the cutting samples over the part's outline, shrunk by the radius, that are within 0.1 mm of the part
    double onPartShare = 0.0;
    std::size_t onPartSamples = 0;           ///< number of these cutting samples
    double machiningSeconds = 0.0;           ///< with the machine's accelerations, corners, dwells and tool changes
    double secondsWithoutAcceleration = 0.0; ///< only at the programmed feeds and the machine's rapid rates
    std::vector<MotionTime> times;           ///< by index in ParsedProgram::motions
    std::vector<MotionLoad> loads;           ///< of motions that remove material, in program order
    std::vector<LoadStep> loadSteps;         ///< the same over time
    int toolChanges = 0;                     ///< included in the time, with that of the first tool
    int untimedMoves = 0;                    ///< not included in the time, as their path is not known (MachiningTime)
    RapidMode rapids = RapidMode::synchronised; ///< the mode in which rapids were judged
    std::vector<StatedPathMode> pathModes;      ///< what the program itself states about corners; included in the time
    std::vector<Finding> findings;              ///< one of a kind for each cause, in program order
    std::vector<Finding> warnings;              ///< loads beyond estimated limits, and bending; the worst first
    std::vector<FeedLimit> feedLimits; ///< of motions whose feed is too high for spindle or tool, in program order
    std::vector<NearPass> nearPasses;  ///< one per location, the nearest first
    std::vector<DeviationSample> deviations;
    std::vector<TouchedVoxels> touched; ///< of the lines with the largest overlap of shank or holder, in program order

    /// True if nothing was found; a gouge within the tolerance is not a finding.
    bool passed() const noexcept { return findings.empty(); }
};

class KeptCheck;

/// Re-simulates a program on a fresh workpiece, or on what an earlier program left, and judges it: flutes, shank and
/// holder against stock and part, rapids, limits, and gouges on the fine mesh and, at the worst samples, on exact
/// geometry. core/verify/README.md states the rules. Nothing is judged after the first move of a tool that the request
/// does not have.
/// @param machined  if not null, receives the workpiece as the program leaves it
/// @param kept  if not null, spares what was examined in an earlier check, and gets what this one finds; the report
/// does
///        not depend on it. Not used after another program (`before`).
/// Errors: those of embed and exactSignedDistances, nameUnknown (a tool of `before`), notSupported (several tools, but
/// one for all in the request), cancelled.
Result<VerifyReport> verify(const VerifyRequest& request, Progress& progress, VolumeSnapshot* machined = nullptr,
                            KeptCheck* kept = nullptr);

} // namespace burin

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

/// A program, and all that it is judged against. Frames: the program's coordinates are those of the work offset; the
/// rest is in the setup frame.
struct VerifyRequest {
    const ParsedProgram* program = nullptr;
    const Model* model = nullptr;       ///< all bodies, with the roles of `setup`
    const Model* partModel = nullptr;   ///< those that nothing may cut; null: all of them
    const MeshDistance* part = nullptr; ///< of their meshes, chord <= 0.005 mm
    Setup setup;
    std::vector<Property> materials; ///< by id, before the library's: those that a project keeps
    std::vector<Obstacle> obstacles; ///< those that are on are judged
    Tool tool;                       ///< of every move, where `tools` is empty
    std::vector<Tool> tools;         ///< those that the program may call by their numbers; empty: it may call one alone
    const Control* control = nullptr; ///< that reads the program; null: what depends on it is not judged
    int workOffset = 54;              ///< that the setup's zero is kept in, as NcMotion::workOffset
    /// What the workpiece was milled with before, and the tools that it may call, as `tools`, or one for all. It is
    /// not judged. Null: the workpiece is fresh.
    const ParsedProgram* before = nullptr;
    std::vector<Tool> toolsBefore;
    MachineProfile machine;
    Box travel; ///< mm, setup frame: where the machine lets the tip go; empty: where its travel lies is not known
    double gougeTolerance = 0.02; ///< mm
    double sampling = 0.1;        ///< mm along moves
    /// mm by which the allowance left may differ from that of `promised`, and blended corners may leave stock at the
    /// part; 0: neither is judged.
    double excessTolerance = 0.1;
    const std::vector<Path>* promised = nullptr; ///< that the program is to follow, setup frame; null: none is known
    double nearDistance = 1.0;      ///< mm: a shank or holder that passes nearer is told, but is no fault; 0: none
    std::size_t exactSamples = 500; ///< of the worst samples are judged on the exact B-rep; 0, or no B-rep: mesh only
    ImportOptions import;           ///< worker and limits for the exact distances

    const Model& protectedBodies() const noexcept { return partModel != nullptr ? *partModel : *model; }
};

enum class FindingKind : std::uint8_t {
    gouge,             ///< amount: mm of depth
    rapidInStock,      ///< amount: mm³ that the rapid would tear off
    shankCollision,    ///< amount: mm³ of overlap
    holderCollision,   ///< amount: mm³ of overlap
    spindleOff,        ///< amount: mm³ removed with the spindle standing still
    travelLimit,       ///< amount: mm of way that one axis would have to have
    feedLimit,         ///< amount: mm/min
    spindleLimit,      ///< amount: 1/min
    unknownStart,      ///< a feed move from a place that the program has not set; amount: 0
    obstacleCollision, ///< the tool enters a fixture or a keep-out volume; amount: mm of depth
    // What the cut asks of spindle and tool, beyond `Finding::limit`:
    spindlePower,  ///< amount: W at the cutter
    spindleTorque, ///< amount: N m
    toolBreakage,  ///< amount: N/mm² of bending stress; limit: strength over `breakingReserve`
    toolBending,   ///< amount: mm that the tool gives way where it cuts
    chipLoad,      ///< amount: mm, thickest chip of a tooth
    depthOfCut,    ///< amount: mm along the tool's axis
    widthOfCut,    ///< amount: mm across it
    centrePlunge,  ///< straight down into material with a tool that does not cut at its centre; amount: mm of depth
    // What the program sets, at the line that does:
    toolUnknown,         ///< a tool that the request does not have: nothing behind it is judged; amount: its number
    toolNotLoaded,       ///< feeds before it loads the tool that it names; amount: 0
    lengthOffsetMissing, ///< moves along Z with a tool whose length is not in force; amount: its number
    lengthOffsetOfOther, ///< the length of another tool; amount: the H number
    workOffsetOther,     ///< in another work offset than the setup's; amount: its number, as NcMotion::workOffset
    spindleReversed,     ///< feeds while the spindle turns against the cutter's hand; amount: 1/min
    cornerGouge,         ///< a corner that the program lets the control cut (G64) enters the part; amount: mm of depth
    cornerExcess,        ///< such a corner leaves stock at the part; amount: mm
    allowanceDiffers, ///< from that of the path to follow; amount: mm left on the part; limit: mm that the path leaves
    // Of the program as a whole, without a line (0):
    partNotProtected, ///< bodies too small for the voxels: nothing of them is protected; amount: how many
};
inline constexpr FindingKind lastFindingKind = FindingKind::partNotProtected;
/// Stable id of a kind, for JSON: "gouge", "rapid_in_stock", …
const char* idOf(FindingKind kind);
/// What a kind's amount is counted in, in ASCII: "mm", "mm^3"; empty where the amount says nothing.
const char* unitOf(FindingKind kind);

struct Finding {
    FindingKind kind = FindingKind::gouge;
    std::uint32_t line = 0;  ///< of the program's text, from 1: of what causes it; 0: it has none
    glm::dvec3 place{0.0};   ///< mm, setup frame
    double amount = 0.0;     ///< in the unit that the kind states
    double limit = 0.0;      ///< in the same unit, that was to be kept; 0: the kind has none
    std::uint32_t count = 1; ///< lines that it stands for, where one is told for many near by
};

/// What shank or holder comes near to.
enum class NearTo : std::uint8_t { stock, part, obstacle };

/// Shank or holder passes something nearer than `VerifyRequest::nearDistance` without touching it: a warning, no fault.
struct NearPass {
    ToolSection section = ToolSection::holder;
    NearTo to = NearTo::part;
    std::uint32_t line = 0;  ///< of the program's text, from 1
    glm::dvec3 place{0.0};   ///< mm, setup frame: of what it comes near to
    double distance = 0.0;   ///< mm; to the part or an obstacle exact on its mesh, to stock as its runs know it
    std::uint32_t lines = 1; ///< on which it passes the same neighbour within `nearPlace` of there; this is the nearest
};
inline constexpr double nearPlace = 10.0; ///< mm
/// Stable id, for JSON: "holder_near_part", "shank_near_stock", …
std::string idOf(const NearPass& pass);

/// The collision area of a line (paper, eq. 4): surface voxels of shank and holder that are surface voxels of the
/// workpiece, at the pose of the line where they overlap most.
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
    double gouge = 0.0;    ///< mm by which the tool went into the part here; 0 within the tolerance for gouges
    bool reachable = true; ///< the tool could touch the part here without entering it or going below it
};

/// A motion that asks for more than spindle or tool bear, of what comes down with the feed: power, torque, bending
/// stress and chip.
struct FeedLimit {
    std::uint32_t motion = 0; ///< place in ParsedProgram::motions
    double feed = 0.0;        ///< mm/min: the greatest at which it does not; 0: it does at any
};

/// What re-simulating a program on its setup found.
struct VerifyReport {
    double gougeMax = 0.0;     ///< mm, >= 0: the exact judgement where there is one, the mesh's elsewhere
    double gougeMaxMesh = 0.0; ///< mm, >= 0
    std::size_t samples = 0;   ///< places along the moves that were judged
    std::size_t exactSamples = 0;
    double excessMax = 0.0;      ///< mm of stock left over reachable places of the part, along its normal
    double excessMean = 0.0;     ///< mm, over reachable places
    double reachableShare = 0.0; ///< of the part's surface, 0 … 1
    double removed = 0.0;        ///< mm³
    double onPartShare = 0.0; ///< of cutting samples over the part's outline shrunk by the radius: within 0.1 mm of it
    std::size_t onPartSamples = 0;              ///< how many those samples are
    double machiningSeconds = 0.0;              ///< with the machine's accelerations, corners, dwells and tool changes
    double secondsWithoutAcceleration = 0.0;    ///< at the programmed feeds and the machine's rapids alone
    std::vector<MotionTime> times;              ///< by place in ParsedProgram::motions
    std::vector<MotionLoad> loads;              ///< of what removes something, in program order
    std::vector<LoadStep> loadSteps;            ///< the same over time
    int toolChanges = 0;                        ///< that the time contains, the first tool's included
    int untimedMoves = 0;                       ///< that it lacks, as their way is not known (MachiningTime)
    RapidMode rapids = RapidMode::synchronised; ///< the way that rapids were judged on
    std::vector<StatedPathMode> pathModes;      ///< what the program itself says of corners, and the time counts
    std::vector<Finding> findings;              ///< one of a kind for each cause, in program order
    std::vector<Finding> warnings;              ///< of loads beyond estimated limits, and of bending; the worst first
    std::vector<FeedLimit> feedLimits; ///< of motions that are fed too fast for spindle or tool, in program order
    std::vector<NearPass> nearPasses;  ///< one a place, the nearest first
    std::vector<DeviationSample> deviations;
    std::vector<TouchedVoxels> touched; ///< of the lines on which shank or holder overlap most, in program order

    /// True when nothing was found; a gouge within the tolerance is not a finding.
    bool passed() const noexcept { return findings.empty(); }
};

/// Re-simulates a program on a fresh workpiece, or as an earlier program left it, and judges it: flutes, shank and
/// holder against stock and part, rapids, limits, gouges on the fine mesh and, at the worst samples, on exact geometry.
/// core/verify/README.md states the rules. Behind the first move of a tool that the request does not have nothing is
/// judged.
/// @param machined  the workpiece as the program leaves it, where not null
/// Errors: those of embed and exactSignedDistances, nameUnknown (a tool of `before`), notSupported (several tools, and
/// a request with one for all), cancelled.
Result<VerifyReport> verify(const VerifyRequest& request, Progress& progress, VolumeSnapshot* machined = nullptr);

} // namespace burin

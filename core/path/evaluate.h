// SPDX-FileCopyrightText: 2026 The Burin authors
// SPDX-License-Identifier: Apache-2.0
#pragma once

#include "core/base/progress.h"
#include "core/base/result.h"
#include "core/cutting/cutting_force.h"
#include "core/geometry/mesh_distance.h"
#include "core/machine/machine_profile.h"
#include "core/path/edit.h"
#include "core/path/milling_interval.h"
#include "core/path/omission.h"
#include "core/path/path.h"
#include "core/path/stroke_entry.h"
#include "core/recording/sample.h"
#include "core/setup/obstacle.h"
#include "core/tool/tool.h"
#include "core/volume/runs/run_volume.h"

#include <functional>
#include <memory>
#include <string>
#include <vector>

namespace burin {

class HeightMap;
struct SourceStrokes;

/// Receives a stock on loan and may cut it; its changes are discarded afterwards.
using StockUse = std::function<Result<void>(RunVolume& stock)>;

/// What evaluating edits needs besides the recording.
struct PathContext {
    const MeshDistance* part = nullptr; ///< chord <= 0.005 mm
    Tool tool;
    CuttingConditions conditions; ///< in the stock's material
    /// By property, for a stock of several materials that are milled; entries of other properties are zero. Empty: one
    /// material.
    std::vector<CuttingConditions> materialConditions{};
    Coolant advisedCoolant = Coolant::off; ///< for the material
    MachineProfile machine;
    Box stock;                            ///< mm, setup frame
    std::vector<ObstacleSolid> obstacles; ///< links keep clear of those that are enabled
    double tickPeriod = 0.001;            ///< s
    /// Lends the stock as it is before this path, out of which the path is cut again for feed optimisation; may be
    /// empty. It may call its argument more than once; the result of the last call counts.
    std::function<Result<void>(const StockUse& use, Progress&)> lendStock{};
    /// What the paths before this one have cleared of the stock; null if there are none.
    std::shared_ptr<const HeightMap> cleared{};
    glm::dvec3 workOffset{0.0}; ///< mm, program zero in the setup frame; a control rounds coordinates relative to it
};

/// The effect of one edit.
struct EditReport {
    std::string edit; ///< its id
    std::size_t pointsBefore = 0, pointsAfter = 0;
    double largestDeviation = 0.0;    ///< mm, between the path before and after, at the worst point (never understated)
    glm::dvec3 worstPlace{0.0};       ///< mm, setup frame
    std::vector<Omission> omissions;  ///< parts that it left out because they cannot be machined
    double lengthBefore = 0.0;        ///< mm of strokes before it, if the edit may leave out any; else 0
    std::vector<StrokeEntry> entries; ///< of strokes that begin in material, if links plan their entries
    std::vector<glm::dvec3> inserted; ///< mm, setup frame: points that InsertPoint inserted, displaced by it
};

struct EvaluatedPath {
    Path path;
    std::vector<EditReport> reports;
    std::vector<MillingInterval> sides; ///< in order; empty unless requested (milling_side.h)
    /// The stock cleared by this path and all before it; null unless requested (milling_side.h)
    std::shared_ptr<const HeightMap> cleared;
    /// The paths before this one in milling order at the time of its evaluation. If the order changes, or one of them
    /// does, this path has to be evaluated again.
    std::vector<std::shared_ptr<const EvaluatedPath>> after;
    double errorBudget = 0.0; ///< mm, sum of the deviations of the edits that approximate the path before them
};

class KeptEdits;

/// What an evaluation gives and takes besides its result.
struct EvaluationHelp {
    /// States of earlier evaluations with the same sources; the evaluation begins with the newest of them that is
    /// before every changed edit, and keeps its own. Null: all edits are applied, none is kept.
    KeptEdits* kept = nullptr;
    /// Called once, on the evaluation's thread, with the path after the first edit that had to be applied anew, without
    /// those after it: for drawing it early. Points are left out where those that remain describe the same line to 0.01
    /// mm. Not called if no edit follows. May be empty.
    std::function<void(EvaluatedPath path)> first{};
    /// Sources that stay with the caller, in place of those given as argument: copied only if no kept state is before
    /// the first changed edit. May be null.
    const std::vector<SourceStrokes>* sources = nullptr;
};

/// Evaluates a path: sources in order, then each edit in order; edits that are not enabled are skipped. The order has
/// to preserve the guarantees of the edits: they come by their steps (edit_step.h), and an edit that may lead the path
/// into the part is followed by one that keeps it out before the path is linked. Intervals with shank contact, with the
/// spindle off, or that were undone are never part of a path. Without Link each stroke is reached by a straight rapid
/// move, which is suitable for drawings only. Thread-safe; the work is shared among all cores, and the result does not
/// depend on their number. Cost: 300,000 ticks on 360,000 triangles in about 8 s on two cores. Cancellable.
/// Errors: pathEmpty, argumentInvalid (a source of another tool, an edit that needs a tool that turns), notSupported (a
/// tilted tool that is no ball), pathGouges (all
/// of the path had to be left out; place: where, detail: remedyOf the reason), cancelled.
/// @param sources moved from where possible, so that hours of strokes are not held twice
Result<EvaluatedPath> evaluate(const std::string& name, std::vector<SourceStrokes> sources,
                               const std::vector<Edit>& edits, const PathContext& context, Progress& progress,
                               const EvaluationHelp& help = {});
/// The same for takes in memory. Errors: also those of StrokeReader.
Result<EvaluatedPath> evaluate(const std::string& name, const std::vector<Take>& takes, const std::vector<Edit>& edits,
                               const PathContext& context, Progress& progress);

} // namespace burin

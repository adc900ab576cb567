// SPDX-FileCopyrightText: 2026 The Burin authors
// SPDX-License-Identifier: Apache-2.0
#pragma once

#include "core/base/progress.h"
#include "core/base/result.h"
#include "core/cutting/cutting_force.h"
#include "core/geometry/mesh_distance.h"
#include "core/machine/machine_profile.h"
#include "core/path/edit.h"
#include "core/path/milling_stretch.h"
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

class ClearedHeights;
struct SourceStrokes;

/// Gets a stock for a while and may cut it; what it cuts is forgotten afterwards.
using StockUse = std::function<Result<void>(RunVolume& stock)>;

/// What evaluating edits needs to know besides the recording.
struct PathContext {
    const MeshDistance* part = nullptr; ///< chord <= 0.005 mm
    Tool tool;
    CuttingConditions conditions; ///< in the stock's material
    /// By property, in a stock of several materials that are milled; those of no such material are zero. Empty: one.
    std::vector<CuttingConditions> materialConditions{};
    Coolant advisedCoolant = Coolant::off; ///< by the material
    MachineProfile machine;
    Box stock;                            ///< mm, setup frame
    std::vector<ObstacleSolid> obstacles; ///< links keep clear of those that are on
    double tickPeriod = 0.001;            ///< s
    /// Lends the stock as it is before this path, which the path is cut out of again for feeds by engagement; may be
    /// empty. It may call what it is given more than once, and what that gave last counts.
    std::function<Result<void>(const StockUse& use, Progress&)> lendStock{};
    /// What the paths before this one have cleared of the stock; null: there are none.
    std::shared_ptr<const ClearedHeights> cleared{};
    glm::dvec3 workOffset{0.0}; ///< mm, program zero in the setup frame: where a control rounds figures
};

/// What one edit did.
struct EditReport {
    std::string edit; ///< its id
    std::size_t pointsBefore = 0, pointsAfter = 0;
    double largestDeviation = 0.0;    ///< mm, between the path before and after, at the worst place (never understated)
    glm::dvec3 worstPlace{0.0};       ///< mm, setup frame
    std::vector<Omission> omissions;  ///< what it left out as it can't be made
    double lengthBefore = 0.0;        ///< mm of strokes that it had before it, where it may leave out any; else 0
    std::vector<StrokeEntry> entries; ///< of strokes that begin in material, where links look after them
};

struct EvaluatedPath {
    Path path;
    std::vector<EditReport> reports;
    std::vector<MillingStretch> sides; ///< in order; none where nobody asked for them (milling_side.h)
    /// What the stock is cleared of behind this path and all before it; null where nobody asked for it (milling_side.h)
    std::shared_ptr<const ClearedHeights> cleared;
    /// The paths that it was evaluated to come after, in the order in which they are milled; another order, or one of
    /// them changed, makes it another path.
    std::vector<std::shared_ptr<const EvaluatedPath>> after;
    double errorBudget = 0.0; ///< mm, sum of the deviations of the edits that approximate what was before them
};

/// Sources in order, each edit in order; edits that are not enabled are skipped. The order has to keep what the
/// edits promise: they come by their steps (edit_step.h), and what may have led the path into the part is followed by
/// an edit that holds it out before it is linked. Stretches with shank contact, with the spindle off, or that were
/// taken back are never part of a path. Without Link each stroke is reached by a straight rapid move, which only a
/// drawing may use. Any thread; the work is shared among all cores, the result does not depend on them. Cost: 300,000
/// ticks on 360,000 triangles in about 8 s on two cores. Cancellable. Errors: pathEmpty, argumentInvalid (a source
/// of another tool), pathGouges (all of it had to be left out; place: where, detail: remedyOf the reason), cancelled.
/// @param sources moved from, where it may be: hours of strokes are not held twice
Result<EvaluatedPath> evaluate(const std::string& name, std::vector<SourceStrokes> sources,
                               const std::vector<Edit>& edits, const PathContext& context, Progress& progress);
/// The same of takes in memory. Errors: also those of StrokeReader.
Result<EvaluatedPath> evaluate(const std::string& name, const std::vector<Take>& takes, const std::vector<Edit>& edits,
                               const PathContext& context, Progress& progress);

} // namespace burin

// SPDX-FileCopyrightText: 2026 The Burin authors
// SPDX-License-Identifier: Apache-2.0
#pragma once

#include "core/base/progress.h"
#include "core/base/result.h"
#include "core/base/text.h"
#include "core/cutting/cutting_force.h"
#include "core/geometry/mesh_distance.h"
#include "core/machine/machine_profile.h"
#include "core/path/path.h"
#include "core/recording/sample.h"
#include "core/setup/obstacle.h"
#include "core/tool/tool.h"

#include <string>
#include <variant>
#include <vector>

namespace burin {

/// Leaves out stretches that removed nothing, unless the boundary held the tool (a finishing pass over finished stock
/// is work, not air) or the stretch is shorter than `shortest`. A stroke in which nothing was done at all goes as well.
struct DropAirCuts { double shortest = 3.0; /* mm */ };
/// Leaves out samples while the tip stays slower than `speed` for longer than `time` and removes nothing. A tip that
/// creeps keeps a point every 0.05 mm, so that the shape stays.
struct DropDwells { double speed = 1.0; /* mm/s */ double time = 0.15; /* s */ };
/// Zero-phase low pass in time (forward-backward Butterworth, second order), cut-off in Hz, held within `tolerance` of
/// the recorded tips. Steps of an encoder are taken out first, so that holding the tolerance does not bring them back.
/// Never across a gap.
struct Smooth { double cutOff = 5.0; double tolerance = 0.03; };
/// Pushes every place of the path out of the part, grown by the take's allowance plus `clearance`: closest point on the
/// fine mesh at the points and every `sampling` between them, closer where a corner may be cut. Points that carry no
/// shape (0.002 mm) are dropped first. Afterwards every place of every move within a stroke keeps at least the allowance.
/// What is not pushed out within a few steps is lifted along the tool axis.
struct HoldOut { double clearance = 0.005; double sampling = 0.1; };
/// Fewest points such that no dropped one is farther than `tolerance` from the result (Douglas & Peucker, distance to
/// segments). Never lets a segment enter the part: a shortcut that would is not taken.
struct Simplify { double tolerance = 0.01; };
/// Joins the stretches: retract to `clearanceAbove` over the top of the stock and of what stands there, rapid across, rapid down to `approach` above
/// what is left at the entry, plunge. What is left is known from a conservative height map of the strokes before. Ends
/// no farther apart than the cutter's diameter are joined straight at the cutting feed, where that keeps the allowance and
/// shank and holder stay in empty space. Under an overhang the tool leaves along the way it came.
struct Link { double clearanceAbove = 5.0; double approach = 1.0; };
/// Feed, plunge feed and spindle speed from tool, material and machine. Plunges, and moves that go down by more than 45°,
/// get the plunge feed.
struct SetFeed { };

using EditParameters = std::variant<DropAirCuts, DropDwells, Smooth, HoldOut, Simplify, Link, SetFeed>;

/// One entry of a path's history.
struct Edit {
    EditParameters parameters;
    bool enabled = true;
};
TextId titleOf(const EditParameters& parameters);
/// Stable id of an edit's kind: "drop-air-cuts", "smooth", … and back.
std::string_view idOf(const EditParameters& parameters);
/// {"edit": id, "enabled": true, parameters with their unit}; what is left out has its first value, unknown keys are
/// errors. Errors: argumentInvalid (subject: the key), nameUnknown (the id).
Result<Edit> editFromJson(std::string_view text);
std::string toJson(const Edit& edit);
Result<void> validate(const Edit& edit);

/// One number of an edit, with what it may be.
struct EditNumber {
    std::string_view key; ///< as in the edit's JSON, its unit at the end: "tolerance_mm"
    double value = 0.0, low = 0.0, high = 0.0;
};
/// Every number of an edit, in order; none for a kind that has none.
std::vector<EditNumber> numbersOf(const EditParameters& parameters);
/// @param key of one of the edit's numbers; @param value not checked here: see `validate`
void setNumber(EditParameters& parameters, std::string_view key, double value);

/// The edits of the main job, in the order that keeps their guarantees.
std::vector<Edit> standardEdits();

/// What evaluating edits needs to know besides the recording.
struct PathContext {
    const MeshDistance* part = nullptr;  ///< chord <= 0.005 mm
    Tool tool;
    CuttingConditions conditions;
    MachineProfile machine;
    Box stock;                           ///< mm, setup frame
    std::vector<ObstacleSolid> obstacles;///< links keep clear of those that are on
    double tickPeriod = 0.001;           ///< s
};

/// What one edit did.
struct EditReport {
    std::string edit;              ///< its id
    std::size_t pointsBefore = 0, pointsAfter = 0;
    double largestDeviation = 0.0; ///< mm, between the path before and after, at the worst place (never understated)
    glm::dvec3 worstPlace{0.0};    ///< mm, setup frame
};

struct EvaluatedPath {
    Path path;
    std::vector<EditReport> reports;
    double errorBudget = 0.0;      ///< mm, sum of the deviations that smoothing, holding out and simplifying report
};

/// Takes in order, each edit in order; edits that are not enabled are skipped. The order has to keep what the edits
/// promise: DropAirCuts, DropDwells and Smooth first, then HoldOut and Simplify, then at most one Link, then at most one
/// SetFeed. Stretches with shank contact, with the spindle off, or that were taken back are never part of a path. Without Link each stroke is reached by a straight rapid
/// move, which only a drawing may use. Any thread; the work is shared among all cores, the result does not depend on them.
/// Cost: 300,000 ticks on 360,000 triangles in about 8 s on two cores. Cancellable.
/// Errors: pathEmpty, argumentInvalid, notSupported (tilted axis), pathGouges (no way around the part), cancelled.
Result<EvaluatedPath> evaluate(const std::string& name, const std::vector<Take>& takes, const std::vector<Edit>& edits,
                               const PathContext& context, Progress& progress);

} // namespace burin

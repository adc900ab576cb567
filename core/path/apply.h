// SPDX-FileCopyrightText: 2026 The Burin authors
// SPDX-License-Identifier: Apache-2.0
#pragma once

#include "core/path/evaluate.h"
#include "core/path/stroke.h"

#include <functional>

namespace burin {

/// The farthest that an edit moved the path.
struct Deviation {
    double distance = 0.0; ///< mm
    glm::dvec3 place{0.0}; ///< mm, setup frame

    void include(double other, const glm::dvec3& at) noexcept {
        if (other > distance) *this = {other, at};
    }
    void include(const Deviation& other) noexcept { include(other.distance, other.place); }
};

/// Errors: argumentInvalid (a cut-off that a stroke's sampling can't tell). @param cutOff Hz
Result<void> checkCutOff(double cutOff, const PathUnderEdit& state);

/// The farthest that any stroke moved; each stroke is changed by itself, all of them in parallel, none any more once
/// the work is cancelled. @param change what an edit does to a stroke, and how far that moves it
Deviation changeEach(PathUnderEdit& state, const Progress& progress,
                     const std::function<Deviation(PathStroke&)>& change);

// One function an edit, each in the file of its name. They change `state` in place and say how far the path went from
// what it was. Strokes stay in their order; each edit treats a stroke by itself, so they run in parallel and give the
// same result with any number of threads. Errors: argumentInvalid, cancelled, and what each one states.
Result<Deviation> apply(const DropAirCuts& edit, PathUnderEdit& state, const PathContext& context, Progress& progress);
Result<Deviation> apply(const DropDwells& edit, PathUnderEdit& state, const PathContext& context, Progress& progress);
Result<Deviation> apply(const SmoothShape& edit, PathUnderEdit& state, const PathContext& context, Progress& progress);
Result<Deviation> apply(const Smooth& edit, PathUnderEdit& state, const PathContext& context, Progress& progress);
Result<Deviation> apply(const SmoothSpline& edit, PathUnderEdit& state, const PathContext& context, Progress& progress);
Result<Deviation> apply(const CutOut& edit, PathUnderEdit& state, const PathContext& context, Progress& progress);
Result<Deviation> apply(const Trim& edit, PathUnderEdit& state, const PathContext& context, Progress& progress);
Result<Deviation> apply(const Split& edit, PathUnderEdit& state, const PathContext& context, Progress& progress);
Result<Deviation> apply(const Join& edit, PathUnderEdit& state, const PathContext& context, Progress& progress);
Result<Deviation> apply(const Reorder& edit, PathUnderEdit& state, const PathContext& context, Progress& progress);
Result<Deviation> apply(const Reverse& edit, PathUnderEdit& state, const PathContext& context, Progress& progress);
Result<Deviation> apply(const Mirror& edit, PathUnderEdit& state, const PathContext& context, Progress& progress);
Result<Deviation> apply(const Rotate& edit, PathUnderEdit& state, const PathContext& context, Progress& progress);
Result<Deviation> apply(const Array& edit, PathUnderEdit& state, const PathContext& context, Progress& progress);
Result<Deviation> apply(const MovePoints& edit, PathUnderEdit& state, const PathContext& context, Progress& progress);
/// Errors: argumentInvalid, where the path has no such stretch.
Result<Deviation> apply(const ReplaceStretch& edit, PathUnderEdit& state, const PathContext& context,
                        Progress& progress);
Result<Deviation> apply(const RemoveArea& edit, PathUnderEdit& state, const PathContext& context, Progress& progress);
Result<Deviation> apply(const LiftArea& edit, PathUnderEdit& state, const PathContext& context, Progress& progress);
Result<Deviation> apply(const HoldOut& edit, PathUnderEdit& state, const PathContext& context, Progress& progress);
Result<Deviation> apply(const LayOnPart& edit, PathUnderEdit& state, const PathContext& context, Progress& progress);
Result<Deviation> apply(const Offset& edit, PathUnderEdit& state, const PathContext& context, Progress& progress);
/// Errors: argumentInvalid, where the path has no such guide.
Result<Deviation> apply(const StepOverRows& edit, PathUnderEdit& state, const PathContext& context, Progress& progress);
Result<Deviation> apply(const Simplify& edit, PathUnderEdit& state, const PathContext& context, Progress& progress);
Result<Deviation> apply(const FitArcs& edit, PathUnderEdit& state, const PathContext& context, Progress& progress);
Result<Deviation> apply(const RoundCorners& edit, PathUnderEdit& state, const PathContext& context, Progress& progress);
Result<Deviation> apply(const LeadIn& edit, PathUnderEdit& state, const PathContext& context, Progress& progress);
Result<Deviation> apply(const LeadOut& edit, PathUnderEdit& state, const PathContext& context, Progress& progress);
/// Errors: those of PathContext::lendStock.
Result<Deviation> apply(const Link& edit, PathUnderEdit& state, const PathContext& context, Progress& progress);
Result<Deviation> apply(const SetFeed& edit, PathUnderEdit& state, const PathContext& context, Progress& progress);
/// Errors: argumentInvalid (no stock, no feeds yet), those of PathContext::lendStock.
Result<Deviation> apply(const LevelFeed& edit, PathUnderEdit& state, const PathContext& context, Progress& progress);
Result<Deviation> apply(const AreaFeed& edit, PathUnderEdit& state, const PathContext& context, Progress& progress);

} // namespace burin

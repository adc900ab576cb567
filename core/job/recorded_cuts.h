// SPDX-FileCopyrightText: 2026 The Burin authors
// SPDX-License-Identifier: Apache-2.0
#pragma once

#include "core/document/project.h"
#include "core/job/cut_motions.h"
#include "core/job/milling_context.h"

#include <functional>
#include <map>
#include <memory>
#include <optional>
#include <vector>

namespace burin {

/// The cutting motions of a recording, with the cutter that it was made with.
struct RecordedCuts {
    std::int64_t take = 0;
    Tool tool;
    CutMotions motions;
    std::size_t strokes = 0;       ///< not undone
    std::uint64_t sampleCount = 0; ///< of the entire take, cutting or not
    /// The motions [done, end) are to be cut: a kept workpiece already contains those before; those after are later
    /// than the requested moment.
    std::uint64_t done = 0, end = ~std::uint64_t{0};
};

using SharedCuts = std::shared_ptr<const RecordedCuts>; ///< never null

/// The grid and the materials of a volume.
struct VolumeKind {
    Grid grid;
    PropertyList properties;
};

/// The effect of recordings on a workpiece: a kept state, and the cuts since. Values; the thread that cuts needs no
/// project.
struct RecordedWork {
    std::optional<KeptWorkpiece> kept;           ///< left by the takes up to its moment; empty: start from the stock
    std::vector<RecordedCuts> cuts;              ///< the rest of its take, and all later takes, in order
    std::map<std::int64_t, std::size_t> strokes; ///< not undone, of all takes
    TakeMoment end;                              ///< of the last take; default if there is no take
};

/// Returns the cuts of one take. @param also called with its samples, in order, from the same read; may be empty
/// Errors: those of Project::visitSamples, toolFor, `also`.
Result<RecordedCuts> cutsOfTake(const Project& project, const TakeInfo& info, const SampleVisitor& also = {});
/// Returns all takes of a project, in order, starting from the newest valid kept workpiece, so that earlier takes need
/// not be read.
/// @param fromKept false: ignore kept workpieces
/// Errors: those of Project::visitSamples, toolFor.
Result<RecordedWork> recordedWork(const Project& project, bool fromKept = true);
/// The same up to a moment. @param also as for cutsOfTake, for each take that is read. Errors: also those of `also`.
Result<RecordedWork> recordedWork(const Project& project, const TakeMoment& until, bool fromKept = true,
                                  const SampleVisitor& also = {});

/// Repeats the cuts of a take, except those that were undone. Errors: volumeOutOfMemory, cancelled.
Result<void> replayTake(const Take& take, const Tool& tool, MillingContext& milling, const Progress& progress);
/// Repeats the cuts of all takes, in order, which gives the present workpiece. Errors: also fileDamaged (a kept
/// workpiece).
/// @param milling with nothing cut yet
Result<void> replayTakes(const RecordedWork& work, MillingContext& milling, Progress& progress);
/// The same as a separate volume. @param stock makes the uncut stock; not called if there is a kept workpiece
/// @param like a kept workpiece of another kind is fileDamaged; empty: not compared
Result<RunVolume> workpieceOf(const RecordedWork& work, const std::function<Result<RunVolume>()>& stock,
                              Progress& progress, const std::optional<VolumeKind>& like = {});
/// Repeats the cuts of a project's takes, from its newest kept workpiece on. Errors: also those of `recordedWork`.
Result<void> replayTakes(const Project& project, MillingContext& milling, Progress& progress);

/// Returns a workpiece in the form in which it is kept. Thread-safe; takes some µs per brick. Errors: those of
/// writeVolume.
Result<KeptWorkpiece> keptAs(const VolumeSnapshot& workpiece, const TakeMoment& at,
                             const std::map<std::int64_t, std::size_t>& strokes, Progress& progress);
/// Returns the volume of a kept workpiece. Errors: those of readVolume, fileDamaged.
Result<RunVolume> volumeOf(const KeptWorkpiece& kept, Progress& progress);

} // namespace burin

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

/// What a recording cut, with the cutter that it was made with.
struct RecordedCuts {
    std::int64_t take = 0;
    Tool tool;
    CutMotions motions;
    std::size_t strokes = 0;       ///< that stand
    std::uint64_t sampleCount = 0; ///< all of the take, whether they cut or not
    /// Motions that count: a kept workpiece has those before already, those after lie behind the moment that is wanted.
    std::uint64_t done = 0, end = ~std::uint64_t{0};
};

using SharedCuts = std::shared_ptr<const RecordedCuts>; ///< never null

/// What a volume is a volume of.
struct VolumeKind {
    Grid grid;
    PropertyList properties;
};

/// What recordings did to a workpiece: what was kept of it, and what was cut since. Values; no project is needed on the
/// thread that cuts.
struct RecordedWork {
    std::optional<KeptWorkpiece> kept;           ///< as the takes up to there left it; null: start from the stock
    std::vector<RecordedCuts> cuts;              ///< of its take where that goes on, and of all after it, in order
    std::map<std::int64_t, std::size_t> strokes; ///< that stand, of all takes
    TakeMoment end;                              ///< of the last take; that of no take where there is none
};

/// Of one take. @param also gets its samples, in their order, from the same reading; may be empty
/// Errors: those of Project::visitSamples, toolFor, `also`.
Result<RecordedCuts> cutsOfTake(const Project& project, const TakeInfo& info, const SampleVisitor& also = {});
/// All takes of a project, in order, from the newest kept workpiece on that holds, which spares reading what is before.
/// @param fromKept false: what is kept is of no account
/// Errors: those of Project::visitSamples, toolFor.
Result<RecordedWork> recordedWork(const Project& project, bool fromKept = true);
/// The same up to a moment.
Result<RecordedWork> recordedWork(const Project& project, const TakeMoment& until, bool fromKept = true);

/// Cuts again what a take cut, but for what was taken back. Errors: volumeOutOfMemory, cancelled.
Result<void> replayTake(const Take& take, const Tool& tool, MillingContext& milling, const Progress& progress);
/// All of them, in order: the workpiece as it stands. Errors: also fileDamaged (what was kept).
/// @param milling fresh: nothing is cut yet
Result<void> replayTakes(const RecordedWork& work, MillingContext& milling, Progress& progress);
/// The same as a volume of its own. @param stock before anything is cut; not called where something was kept
/// @param like what was kept of another kind is fileDamaged; nothing: it is not compared
Result<RunVolume> workpieceOf(const RecordedWork& work, const std::function<Result<RunVolume>()>& stock,
                              Progress& progress, const std::optional<VolumeKind>& like = {});
/// Those of a project, from its newest kept workpiece on. Errors: also those of `recordedWork`.
Result<void> replayTakes(const Project& project, MillingContext& milling, Progress& progress);

/// A workpiece as it is to be kept. Any thread; some µs a brick. Errors: those of writeVolume.
Result<KeptWorkpiece> keptAs(const VolumeSnapshot& workpiece, const TakeMoment& at,
                             const std::map<std::int64_t, std::size_t>& strokes, Progress& progress);
/// The volume that was kept. Errors: those of readVolume, fileDamaged.
Result<RunVolume> volumeOf(const KeptWorkpiece& kept, Progress& progress);

} // namespace burin

// SPDX-FileCopyrightText: 2026 The Burin authors
// SPDX-License-Identifier: Apache-2.0
#pragma once

#include "core/job/recorded_cuts.h"
#include "core/volume/packed/volume_delta.h"

#include <cstdint>
#include <optional>
#include <vector>

namespace burin {

/// Goes to any moment of a setup's recordings: the workpiece as it was then, to the bit. It cuts again what it has not
/// seen yet, from the nearest kept workpiece on, and remembers each stretch of a thousand motions packed (VolumeDelta,
/// some bytes a run end that it changed), so that going there again, and backwards, costs no cutting.
/// One thread at a time; the snapshots that it gives may be read anywhere. Holds a volume of its own: about as much
/// memory as the workpiece itself.
class WorkpieceInTime {
public:
    static constexpr std::uint64_t motionsPerStep = 1000;
    /// Motions between two workpieces that are worth keeping; more where that would be more than `mostKept` in all.
    static constexpr std::uint64_t motionsPerKept = 30000;
    static constexpr std::size_t mostKept = 48;

    /// @param stock before the first take
    /// @param takes all of them, in order
    /// @param kept the workpiece at some of their moments
    /// Errors: those of volumeOf.
    static Result<WorkpieceInTime> make(KeptWorkpiece stock, std::vector<SharedCuts> takes,
                                        std::vector<KeptWorkpiece> kept, Progress& progress);

    /// The workpiece at a moment; one beyond the last is the last. Where that fails, the place it stands at is the one
    /// before. Errors: cancelled, volumeOutOfMemory, outOfMemory, fileDamaged (what was kept).
    Result<VolumeSnapshot> at(const TakeMoment& moment, Progress& progress);
    /// What came up on the way that is worth keeping and was not kept yet; handed over once.
    std::vector<KeptWorkpiece> takeWorthKeeping();

    const std::vector<SharedCuts>& takes() const noexcept { return takes_; }
    /// Motions that were cut in all of its life; for tests and figures.
    std::uint64_t motionsCut() const noexcept { return cut_; }

private:
    /// A place between motions where a stretch ends, counted over all takes.
    struct Mark {
        std::uint64_t motions = 0;
        TakeMoment moment;                       ///< the first that has these motions
        std::optional<VolumeDelta> next;         ///< to the mark behind it
        std::optional<KeptWorkpiece> kept;       ///< the workpiece there; of the first mark always
        bool worthKeeping = false, told = false; ///< told: it was handed over, or came from there
    };
    WorkpieceInTime(RunVolume stock, std::vector<SharedCuts> takes, std::vector<KeptWorkpiece> kept);
    std::uint64_t motionsBefore(const TakeMoment& moment) const noexcept;
    void placeMarks(std::vector<KeptWorkpiece> kept);
    std::size_t markAt(std::uint64_t motions) const noexcept; ///< the last one no later
    std::uint64_t costOfWalk(std::size_t mark) const noexcept;
    std::optional<std::size_t> betterStart(std::size_t target) const noexcept;
    Result<void> jump(std::size_t mark, Progress& progress);
    Result<void> walkTo(std::size_t mark, Progress& progress);
    Result<void> stepForward(Progress& progress);
    Result<void> stepBackward();
    Result<void> cut(std::uint64_t from, std::uint64_t to, const Progress& progress);
    Result<void> keep(std::size_t mark, Progress& progress);

    std::vector<SharedCuts> takes_;
    std::vector<std::uint64_t> before_; ///< motions before each take, and all
    std::vector<Mark> marks_;
    RunVolume volume_;
    std::size_t mark_ = 0;    ///< that the volume stands at, or a little behind
    VolumeSnapshot atMark_;   ///< what it held there
    std::uint64_t place_ = 0; ///< motions that it has
    std::uint64_t cut_ = 0;
};

} // namespace burin

// SPDX-FileCopyrightText: 2026 The Burin authors
// SPDX-License-Identifier: Apache-2.0
#pragma once

#include "core/job/recorded_cuts.h"
#include "core/volume/packed/volume_delta.h"

#include <cstdint>
#include <map>
#include <optional>
#include <span>
#include <vector>

namespace burin {

/// Returns the number of strokes not undone of each take that has ended at a moment. @param takes in order
std::map<std::int64_t, std::size_t> strokesBefore(std::span<const SharedCuts> takes, const TakeMoment& moment);

/// Restores the workpiece at any moment of a setup's recordings, bitwise exact. Repeats cuts that it has not made yet,
/// starting from the nearest kept workpiece, and stores each step of a thousand motions packed (VolumeDelta, some bytes
/// per changed run end), so that going there again, and backwards, requires no cutting. One thread at a time; the
/// returned snapshots may be read on any thread. Holds its own volume: about as much memory as the workpiece itself.
class WorkpieceInTime {
public:
    static constexpr std::uint64_t motionsPerStep = 1000;
    /// Motions between two workpieces that are kept; more if there would be more than `mostKept` in total.
    static constexpr std::uint64_t motionsPerKept = 30000;
    static constexpr std::size_t mostKept = 48;

    /// @param stock the workpiece before the first take
    /// @param takes all takes, in order
    /// @param kept the workpiece at some moments of the takes
    /// Errors: those of volumeOf.
    static Result<WorkpieceInTime> make(KeptWorkpiece stock, std::vector<SharedCuts> takes,
                                        std::vector<KeptWorkpiece> kept, Progress& progress);

    /// Returns the workpiece at a moment, limited to the last one. On failure, the position is the previous one.
    /// Errors: cancelled, volumeOutOfMemory, outOfMemory, fileDamaged (a kept workpiece).
    Result<VolumeSnapshot> at(const TakeMoment& moment, Progress& progress);
    /// Returns the workpieces made so far that should be kept and were not kept yet; each is returned once.
    std::vector<KeptWorkpiece> takeWorthKeeping();

    const std::vector<SharedCuts>& takes() const noexcept { return takes_; }
    /// Returns the number of motions cut since its creation; for tests and benchmarks.
    std::uint64_t motionsCut() const noexcept { return cut_; }

private:
    /// A position between motions where a step ends, counted over all takes.
    struct Mark {
        std::uint64_t motions = 0;
        TakeMoment moment;                       ///< the first one at which these motions are cut
        std::optional<VolumeDelta> next;         ///< to the next mark
        std::optional<KeptWorkpiece> kept;       ///< the workpiece there; always set for the first mark
        bool worthKeeping = false, told = false; ///< told: was returned, or came from the caller
    };
    WorkpieceInTime(RunVolume stock, std::vector<SharedCuts> takes, std::vector<KeptWorkpiece> kept);
    std::uint64_t motionsBefore(const TakeMoment& moment) const noexcept;
    void placeMarks(std::vector<KeptWorkpiece> kept);
    std::size_t markAt(std::uint64_t motions) const noexcept; ///< the last mark that is not later
    std::uint64_t costOfWalk(std::size_t mark) const noexcept;
    std::optional<std::size_t> betterStart(std::size_t target) const noexcept;
    Result<void> jump(std::size_t mark, Progress& progress);
    Result<void> walkTo(std::size_t mark, Progress& progress);
    Result<void> stepForward(Progress& progress);
    Result<void> stepBackward();
    Result<void> cut(std::uint64_t from, std::uint64_t to, const Progress& progress);
    Result<void> keep(std::size_t mark, Progress& progress);

    std::vector<SharedCuts> takes_;
    std::vector<std::uint64_t> before_; ///< motions before each take, and in total
    std::vector<Mark> marks_;
    RunVolume volume_;
    std::size_t mark_ = 0;    ///< at or shortly before the position of the volume
    VolumeSnapshot atMark_;   ///< the volume at that mark
    std::uint64_t place_ = 0; ///< motions that the volume contains
    std::uint64_t cut_ = 0;
};

} // namespace burin

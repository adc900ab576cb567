// SPDX-FileCopyrightText: 2026 The Burin authors
// SPDX-License-Identifier: Apache-2.0
#pragma once

#include "core/document/project.h"
#include "core/volume/packed/volume_history.h"

#include <cstdint>
#include <deque>

namespace burin {

/// One stroke of a take: samples from the spindle's start to its stop.
struct Stroke {
    std::int64_t take = 0;
    std::uint64_t first = 0, count = 0; ///< samples of the take
    VolumeSnapshot before;              ///< the workpiece before the stroke
};

/// The newest strokes of a milling context, so that they can be undone during a session and after it. Belongs to one
/// workpiece: clear it when the workpiece is made anew, changed by others, or when one of its takes is removed. Call on
/// the owner's thread. The last few strokes occupy the volume's memory that has changed since; older ones are packed
/// (VolumeHistory) and take some bytes per run end that they changed.
class StrokeHistory {
public:
    static constexpr std::size_t maximum = 128; ///< strokes that can be undone immediately; older ones by cutting again
    bool canUndo() const noexcept { return !done_.empty(); }
    bool canRedo() const noexcept { return !undone_.empty(); }
    std::size_t count() const noexcept { return done_.size(); }
    /// Returns the number of all strokes that were ever added, including forgotten ones.
    std::uint64_t added() const noexcept { return added_; }
    /// Returns the stroke that `undo` would undo; there must be one. Its snapshot is empty, as the history has taken
    /// it.
    const Stroke& newest() const noexcept { return newest(0); }
    /// Returns the stroke that is older than the `newer` newest ones; there must be one. @param newer below `count`
    const Stroke& newest(std::size_t newer) const noexcept { return done_[done_.size() - 1 - newer]; }
    /// Returns the stroke that `redo` would redo; there must be one.
    const Stroke& nextRedo() const noexcept { return undone_.back(); }
    /// Returns the memory that the strokes occupy inside and outside the volume.
    VolumeHistory::Cost cost() const noexcept { return workpiece_.totalCost(); }
    void clear(); ///< also releases its part of the volume's memory

    /// For the session only: adds a stroke that has just ended. Strokes that could be redone are forgotten.
    void add(Stroke stroke);
    /// For the session only, call from time to time: packs some of the pending strokes (a millisecond or two).
    void tidy();
    /// `undo` restores the workpiece and marks the stroke's samples as undone in the project; `redo` reverts both. The
    /// workpiece must have no other writer. Errors: argumentInvalid (there is no such stroke), volumeOutOfMemory (a
    /// packed stroke does not fit), those of Project; nothing is changed then.
    Result<void> undo(Project& project, RunVolume& workpiece);
    Result<void> redo(Project& project, RunVolume& workpiece);
    /// Returns memory to the volume: packs the strokes or, if they are packed already, forgets the oldest half. Returns
    /// false if there is nothing to free.
    bool makeRoom();
    /// Forgets the oldest half of the strokes, which can then no longer be undone. Returns false if there are none.
    bool forgetOldest();

private:
    void forget(std::size_t strokes);
    void forgetBeyondMemory();

    std::deque<Stroke> done_, undone_; ///< newest last; for undone_: the next one to redo
    std::uint64_t added_ = 0;
    VolumeHistory workpiece_; ///< one step per stroke
};

} // namespace burin

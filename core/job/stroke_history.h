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
    VolumeSnapshot before;              ///< the workpiece as the stroke found it
};

/// The newest strokes of a milling context, so that they can be taken back, during a session and after it. It belongs
/// to one workpiece: to be cleared when that is made anew, changed by others, or a take of it is removed. Owner's
/// thread. The last few strokes hold back what of the volume's memory has changed since; older ones are packed
/// (VolumeHistory) and cost some bytes a run end that they changed.
class StrokeHistory {
public:
    static constexpr std::size_t maximum = 128; ///< strokes that can be taken back at once; older ones by cutting again
    bool canUndo() const noexcept { return !done_.empty(); }
    bool canRedo() const noexcept { return !undone_.empty(); }
    std::size_t count() const noexcept { return done_.size(); }
    /// All strokes that were ever added, whatever became of them.
    std::uint64_t added() const noexcept { return added_; }
    /// The stroke that `undo` would take back; there must be one. Its snapshot is empty: the history has taken it.
    const Stroke& newest() const noexcept { return newest(0); }
    /// The one that so many are newer than; there must be one. @param newer below `count`
    const Stroke& newest(std::size_t newer) const noexcept { return done_[done_.size() - 1 - newer]; }
    /// The stroke that `redo` would put back; there must be one.
    const Stroke& nextRedo() const noexcept { return undone_.back(); }
    /// What the strokes hold of the volume's memory and beside it.
    VolumeHistory::Cost cost() const noexcept { return workpiece_.totalCost(); }
    void clear(); ///< gives back what it holds of the volume's memory

    /// For the session alone: a stroke that was just ended. What could be redone is forgotten.
    void add(Stroke stroke);
    /// For the session alone, now and then: packs a little of what is to be packed (a millisecond or two).
    void tidy();
    /// Puts the workpiece back and marks the stroke's samples as undone in the project, or takes both back. The
    /// workpiece must have no other writer. Errors: argumentInvalid (there is none), volumeOutOfMemory (a packed
    /// stroke does not fit in), those of Project; nothing is changed then.
    Result<void> undo(Project& project, RunVolume& workpiece);
    Result<void> redo(Project& project, RunVolume& workpiece);
    /// Gives memory back to the volume: what strokes hold is packed, or, when that was done before, the oldest half
    /// stays for good. False: there is nothing to give.
    bool makeRoom();
    /// The oldest half stays for good. False: there is none.
    bool forgetOldest();

private:
    void forget(std::size_t strokes);
    void forgetBeyondMemory();

    std::deque<Stroke> done_, undone_; ///< newest last; of the undone, the one that is redone first
    std::uint64_t added_ = 0;
    VolumeHistory workpiece_; ///< a step a stroke
};

} // namespace burin

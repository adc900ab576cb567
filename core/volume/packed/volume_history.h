// SPDX-FileCopyrightText: 2026 The Burin authors
// SPDX-License-Identifier: Apache-2.0
#pragma once

#include "core/volume/packed/volume_delta.h"

#include <cstddef>
#include <deque>
#include <memory>
#include <optional>

namespace burin {

class VolumeStore;

/// Steps of cutting on one volume that can be undone and redone, in bounded memory. The newest are held by snapshots
/// (undoing one costs no more than its table of bricks), older ones are packed (VolumeDelta), the oldest are dropped.
/// Used on one thread; while `undo` and `redo` run, nobody else may write the volume.
class VolumeHistory {
public:
    struct Budget {
        std::size_t packedBytes =
            std::size_t{256} << 20; ///< for packed steps; the oldest go when they take more, then those redone last
        std::size_t heldBytes = 0;  ///< of the volume's reserve, for steps held by snapshots; 0: an eighth of it
        std::size_t heldSteps = 4;  ///< newest steps that stay held as long as memory allows
        /// A volume has 64 snapshots prepared; if more steps are held, `add` packs those that `tidy` has not packed
        /// yet.
        std::size_t mostHeldSteps = 32;
    };
    /// Memory of a step: one of the two is 0.
    struct Cost {
        std::size_t packedBytes = 0; ///< memory outside the volume's reserve
        std::size_t heldBytes = 0;   ///< in the volume's reserve; 0 for the newest step until the one after it is known
    };

    VolumeHistory() = default;
    explicit VolumeHistory(const Budget& budget) : budget_(budget) {}

    /// Records the end of a step: the volume went from `before` to its current state. Steps that could be redone are
    /// dropped. Cost: some ms if there are many bricks.
    /// @param before  the state after the previous step, of the same volume; another volume starts a new history
    void add(VolumeSnapshot before);
    bool canUndo() const noexcept { return present_ > 0; }
    bool canRedo() const noexcept { return present_ < steps_.size(); }
    std::size_t undoSteps() const noexcept { return present_; }
    std::size_t redoSteps() const noexcept { return steps_.size() - present_; }
    /// Errors: argumentInvalid (no such step, or it belongs to another volume), volumeOutOfMemory (a packed step, and
    /// the reserve is used up): the volume is then unchanged.
    Result<void> undo(RunVolume& volume);
    Result<void> redo(RunVolume& volume);

    /// Packs steps that are due and drops what exceeds the budget: to be called from time to time, between other work.
    /// @param bricks  maximum number to pack in this call; some µs each. True: nothing more is due.
    bool tidy(std::size_t bricks);
    /// Packs every step that can be packed, so that the memory held by snapshots returns to the volume. False if there
    /// was none. The newest step stays held until the one after it is known or it is undone.
    bool packAll();
    /// Drops the oldest steps, at most as many as there are.
    void forgetOldest(std::size_t steps);
    void clear();

    /// Cost of a step: 0 is the oldest, those that can be redone come last.
    Cost cost(std::size_t step) const noexcept;
    Cost totalCost() const noexcept;

private:
    struct Step {
        std::optional<VolumeDelta> delta;
        std::size_t heldBytes = 0;
    };

    bool belongsTo(RunVolume& volume) const;
    void leave(std::size_t step, RunVolume& volume);
    std::size_t heldLimit() const noexcept;
    bool packable(std::size_t step) const noexcept;
    std::optional<std::size_t> nextDue(std::size_t heldSteps, std::size_t heldBytes) const noexcept;
    bool packDue(std::size_t heldSteps, std::size_t heldBytes, std::size_t bricks);
    bool advancePacking(std::size_t bricks);
    void startPacking(std::size_t step);
    void releaseMarks();
    void keepBudget();
    void forgetFrom(std::size_t step);

    Budget budget_;
    std::deque<Step> steps_;
    std::deque<VolumeSnapshot> marks_;  ///< states between steps, one more than there are steps; empty if not held
    std::weak_ptr<VolumeStore> volume_; ///< the volume that the steps belong to
    std::size_t reserve_ = 0;           ///< of the volume, bytes
    std::size_t present_ = 0;           ///< index of the mark that is the volume's current state
    struct Packing {
        std::size_t step = 0;
        VolumeDeltaPacker packer;
    };
    std::optional<Packing> packing_;
};

} // namespace burin

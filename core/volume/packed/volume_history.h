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

/// Steps of cutting on one volume that can be taken back and done again, in bounded memory. The newest are held by
/// snapshots (taking one back costs no more than its table of bricks), older ones packed (VolumeDelta), the oldest
/// given up. One owner's thread; `undo` and `redo` need that nobody else writes the volume meanwhile.
class VolumeHistory {
public:
    struct Budget {
        std::size_t packedBytes =
            std::size_t{256} << 20; ///< for packed steps; the oldest go when they take more, then those redone last
        std::size_t heldBytes = 0;  ///< of the volume's reserve, for steps held by snapshots; 0: an eighth of it
        std::size_t heldSteps = 4;  ///< newest steps that stay held while memory allows
        /// A volume has 64 snapshots prepared; when more steps are held, `add` packs what `tidy` did not come to.
        std::size_t mostHeldSteps = 32;
    };
    /// What a step costs: either of the two is 0.
    struct Cost {
        std::size_t packedBytes = 0; ///< memory of its own
        std::size_t heldBytes = 0;   ///< of the volume's reserve; 0 for the newest until the one after it is known
    };

    VolumeHistory() = default;
    explicit VolumeHistory(const Budget& budget) : budget_(budget) {}

    /// A step ended: the volume went from `before` to where it stands now, and so do all steps that follow. What could
    /// be redone is forgotten. Cost: some ms where bricks are many.
    /// @param before the state that the step before left, of the same volume; another volume starts a new history
    void add(VolumeSnapshot before);
    bool canUndo() const noexcept { return present_ > 0; }
    bool canRedo() const noexcept { return present_ < steps_.size(); }
    std::size_t undoSteps() const noexcept { return present_; }
    std::size_t redoSteps() const noexcept { return steps_.size() - present_; }
    /// Errors: argumentInvalid (there is none, or it is another volume's), volumeOutOfMemory (a packed step, and a
    /// reserve that is used up): the volume is then what it was.
    Result<void> undo(RunVolume& volume);
    Result<void> redo(RunVolume& volume);

    /// Packs what is due and gives up what is beyond the budget: to be called now and then, between other work.
    /// @param bricks to pack at most in this call; some µs each. True: nothing more is due.
    bool tidy(std::size_t bricks);
    /// Packs every step that can be, so that the volume gets back what snapshots held. False: there was none. The
    /// newest step is held until the one after it is known, or it was undone.
    bool packAll();
    /// Gives the oldest steps up. No more than there are.
    void forgetOldest(std::size_t steps);
    void clear();

    /// Of a step, the oldest 0, those that can be redone last.
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
    std::deque<VolumeSnapshot> marks_;  ///< states between steps, one more than there are steps; empty: not held
    std::weak_ptr<VolumeStore> volume_; ///< whose steps they are
    std::size_t reserve_ = 0;           ///< of the volume, bytes
    std::size_t present_ = 0;           ///< the mark at which the volume stands
    struct Packing {
        std::size_t step = 0;
        VolumeDeltaPacker packer;
    };
    std::optional<Packing> packing_;
};

} // namespace burin

// SPDX-FileCopyrightText: 2026 The Burin authors
// SPDX-License-Identifier: Apache-2.0
#include "core/volume/packed/volume_history.h"

#include "core/volume/runs/volume_access.h"
#include "core/volume/runs/volume_memory.h"

#include <algorithm>
#include <limits>
#include <utility>

namespace burin {

namespace {
constexpr std::size_t noLimit = std::numeric_limits<std::size_t>::max();
}

void VolumeHistory::clear() {
    packing_.reset();
    steps_.clear();
    marks_.clear();
    present_ = 0;
}

void VolumeHistory::add(VolumeSnapshot before) {
    if (packing_ && packing_->step >= present_) packing_.reset();
    steps_.resize(present_);
    marks_.resize(marks_.empty() ? 0 : present_ + 1);
    const std::shared_ptr<VolumeStore>& store = VolumeAccess::state(before).store;
    if (volume_.lock() != store) clear();
    volume_ = store;
    reserve_ = store->arena->reservedBytes();
    if (marks_.empty())
        marks_.push_back(std::move(before));
    else
        marks_.back() = std::move(before);
    if (present_ > 0 && !marks_[present_ - 1].empty())
        steps_.back().heldBytes = bytesHeldBack(marks_[present_ - 1], marks_.back());
    steps_.emplace_back();
    marks_.emplace_back();
    ++present_;
    while (nextDue(budget_.mostHeldSteps, noLimit)) packDue(budget_.mostHeldSteps, noLimit, noLimit);
}

bool VolumeHistory::belongsTo(RunVolume& volume) const {
    return volume_.lock().get() == &VolumeAccess::writer(volume).store();
}

/// Ensures that the volume can return over a step to the current mark.
void VolumeHistory::leave(std::size_t step, RunVolume& volume) {
    if (steps_[step].delta || !marks_[present_].empty()) return;
    marks_[present_] = volume.snapshot();
    if (step < present_) steps_[step].heldBytes = bytesHeldBack(marks_[step], marks_[present_]);
}

Result<void> VolumeHistory::undo(RunVolume& volume) {
    if (!canUndo() || !belongsTo(volume))
        return Error{ErrorCode::argumentInvalid, "undo", "0", "a step that can be taken back"};
    const std::size_t step = present_ - 1;
    leave(step, volume);
    if (!marks_[step].empty())
        volume.restore(marks_[step]);
    else if (Result<void> applied = steps_[step].delta->applyBackward(volume); !applied)
        return applied;
    --present_;
    return {};
}

Result<void> VolumeHistory::redo(RunVolume& volume) {
    if (!canRedo() || !belongsTo(volume))
        return Error{ErrorCode::argumentInvalid, "redo", "0", "a step that was taken back"};
    const std::size_t step = present_;
    leave(step, volume);
    if (!marks_[step + 1].empty())
        volume.restore(marks_[step + 1]);
    else if (Result<void> applied = steps_[step].delta->applyForward(volume); !applied)
        return applied;
    ++present_;
    return {};
}

std::size_t VolumeHistory::heldLimit() const noexcept {
    constexpr std::size_t share = 8;
    return budget_.heldBytes != 0 ? budget_.heldBytes : reserve_ / share;
}

bool VolumeHistory::packable(std::size_t step) const noexcept {
    return !steps_[step].delta && !marks_[step].empty() && !marks_[step + 1].empty();
}

/// The step that will not be needed for longest: the oldest, because those to be redone are near.
std::optional<std::size_t> VolumeHistory::nextDue(std::size_t heldSteps, std::size_t heldBytes) const noexcept {
    std::size_t steps = 0, bytes = 0;
    std::optional<std::size_t> oldest;
    for (std::size_t step = steps_.size(); step-- > 0;) {
        if (steps_[step].delta) continue;
        ++steps;
        bytes += steps_[step].heldBytes;
        if (packable(step)) oldest = step;
    }
    return steps > heldSteps || bytes > heldBytes ? oldest : std::nullopt;
}

void VolumeHistory::startPacking(std::size_t step) {
    packing_.emplace(Packing{step, VolumeDeltaPacker(marks_[step], marks_[step + 1])});
}

/// True: the current packing is done.
bool VolumeHistory::advancePacking(std::size_t bricks) {
    if (!packing_->packer.advance(bricks)) return false;
    Step& step = steps_[packing_->step];
    step.delta = packing_->packer.take();
    step.heldBytes = 0;
    packing_.reset();
    releaseMarks();
    return true;
}

/// A state is held only if a step before or after it is not packed.
void VolumeHistory::releaseMarks() {
    for (std::size_t mark = 0; mark < marks_.size(); ++mark) {
        const bool before = mark > 0 && !steps_[mark - 1].delta;
        const bool after = mark < steps_.size() && !steps_[mark].delta;
        if (!before && !after) marks_[mark] = {};
    }
}

/// Drops the oldest steps first, then those that would be redone last.
void VolumeHistory::keepBudget() {
    std::size_t packed = totalCost().packedBytes, forgotten = 0, last = steps_.size();
    while (forgotten < present_ && packed > budget_.packedBytes) packed -= cost(forgotten++).packedBytes;
    while (last > present_ && packed > budget_.packedBytes) packed -= cost(--last).packedBytes;
    forgetFrom(last);
    forgetOldest(forgotten);
}

/// Drops a step that can be redone, and all after it.
void VolumeHistory::forgetFrom(std::size_t step) {
    if (step >= steps_.size()) return;
    if (packing_ && packing_->step >= step) packing_.reset();
    steps_.resize(step);
    marks_.resize(step + 1);
    if (steps_.empty())
        clear();
    else
        releaseMarks();
}

/// True: snapshots hold no more than that.
bool VolumeHistory::packDue(std::size_t heldSteps, std::size_t heldBytes, std::size_t bricks) {
    const std::optional<std::size_t> due = nextDue(heldSteps, heldBytes);
    if (!packing_ && !due) return true;
    if (!packing_) startPacking(*due);
    if (!advancePacking(bricks)) return false;
    keepBudget();
    return !nextDue(heldSteps, heldBytes);
}

bool VolumeHistory::tidy(std::size_t bricks) {
    return packDue(budget_.heldSteps, heldLimit(), bricks);
}

bool VolumeHistory::packAll() {
    bool any = packing_ && advancePacking(noLimit);
    for (std::size_t step = 0; step < steps_.size(); ++step) {
        if (!packable(step)) continue;
        startPacking(step);
        any = advancePacking(noLimit);
    }
    keepBudget();
    return any;
}

void VolumeHistory::forgetOldest(std::size_t steps) {
    const std::size_t gone = std::min(steps, present_);
    if (gone == 0) return;
    if (packing_ && packing_->step < gone) packing_.reset();
    if (packing_) packing_->step -= gone;
    steps_.erase(steps_.begin(), steps_.begin() + static_cast<std::ptrdiff_t>(gone));
    marks_.erase(marks_.begin(), marks_.begin() + static_cast<std::ptrdiff_t>(gone));
    present_ -= gone;
    if (steps_.empty())
        clear();
    else
        releaseMarks();
}

VolumeHistory::Cost VolumeHistory::cost(std::size_t step) const noexcept {
    const Step& known = steps_[step];
    return {known.delta ? known.delta->memoryBytes() : 0, known.delta ? 0 : known.heldBytes};
}

VolumeHistory::Cost VolumeHistory::totalCost() const noexcept {
    Cost total;
    for (std::size_t step = 0; step < steps_.size(); ++step) {
        total.packedBytes += cost(step).packedBytes;
        total.heldBytes += cost(step).heldBytes;
    }
    return total;
}

} // namespace burin

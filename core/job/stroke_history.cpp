// SPDX-FileCopyrightText: 2026 The Burin authors
// SPDX-License-Identifier: Apache-2.0
#include "core/job/stroke_history.h"

#include <utility>

namespace burin {

void StrokeHistory::clear() {
    done_.clear();
    undone_.clear();
    workpiece_.clear();
}

void StrokeHistory::add(Stroke stroke) {
    undone_.clear();
    ++added_;
    workpiece_.add(std::exchange(stroke.before, {}));
    done_.push_back(std::move(stroke));
    if (done_.size() > maximum) forget(1);
    forgetBeyondMemory();
}

void StrokeHistory::tidy() {
    constexpr std::size_t bricks = 128;
    workpiece_.tidy(bricks);
    forgetBeyondMemory();
}

/// Drops the strokes whose steps the volume's history gave up, as they took more than its budget.
void StrokeHistory::forgetBeyondMemory() {
    while (done_.size() > workpiece_.undoSteps()) done_.pop_front();
    while (undone_.size() > workpiece_.redoSteps()) undone_.pop_front();
}

Result<void> StrokeHistory::undo(Project& project, RunVolume& workpiece) {
    if (!canUndo()) return Error{ErrorCode::argumentInvalid, "undo", "0", "a stroke that can be taken back"};
    Stroke& stroke = done_.back();
    if (Result<void> undone = workpiece_.undo(workpiece); !undone) return undone;
    if (Result<void> noted = project.undoInterval(stroke.take, {stroke.first, stroke.count}); !noted) {
        static_cast<void>(workpiece_.redo(workpiece));
        return noted;
    }
    undone_.push_back(std::move(stroke));
    done_.pop_back();
    return {};
}

Result<void> StrokeHistory::redo(Project& project, RunVolume& workpiece) {
    if (!canRedo()) return Error{ErrorCode::argumentInvalid, "redo", "0", "a stroke that was taken back"};
    Stroke& stroke = undone_.back();
    if (Result<void> redone = workpiece_.redo(workpiece); !redone) return redone;
    if (Result<void> noted = project.redoInterval(stroke.take, {stroke.first, stroke.count}); !noted) {
        static_cast<void>(workpiece_.undo(workpiece));
        return noted;
    }
    done_.push_back(std::move(stroke));
    undone_.pop_back();
    return {};
}

bool StrokeHistory::makeRoom() {
    const bool packed = workpiece_.packAll();
    forgetBeyondMemory();
    return packed || forgetOldest();
}

bool StrokeHistory::forgetOldest() {
    const std::size_t half = (done_.size() + 1) / 2;
    forget(half);
    return half > 0;
}

void StrokeHistory::forget(std::size_t strokes) {
    workpiece_.forgetOldest(strokes);
    done_.erase(done_.begin(), done_.begin() + static_cast<std::ptrdiff_t>(strokes));
}

} // namespace burin

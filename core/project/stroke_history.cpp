// SPDX-FileCopyrightText: 2026 The Burin authors
// SPDX-License-Identifier: Apache-2.0
#include "core/project/stroke_history.h"

#include <utility>

namespace burin {

void StrokeHistory::clear() {
    done_.clear();
    undone_.clear();
    after_ = {};
}

void StrokeHistory::add(Stroke stroke) {
    undone_.clear();
    after_ = {};
    ++added_;
    done_.push_back(std::move(stroke));
    if (done_.size() > maximum) done_.pop_front();
}

Result<void> StrokeHistory::undo(Project& project, RunVolume& workpiece) {
    if (!canUndo()) return Error{ErrorCode::argumentInvalid, "undo", "0", "a stroke that can be taken back"};
    Stroke& stroke = done_.back();
    if (Result<void> noted = project.undoStretch(stroke.take, {stroke.first, stroke.count}); !noted) return noted;
    if (undone_.empty()) after_ = workpiece.snapshot();
    workpiece.restore(stroke.before);
    undone_.push_back(std::move(stroke));
    done_.pop_back();
    return {};
}

Result<void> StrokeHistory::redo(Project& project, RunVolume& workpiece) {
    if (!canRedo()) return Error{ErrorCode::argumentInvalid, "redo", "0", "a stroke that was taken back"};
    Stroke& stroke = undone_.back();
    if (Result<void> noted = project.redoStretch(stroke.take, {stroke.first, stroke.count}); !noted) return noted;
    // A stroke left the workpiece as the one after it found it.
    const bool newest = undone_.size() == 1;
    workpiece.restore(newest ? after_ : undone_[undone_.size() - 2].before);
    done_.push_back(std::move(stroke));
    undone_.pop_back();
    if (newest) after_ = {};
    return {};
}

bool StrokeHistory::forgetOldest() {
    const auto half = static_cast<std::ptrdiff_t>((done_.size() + 1) / 2);
    done_.erase(done_.begin(), done_.begin() + half);
    return half > 0;
}

} // namespace burin

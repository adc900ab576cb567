// SPDX-FileCopyrightText: 2026 The Burin authors
// SPDX-License-Identifier: Apache-2.0
#include "ui/input/fine_pointer.h"

namespace burin {

namespace {

/// Whether both are lines of sight of the same picture, as far as they show: the eye, or the direction, is the same.
bool comparable(const Sight& a, const Sight& b) {
    if (a.parallel != b.parallel) return false;
    return a.parallel ? a.direction == b.direction : a.origin == b.origin;
}

/// `from`, moved by a fraction of the motion between two lines of sight of its picture.
Sight moved(const Sight& from, const Sight& before, const Sight& now, double part) {
    return {from.origin + part * (now.origin - before.origin),
            glm::normalize(from.direction + part * (now.direction - before.direction)), now.parallel, now.seenFrom};
}

} // namespace

Sight FinePointer::follow(const Sight& pointer, bool fine) {
    const Sight last = lastPointer_.value_or(pointer);
    lastPointer_ = pointer;
    if (anchor_ && !comparable(anchor_->pointer, pointer)) anchor_.reset(); // the camera moved
    const auto used = [this](const Sight& now) {
        if (!anchor_) return now;
        return moved(anchor_->used, anchor_->pointer, now, anchor_->fine ? share : 1.0);
    };
    if (fine != (anchor_ && anchor_->fine) && comparable(last, pointer) && (fine || anchor_))
        anchor_ = Anchor{last, used(last), fine};
    return used(pointer);
}

} // namespace burin

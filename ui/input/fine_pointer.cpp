// SPDX-FileCopyrightText: 2026 The Burin authors
// SPDX-License-Identifier: Apache-2.0
#include "ui/input/fine_pointer.h"

namespace burin {

Sight FinePointer::follow(const Sight& pointer, bool fine) {
    const Sight last = lastPointer_.value_or(pointer);
    lastPointer_ = pointer;
    if (anchor_ && anchor_->pointer.origin != pointer.origin) anchor_.reset(); // the camera moved: nothing to compare
    const auto used = [this](const Sight& now) {
        if (!anchor_) return now;
        const glm::dvec3 turn = now.direction - anchor_->pointer.direction;
        return Sight{now.origin, glm::normalize(anchor_->used.direction + (anchor_->fine ? share : 1.0) * turn)};
    };
    if (fine != (anchor_ && anchor_->fine) && last.origin == pointer.origin && (fine || anchor_))
        anchor_ = Anchor{last, used(last), fine};
    return used(pointer);
}

} // namespace burin

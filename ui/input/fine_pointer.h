// SPDX-FileCopyrightText: 2026 The Burin authors
// SPDX-License-Identifier: Apache-2.0
#pragma once

#include "ui/scene/sight.h"

#include <optional>

namespace burin {

/// Makes the pointer fine: while it is requested, the line of sight rotates (in a parallel picture: moves) by a tenth
/// of what the pointer's did since then. Afterwards the sight goes on from where it is, so that nothing jumps, until
/// `reset`.
class FinePointer {
public:
    static constexpr double share = 0.1;

    /// @param pointer the sight through the pointer; @param fine Shift is down
    /// @return the sight to use
    Sight follow(const Sight& pointer, bool fine);
    void reset() noexcept { anchor_.reset(); }
    bool isFine() const noexcept { return anchor_ && anchor_->fine; } ///< the newest sight is

private:
    struct Anchor {
        Sight pointer, used; ///< when fine pointing began or ended
        bool fine = true;
    };
    std::optional<Anchor> anchor_;
    std::optional<Sight> lastPointer_;
};

} // namespace burin

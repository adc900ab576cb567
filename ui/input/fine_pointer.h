// SPDX-FileCopyrightText: 2026 The Burin authors
// SPDX-License-Identifier: Apache-2.0
#pragma once

#include "ui/scene/sight.h"

#include <optional>

namespace burin {

/// Makes the pointer fine: while requested, the line of sight rotates (in a parallel projection: moves) by a tenth of
/// the pointer's motion since then. Afterwards the line of sight continues from its present position without a jump,
/// until `reset`.
class FinePointer {
public:
    static constexpr double share = 0.1;

    /// @param pointer the line of sight through the pointer; @param fine Shift is down
    /// @return the line of sight to use
    Sight follow(const Sight& pointer, bool fine);
    void reset() noexcept { anchor_.reset(); }
    /// Whether this applies to the newest line of sight
    bool isFine() const noexcept { return anchor_ && anchor_->fine; }

private:
    struct Anchor {
        Sight pointer, used; ///< when fine pointing began or ended
        bool fine = true;
    };
    std::optional<Anchor> anchor_;
    std::optional<Sight> lastPointer_;
};

} // namespace burin

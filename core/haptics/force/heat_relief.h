// SPDX-FileCopyrightText: 2026 The Burin authors
// SPDX-License-Identifier: Apache-2.0
#pragma once

#include <algorithm>

namespace burin {

/// Spares motors that say they are hot: the share of the maximum that they are asked for goes down to half, and back
/// once they have cooled a little, slowly enough to be no kick (0.45 mN a tick of 1 ms for 1.8 N). Tick code.
class HeatRelief {
public:
    static constexpr double hot = 0.8;              ///< of what the motors bear: beyond it they are spared
    static constexpr double cooled = 0.75;          ///< below it no longer
    static constexpr double least = 0.5;            ///< of the maximum
    static constexpr double changePerSecond = 0.25; ///< of the maximum

    /// @param heat share of what the motors bear; what is no number says nothing. @param period s
    void advance(double heat, double period) noexcept {
        if (heat > hot) spares_ = true;
        if (heat < cooled) spares_ = false;
        if (!(period > 0.0)) return;
        const double change = changePerSecond * std::min(period, longestPeriod);
        share_ = spares_ ? std::max(least, share_ - change) : std::min(1.0, share_ + change);
    }
    /// Of the maximum, 0.5 … 1.
    double share() const noexcept { return share_; }
    bool active() const noexcept { return share_ < 1.0; }

private:
    static constexpr double longestPeriod = 0.01; ///< s; after a gap nothing jumps

    double share_ = 1.0;
    bool spares_ = false;
};

} // namespace burin

// SPDX-FileCopyrightText: 2026 The Burin authors
// SPDX-License-Identifier: Apache-2.0
#pragma once

#include <algorithm>

namespace burin {

/// Protects motors that report that they are hot: the share of the maximum force that is used goes down to half, and
/// back once they have cooled a little, slowly enough not to be felt as a jump (0.45 mN per tick of 1 ms for 1.8 N).
/// Called in the haptic tick.
class HeatRelief {
public:
    static constexpr double hot = 0.8;              ///< share of the motors' limit above which the force is reduced
    static constexpr double cooled = 0.75;          ///< below this share it is no longer reduced
    static constexpr double least = 0.5;            ///< share of the maximum force
    static constexpr double changePerSecond = 0.25; ///< share of the maximum force

    /// @param heat share of the motors' limit; NaN is ignored. @param period s
    void advance(double heat, double period) noexcept {
        if (heat > hot) spares_ = true;
        if (heat < cooled) spares_ = false;
        if (!(period > 0.0)) return;
        const double change = changePerSecond * std::min(period, longestPeriod);
        share_ = spares_ ? std::max(least, share_ - change) : std::min(1.0, share_ + change);
    }
    /// Share of the maximum force to be used, 0.5 … 1.
    double share() const noexcept { return share_; }
    bool active() const noexcept { return share_ < 1.0; }

private:
    static constexpr double longestPeriod = 0.01; ///< s; avoids a jump after a gap

    double share_ = 1.0;
    bool spares_ = false;
};

} // namespace burin

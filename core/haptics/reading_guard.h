// SPDX-FileCopyrightText: 2026 The Burin authors
// SPDX-License-Identifier: Apache-2.0
#pragma once

#include "core/device/stylus.h"
#include "core/haptics/loop/tick_fault.h"

namespace burin {

enum class Reading : std::uint8_t {
    good,
    late,  ///< the tick came late: usable, but no force this time
    fault, ///< not usable: no force, and forces fade in again
};

/// Judges what a stylus read before anything acts on it.
class ReadingGuard {
public:
    static constexpr double largestJump = 20.0; ///< mm in one tick; no hand does that

    /// @param nominalPeriod s
    ReadingGuard(const StylusDescription& stylus, double nominalPeriod) noexcept
        : maximumSpeed_(stylus.maximumSpeed.value), nominalPeriod_(nominalPeriod), gaps_(gapLimits(nominalPeriod)) {}

    /// After a fault the next finite reading is a new start: nobody knows where the hand has been meanwhile. A jump
    /// is a fault once; what follows is measured from where it went.
    Reading check(const StylusState& state, double period) noexcept;
    /// Of the last reading that had one, for the record.
    const Pose& lastPose() const noexcept { return last_; }

private:
    double maximumSpeed_, nominalPeriod_;
    GapLimits gaps_;
    Pose last_;
    bool known_ = false;
};

} // namespace burin

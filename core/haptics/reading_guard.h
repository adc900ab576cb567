// SPDX-FileCopyrightText: 2026 The Burin authors
// SPDX-License-Identifier: Apache-2.0
#pragma once

#include "core/device/stylus.h"
#include "core/haptics/loop/tick_fault.h"

namespace burin {

enum class Reading : std::uint8_t {
    good,
    late,  ///< the tick was late: usable, but no force this time
    fault, ///< not usable: no force, and forces fade in again afterwards
};

/// Checks the readings of a stylus before they are used.
class ReadingGuard {
public:
    static constexpr double largestJump = 20.0; ///< mm in one tick, more than any hand moves

    /// @param nominalPeriod s
    ReadingGuard(const StylusDescription& stylus, double nominalPeriod) noexcept
        : maximumSpeed_(stylus.maximumSpeed.value), nominalPeriod_(nominalPeriod), gaps_(gapLimits(nominalPeriod)) {}

    /// Checks a reading. After a fault the next finite reading is a new start, because the motion of the hand in
    /// between is not known. A jump is a fault only once; following readings are compared with the position that it led
    /// to.
    Reading check(const StylusState& state, double period) noexcept;
    /// Pose of the last usable reading, for the record.
    const Pose& lastPose() const noexcept { return last_; }

private:
    double maximumSpeed_, nominalPeriod_;
    GapLimits gaps_;
    Pose last_;
    bool known_ = false;
};

} // namespace burin

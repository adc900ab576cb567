// SPDX-FileCopyrightText: 2026 The Burin authors
// SPDX-License-Identifier: Apache-2.0
#pragma once

#include "core/haptics/guides/guide_reach.h"
#include "core/haptics/guides/guide_shape.h"

namespace burin {

/// One guide from tick to tick: takes the hand when it comes near, and lets go when it is pushed off, is switched off
/// or cannot be told any more. Its hold on the goal, and its pull on the hand, fade in and out; a hand that was let go
/// for the distance feels nothing at once, since the pull has faded with the distance. Tick code.
class GuideSlot {
public:
    enum class State : std::uint8_t { idle, held, leaving };

    /// What is wanted of it from the next tick on.
    void want(const Guide& guide) noexcept { wanted_ = guide; }
    /// @param reach of the guides, mm in the setup per mm in the device. @param moved mm, of the hand
    void update(const GuideSurroundings& around, const glm::dvec3& hand, double moved, double reach,
                double period) noexcept;
    /// It may be captured now; whether it is depends on the others.
    bool offers() const noexcept { return offers_; }
    /// Holds the hand from now on; its pull grows from 0.
    void capture() noexcept;
    /// The others do not let it: a level that was asked for is given up.
    void refuse() noexcept { offers_ = stepping_ = false; }
    /// Lets go; what was held fades. @param pulls the pull fades, too; else there was none any more
    void leave(bool pulls) noexcept;
    /// Takes the next level. @param levels +1: along the normal
    void step(int levels) noexcept;
    /// As before the first tick, at once.
    void forget() noexcept;

    State state() const noexcept { return state_; }
    const GuideShape& shape() const noexcept { return shape_; }
    double distance() const noexcept { return distance_; } ///< mm, of the hand
    /// About the hand's foot; kept while it leaves.
    const GuideRows& rows() const noexcept { return rows_; }
    double hold() const noexcept { return smooth(hold_); } ///< on the goal, 0 … 1
    double pull() const noexcept { return smooth(pull_); } ///< on the hand, 0 … 1, but for its distance
    /// Share of an endless spring's force that a hand feels at its distance, 0 … 1. @param strongest mm, at which the
    /// spring is at its largest force
    double fading(double reach, double strongest) const noexcept;
    bool stepping() const noexcept { return stepping_; }

private:
    static double smooth(double share) noexcept { return share * share * (3.0 - 2.0 * share); }
    double release(double reach) const noexcept;
    double capturing(double reach) const noexcept;
    void updateIdle(const GuideSurroundings& around, const glm::dvec3& hand, double reach) noexcept;
    void updateHeld(const GuideSurroundings& around, const glm::dvec3& hand, double moved, double reach) noexcept;

    Guide wanted_;
    GuideShape shape_;
    State state_ = State::idle;
    GuideRows rows_;
    double distance_ = 0.0;
    double hold_ = 0.0, pull_ = 0.0; ///< 0 … 1, rising and falling evenly
    bool offers_ = false;
    bool stepping_ = false; ///< on the way to a level that was asked for
    bool unfaded_ = false;  ///< taken for such a level: the pull does not fade with the distance
    double farthest_ = 0.0; ///< mm that it was away when it was taken
};

} // namespace burin

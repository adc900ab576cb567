// SPDX-FileCopyrightText: 2026 The Burin authors
// SPDX-License-Identifier: Apache-2.0
#pragma once

#include "core/haptics/guides/guide_reach.h"
#include "core/haptics/guides/guide_shape.h"

namespace burin {

/// One guide from tick to tick: captures the hand when it comes near, and releases it when the hand pushes off, when
/// the guide is switched off, or when it can't be evaluated any more. Its hold on the goal and its pull on the hand
/// fade in and out. A hand that was released because of its distance feels nothing at once, since the pull has already
/// faded with the distance. Called in the haptic tick.
class GuideSlot {
public:
    enum class State : std::uint8_t { idle, held, leaving };

    /// The guide to be used from the next tick on.
    void want(const Guide& guide) noexcept { wanted_ = guide; }
    /// @param reach scale for the guides' distances, mm in the setup per mm in the device. @param moved mm, of the hand
    void update(const GuideSurroundings& around, const glm::dvec3& hand, double moved, double reach,
                double period) noexcept;
    /// Whether it could be captured now; whether it is captured depends on the other guides.
    bool offers() const noexcept { return offers_; }
    /// The guide holds the hand from now on; its pull grows from 0.
    void capture() noexcept;
    /// The other guides prevent the capture: a requested level change is given up.
    void refuse() noexcept { offers_ = stepping_ = false; }
    /// Releases the hand; the hold on the goal fades out. @param pulls whether the pull fades out as well; otherwise it
    /// ends at once, because there was none left
    void leave(bool pulls) noexcept;
    /// Changes the level. @param levels +1: along the normal
    void step(int levels) noexcept;
    /// Returns to the state before the first tick, at once.
    void forget() noexcept;

    State state() const noexcept { return state_; }
    const GuideShape& shape() const noexcept { return shape_; }
    double distance() const noexcept { return distance_; } ///< mm, of the hand
    /// Planes at the hand's foot; kept while it leaves.
    const GuideRows& rows() const noexcept { return rows_; }
    double hold() const noexcept { return smooth(hold_); } ///< weight of its hold on the goal, 0 … 1
    /// weight of its pull on the hand, 0 … 1, not including the fading with distance
    double pull() const noexcept { return smooth(pull_); }
    /// Share of the force of an unlimited spring that a hand feels at its distance, 0 … 1. @param strongest mm,
    /// distance at which the spring force is largest
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
    double hold_ = 0.0, pull_ = 0.0; ///< 0 … 1, rising and falling linearly in time
    bool offers_ = false;
    bool stepping_ = false; ///< moving to a level that was requested
    bool unfaded_ = false;  ///< captured for such a level: the pull does not fade with the distance
    double farthest_ = 0.0; ///< mm, distance at the time of capture
};

} // namespace burin

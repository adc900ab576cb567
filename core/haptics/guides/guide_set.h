// SPDX-FileCopyrightText: 2026 The Burin authors
// SPDX-License-Identifier: Apache-2.0
#pragma once

#include "core/haptics/guides/guide_axis.h"
#include "core/haptics/guides/guide_reach.h"
#include "core/haptics/guides/guide_slot.h"
#include "core/haptics/guides/guide_solver.h"
#include "core/haptics/hand_input.h"

namespace burin {

/// The goal of the hand according to the guides, and what the hand feels of them. Setup frame.
struct GuidedHand {
    ToolPose goal; ///< pose that the tool moves to
    /// mm, displacement of the guides' spring, faded and clamped; to be multiplied by its stiffness
    glm::dvec3 pull{0.0};
    glm::dvec3 across{0.0}; ///< mm/s, velocity of the hand across the guides that hold it, for the guides' damper
    std::uint32_t held = 0; ///< bit i: guide i holds the hand
};

/// All guides of a session, solved together: the hand's request becomes a goal on every guide that holds the hand. A
/// guide captures the hand within GuideReach::capture and releases it beyond GuideReach::release. A guide that
/// contradicts one that holds the hand waits (overruled), or, if it comes earlier in the settings, makes the other one
/// leave first. All changes fade over rampSeconds. The pull is the gradient of a potential that is highest at the
/// release distance, so that approaching a guide, being captured and pushing off costs energy and never yields any.
/// Called in the haptic tick, except for the constructor.
class GuideSet {
public:
    /// @param field of the tool; outlives the object
    GuideSet(const ClearanceField& field, const HapticSettings& settings);

    /// Takes effect with the next tick, without a jump of the force. Called between two ticks.
    void set(const GuideSettings& settings) noexcept;
    /// Selects the next level of all level guides that hold the hand, and ends the pass for step-over. Called between
    /// two ticks.
    /// @param levels +1: along the normal
    void step(int levels) noexcept;

    /// @param tool its current pose. @param cutting whether the spindle turns: the tool makes a pass. @param period s
    GuidedHand guide(const Hand& hand, const ToolPose& tool, bool cutting, double period) noexcept;
    /// To be called when the motion of the hand is not known for some time: no guide holds the hand any more. The last
    /// pass is kept.
    void forget() noexcept;

    const GuideSettings& settings() const noexcept { return settings_; }
    /// @param guide its number in the settings, not range-checked
    GuideNews news(std::size_t guide) const noexcept;
    double stiffness() const noexcept { return stiffness_; } ///< N/m, device space

private:
    void followPass(const ToolPose& tool, bool cutting) noexcept;
    void order() noexcept;
    void giveWay(std::size_t guide, const GuideRows& rows) noexcept;
    bool gather(const GuideSurroundings& around, const glm::dvec3* place) noexcept;
    void capture() noexcept;
    void solve(const GuideSurroundings& around, const glm::dvec3& hand, double reach) noexcept;
    const Guide* axisGuide() const noexcept;
    void feel(const Hand& hand, GuidedHand& guided) const noexcept;
    double sumOfShares(const glm::dvec3& direction) const noexcept;

    const ClearanceField* field_;
    double stiffness_;     ///< N/m, device space
    double strongestPull_; ///< mm of the device
    GuideSettings settings_;
    std::array<GuideSlot, GuideSettings::capacity> slots_;
    std::array<std::size_t, GuideSettings::capacity> active_{}; ///< guides that hold or leave, oldest first
    std::size_t activeCount_ = 0;
    GuideSolver solver_;
    GuideAxis axis_;
    LastPass lastPass_;
    glm::dvec3 passDirection_{0.0};
    bool passUnderWay_ = false;
    glm::dvec3 hand_{0.0}, correction_{0.0}; ///< mm, in the previous tick
    std::uint32_t buttons_ = 0, overruled_ = 0;
    bool known_ = false;
};

} // namespace burin

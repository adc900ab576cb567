// SPDX-FileCopyrightText: 2026 The Burin authors
// SPDX-License-Identifier: Apache-2.0
#pragma once

#include "core/haptics/guides/guide_axis.h"
#include "core/haptics/guides/guide_reach.h"
#include "core/haptics/guides/guide_slot.h"
#include "core/haptics/guides/guide_solver.h"
#include "core/haptics/hand_input.h"

namespace burin {

/// Where the guides would have the hand, and what they let it feel of that. Setup frame.
struct GuidedHand {
    ToolPose goal;          ///< that the tool goes for
    glm::dvec3 pull{0.0};   ///< mm: the guides' spring pulls the hand so far, faded and clamped; times its stiffness
    glm::dvec3 across{0.0}; ///< mm/s of the hand across what holds it, for the guides' damper
    std::uint32_t held = 0; ///< bit i: guide i holds
};

/// All guides of a session, solved together: the hand's wish becomes a guided goal on every guide that holds. A guide
/// takes the hand within GuideReach::capture and lets go beyond release; a guide that contradicts one that holds waits
/// (overruled), or, if it stands before it in the settings, makes it leave first. All changes fade over rampSeconds.
/// The pull is the gradient of a potential that is highest where a guide lets go, so that coming near, being taken,
/// and pushing off costs energy, and never gives any.
/// Tick code, but for making the object.
class GuideSet {
public:
    /// @param field of the tool; outlives the object
    GuideSet(const ClearanceField& field, const HapticSettings& settings);

    /// Takes effect with the next tick, without a kick. Between two ticks.
    void set(const GuideSettings& settings) noexcept;
    /// The next level for all level guides that hold, and the end of a pass for step-over. Between two ticks.
    /// @param levels +1: along the normal
    void step(int levels) noexcept;

    /// @param tool where it is. @param cutting the spindle turns: the tool makes a pass. @param period s
    GuidedHand guide(const Hand& hand, const ToolPose& tool, bool cutting, double period) noexcept;
    /// Nobody knows where the hand has been meanwhile: no guide holds. The last pass stays known.
    void forget() noexcept;

    const GuideSettings& settings() const noexcept { return settings_; }
    /// @param guide its number in the settings, not checked
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
    double strongestPull_; ///< mm in the device
    GuideSettings settings_;
    std::array<GuideSlot, GuideSettings::capacity> slots_;
    std::array<std::size_t, GuideSettings::capacity> active_{}; ///< held and leaving ones, oldest first
    std::size_t activeCount_ = 0;
    GuideSolver solver_;
    GuideAxis axis_;
    LastPass lastPass_;
    glm::dvec3 passDirection_{0.0};
    bool passUnderWay_ = false;
    glm::dvec3 hand_{0.0}, correction_{0.0}; ///< mm, of the tick before
    std::uint32_t buttons_ = 0, overruled_ = 0;
    bool known_ = false;
};

} // namespace burin

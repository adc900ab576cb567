// SPDX-FileCopyrightText: 2026 The Burin authors
// SPDX-License-Identifier: Apache-2.0
#pragma once

#include "core/cutting/cutting_force.h"
#include "core/cutting/removal.h"
#include "core/device/stylus.h"
#include "core/haptics/allowance_follower.h"
#include "core/haptics/brake_on_contact.h"
#include "core/haptics/coupling.h"
#include "core/haptics/cutting_force_rendering.h"
#include "core/haptics/force_limiter.h"
#include "core/haptics/passivity_controller.h"
#include "core/haptics/proxy.h"
#include "core/haptics/reading_guard.h"
#include "core/haptics/velocity_window.h"
#include "core/haptics/workspace_mapping.h"
#include "core/recording/sample.h"

namespace burin {

/// Gains and limits of one session.
struct HapticSettings {
    WorkspaceMapping mapping;
    StylusDescription stylus;        ///< whose limits bound everything that is sent
    double allowance = 0.0;          ///< mm left on the part
    double cuttingSpeed = 1000.0;    ///< mm/s of the flutes' edge
    double cuttingForceScale = 0.01; ///< rendered / real cutting force
    double couplingShare = 0.8;      ///< of the stylus' maximum stiffness
    double forceShare = 0.6;         ///< of the stylus' maximum force
    double rampSeconds = 1.5;        ///< forces fade in after start and after any fault
    double tickPeriod = 0.001;       ///< s that the loop intends; later ticks count as late
    bool cutsOnButton = false;       ///< the spindle turns only while the stylus' first button is down
};

/// One tick of milling: mapping, proxy, swept cut, force, coupling, limits (design.md section 4). A function of its
/// inputs and its state: no clock, no allocation, lock, exception, log or file.
/// Thread: the one writer of the workpiece.
class HapticStep {
public:
    /// All references but the settings must outlive the object; the tool is copied.
    HapticStep(RunVolume& workpiece, const ClearanceField& field, const Tool& tool, const HapticSettings& settings);

    /// @param state what the stylus read; @param period s since the tick before, > 0.
    /// @return the tick's record; `Sample::force` is what goes to the device, in the device frame via `deviceForce`.
    /// Until `started`, the record's proxy is parked clear above the hand, and nothing is cut. Neither is anything in
    /// the first tick of a take: the tool is taken up where it stands, so that what is cut lies between two samples.
    /// While the spindle stands (sampleSpindleOff) the part alone holds the tool; stock, shank and holder don't count.
    Sample operator()(const StylusState& state, double period) noexcept;

    /// Force of the last tick in the device frame, N.
    glm::dvec3 deviceForce() const noexcept { return deviceForce_; }
    /// True once the tool has been clear of the part; forces stay off until then.
    bool started() const noexcept { return started_; }
    /// Takes effect over some ticks (5 mm/s), without a kick. @param allowance mm, >= 0
    void setAllowance(double allowance) noexcept { allowance_.want(allowance); }
    /// Writes what was cut to the workpiece, which lags by up to 16 ticks. For whoever reads it for good: before a
    /// snapshot that is to be restored, undo, saving, amounts; pictures need not. Loop's thread, between two ticks.
    void settle() noexcept;
    /// Cuts again after the reserved memory had run out and the owner has made room.
    void resumeCutting() noexcept { memoryFull_ = false; }
    /// Ticks and time of the samples start again from 0 with the next tick.
    void beginTake() noexcept;
    /// @param released false: the spindle stands, whatever the button says. A new step's is released.
    void releaseSpindle(bool released) noexcept { spindleReleased_ = released; }
    /// The owner put another state of the workpiece in place, between two ticks: what the step knew of it is forgotten,
    /// and forces fade in again.
    void workpieceChanged() noexcept;
    /// What shank or holder touched in the last tick; meaningful with sampleShankContact.
    const ShankContact& shankContact() const noexcept { return shank_; }

    /// What the limits were made from, for meters and tests.
    double couplingStiffness() const noexcept { return coupling_.stiffness(); } ///< N/m, device space
    const ForceLimiter& limiter() const noexcept { return limiter_; }

private:
    struct Motion;
    Sample beginSample(double period) noexcept;
    bool cuts() const noexcept { return spindleReleased_ && (!settings_.cutsOnButton || buttonDown_); }
    bool start(const glm::dvec3& hand) noexcept;
    glm::dvec3 parkedAbove(const glm::dvec3& hand) const noexcept;
    Motion moveTool(const glm::dvec3& hand, double period) noexcept;
    CuttingForce cut(Motion& motion, double period, Sample& sample) noexcept;
    glm::dvec3 wantedForce(const Motion& motion, const CuttingForce& cutting, const glm::dvec3& hand,
                           double period) noexcept;
    void send(const glm::dvec3& wanted, const Pose& device, double period, Sample& sample) noexcept;
    void noForce(bool fadesIn, Sample& sample) noexcept;
    CutResult take(const glm::dvec3& from, const glm::dvec3& to) noexcept;
    void fadeIn() noexcept;

    RunVolume* workpiece_;
    HapticSettings settings_;
    CuttingCoefficients coefficients_;
    double topOfWorkpiece_, spacing_, travelPerSecond_;
    MaterialRemoval removal_;
    BrakeOnContact brake_;
    Proxy proxy_;
    AllowanceFollower allowance_;
    ReadingGuard guard_;
    Coupling coupling_;
    CuttingForceRendering cuttingRendering_;
    PassivityController passivity_;
    ForceLimiter limiter_;
    ForceRamp ramp_;
    VelocityWindow deviceVelocity_, proxyVelocity_;

    std::uint64_t tick_ = 0;
    double time_ = 0.0;
    glm::dvec3 tip_{0.0};
    double travelSinceRemoval_ = 0.0; ///< mm
    glm::dvec3 deviceForce_{0.0};
    ShankContact shank_;
    bool started_ = false;
    bool memoryFull_ = false;
    bool spindleReleased_ = true, buttonDown_ = false;
    bool takesUp_ = true; ///< the next tick does not cut
};

} // namespace burin

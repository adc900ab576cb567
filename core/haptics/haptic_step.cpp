// SPDX-FileCopyrightText: 2026 The Burin authors
// SPDX-License-Identifier: Apache-2.0
#include "core/haptics/haptic_step.h"

#include "core/haptics/recorded_removal.h"

#include <algorithm>
#include <cmath>
#include <limits>

namespace burin {
namespace {

constexpr double voxelsPerTick = 6.0; // of travel, at least
constexpr double cuttingShare = 0.6;  // of the force that is allowed at all
constexpr int parkingSamples = 256;
// A tool that cuts takes a row of scanlines at least so often. The reported removal looks a voxel ahead; without this
// a tool on its way to the stock would feel it before it touches.
constexpr double idleVoxels = 2.0;

double maximumForce(const HapticSettings& settings) noexcept {
    return settings.stylus.hasMotors() ? settings.forceShare * settings.stylus.maximumForce.value : 0.0;
}

CuttingForceRendering::Settings renderingSettings(const HapticSettings& settings, double stiffness) noexcept {
    return {settings.cuttingForceScale, stiffness, cuttingShare * maximumForce(settings), settings.mapping.scale};
}

/// A tool as fast as the fastest hand that is believed follows it without a lag, hence without a force.
double travelPerSecond(const HapticSettings& settings, const Grid& grid) noexcept {
    return std::max(voxelsPerTick * grid.edge() / settings.tickPeriod,
                    1.1 * settings.stylus.maximumSpeed.value * settings.mapping.scale);
}

} // namespace

/// What became of the hand's wish in one tick.
struct HapticStep::Motion {
    glm::dvec3 from{0.0}, to{0.0}; ///< mm, tips
    glm::dvec3 normal{0.0};        ///< unit, of the part's boundary where it holds the tool; zero when free
    bool shankContact = false;
    bool barred = false; ///< the tool stays although the part would let it go
};

HapticStep::HapticStep(RunVolume& workpiece, const ClearanceField& field, const Tool& tool,
                       const HapticSettings& settings)
    : workpiece_(&workpiece)
    , settings_(settings)
    , coefficients_(cuttingCoefficients(workpiece.properties()))
    , topOfWorkpiece_(workpiece.grid().box().high.z)
    , spacing_(field.spacing())
    , travelPerSecond_(travelPerSecond(settings, workpiece.grid()))
    , removal_(tool.cutter, workpiece.grid(), Writing::deferred)
    , brake_(tool.cutter, workpiece.grid())
    , proxy_(field)
    , allowance_(settings.allowance)
    , guard_(settings.stylus, settings.tickPeriod)
    , coupling_(couplingGains(settings.stylus, settings.couplingShare, settings.tickPeriod), settings.mapping.scale)
    , cuttingRendering_(renderingSettings(settings, coupling_.stiffness()))
    , passivity_(usableDamping(settings.stylus))
    , limiter_(maximumForce(settings), coupling_.stiffness(), settings.tickPeriod)
    , ramp_(settings.rampSeconds) {}

Sample HapticStep::operator()(const StylusState& state, double period) noexcept {
    Sample sample = beginSample(period);
    const Reading reading = guard_.check(state, period);
    sample.device = guard_.lastPose();
    sample.stylusTip = settings_.mapping.toSetup(sample.device.position);
    sample.proxy.tip = started_ ? tip_ : parkedAbove(sample.stylusTip);
    if (memoryFull_) sample.flags |= sampleMemoryFull;
    if (reading != Reading::fault) buttonDown_ = (state.buttons & 1u) != 0;
    if (!cuts()) sample.flags |= sampleSpindleOff;
    if (reading == Reading::fault) {
        sample.flags |= sampleStylusInvalid;
        noForce(true, sample);
        return sample;
    }
    sample.buttons = state.buttons;
    deviceVelocity_.add(state.pose.position, period);
    if (!started_ && !start(sample.stylusTip)) {
        noForce(true, sample);
        return sample;
    }
    Motion motion = moveTool(sample.stylusTip, period);
    const CuttingForce cutting = cut(motion, period, sample);
    takesUp_ = false;
    tip_ = motion.to;
    if (motion.barred) allowance_.limitTo(proxy_.clearance(tip_));
    proxyVelocity_.add(tip_, period);
    sample.proxy.tip = tip_;
    if (motion.shankContact) sample.flags |= sampleShankContact;
    if (motion.normal != glm::dvec3(0.0)) sample.flags |= sampleOnBoundary;
    const glm::dvec3 wanted = wantedForce(motion, cutting, sample.stylusTip, period);
    if (reading == Reading::late) {
        noForce(false, sample);
        return sample;
    }
    send(wanted, state.pose, period, sample);
    return sample;
}

Sample HapticStep::beginSample(double period) noexcept {
    Sample sample;
    if (tick_ > 0 && std::isfinite(period) && period > 0.0) time_ += period;
    sample.tick = tick_++;
    sample.time = time_;
    return sample;
}

void HapticStep::beginTake() noexcept {
    tick_ = 0;
    time_ = 0.0;
    takesUp_ = true;
}

void HapticStep::settle() noexcept {
    // Nothing is put off between two ticks (see `take`), so that there is nothing to count.
    if (removal_.settle(*workpiece_).outOfMemory) memoryFull_ = true;
}

void HapticStep::workpieceChanged() noexcept {
    removal_.reset();
    brake_.workpieceChanged();
    travelSinceRemoval_ = std::numeric_limits<double>::infinity();
    memoryFull_ = false;
    deviceForce_ = glm::dvec3(0.0);
    fadeIn();
}

bool HapticStep::start(const glm::dvec3& hand) noexcept {
    allowance_.settle();
    if (!proxy_.feasible(hand, allowance_.inForce())) return false;
    if (cuts() && brake_.at(*workpiece_, hand).touches) return false;
    tip_ = hand;
    takesUp_ = true;
    travelSinceRemoval_ = std::numeric_limits<double>::infinity();
    proxyVelocity_.reset();
    started_ = true;
    return true;
}

/// Where a tool that has not started is shown: straight above the hand, clear of the part.
glm::dvec3 HapticStep::parkedAbove(const glm::dvec3& hand) const noexcept {
    glm::dvec3 tip = hand;
    for (int i = 0; i < parkingSamples; ++i) {
        const double missing = allowance_.inForce() - proxy_.clearance(tip);
        if (!(missing > 0.0)) return tip;
        tip.z += std::max(missing, spacing_);
    }
    tip.z = std::max(tip.z, topOfWorkpiece_);
    return tip;
}

HapticStep::Motion HapticStep::moveTool(const glm::dvec3& hand, double period) noexcept {
    const double travel = travelPerSecond_ * std::min(period, ReadingGuard::lateTicks * settings_.tickPeriod);
    Motion motion;
    motion.from = tip_;
    const glm::dvec3 standing = allowance_.advance(proxy_, tip_, period);
    const auto barred = [&](const glm::dvec3& to) noexcept {
        if (!cuts()) return false;
        ShankContact contact = brake_.onTheWay(*workpiece_, tip_, to);
        // What is touched may be gone, though not yet written.
        if (contact.touches && !removal_.settled()) {
            settle();
            contact = brake_.onTheWay(*workpiece_, tip_, to);
        }
        if (contact.touches) shank_ = contact;
        motion.shankContact = motion.shankContact || contact.touches;
        return contact.touches || (memoryFull_ && brake_.onTheWayWithFlutes(*workpiece_, tip_, to).touches);
    };
    ProxyStep step = proxy_.advance(standing, hand, allowance_.inForce(), travel);
    if (barred(step.tip)) {
        motion.barred = true;
        // Held sideways, a tool can still be pulled out along its axis.
        const glm::dvec3 above(standing.x, standing.y, std::max(standing.z, hand.z));
        step = proxy_.advance(standing, above, allowance_.inForce(), travel);
        if (step.tip == tip_ || barred(step.tip)) step = {tip_, false, glm::dvec3(0.0), 0};
    }
    motion.to = step.tip;
    if (step.onBoundary) motion.normal = step.normal;
    return motion;
}

CuttingForce HapticStep::cut(Motion& motion, double period, Sample& sample) noexcept {
    if (!cuts()) travelSinceRemoval_ = std::numeric_limits<double>::infinity();
    if (!cuts() || takesUp_ || motion.shankContact || memoryFull_) {
        removal_.approach(*workpiece_, {motion.to, {0.0, 0.0, 1.0}});
        return {};
    }
    const CutResult cut = take(motion.from, motion.to);
    recordRemoval(cut, workpiece_->properties(), sample);
    sample.reportedRemoval = cut.reported;
    const glm::dvec3 way = motion.to - motion.from;
    travelSinceRemoval_ = cut.volume > 0.0 ? 0.0 : travelSinceRemoval_ + glm::length(way);
    CuttingForce force;
    if (travelSinceRemoval_ <= idleVoxels * workpiece_->grid().edge())
        force = cuttingForce(cut, coefficients_, way, motion.to, settings_.cuttingSpeed, period);
    sample.cuttingForce = force.force;
    if (cut.outOfMemory) {
        memoryFull_ = true;
        sample.flags |= sampleMemoryFull;
        motion.to = motion.from; // part of the way is uncut
        motion.normal = glm::dvec3(0.0);
        motion.barred = true;
    }
    return force;
}

/// A sample holds all that was cut between it and the one before, so that replaying takes gives the same workpiece:
/// what a cut would put off is taken at once. `approach` has made that rare.
CutResult HapticStep::take(const glm::dvec3& from, const glm::dvec3& to) noexcept {
    CutResult cut = removal_.cut(*workpiece_, from, to);
    if (!cut.putOff || cut.outOfMemory) return cut;
    const CutResult rest = removal_.settle(*workpiece_);
    const double volume = cut.volume + rest.volume;
    if (volume > 0.0) cut.centroid = (cut.centroid * cut.volume + rest.centroid * rest.volume) / volume;
    cut.volume = volume;
    cut.outOfMemory = rest.outOfMemory;
    for (const MaterialVolume& more : rest.removed) {
        if (more.property == airProperty) continue;
        const auto same = std::find_if(cut.removed.begin(), cut.removed.end(), [&](const MaterialVolume& one) {
            return one.property == more.property || one.property == airProperty;
        });
        same->property = more.property;
        same->units += more.units;
        same->volume += more.volume;
    }
    return cut;
}

glm::dvec3 HapticStep::wantedForce(const Motion& motion, const CuttingForce& cutting, const glm::dvec3& hand,
                                   double period) noexcept {
    Coupling::State state;
    state.proxy = motion.to;
    state.hand = hand;
    state.proxyVelocity = proxyVelocity_.velocity();
    state.handVelocity = settings_.mapping.scale * settings_.mapping.directionToSetup(deviceVelocity_.velocity());
    state.normal = motion.normal;
    const glm::dvec3 away = motion.to - hand;
    if (motion.barred && glm::length(away) > 1e-6) state.normal = glm::normalize(away);
    return coupling_.force(state) + cuttingRendering_(cutting, motion.to - motion.from, motion.to, period);
}

void HapticStep::send(const glm::dvec3& wanted, const Pose& device, double period, Sample& sample) noexcept {
    const glm::dvec3 inDevice = settings_.mapping.directionToDevice(wanted);
    if (!isFinite(inDevice)) {
        noForce(true, sample);
        return;
    }
    const glm::dvec3 passive = passivity_(inDevice, device.position, deviceVelocity_.velocity(), period);
    deviceForce_ = limiter_(passive) * ramp_.weight();
    passivity_.sent(deviceForce_);
    sample.force = settings_.mapping.directionToSetup(deviceForce_);
    if (limiter_.saturated() && limiter_.maximum() > 0.0) sample.flags |= sampleForceSaturated;
    if (!ramp_.complete()) sample.flags |= sampleForcesOff;
    ramp_.advance(period);
}

void HapticStep::noForce(bool fadesIn, Sample& sample) noexcept {
    deviceForce_ = glm::dvec3(0.0);
    sample.force = glm::dvec3(0.0);
    sample.flags |= sampleForcesOff;
    limiter_.reset();
    passivity_.reset();
    if (fadesIn) fadeIn();
}

void HapticStep::fadeIn() noexcept {
    limiter_.reset();
    passivity_.reset();
    ramp_.restart();
    cuttingRendering_.reset();
    deviceVelocity_.reset();
    proxyVelocity_.reset();
}

} // namespace burin

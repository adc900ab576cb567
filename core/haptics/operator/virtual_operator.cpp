// SPDX-FileCopyrightText: 2026 The Burin authors
// SPDX-License-Identifier: Apache-2.0
#include "core/haptics/operator/virtual_operator.h"

#include "core/base/numbers.h"

#include <algorithm>
#include <cmath>

namespace burin {

namespace {

constexpr double smallestScale = 0.25; // mm of setup per mm of device
constexpr double workspaceShare = 0.9;
constexpr double restingSpeed = 0.5;    // mm/s
constexpr double longestSettling = 1.0; // s

glm::dvec3 quantised(const glm::dvec3& position, double step) noexcept {
    return step > 0.0 ? glm::round(position / step) * step : position;
}

} // namespace

StylusDescription touchLikeStylus() {
    StylusDescription stylus;
    stylus.name = "Virtual operator";
    stylus.simulated = true;
    const std::string touch = "CHAI3D device table, 3D Systems Touch (closed loop at 1 kHz)";
    stylus.actuated = {3, 0};
    stylus.maximumForce = {3.3, touch};
    stylus.maximumStiffness = {400.0, touch};
    stylus.maximumDamping = {4.0, touch};
    stylus.workspaceRadius = {75.0, touch};
    return stylus;
}

WorkspaceMapping mappingFor(const Box& setupRegion, const StylusDescription& stylus) {
    WorkspaceMapping mapping;
    mapping.origin = setupRegion.centre();
    mapping.scale = std::max(smallestScale,
                             0.5 * glm::length(setupRegion.size()) / (workspaceShare * stylus.workspaceRadius.value));
    return mapping;
}

VirtualOperator::VirtualOperator(std::vector<IntentPoint> intent, const WorkspaceMapping& mapping,
                                 const OperatorSettings& settings)
    : intent_(std::move(intent))
    , mapping_(mapping)
    , settings_(settings)
    , arm_(settings.hand, settings.handle, settings.reaction, settings.integrationStep)
    , tremor_(settings.tremor, settings.seed) {}

Result<void> VirtualOperator::open() {
    std::vector<IntentPoint> way = intent_;
    for (std::size_t i = 0; i < way.size(); ++i) {
        way[i].tip = mapping_.toDevice(intent_[i].tip);
        way[i].speed = intent_[i].speed / mapping_.scale;
        if (glm::length(way[i].tip) > settings_.stylus.workspaceRadius.value)
            return Error{ErrorCode::argumentInvalid, "intent point " + std::to_string(i + 1),
                         formatFixed(glm::length(way[i].tip), 1) + " mm",
                         "a position within the device's workspace of " +
                             formatFixed(settings_.stylus.workspaceRadius.value, 1) + " mm"};
    }
    Result<IntentMotion> motion = IntentMotion::make(way, settings_.motion);
    if (!motion) return motion.error();
    motion_ = std::move(*motion);
    arm_.reset();
    force_ = glm::dvec3(0.0);
    started_.reset();
    time_ = 0.0;
    return {};
}

StylusState VirtualOperator::read(double time) noexcept {
    if (!motion_ || !std::isfinite(time)) return {};
    if (!started_) started_ = time_ = time;
    const double elapsed = time - time_;
    const double sinceStart = time - *started_;
    const glm::dvec3 intended = motion_->at(sinceStart).position + tremor_.at(sinceStart);
    if (elapsed > 0.0) {
        arm_.advance(force_, elapsed);
        time_ = time;
    }
    stayInWorkspace(intended);

    StylusState state;
    state.time = time;
    state.pose.position = quantised(intended + arm_.deviation(), settings_.encoderStep);
    state.pose.rotation = glm::conjugate(mapping_.rotation); // upright in the setup
    state.valid = true;
    return state;
}

void VirtualOperator::stayInWorkspace(const glm::dvec3& intended) noexcept {
    const glm::dvec3 place = intended + arm_.deviation();
    const double reach = glm::length(place);
    if (reach <= settings_.stylus.workspaceRadius.value) return;
    const glm::dvec3 outward = place / reach;
    arm_.stopAt(outward * settings_.stylus.workspaceRadius.value - intended, outward);
}

void VirtualOperator::write(const Wrench& wrench) noexcept {
    force_ = isFinite(wrench.force) ? clampLength(wrench.force, settings_.stylus.maximumForce.value) : glm::dvec3(0.0);
}

bool VirtualOperator::finished() const noexcept {
    if (!motion_ || !started_) return false;
    const double past = time_ - *started_ - motion_->duration();
    return past >= 0.0 && (glm::length(arm_.velocity()) < restingSpeed || past > longestSettling);
}

void VirtualOperator::close() noexcept {
    force_ = glm::dvec3(0.0);
}

} // namespace burin

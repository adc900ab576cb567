// SPDX-FileCopyrightText: 2026 The Burin authors
// SPDX-License-Identifier: Apache-2.0
#include "core/haptics/workspace.h"

#include "core/device/deflection.h"

#include <algorithm>
#include <cmath>

namespace burin {
namespace {

constexpr double smallestScale = 1e-3, largestScale = 1e3;
constexpr double sameTurn = 1e-12;

bool usable(const glm::dquat& rotation) noexcept {
    return std::abs(glm::dot(rotation, rotation) - 1.0) < 1e-6; // also false for NaN
}

} // namespace

Workspace::Workspace(const HapticSettings& settings) noexcept
    : mapping_(settings.mapping)
    , motors_(settings.stylus.hasMotors())
    , radius_(settings.stylus.workspaceRadius.value) {}

void Workspace::set(const WorkspaceSettings& settings) noexcept {
    if (settings.recentrings != settings_.recentrings) recentring_ = true;
    settings_ = settings;
    const std::optional<double>& scale = settings_.scale;
    if (scale && !(*scale >= smallestScale && *scale <= largestScale)) settings_.scale.reset();
    if (settings_.rotation && !usable(*settings_.rotation)) settings_.rotation.reset();
    // With motors, a force would push the stylus out of its position, and the tool would drift away.
    if (motors_) settings_.control = WorkspaceControl::position;
}

/// Speed of the tip, mm/s, for a position of the stylus.
glm::dvec3 Workspace::rate(const glm::dvec3& place) const noexcept {
    const double deflection = glm::length(place);
    if (!(deflection > 0.0) || !(radius_ > 0.0)) return glm::dvec3(0.0);
    const double speed = mapping_.scale * topSpeed * deflectionResponse(deflection / (fullDeflection * radius_));
    return mapping_.directionToSetup(place) * (speed / deflection);
}

/// Additional motion of the tip, mm, beyond that of the hand.
glm::dvec3 Workspace::drifted(const glm::dvec3& place) noexcept {
    const double off = glm::length(place);
    if (off <= recentred * radius_) recentring_ = false;
    if (!recentring_) return glm::dvec3(0.0);
    return mapping_.directionToSetup(place) * (mapping_.scale * drift * glm::length(place - place_) / off);
}

/// Changes scale and rotation towards the requested values.
bool Workspace::change(bool quiet, double period) noexcept {
    const WorkspaceMapping before = mapping_;
    if (settings_.scale) {
        const double factor = quiet ? largestScale / smallestScale : std::exp(scaleRate * period);
        mapping_.scale = std::clamp(*settings_.scale, before.scale / factor, before.scale * factor);
    }
    if (quiet && settings_.rotation && std::abs(glm::dot(*settings_.rotation, before.rotation)) < 1.0 - sameTurn)
        mapping_.rotation = *settings_.rotation;
    return mapping_.scale != before.scale || mapping_.rotation != before.rotation;
}

Workspace::Place Workspace::map(const Pose& device, std::uint32_t buttons, const glm::dvec3* tool, bool quiet,
                                double period) noexcept {
    const glm::dvec3 place = device.position;
    Place answer;
    clutched_ = settings_.clutched || (buttons & settings_.clutchButton) != 0;
    answer.follows = !clutched_ && settings_.control == WorkspaceControl::position;
    glm::dvec3 tip = answer.follows || !begun_ ? mapping_.toSetup(place) : tip_;
    bool moves = !answer.follows; // whether the mapping changes, so that the tip keeps its position
    if (!begun_) {
        moves = false; // the first position is that of the mapping
    } else if (clutched_) {
        if (tool != nullptr) tip += clampLength(*tool - tip, clutchSpeed * mapping_.scale * period);
    } else if (!answer.follows) {
        answer.drive = rate(place);
        tip += answer.drive * period;
        const Box& region = settings_.region;
        if (!region.empty()) tip = glm::clamp(tip, region.low, region.high);
    } else if (recentring_ && quiet && known_) {
        tip += drifted(place);
        moves = true;
    }
    moves = change(quiet, period) || moves;
    if (moves) mapping_.origin = tip - mapping_.rotation * place * mapping_.scale;

    const glm::dvec3 handAxis = device.rotation * glm::dvec3(0.0, 0.0, 1.0);
    const double own = known_ ? angleBetween(handAxis_, handAxis) : 0.0;
    const bool stays = clutched_ && begun_;
    answer.wanted.axis = stays ? axis_.axis() : axis_.turn(mapping_.directionToSetup(handAxis), own, period);
    answer.wanted.tip = tip_ = tip;
    answer.mapping = mapping_;
    place_ = place;
    handAxis_ = handAxis;
    known_ = begun_ = true;
    return answer;
}

} // namespace burin

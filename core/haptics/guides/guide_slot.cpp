// SPDX-FileCopyrightText: 2026 The Burin authors
// SPDX-License-Identifier: Apache-2.0
#include "core/haptics/guides/guide_slot.h"

#include <algorithm>
#include <cmath>

namespace burin {
namespace {

constexpr double smallestJump = 0.05; // mm

double distanceFrom(const GuideRows& rows, const glm::dvec3& place) noexcept {
    double square = 0.0;
    for (const GuideRows::Row& row : rows) {
        const double off = glm::dot(row.normal, place) - row.offset;
        square += off * off;
    }
    return std::sqrt(square);
}

} // namespace

double GuideSlot::release(double reach) const noexcept {
    const double spacing = shape_.spacing();
    const double alone = GuideReach::release * reach;
    return spacing > 0.0 ? std::min(alone, GuideReach::levelChange * spacing) : alone;
}

double GuideSlot::capturing(double reach) const noexcept {
    const double spacing = shape_.spacing();
    const double alone = GuideReach::capture * reach;
    return spacing > 0.0 ? std::min(alone, GuideReach::levelCapture * spacing) : alone;
}

void GuideSlot::update(const GuideSurroundings& around, const glm::dvec3& hand, double moved, double reach,
                       double period) noexcept {
    const double change = period / GuideReach::rampSeconds;
    offers_ = false;
    if (state_ == State::leaving) {
        distance_ = distanceFrom(rows_, hand);
        hold_ = std::max(0.0, hold_ - change);
        pull_ = std::max(0.0, pull_ - change);
        if (hold_ == 0.0 && pull_ == 0.0) state_ = State::idle;
    }
    if (state_ == State::held) updateHeld(around, hand, moved, reach);
    if (state_ == State::held) {
        hold_ = std::min(1.0, hold_ + change);
        pull_ = std::min(1.0, pull_ + change);
    }
    if (state_ == State::idle) updateIdle(around, hand, reach);
}

void GuideSlot::updateIdle(const GuideSurroundings& around, const glm::dvec3& hand, double reach) noexcept {
    if (!(wanted_ == shape_.guide())) {
        shape_.set(wanted_);
        stepping_ = false;
    }
    if (!wanted_.on) return;
    const GuideFoot foot = shape_.foot(around, hand, stepping_, 0.0);
    distance_ = foot.distance;
    offers_ = foot.known && (stepping_ || distance_ <= capturing(reach));
    if (offers_) rows_ = shape_.atFoot(around, hand);
}

void GuideSlot::updateHeld(const GuideSurroundings& around, const glm::dvec3& hand, double moved,
                           double reach) noexcept {
    if (!(wanted_ == shape_.guide())) return leave(true);
    const GuideFoot foot = shape_.foot(around, hand, true, moved);
    // A distance changes no more than the hand moves; a larger change means another branch.
    const bool jumped = std::abs(foot.distance - distance_) > 2.0 * moved + smallestJump;
    if (!foot.known || jumped) return leave(true);
    distance_ = foot.distance;
    if (stepping_ && distance_ <= GuideReach::strongest * release(reach)) stepping_ = unfaded_ = false;
    if (!stepping_ && distance_ > release(reach)) return leave(false);
    if (stepping_ && distance_ > farthest_ + release(reach)) return leave(true);
    const GuideRows rows = shape_.atFoot(around, hand);
    if (rows.count == 0) return leave(true);
    rows_ = rows;
}

void GuideSlot::capture() noexcept {
    state_ = State::held;
    hold_ = pull_ = 0.0;
    offers_ = false;
    farthest_ = distance_;
    unfaded_ = stepping_;
}

void GuideSlot::leave(bool pulls) noexcept {
    state_ = State::leaving;
    if (!pulls) pull_ = 0.0;
    stepping_ = false;
}

void GuideSlot::step(int levels) noexcept {
    const bool asked = state_ == State::held || stepping_;
    if (shape_.guide().kind != GuideKind::levels || !asked) return;
    if (state_ == State::held) leave(true);
    shape_.setLevel(shape_.level() + levels);
    stepping_ = true;
}

void GuideSlot::forget() noexcept {
    state_ = State::idle;
    hold_ = pull_ = 0.0;
    offers_ = stepping_ = unfaded_ = false;
    shape_.set(wanted_);
}

double GuideSlot::fading(double reach, double strongest) const noexcept {
    const double end = release(reach), fades = GuideReach::strongest * end;
    const double most = std::min(strongest, fades);
    const double spring = distance_ > most ? most / distance_ : 1.0;
    if (unfaded_ || distance_ <= fades) return spring;
    return spring * std::max(0.0, (end - distance_) / (end - fades));
}

} // namespace burin

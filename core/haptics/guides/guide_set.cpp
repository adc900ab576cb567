// SPDX-FileCopyrightText: 2026 The Burin authors
// SPDX-License-Identifier: Apache-2.0
#include "core/haptics/guides/guide_set.h"

#include "core/base/units.h"
#include "core/haptics/force/coupling.h"

#include <algorithm>
#include <cmath>

namespace burin {
namespace {

constexpr double mostForceShare = 0.5; // of the maximum force: the rest is for contact and cutting
constexpr int mostRounds = 6;
constexpr double smallestRound = 1e-7; // mm
constexpr double farthestGoal = 2.0;   // distance from the hand, in release distances
// mm/s of the device: speed of the goal relative to the hand, in addition to the hand's own motion
constexpr double correctionSpeed = 200.0;

double strongestPull(const HapticSettings& settings, double stiffness) noexcept {
    const double byDistance = GuideReach::strongest * GuideReach::release;
    if (!(stiffness > 0.0)) return byDistance;
    return std::min(byDistance, mostForceShare * settings.maximumForce() / stiffness * millimetresPerMetre);
}

} // namespace

GuideSet::GuideSet(const ClearanceField& field, const HapticSettings& settings)
    : field_(&field), stiffness_(guideGains(settings).stiffness), strongestPull_(strongestPull(settings, stiffness_)) {}

void GuideSet::set(const GuideSettings& settings) noexcept {
    settings_ = settings;
    for (std::size_t i = 0; i < slots_.size(); ++i) slots_[i].want(settings.guides[i]);
}

void GuideSet::step(int levels) noexcept {
    for (GuideSlot& slot : slots_) slot.step(levels);
    passUnderWay_ = false;
    lastPass_.finish();
}

void GuideSet::forget() noexcept {
    for (GuideSlot& slot : slots_) slot.forget();
    activeCount_ = 0;
    overruled_ = 0;
    axis_.forget();
    known_ = false;
}

GuideNews GuideSet::news(std::size_t guide) const noexcept {
    const GuideSlot& slot = slots_[guide];
    GuideNews news;
    if (!settings_.guides[guide].on) return news;
    news.is = GuideNews::Is::away;
    news.level = slot.shape().level();
    news.distance = slot.distance();
    const bool axis = settings_.guides[guide].kind == GuideKind::axis;
    if (axis ? axisGuide() == &settings_.guides[guide] : slot.state() == GuideSlot::State::held)
        news.is = GuideNews::Is::holding;
    else if (axis || (overruled_ >> guide & 1U) != 0)
        news.is = GuideNews::Is::overruled;
    return news;
}

const Guide* GuideSet::axisGuide() const noexcept {
    const auto axis = std::find_if(settings_.guides.begin(), settings_.guides.end(),
                                   [](const Guide& guide) { return guide.on && guide.kind == GuideKind::axis; });
    return axis == settings_.guides.end() ? nullptr : &*axis;
}

/// A pass is recorded even if no guide uses it: the guide may be switched on after the pass.
void GuideSet::followPass(const ToolPose& tool, bool cutting) noexcept {
    const auto stepOver = std::find_if(settings_.guides.begin(), settings_.guides.end(),
                                       [](const Guide& guide) { return guide.kind == GuideKind::stepOver; });
    const glm::dvec3 direction = stepOver == settings_.guides.end() ? glm::dvec3(0.0, 0.0, 1.0) : stepOver->direction;
    if (direction != passDirection_) lastPass_.forget();
    passDirection_ = direction;
    if (cutting)
        lastPass_.add(tool.tip - direction * glm::dot(direction, tool.tip));
    else if (passUnderWay_)
        lastPass_.finish();
    passUnderWay_ = cutting;
}

GuidedHand GuideSet::guide(const Hand& hand, const ToolPose& tool, bool cutting, double period) noexcept {
    const glm::dvec3 place = hand.wanted.tip;
    const double reach = hand.mapping.scale, moved = known_ ? glm::length(place - hand_) : 0.0;
    followPass(tool, cutting);
    if (!known_) correction_ = glm::dvec3(0.0);
    const std::uint32_t pressed = known_ ? hand.buttons & ~buttons_ : 0;
    buttons_ = hand.buttons;
    hand_ = place;
    known_ = true;
    if ((pressed & settings_.stepButton) != 0) step(-1);

    const GuideSurroundings around{*field_, lastPass_};
    for (GuideSlot& slot : slots_) slot.update(around, place, moved, reach, period);
    order();
    solve(around, place, reach);

    GuidedHand guided;
    glm::dvec3 correction(0.0);
    for (const GuideSolver::Direction& held : solver_)
        correction += slots_[held.guide].hold() * held.normal * (held.offset - glm::dot(held.normal, place));
    const double most = moved / GuideSolver::smallestSine + correctionSpeed * reach * period;
    correction_ += clampLength(correction - correction_, most);
    guided.goal.tip = place + correction_;
    guided.goal.axis = axis_.lean(axisGuide(), *field_, hand.wanted, guided.goal.tip, period);
    feel(hand, guided);
    for (std::size_t i = 0; i < slots_.size(); ++i)
        if (news(i).is == GuideNews::Is::holding) guided.held |= 1U << i;
    return guided;
}

/// Sorts leaving guides last, so that they do not affect what the others hold.
void GuideSet::order() noexcept {
    std::array<std::size_t, GuideSettings::capacity> leaving{};
    std::size_t held = 0, left = 0;
    for (std::size_t i = 0; i < activeCount_; ++i) {
        const GuideSlot::State state = slots_[active_[i]].state();
        if (state == GuideSlot::State::held) active_[held++] = active_[i];
        if (state == GuideSlot::State::leaving) leaving[left++] = active_[i];
    }
    for (std::size_t i = 0; i < left; ++i) active_[held + i] = leaving[i];
    activeCount_ = held + left;
}

/// Of the guides that contradict a guide, itself included, the last in the settings gives way.
void GuideSet::giveWay(std::size_t guide, const GuideRows& rows) noexcept {
    std::size_t last = guide;
    for (std::size_t i = 0; i < activeCount_; ++i) {
        const std::size_t other = active_[i];
        if (other > last && slots_[other].state() == GuideSlot::State::held && solver_.concerns(other, rows))
            last = other;
    }
    overruled_ |= 1U << last;
    if (slots_[last].state() == GuideSlot::State::held) slots_[last].leave(true);
}

/// Collects the planes of the active guides in the solver, at their feet or near a point. Returns false if a guide
/// can't be evaluated there.
bool GuideSet::gather(const GuideSurroundings& around, const glm::dvec3* place) noexcept {
    solver_.clear();
    for (std::size_t i = 0; i < activeCount_; ++i) {
        const GuideSlot& slot = slots_[active_[i]];
        const bool anew = place != nullptr && slot.state() == GuideSlot::State::held && slot.shape().curved();
        const GuideRows rows = anew ? slot.shape().near(around, *place) : slot.rows();
        if (rows.count == 0) return false;
        if (solver_.add(active_[i], rows)) continue;
        if (anew) return false;
        if (slot.state() == GuideSlot::State::held) giveWay(active_[i], rows);
    }
    return true;
}

void GuideSet::capture() noexcept {
    for (std::size_t i = 0; i < slots_.size(); ++i) {
        if (!slots_[i].offers()) continue;
        const GuideRows rows = slots_[i].rows();
        if (solver_.independence(rows) < GuideSolver::capturingSine || !solver_.add(i, rows)) {
            giveWay(i, rows);
            slots_[i].refuse();
            continue;
        }
        slots_[i].capture();
        active_[activeCount_++] = i;
    }
}

/// A single guide holds at its foot. Several guides hold at the common point nearest to the hand, found by repeated
/// projection onto the planes near the result of the previous round.
void GuideSet::solve(const GuideSurroundings& around, const glm::dvec3& hand, double reach) noexcept {
    overruled_ = 0;
    gather(around, nullptr);
    capture();
    if (activeCount_ < 2) return;
    const GuideSolver first = solver_;
    glm::dvec3 point = solver_.nearest(hand);
    for (int round = 0; round < mostRounds; ++round) {
        const glm::dvec3 before = point;
        if (!gather(around, &before)) {
            solver_ = first;
            break;
        }
        point = solver_.nearest(hand);
        if (glm::length(point - before) < smallestRound) break;
    }
    // Guides that meet far away are treated as if they did not meet.
    if (glm::length(point - hand) <= farthestGoal * GuideReach::release * reach) return;
    const auto held = [this](std::size_t i) {
        return slots_[i].state() == GuideSlot::State::held && !slots_[i].stepping();
    };
    for (std::size_t i = slots_.size(); i-- > 0;)
        if (held(i)) return slots_[i].leave(true);
}

/// Each guide pulls individually, so that changes of other guides cause no jump in it, and together they pull towards
/// the common point. Guides that are not perpendicular share the force of the device: the sum of their shares along any
/// direction (Gershgorin's bound on the stiffness matrix) is at most 1.
void GuideSet::feel(const Hand& hand, GuidedHand& guided) const noexcept {
    const double reach = hand.mapping.scale, strongest = strongestPull_ * reach;
    double crowd = 1.0;
    for (std::size_t i = 0; i < activeCount_; ++i) {
        const GuideSlot& slot = slots_[active_[i]];
        for (const GuideRows::Row& row : slot.rows()) {
            const double off = row.offset - glm::dot(row.normal, hand.wanted.tip);
            guided.pull += slot.pull() * slot.fading(reach, strongest) * off * row.normal;
            guided.across += slot.pull() * glm::dot(row.normal, hand.velocity) * row.normal;
            crowd = std::max(crowd, std::sqrt(slot.hold()) * sumOfShares(row.normal));
        }
    }
    guided.pull = clampLength(guided.pull / crowd, strongest);
    guided.across /= crowd;
}

double GuideSet::sumOfShares(const glm::dvec3& direction) const noexcept {
    double sum = 0.0;
    for (std::size_t i = 0; i < activeCount_; ++i)
        for (const GuideRows::Row& row : slots_[active_[i]].rows())
            sum += std::sqrt(slots_[active_[i]].hold()) * std::abs(glm::dot(row.normal, direction));
    return sum;
}

} // namespace burin

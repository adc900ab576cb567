// SPDX-FileCopyrightText: 2026 The Burin authors
// SPDX-License-Identifier: Apache-2.0
#pragma once

#include "core/haptics/guides/guide_set.h"
#include "tests/core/haptics/analytic_fields.h"
#include "tests/core/haptics/haptic_rig.h"

namespace burin::test {

inline constexpr int settled = 150; ///< ticks: longer than the fading of a guide

/// A set of guides next to a solid, fed with positions of the hand; the tool is always at the position that the guides
/// request.
template <class Solid = PlaneSolid>
struct GuideRig {
    explicit GuideRig(Solid solid = {}, double scale = 1.0) : field(solid, 3.0), guides(field, Rig::settings()) {
        mapping.scale = scale;
    }
    GuidedHand feed(const glm::dvec3& place, const glm::dvec3& axis = {0, 0, 1}) {
        Hand now;
        now.reading = Reading::good;
        now.mapping = mapping;
        now.wanted = {place, axis};
        now.velocity = (place - hand) / period;
        now.buttons = buttons;
        hand = place;
        last = guides.guide(now, tool, cutting, period);
        tool = last.goal;
        onTick(last);
        return last;
    }
    GuidedHand rest(int ticks) {
        for (int i = 0; i < ticks; ++i) feed(hand);
        return last;
    }
    GuidedHand moveTo(const glm::dvec3& target, double speed = 50.0) {
        const glm::dvec3 from = hand;
        const int ticks = std::max(1, static_cast<int>(std::ceil(glm::length(target - from) / (speed * period))));
        for (int i = 1; i <= ticks; ++i) feed(glm::mix(from, target, static_cast<double>(i) / ticks));
        return last;
    }
    void use(std::initializer_list<Guide> wanted) {
        GuideSettings settings;
        std::copy(wanted.begin(), wanted.end(), settings.guides.begin());
        guides.set(settings);
    }

    std::function<void(const GuidedHand&)> onTick = [](const GuidedHand&) {};
    BallField<Solid> field;
    GuideSet guides;
    WorkspaceMapping mapping;
    glm::dvec3 hand{0.0};
    ToolPose tool;
    GuidedHand last;
    std::uint32_t buttons = 0;
    bool cutting = false;
};

inline Guide planeGuide(const glm::dvec3& point, const glm::dvec3& normal) {
    Guide guide;
    guide.on = true;
    guide.point = point;
    guide.direction = glm::normalize(normal);
    return guide;
}
inline Guide guideOf(GuideKind kind, double distance = 1.0) {
    Guide guide;
    guide.kind = kind;
    guide.on = true;
    guide.distance = distance;
    return guide;
}

/// mm: pull of the force law on a hand at `distance` from a single guide.
inline double pullAt(double distance, double strongest) {
    const double fading = 0.6 * 3.0;
    const double most = std::min(strongest, fading);
    if (distance >= 3.0) return 0.0;
    return std::min(distance, most) * (distance > fading ? (3.0 - distance) / (3.0 - fading) : 1.0);
}

} // namespace burin::test

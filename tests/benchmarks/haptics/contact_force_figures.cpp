// SPDX-FileCopyrightText: 2026 The Burin authors
// SPDX-License-Identifier: Apache-2.0
#include "tests/benchmarks/haptics/haptic_groups.h"
#include "tests/benchmarks/haptics/held_floor.h"

#include <random>

namespace burin::benchmarks {

namespace {

using test::period;

/// The relative error of the contact force for a push against the floor, N: the larger one of the errors of the
/// device's force and of stiffness times interval. The handle is at rest when the force on it equals the push, so the
/// push is the oracle.
double pressError(double push, double stiffness, double scale) {
    constexpr int settling = 4000, looking = 1000; // ticks
    HeldFloor floor({stiffness, 4.0, 100.0, scale}, {0.15, 5.0, 0.0}, {0.08, 0.5, 0.02, 0}, 1.0);
    double force = 0.0, interval = 0.0;
    for (int tick = 0; tick < settling + looking; ++tick) {
        const Sample sample = floor.tick(0.0, push);
        if (tick < settling) continue;
        force += floor.force() / looking;
        interval += (sample.proxy.tip.z - sample.stylusTip.z) / looking;
    }
    const double spring = stiffness * interval / (scale * millimetresPerMetre);
    return std::max(std::abs(force - push), std::abs(spring - push)) / push;
}

void pressFigures(Session& session) {
    if (!session.wants("press.")) return;
    session.stage("press.force_error");
    double worst = 0.0;
    for (const double push : {0.5, 1.0, 3.0})
        for (const double stiffness : {400.0, 1500.0})
            for (const double scale : {1.0, 2.5}) worst = std::max(worst, pressError(push, stiffness, scale));
    session.add(figure("press.force_error", worst, "1", 0.01));
}

/// The largest force, N, while a hand moves fast above the floor, down to half a millimetre from it, with the spindle
/// on.
double largestFreeForce() {
    constexpr int ticks = 60'000;
    test::Rig rig(test::Rig::settings(), test::ballTool(), test::stockOnPart(0, false));
    std::mt19937 random(5);
    const auto draw = [&] { return 2.0 * static_cast<double>(random()) / 4294967295.0 - 1.0; };
    glm::dvec3 hand(0.0), velocity(0.0); // mm, mm/tick
    rig.begin(hand);
    double largest = 0.0;
    const glm::dvec3 low(-15.0, -15.0, test::floorHeight + 0.5), high(15.0, 15.0, 8.0);
    for (int tick = 0; tick < ticks; ++tick) {
        velocity = 0.98 * velocity + 0.02 * glm::dvec3(draw(), draw(), draw());
        hand = glm::clamp(hand + velocity, low, high);
        largest = std::max(largest, glm::length(rig.feed(hand).force));
    }
    return largest;
}

} // namespace

void contactForceFigures(Session& session) {
    pressFigures(session);
    if (!session.wants("free.")) return;
    session.stage("free.force_n");
    session.add(figure("free.force_n", largestFreeForce(), "N", 0.01));
}

} // namespace burin::benchmarks

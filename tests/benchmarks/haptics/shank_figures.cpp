// SPDX-FileCopyrightText: 2026 The Burin authors
// SPDX-License-Identifier: Apache-2.0
#include "tests/benchmarks/haptics/haptic_groups.h"
#include "tests/core/haptics/haptic_rig.h"

#include <algorithm>

namespace burin::benchmarks {

namespace {

constexpr double fluteLength = 5.0, share = 0.95;

struct Braking {
    int ticks = 0;        ///< largest delay of the flag or of the braking force
    double removed = 0.0; ///< mm³, in ticks with braking
};

/// A hand drives a shank that is wider than its flutes straight down into the stock. The shank's face and the top of
/// the stock at 0 are flat: they meet at a tip of -fluteLength, and their overlap from there on is the depth of the
/// hand.
Braking brakeOf(double speed, double stiffness) {
    HapticSettings settings = test::Rig::settings();
    settings.stylus.maximumStiffness.value = stiffness;
    test::Rig rig(settings, test::ballTool(fluteLength, 12.0));
    const double spring = settings.couplingShare * stiffness, most = settings.maximumForce(); // N/m, N
    constexpr double unseen = 0.25 * test::voxel; // mm of overlap that is not checked
    rig.begin({0.0, 0.0, 3.0});
    std::vector<double> wanted, felt; // N, in each tick since contact
    Braking braking;
    int contact = -1, flagged = -1, tick = 0;
    rig.onTick = [&](const Sample& sample) {
        const double overlap = -fluteLength - sample.stylusTip.z;
        if (overlap > unseen && contact < 0) contact = tick;
        const bool brakes = (sample.flags & sampleShankContact) != 0;
        if (brakes && flagged < 0) flagged = tick;
        if (brakes)
            for (const RemovedMaterial& material : sample.removed)
                braking.removed += static_cast<double>(material.units) * rig.volume.grid().unitVolume();
        if (contact >= 0) {
            wanted.push_back(std::min(spring * overlap / millimetresPerMetre, most));
            felt.push_back(sample.force.z);
        }
        ++tick;
    };
    rig.moveTo({0.0, 0.0, -fluteLength - 12.0}, speed);
    rig.rest(20);
    const int never = tick;
    braking.ticks = flagged < 0 ? never : std::max(0, flagged - contact);
    for (std::size_t i = 0; i + 20 < wanted.size(); ++i) {
        const auto reached = std::find_if(felt.begin() + static_cast<std::ptrdiff_t>(i), felt.end(),
                                          [&](double force) { return force >= share * wanted[i]; });
        const auto late =
            reached == felt.end() ? never : static_cast<int>(reached - felt.begin()) - static_cast<int>(i);
        braking.ticks = std::max(braking.ticks, late);
    }
    return braking;
}

} // namespace

void shankFigures(Session& session) {
    if (!session.wants("shank.")) return;
    session.stage("shank.ticks");
    Braking worst;
    for (const double speed : {20.0, 100.0, 400.0})
        for (const double stiffness : {400.0, 1000.0}) {
            const Braking one = brakeOf(speed, stiffness);
            worst = {std::max(worst.ticks, one.ticks), std::max(worst.removed, one.removed)};
        }
    session.add(figure("shank.ticks", worst.ticks, "ticks", 2.0));
    session.add(figure("shank.removed_mm3", worst.removed, "mm3", 0.0));
}

} // namespace burin::benchmarks

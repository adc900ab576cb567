// SPDX-FileCopyrightText: 2026 The Burin authors
// SPDX-License-Identifier: Apache-2.0
#include "tests/benchmarks/haptics/haptic_groups.h"
#include "tests/core/haptics/hostile_rig.h"

#include <algorithm>

namespace burin::benchmarks {

namespace {

/// The limits of a force, recomputed here from the stylus' own values instead of being read from the loop.
struct Bounds {
    double largest, rise, fall; ///< N, N per tick, N per tick
};

Bounds boundsOf(const HapticSettings& settings) {
    const double largest = settings.forceShare * settings.stylus.maximumForce.value;
    const double stiffness = settings.couplingShare * settings.stylus.maximumStiffness.value; // N/m
    // Fading in multiplies by a weight whose slope is at most 1.5 over its time.
    const double fading = 1.5 * settings.tickPeriod / settings.rampSeconds * largest;
    const double rise = std::max(0.15, stiffness * 0.5 * settings.tickPeriod) + fading;
    return {largest, rise, 3.0 * rise};
}

struct Verdict {
    std::size_t violations = 0;
    int slowest = 0; ///< ticks from a bad one until the force is zero
    std::size_t bad = 0, pressed = 0;
};

bool broken(const Sample& sample, const glm::dvec3& force, const glm::dvec3& before, const Bounds& bounds) {
    constexpr double rounding = 1e-12;
    if (!isFinite(force) || !isFinite(sample.proxy.tip) || !isFinite(sample.cuttingForce)) return true;
    const double size = glm::length(force);
    if (size > bounds.largest + rounding) return true;
    if (size == 0.0) return false; // releasing the force is always safe
    return glm::length(force - before) > bounds.fall + rounding || size - glm::length(before) > bounds.rise + rounding;
}

Verdict judge(std::size_t ticks, unsigned seed) {
    HapticSettings settings = test::Rig::settings();
    settings.rampSeconds = 0.05;
    settings.felt.gain = 100.0;
    test::Rig rig(settings, test::ballTool(5.0, 12.0));
    const std::uint64_t part = rig.volume.amounts().units[2];
    const Bounds bounds = boundsOf(settings);
    HostileStylus hostile(test::strayingInTheStock(seed));
    SeededRandom random(seed);
    Verdict verdict;
    glm::dvec3 before(0.0);
    int sinceBad = -1; // -1: the force has been zero since
    for (std::size_t i = 0; i < ticks; ++i) {
        const HostileStylus::Tick tick = hostile.next();
        if (random.below(1000) == 0) rig.step.setAllowance(random.between(-1.0, 1.0));
        const Sample sample = rig.step.advance(tick.state, tick.period);
        const glm::dvec3 force = rig.step.deviceWrench().force;
        hostile.write(rig.step.deviceWrench());
        if (broken(sample, force, before, bounds)) ++verdict.violations;
        if (HostileStylus::mustBeStill(tick.event)) {
            ++verdict.bad;
            sinceBad = 0;
        }
        if (sinceBad >= 0 && force == glm::dvec3(0.0)) {
            verdict.slowest = std::max(verdict.slowest, sinceBad);
            sinceBad = -1;
        } else if (sinceBad >= 0) {
            verdict.slowest = std::max(verdict.slowest, ++sinceBad);
        }
        verdict.pressed += glm::length(force) > 0.0 ? 1U : 0U;
        before = force;
    }
    if (rig.volume.amounts().units[2] != part) ++verdict.violations; // the part was cut
    return verdict;
}

} // namespace

void guardFigures(Session& session) {
    if (!session.wants("guards.")) return;
    constexpr std::size_t runs = 10, ticksEach = 100'000; // a milled stock is soon all air
    Verdict all;
    for (unsigned run = 0; run < runs; ++run) {
        session.stage("guards.violations");
        const Verdict one = judge(ticksEach, run + 1);
        all.violations += one.violations;
        all.slowest = std::max(all.slowest, one.slowest);
        all.bad += one.bad;
        all.pressed += one.pressed;
    }
    session.check(all.bad > 5000 && all.pressed > 50'000, "hostile ticks were bad, and pressed, often enough");
    session.add(figure("guards.violations", static_cast<double>(all.violations), "ticks", 0.0));
    session.add(figure("guards.ticks_to_zero", all.slowest, "ticks", 2.0));
    session.add(figure("guards.hostile_ticks", static_cast<double>(runs * ticksEach), "ticks"));
}

} // namespace burin::benchmarks

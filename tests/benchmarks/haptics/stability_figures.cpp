// SPDX-FileCopyrightText: 2026 The Burin authors
// SPDX-License-Identifier: Apache-2.0
#include "tests/benchmarks/haptics/haptic_groups.h"
#include "tests/benchmarks/haptics/held_floor.h"

#include <array>

namespace burin::benchmarks {

namespace {

using test::period;

/// Calls `visit` with each combination for which stability is assessed.
template <class Visit>
void forEachHand(const Visit& visit) {
    for (const test::SimulatedGrip& grip : {test::lightGrip, test::middleGrip, test::firmGrip})
        for (const double stiffness : {400.0, 800.0, 1500.0})
            for (const double encoder : {0.02, 0.055})
                for (const std::size_t delay : {std::size_t{0}, std::size_t{1}}) {
                    Session::throwIfCancelled();
                    visit(grip, stiffness, test::SimulatedMechanism{0.08, 0.5, encoder, delay});
                }
}

/// The energy that one contact gives to the hand, mJ, the worst of ten: once a second the hand moves 5 mm into the
/// floor and 5 mm above it. In the air no energy is stored, so any surplus comes from the loop.
double energyOfContact(const test::SimulatedGrip& grip, double stiffness, const test::SimulatedMechanism& mechanism) {
    constexpr int cycle = 1000, cycles = 10; // ticks
    constexpr double reach = 5.0;            // mm
    HeldFloor floor({stiffness}, grip, mechanism, reach);
    double worst = -1.0, before = 0.0;
    for (int i = 0; i < cycle * cycles; ++i) {
        floor.tick(reach * std::cos(2.0 * pi * i / cycle));
        if ((i + 1) % cycle != 0) continue;
        worst = std::max(worst, floor.handle().energy() - before);
        before = floor.handle().energy();
    }
    return 1e3 * worst;
}

void energyFigures(Session& session) {
    if (!session.wants("energy.")) return;
    session.stage("energy.cycle_mj");
    double worst = -1.0;
    forEachHand([&](const test::SimulatedGrip& grip, double stiffness, const test::SimulatedMechanism& mechanism) {
        worst = std::max(worst, energyOfContact(grip, stiffness, mechanism));
    });
    session.add(figure("energy.cycle_mj", worst, "mJ", 0.02));
}

/// The speed of a handle that nobody holds and that is pressed down with 1 N: root mean square over the last of five
/// seconds, mm/s.
double restlessness(double stiffness, double encoder) {
    constexpr int ticks = 5000, judged = 1000;
    HeldFloor floor({stiffness}, test::noGrip, {0.08, 0.5, encoder, 0}, 1.0);
    double squares = 0.0;
    for (int i = 0; i < ticks; ++i) {
        floor.tick(0.0, 1.0);
        if (i >= ticks - judged) squares += glm::dot(floor.handle().velocity(), floor.handle().velocity());
    }
    return std::sqrt(squares / judged);
}

void nobodyFigures(Session& session) {
    if (!session.wants("nohand.")) return;
    session.stage("nohand.rms_mm_s");
    // With a higher stiffness, twice the damping over the period, a sampled spring feeds energy into the bare handle.
    constexpr double limit = 2.0 * test::SimulatedMechanism{}.damping / period; // N/m
    double worst = 0.0;
    for (const double times : {1.0, 2.0, 3.0, 4.0, 5.0, 6.0})
        for (const double encoder : {0.0, 0.02, 0.055}) worst = std::max(worst, restlessness(times * limit, encoder));
    session.add(figure("nohand.rms_mm_s", worst, "mm/s", 10.0));
}

struct Noise {
    double rms = 0.0, largest = 0.0; ///< N, from tick to tick
};

/// The noise of the force for a hand that rests 3 mm within the floor.
Noise noiseOfContact(const test::SimulatedGrip& grip, double stiffness, const test::SimulatedMechanism& mechanism) {
    constexpr int ticks = 3000, judged = 1000;
    HeldFloor floor({stiffness}, grip, mechanism, 1.0);
    Noise noise;
    double before = 0.0;
    for (int i = 0; i < ticks; ++i) {
        floor.tick(-3.0);
        const double change = floor.force() - before;
        before = floor.force();
        if (i < ticks - judged) continue;
        noise.rms += change * change / judged;
        noise.largest = std::max(noise.largest, std::abs(change));
    }
    noise.rms = std::sqrt(noise.rms);
    return noise;
}

void noiseFigures(Session& session) {
    if (!session.wants("noise.")) return;
    session.stage("noise.n_per_tick");
    Noise worst;
    forEachHand([&](const test::SimulatedGrip& grip, double stiffness, const test::SimulatedMechanism& mechanism) {
        const Noise noise = noiseOfContact(grip, stiffness, mechanism);
        worst = {std::max(worst.rms, noise.rms), std::max(worst.largest, noise.largest)};
    });
    session.add(figure("noise.n_per_tick", worst.rms, "N", 0.02));
    session.add(figure("noise.largest_n_per_tick", worst.largest, "N"));
}

} // namespace

void stabilityFigures(Session& session) {
    energyFigures(session);
    nobodyFigures(session);
    noiseFigures(session);
}

} // namespace burin::benchmarks

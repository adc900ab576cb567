// SPDX-FileCopyrightText: 2026 The Burin authors
// SPDX-License-Identifier: Apache-2.0
#include "tests/benchmarks/haptics/haptic_groups.h"
#include "tests/oracles/slot_scene.h"

namespace burin::benchmarks {

namespace {

/// Combinations of cutters, directions relative to the scanlines, speeds, encoders and hands, with one material and
/// with two.
std::vector<test::SlotCase> slotCases() {
    std::vector<test::SlotCase> cases;
    for (const CutterType cutter : {CutterType::flat, CutterType::ball, CutterType::bullNose})
        for (const double heading : {0.0, 0.6})
            for (const double firstEnergy : {1.0, 0.4, 2.0}) {
                test::SlotCase slot;
                slot.cutter = cutter;
                slot.heading = heading;
                slot.firstEnergy = firstEnergy;
                slot.mechanism.encoder = heading == 0.0 ? 0.055 : 0.02;
                slot.grip = firstEnergy == 1.0 ? test::middleGrip : test::firmGrip;
                cases.push_back(slot);
            }
    return cases;
}

} // namespace

void slotFigures(Session& session) {
    if (!session.wants("slot.")) return;
    test::SlotFigures worst;
    for (const test::SlotCase& slot : slotCases()) {
        session.stage("slot.force_error");
        const test::SlotFigures one = test::SlotScene(slot).mill();
        worst.forceError = std::max(worst.forceError, one.forceError);
        worst.noise = std::max(worst.noise, one.noise);
        worst.creep = std::max(worst.creep, one.creep);
        if (slot.firstEnergy == slot.secondEnergy) continue;
        session.check(one.ticksToChange >= 0, "a change of material in the slot is felt");
        worst.ticksToChange = std::max(worst.ticksToChange, one.ticksToChange);
    }
    session.add(figure("slot.force_error", worst.forceError, "1", 0.05));
    session.add(figure("slot.noise_n_per_tick", worst.noise, "N", 0.005));
    session.add(figure("slot.creep_mm_s", worst.creep, "mm/s", 1.0));
    session.add(figure("slot.ticks_to_change", worst.ticksToChange, "ticks", 2.0));
}

} // namespace burin::benchmarks

// SPDX-FileCopyrightText: 2026 The Burin authors
// SPDX-License-Identifier: Apache-2.0
#include "plugins/devices/cap/cap_mapping.h"
#include "plugins/devices/spacemouse/reports.h"
#include "tests/fuzz/reports.h"

#include <cstdlib>

/// No reading leaves the workspace, whatever the bus delivers.
extern "C" int LLVMFuzzerTestOneInput(const std::uint8_t* bytes, std::size_t count) {
    using namespace burin;
    spacemouse::ReportReader reader;
    cap::CapMapping rate(cap::ControlMode::rate), position(cap::ControlMode::position);
    fuzz::forEachReport({bytes, count}, [&](std::span<const std::uint8_t> report) {
        reader.take(report);
        for (cap::CapMapping* mapping : {&rate, &position}) {
            const Pose& pose = mapping->advance(
                motionsOf(cap::capMap(), cap::readingsOf(reader.controls().axes, cap::CapMapping::fullScale)), 0.01);
            if (!(glm::length(pose.position) <= cap::CapMapping::workspaceRadius + 1e-9)) std::abort();
        }
        if (reader.controls().batteryPercent > 100) std::abort();
    });
    return 0;
}

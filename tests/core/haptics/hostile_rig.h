// SPDX-FileCopyrightText: 2026 The Burin authors
// SPDX-License-Identifier: Apache-2.0
#pragma once

#include "core/haptics/operator/hostile_stylus.h"
#include "tests/core/haptics/haptic_rig.h"

namespace burin::test {

/// A hostile hand that wanders through the volume of `stockOnPart`, deep into the part.
inline HostileSettings strayingInTheStock(std::uint64_t seed) {
    HostileSettings settings;
    settings.stylus = desktopStylus();
    settings.region = {{-12, -12, floorHeight - 6.0}, {12, 12, 8}};
    settings.seed = seed;
    return settings;
}

} // namespace burin::test

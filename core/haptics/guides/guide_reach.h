// SPDX-FileCopyrightText: 2026 The Burin authors
// SPDX-License-Identifier: Apache-2.0
#pragma once

#include <cstdint>

namespace burin {

/// The state of a guide, for display.
struct GuideNews {
    enum class Is : std::uint8_t { off, away, holding, overruled };
    Is is = Is::off;
    std::int32_t level = 0;
    double distance = 0.0; ///< mm, of the hand from the guide, as far as it is known
};

/// The distances at which a guide captures and releases the hand, in mm of the device: what a hand feels does not
/// depend on the scale. Published snap distances are 1.5 to 3 mm (OpenHaptics' examples).
struct GuideReach {
    static constexpr double capture = 2.0;       ///< mm
    static constexpr double release = 3.0;       ///< mm
    static constexpr double strongest = 0.6;     ///< share of the release distance at which the pull is largest
    static constexpr double rampSeconds = 0.1;   ///< s, in and out
    static constexpr double levelChange = 0.6;   ///< share of the distance between levels: release distance
    static constexpr double levelCapture = 0.45; ///< share of the distance between levels: capture distance
};

} // namespace burin

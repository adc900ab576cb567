// SPDX-FileCopyrightText: 2026 The Burin authors
// SPDX-License-Identifier: Apache-2.0
#pragma once

#include "core/verify/deviation_map.h"
#include "ui/theme/theme.h"

namespace burin {

/// The colour of a band of deviations: red where it gouges, blue in tolerance, the accent for too much, grey out of
/// reach. Red and green never stand against each other.
constexpr ColourRole roleOf(DeviationBand band) noexcept {
    switch (band) {
    case DeviationBand::gouge:
        return &Palette::force;
    case DeviationBand::inTolerance:
        return &Palette::part;
    case DeviationBand::excess:
        return &Palette::accent;
    case DeviationBand::unreachable:
        break;
    }
    return &Palette::quietText;
}

} // namespace burin

// SPDX-FileCopyrightText: 2026 The Burin authors
// SPDX-License-Identifier: Apache-2.0
#include "ui/scene/round_spacing.h"

#include <cmath>

namespace burin {

double roundSpacing(double length) {
    const double tenth = length / 10.0;
    const double power = std::pow(10.0, std::floor(std::log10(tenth)));
    const double lead = tenth / power;
    return power * (lead < 1.5 ? 1.0 : lead < 3.5 ? 2.0 : lead < 7.5 ? 5.0 : 10.0);
}

} // namespace burin

// SPDX-FileCopyrightText: 2026 The Burin authors
// SPDX-License-Identifier: Apache-2.0
#pragma once

#include "core/volume/runs/run_volume.h"

#include <optional>
#include <string>
#include <vector>

namespace burin {

/// How much of one material a volume holds; grades count as what they are a grade of.
struct MaterialAmount {
    std::string id, name;
    bool isProtected = false;
    double volume = 0.0;        ///< mm³
    std::optional<double> mass; ///< g; none where the material states no density
};

/// In the order of the property list; what it holds nothing of is there with 0. Of graded densities each grade weighs
/// its own.
/// @param unitVolume mm³ of a run unit (Grid::unitVolume)
std::vector<MaterialAmount> amountsOf(const PropertyList& list, const RunAmounts& amounts, double unitVolume);

} // namespace burin

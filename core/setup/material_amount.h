// SPDX-FileCopyrightText: 2026 The Burin authors
// SPDX-License-Identifier: Apache-2.0
#pragma once

#include "core/volume/runs/run_volume.h"

#include <optional>
#include <string>
#include <vector>

namespace burin {

/// The amount of one material in a volume; grades are counted with their base material.
struct MaterialAmount {
    std::string id, name;
    bool isProtected = false;
    double volume = 0.0;        ///< mm³
    std::optional<double> mass; ///< g; empty if the material states no density
};

/// Returns the amounts in the order of the property list; materials that do not occur are listed with 0. If the density
/// is graded, each grade is weighed with its own density.
/// @param unitVolume volume of a run unit, mm³ (Grid::unitVolume)
std::vector<MaterialAmount> amountsOf(const PropertyList& list, const RunAmounts& amounts, double unitVolume);

} // namespace burin

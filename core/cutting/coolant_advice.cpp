// SPDX-FileCopyrightText: 2026 The Burin authors
// SPDX-License-Identifier: Apache-2.0
#include "core/cutting/coolant_advice.h"

#include "core/cutting/cutting_force.h"

namespace burin {

Coolant advisedCoolant(const Tool& tool, const Property& material) {
    if (const CuttingPreset* preset = presetFor(tool, material); preset != nullptr && preset->coolant)
        return *preset->coolant;
    if (material.valueOr(floodCoolant, 0.0) > 0.0) return Coolant::flood;
    if (material.valueOr(mistCoolant, 0.0) > 0.0) return Coolant::mist;
    return Coolant::off;
}

} // namespace burin

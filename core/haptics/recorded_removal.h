// SPDX-FileCopyrightText: 2026 The Burin authors
// SPDX-License-Identifier: Apache-2.0
#pragma once

#include "core/cutting/removal.h"
#include "core/recording/sample.h"

namespace burin {

/// Records the material removed by one cut, by material: grades count as the material that they are a grade of, so that
/// a sample has room for all materials of a property list. Exact: integer units of runs are added. Called in the haptic
/// tick.
inline void recordRemoval(const CutResult& cut, const PropertyList& properties, Sample& sample) noexcept {
    static_assert(std::tuple_size_v<decltype(Sample::removed)> >= maximumMachinableMaterials);
    for (const MaterialVolume& material : cut.removed) {
        if (material.property == airProperty) break;
        const PropertyIndex base = properties.baseOf(material.property);
        for (RemovedMaterial& entry : sample.removed) {
            if (entry.property != base && entry.property != airProperty) continue;
            entry.property = base;
            entry.units += material.units;
            break;
        }
    }
}

} // namespace burin

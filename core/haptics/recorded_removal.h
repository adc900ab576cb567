// SPDX-FileCopyrightText: 2026 The Burin authors
// SPDX-License-Identifier: Apache-2.0
#pragma once

#include "core/cutting/removal.h"
#include "core/recording/sample.h"

namespace burin {

/// Records what one cut removed, by material: grades count as the material that they are a grade of, so that a sample
/// has room for all that a property list may hold. Exact: run units are added. Tick code.
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

// SPDX-FileCopyrightText: 2026 The Burin authors
// SPDX-License-Identifier: Apache-2.0
#pragma once

#include "core/setup/guide.h"

#include <memory>
#include <vector>

namespace burin {

/// Guides as a project keeps them, with the curves that they lead along.
struct KeptGuides {
    std::vector<Guide> guides;    ///< at most GuideSettings::capacity; each curve is one of `curves`
    std::uint32_t stepButton = 0; ///< as in GuideSettings
    std::vector<std::shared_ptr<const GuideCurve>> curves; ///< never null
};

} // namespace burin

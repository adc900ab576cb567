// SPDX-FileCopyrightText: 2026 The Burin authors
// SPDX-License-Identifier: Apache-2.0
#pragma once

#include "core/setup/guide.h"

#include <algorithm>
#include <memory>
#include <span>
#include <vector>

namespace burin {

/// Guides as stored in a project, with the curves that they follow.
struct KeptGuides {
    std::vector<Guide> guides;    ///< at most GuideSettings::capacity; each curve is one of `curves`
    std::uint32_t stepButton = 0; ///< as in GuideSettings
    std::vector<std::shared_ptr<const GuideCurve>> curves; ///< never null
};

/// Returns the guides in the form that the loop takes. @param guides at most GuideSettings::capacity
inline GuideSettings guideSettings(std::span<const Guide> guides, std::uint32_t stepButton) {
    GuideSettings settings;
    settings.stepButton = stepButton;
    std::copy(guides.begin(), guides.end(), settings.guides.begin());
    return settings;
}

} // namespace burin

// SPDX-FileCopyrightText: 2026 The Burin authors
// SPDX-License-Identifier: Apache-2.0
#pragma once

#include "core/setup/obstacle.h"

#include <memory>

namespace burin {

/// How a fixture or a keep-out volume is to be seen.
struct ObstacleMark {
    std::shared_ptr<const Obstacle> obstacle; ///< never null, and never another in the same place of memory meanwhile
    bool on = true;                           ///< it keeps the tool out; else its outline alone is drawn
    bool holds = false;                       ///< it holds the tool back just now

    friend bool operator==(const ObstacleMark&, const ObstacleMark&) = default;
};

} // namespace burin

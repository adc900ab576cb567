// SPDX-FileCopyrightText: 2026 The Burin authors
// SPDX-License-Identifier: Apache-2.0
#pragma once

#include "core/geometry/placement.h"
#include "core/setup/obstacle.h"

#include <memory>

namespace burin {

/// How a fixture or keep-out volume is drawn.
struct ObstacleMark {
    std::shared_ptr<const Obstacle> obstacle; ///< never null; its address is not reused for another one in the meantime
    bool on = true;                           ///< whether it keeps the tool out; if not, only its outline is drawn
    bool holds = false;                       ///< whether it is currently holding the tool back
    Placement moved{};                        ///< by how much it is drawn away from its position

    friend bool operator==(const ObstacleMark&, const ObstacleMark&) = default;
};

} // namespace burin

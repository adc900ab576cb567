// SPDX-FileCopyrightText: 2026 The Burin authors
// SPDX-License-Identifier: Apache-2.0
#pragma once

#include "core/machine/envelope.h"
#include "core/setup/axis_mode.h"
#include "core/setup/obstacle.h"

#include <memory>
#include <vector>

namespace burin {

/// An obstacle as the window has it: what it is never changes, so that copies are cheap; `obstacle->on` is not looked
/// at.
struct PlacedObstacle {
    std::shared_ptr<const Obstacle> obstacle; ///< never null
    bool on = true;

    friend bool operator==(const PlacedObstacle&, const PlacedObstacle&) = default;
};

/// What bounds the tool besides the part, and how its axis is held.
struct WantedBounds {
    std::vector<PlacedObstacle> obstacles;
    AxisMode axis;
    TravelPlacement travel;
};

/// Whether both are bounded alike once layers are switched.
bool boundAlike(const WantedBounds& one, const WantedBounds& other);
/// As core has them.
std::vector<Obstacle> obstaclesOf(const std::vector<PlacedObstacle>& placed);
std::vector<PlacedObstacle> placed(std::vector<Obstacle> obstacles);

} // namespace burin

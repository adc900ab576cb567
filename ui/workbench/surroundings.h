// SPDX-FileCopyrightText: 2026 The Burin authors
// SPDX-License-Identifier: Apache-2.0
#pragma once

#include "core/machine/envelope.h"
#include "core/setup/axis_mode.h"
#include "core/setup/obstacle.h"

#include <memory>
#include <vector>

namespace burin {

/// An obstacle in the user interface: its shape is immutable, so that copies are cheap; `obstacle->on` is ignored.
struct PlacedObstacle {
    std::shared_ptr<const Obstacle> obstacle; ///< never null
    bool on = true;

    friend bool operator==(const PlacedObstacle&, const PlacedObstacle&) = default;
};

/// Bounds of the tool besides the part, and the control of its axis.
struct RequestedBounds {
    std::vector<PlacedObstacle> obstacles;
    AxisMode axis;
    TravelPlacement travel;
};

/// Whether both give the same bounds, apart from layers being on or off.
bool boundAlike(const RequestedBounds& one, const RequestedBounds& other);
/// In the form used by core.
std::vector<Obstacle> obstaclesOf(const std::vector<PlacedObstacle>& placed);
std::vector<PlacedObstacle> placed(std::vector<Obstacle> obstacles);

} // namespace burin

// SPDX-FileCopyrightText: 2026 The Burin authors
// SPDX-License-Identifier: Apache-2.0
#include "ui/workbench/surroundings.h"

#include <algorithm>
#include <utility>

namespace burin {

bool boundAlike(const RequestedBounds& one, const RequestedBounds& other) {
    return one.axis.free == other.axis.free && one.axis.direction == other.axis.direction &&
           one.travel.zero == other.travel.zero &&
           std::ranges::equal(one.obstacles, other.obstacles, {}, &PlacedObstacle::obstacle, &PlacedObstacle::obstacle);
}

std::vector<Obstacle> obstaclesOf(const std::vector<PlacedObstacle>& placed) {
    std::vector<Obstacle> obstacles;
    for (const PlacedObstacle& each : placed) {
        obstacles.push_back(*each.obstacle);
        obstacles.back().on = each.on;
    }
    return obstacles;
}

std::vector<PlacedObstacle> placed(std::vector<Obstacle> obstacles) {
    std::vector<PlacedObstacle> result;
    for (Obstacle& obstacle : obstacles) {
        const bool on = obstacle.on;
        result.push_back({std::make_shared<const Obstacle>(std::move(obstacle)), on});
    }
    return result;
}

} // namespace burin

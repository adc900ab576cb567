// SPDX-FileCopyrightText: 2026 The Burin authors
// SPDX-License-Identifier: Apache-2.0
#include "ui/scene/path_thinner.h"

#include <algorithm>

namespace burin {

void PathThinner::begin(const glm::vec3& first) {
    corner_ = first;
    pending_.clear();
}

bool PathThinner::bridges(const glm::vec3& next) const {
    const glm::vec3 way = next - corner_;
    const float length = glm::dot(way, way);
    return std::ranges::all_of(pending_, [&](const glm::vec3& place) {
        const float share = length > 0.0F ? std::clamp(glm::dot(place - corner_, way) / length, 0.0F, 1.0F) : 0.0F;
        return glm::distance(place, corner_ + way * share) <= tolerance_;
    });
}

bool PathThinner::add(const glm::vec3& next) {
    const bool corner = pending_.empty() || pending_.size() >= mostPending || !bridges(next);
    if (corner && !pending_.empty()) {
        corner_ = pending_.back();
        pending_.clear();
    }
    pending_.push_back(next);
    return corner;
}

} // namespace burin

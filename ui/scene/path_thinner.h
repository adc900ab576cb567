// SPDX-FileCopyrightText: 2026 The Burin authors
// SPDX-License-Identifier: Apache-2.0
#pragma once

#include <glm/glm.hpp>

#include <cstddef>
#include <vector>

namespace burin {

/// Drops points of a growing polyline that a straight line can replace within a tolerance.
class PathThinner {
public:
    explicit PathThinner(float tolerance) : tolerance_(tolerance) {}
    void begin(const glm::vec3& first);
    /// @return true: the previous point becomes a corner and `next` the new end; false: `next` replaces the end.
    bool add(const glm::vec3& next);

private:
    bool bridges(const glm::vec3& next) const;
    static constexpr std::size_t mostPending = 32;
    float tolerance_;
    glm::vec3 corner_{0.0F};
    std::vector<glm::vec3> pending_; ///< points after the corner, the end last
};

} // namespace burin

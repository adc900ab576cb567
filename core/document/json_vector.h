// SPDX-FileCopyrightText: 2026 The Burin authors
// SPDX-License-Identifier: Apache-2.0
#pragma once

#include <glm/glm.hpp>

#include <nlohmann/json.hpp>

namespace burin {

/// [x, y, z]; stores every bit of the values.
inline nlohmann::json jsonOf(const glm::dvec3& vector) {
    return nlohmann::json::array({vector.x, vector.y, vector.z});
}

/// Throws nlohmann's exceptions if `value` is not a vector.
inline glm::dvec3 vectorOf(const nlohmann::json& value) {
    return {value.at(0).get<double>(), value.at(1).get<double>(), value.at(2).get<double>()};
}

} // namespace burin

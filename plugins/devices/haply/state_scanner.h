// SPDX-FileCopyrightText: 2026 The Burin authors
// SPDX-License-Identifier: Apache-2.0
#pragma once

#include <glm/glm.hpp>
#include <glm/gtc/quaternion.hpp>

#include <cstdint>
#include <optional>
#include <string_view>

namespace burin::haply {

/// What a message of the service says of one arm and the grip on it. Their own frame: x right, y away from the user, z
/// up; m, N.
struct ServiceState {
    std::optional<glm::dvec3> cursor;   ///< m; nothing: the message tells of no such arm
    std::optional<glm::dvec3> force;    ///< N, that the arm renders now
    std::optional<glm::dquat> grip;     ///< of the first grip there is
    std::uint32_t buttons = 0;          ///< of that grip: a, b, c, or its only one
    std::optional<double> batteryShare; ///< of that grip, 0 … 1
    bool ready = true;                  ///< false: it says that it is not
    bool calibrated = true;             ///< false: it says that it is not
};

/// Reads a message without allocation: only numbers and booleans at the places that are looked for. Nothing for a text
/// that is no JSON object, or that nests deeper than any message does.
/// @param arm device id
std::optional<ServiceState> scanState(std::string_view message, std::string_view arm) noexcept;

} // namespace burin::haply

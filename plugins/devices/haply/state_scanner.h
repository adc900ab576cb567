// SPDX-FileCopyrightText: 2026 The Burin authors
// SPDX-License-Identifier: Apache-2.0
#pragma once

#include <glm/glm.hpp>
#include <glm/gtc/quaternion.hpp>

#include <cstdint>
#include <optional>
#include <string_view>

namespace burin::haply {

/// The content of a message of the service for one arm and the grip on it. The service's own frame: x right, y away
/// from the user, z up; m, N.
struct ServiceState {
    std::optional<glm::dvec3> cursor;   ///< m; empty: the message does not contain this arm
    std::optional<glm::dvec3> force;    ///< N, rendered by the arm now
    std::optional<glm::dquat> grip;     ///< of the first grip in the message
    std::uint32_t buttons = 0;          ///< of that grip: a, b, c, or its only button
    std::optional<double> batteryShare; ///< of that grip, 0 … 1
    bool ready = true;                  ///< false: it is reported as not ready
    bool calibrated = true;             ///< false: it is reported as not calibrated
};

/// Reads a message without allocation: only numbers and booleans at the relevant keys. Empty for a text that is not a
/// JSON object, or that is nested deeper than any message.
/// @param arm device id
std::optional<ServiceState> scanState(std::string_view message, std::string_view arm) noexcept;

} // namespace burin::haply

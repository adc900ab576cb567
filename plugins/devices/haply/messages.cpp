// SPDX-FileCopyrightText: 2026 The Burin authors
// SPDX-License-Identifier: Apache-2.0
#include "plugins/devices/haply/messages.h"

#include <nlohmann/json.hpp>

#include <algorithm>
#include <charconv>
#include <cmath>

namespace burin::haply {
namespace {

constexpr int decimals = 5;       // of a newton: finer than any motor's resolution
constexpr std::size_t room = 100; // for three numbers with that many digits, and the text around them

} // namespace

ForceMessage::ForceMessage(std::string_view arm) {
    const std::string id = nlohmann::json(arm).dump(-1, ' ', true, nlohmann::json::error_handler_t::replace);
    for (const ForceKey key : {ForceKey::vector, ForceKey::values}) {
        std::string& head = heads_[static_cast<std::size_t>(key)];
        head = R"({"inverse3":[{"device_id":)" + id + R"(,"commands":{"set_cursor_force":{")" +
               (key == ForceKey::vector ? "vector" : "values") + R"(":{)";
    }
    buffer_.resize(std::max(heads_[0].size(), heads_[1].size()) + room);
}

std::string_view ForceMessage::write(const glm::dvec3& force, ForceKey key) noexcept {
    const std::string& head = heads_[static_cast<std::size_t>(key)];
    char* at = std::copy(head.begin(), head.end(), buffer_.data());
    char* const end = buffer_.data() + buffer_.size();
    const auto add = [&](std::string_view text) { at = std::copy(text.begin(), text.end(), at); };
    constexpr std::array<std::string_view, 3> names{"\"x\":", ",\"y\":", ",\"z\":"};
    for (int axis = 0; axis < 3; ++axis) {
        add(names[static_cast<std::size_t>(axis)]);
        const double component = std::isfinite(force[axis]) ? std::clamp(force[axis], -largest, largest) : 0.0;
        at = std::to_chars(at, end, component, std::chars_format::fixed, decimals).ptr;
    }
    add("}}}}]}");
    return {buffer_.data(), static_cast<std::size_t>(at - buffer_.data())};
}

} // namespace burin::haply

// SPDX-FileCopyrightText: 2026 The Burin authors
// SPDX-License-Identifier: Apache-2.0
#include "plugins/devices/haply/messages.h"

#include <nlohmann/json.hpp>

#include <algorithm>
#include <charconv>

namespace burin::haply {
namespace {

constexpr std::size_t longestHead = 400; // leaves room for three numbers
constexpr int decimals = 5;              // of a newton: finer than any motor

} // namespace

ForceMessage::ForceMessage(std::string_view arm) {
    const std::string id = nlohmann::json(arm).dump(-1, ' ', true, nlohmann::json::error_handler_t::replace);
    for (const ForceKey key : {ForceKey::vector, ForceKey::values}) {
        std::string& head = heads_[static_cast<std::size_t>(key)];
        head = R"({"inverse3":[{"device_id":)" + id + R"(,"commands":{"set_cursor_force":{")" +
               (key == ForceKey::vector ? "vector" : "values") + R"(":{)";
        head.resize(std::min(head.size(), longestHead));
    }
}

std::string_view ForceMessage::write(const glm::dvec3& force, ForceKey key) noexcept {
    const std::string& head = heads_[static_cast<std::size_t>(key)];
    char* at = std::copy(head.begin(), head.end(), buffer_.data());
    char* const end = buffer_.data() + buffer_.size();
    const auto add = [&](std::string_view text) { at = std::copy(text.begin(), text.end(), at); };
    constexpr std::array<std::string_view, 3> names{"\"x\":", ",\"y\":", ",\"z\":"};
    for (int axis = 0; axis < 3; ++axis) {
        add(names[static_cast<std::size_t>(axis)]);
        at = std::to_chars(at, end, force[axis], std::chars_format::fixed, decimals).ptr;
    }
    add("}}}}]}");
    return {buffer_.data(), static_cast<std::size_t>(at - buffer_.data())};
}

} // namespace burin::haply

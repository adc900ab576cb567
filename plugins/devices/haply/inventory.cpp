// SPDX-FileCopyrightText: 2026 The Burin authors
// SPDX-License-Identifier: Apache-2.0
#include "plugins/devices/haply/inventory.h"

#include <nlohmann/json.hpp>

namespace burin::haply {

std::vector<std::string> armsOf(std::string_view message) {
    std::vector<std::string> ids;
    const nlohmann::json inventory = nlohmann::json::parse(message, nullptr, false);
    if (!inventory.is_object()) return ids;
    const auto arms = inventory.find("inverse3");
    if (arms == inventory.end() || !arms->is_array()) return ids;
    for (const nlohmann::json& arm : *arms) {
        const auto id = arm.is_object() ? arm.find("device_id") : arm.end();
        if (arm.is_object() && id != arm.end() && id->is_string()) ids.push_back(id->get<std::string>());
    }
    return ids;
}

} // namespace burin::haply

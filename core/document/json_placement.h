// SPDX-FileCopyrightText: 2026 The Burin authors
// SPDX-License-Identifier: Apache-2.0
#pragma once

#include "core/document/json_vector.h"
#include "core/geometry/placement.h"

namespace burin {

/// {"turn": its three columns, "shift_mm"}; stores every bit of the values.
inline nlohmann::json jsonOf(const Placement& placement) {
    return {{"turn", {jsonOf(placement.turn[0]), jsonOf(placement.turn[1]), jsonOf(placement.turn[2])}},
            {"shift_mm", jsonOf(placement.shift)}};
}

/// Throws nlohmann's exceptions if `record` is not a placement, or does not preserve lengths.
inline Placement placementOf(const nlohmann::json& record) {
    const nlohmann::json& turn = record.at("turn");
    const Placement placement{glm::dmat3(vectorOf(turn.at(0)), vectorOf(turn.at(1)), vectorOf(turn.at(2))),
                              vectorOf(record.at("shift_mm"))};
    if (!isSound(placement)) throw nlohmann::json::other_error::create(501, "turn", &record);
    return placement;
}

} // namespace burin
